# Functions for projects that use treedyn::treedyn, by find_package(treedyn) or add_subdirectory.

cmake_policy(VERSION 3.20)  # at least; of depfiles (CMP0116), whatever the project asks for

# Sets `arguments` to the model or scene of a call as the program wants it, `subject` to its file, `settings` and `scenes`
# to those of its OPTIONS.
function(_treedyn_subject call)
  list(REMOVE_ITEM ARG_KEYWORDS_MISSING_VALUES OPTIONS)  # OPTIONS ${none}
  list(REMOVE_DUPLICATES ARG_KEYWORDS_MISSING_VALUES)
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "'${ARG_UNPARSED_ARGUMENTS}' is not expected in ${call}")
  elseif(ARG_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "${ARG_KEYWORDS_MISSING_VALUES} has no value; expected ${call}")
  elseif(NOT "${ARG_MODEL}${ARG_SCENE}" MATCHES "." OR ("${ARG_MODEL}" MATCHES "." AND "${ARG_SCENE}" MATCHES "."))
    message(FATAL_ERROR "exactly one of MODEL and SCENE is needed; expected ${call}")
  endif()
  get_filename_component(subject "${ARG_MODEL}${ARG_SCENE}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  set(arguments "${subject}")
  if("${ARG_SCENE}" MATCHES ".")  # a value that is a word for false is one, too
    set(arguments --scene "${subject}")
  endif()
  if("${ARG_NAME}" MATCHES ".")
    list(APPEND arguments --name "${ARG_NAME}")
  endif()
  set(before "")
  set(settings "")
  set(scenes "")
  foreach(option IN LISTS ARG_OPTIONS)  # files are those of the folder of the call
    set(key "")
    set(start "")
    set(file "${option}")
    if(before MATCHES "^--(equations|scene|settings)$")
      set(key "${before}")
    elseif(option MATCHES "^(--equations|--scene|--settings)=(.+)$")
      set(key "${CMAKE_MATCH_1}")
      set(start "${key}=")
      set(file "${CMAKE_MATCH_2}")
    endif()
    if(key)
      get_filename_component(file "${file}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
      set(option "${start}${file}")
    endif()
    if(key STREQUAL "--settings")
      list(APPEND settings "${file}")
    elseif(key STREQUAL "--scene")
      list(APPEND scenes "${file}")
    endif()
    list(APPEND arguments "${option}")
    set(before "${option}")
  endforeach()
  set(arguments ${arguments} PARENT_SCOPE)
  set(subject "${subject}" PARENT_SCOPE)
  set(settings "${settings}" PARENT_SCOPE)
  set(scenes "${scenes}" PARENT_SCOPE)
endfunction()

# Sets `value` to what settings say of an option, of a list the first; empty: they say nothing of it.
function(_treedyn_setting file option)
  file(READ "${file}" text)
  string(ASCII 239 187 191 mark)  # of the order of bytes
  set(value "")
  if("\n${text}" MATCHES "\n(${mark})?[ \t]*${option}[ \t]*=[[ \t]*(\"([^\"\r\n]*)\"|'([^'\r\n]*)'|([^]\"',# \t\r\n]+))")
    set(value "${CMAKE_MATCH_3}${CMAKE_MATCH_4}${CMAKE_MATCH_5}")
  endif()
  set(value "${value}" PARENT_SCOPE)
endfunction()

# Sets `language` to the one that the options or, if they name none, the files `settings` choose.
function(_treedyn_language settings)
  set(language "c++")
  if("${ARGN}" MATCHES "(^|;)--language[;=]([^;]*)")
    set(language "${CMAKE_MATCH_2}")
  else()
    foreach(file IN LISTS settings)
      _treedyn_setting("${file}" language)
      if(value STREQUAL "c99")
        set(language "c99")
      endif()
    endforeach()
  endif()
  set(language "${language}" PARENT_SCOPE)
endfunction()

# Sets `files` to what `treedyn generate ${arguments} -o ${folder}` writes. Without a NAME it stands in the model or
# scene, the one of options or settings too, and the program is asked while the project is configured: it has to be there.
function(_treedyn_files name folder subjects settings)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${settings})
  _treedyn_language("${settings}" ${ARGN})
  if("${name}" MATCHES "." AND language STREQUAL "c99")
    set(files "${folder}/${name}.h" "${folder}/${name}.c" "${folder}/${name}.json")
  elseif("${name}" MATCHES ".")
    set(files "${folder}/${name}.hpp" "${folder}/${name}.cpp" "${folder}/${name}.json")
  else()
    get_target_property(imported treedyn::treedyn IMPORTED)
    if(NOT imported)
      message(FATAL_ERROR "treedyn_generate: treedyn is built in this project; expected NAME, the stem of the generated files")
    endif()
    get_target_property(program treedyn::treedyn IMPORTED_LOCATION)
    if(NOT EXISTS "${program}")
      message(FATAL_ERROR "treedyn_generate: there is no program '${program}'; expected TREEDYN_EXECUTABLE that is there, or NAME")
    endif()
    foreach(file IN LISTS settings)  # a scene stands beside the settings that name it
      _treedyn_setting("${file}" scene)
      if(value MATCHES ".")
        get_filename_component(beside "${file}" DIRECTORY)
        get_filename_component(scene "${value}" ABSOLUTE BASE_DIR "${beside}")
        list(APPEND subjects "${scene}")
      endif()
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${subjects})
    execute_process(COMMAND "${program}" outputs -q ${ARGN} -o "${folder}"
                    OUTPUT_VARIABLE files OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE "\n" ";" files "${files}")
  endif()
  set(files ${files} PARENT_SCOPE)
endfunction()

# Warns if another target writes functions of the same namespace or prefix by other arguments (with its model or scene).
# What settings files say of it is not seen.
function(_treedyn_warn_of_twins target header)
  get_filename_component(names "${header}" NAME_WE)
  get_filename_component(language "${header}" EXT)
  string(REGEX REPLACE "(^|;)--name[;=][^;]*" "" asked "${ARGN}")  # the default may be the same
  if("${ARGN}" MATCHES "(^|;)--(namespace|prefix)[;=]([^;]*)")
    set(names "${CMAKE_MATCH_3}")
  endif()
  set(key "${names}${language}")
  get_property(first GLOBAL PROPERTY "TREEDYN_TARGET_OF_${key}")
  get_property(first_asked GLOBAL PROPERTY "TREEDYN_ASKED_OF_${key}")
  if(NOT first)
    set_property(GLOBAL PROPERTY "TREEDYN_TARGET_OF_${key}" "${target}")
    set_property(GLOBAL PROPERTY "TREEDYN_ASKED_OF_${key}" "${asked}")
  elseif(NOT asked STREQUAL first_asked)
    message(WARNING "treedyn_generate: ${first} and ${target} both write functions of ${names}, and not the same: a program that "
                    "links both calls those of one for both; expected a NAME (or --namespace, --prefix) that no other target has")
  endif()
endfunction()

# treedyn_generate(TARGET MODEL|SCENE file [NAME name] [OPTIONS option...] [FOLDER folder] [CONTRACTION on|off])
#
# A static library TARGET of the functions that `treedyn generate` writes for a model or a scene into FOLDER (default:
# a folder of the build); whoever links it can include NAME.hpp (NAME.h with OPTIONS --language c99). Runs again when a file that was read or treedyn changes.
# CONTRACTION off, the default: the same bits on every processor; on: products and sums as one rounded operation where there
# is one, which takes more cycles on a Cortex-M4F. On a host that has it (AVX2: -march=x86-64-v3 or native in CMAKE_CXX_FLAGS,
# which this function does not set) off costs 1.1 to 1.4 times the time; without such an option both are the same there.
# Square roots leave errno alone.
function(treedyn_generate target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "MODEL;SCENE;NAME;FOLDER;CONTRACTION" "OPTIONS")
  _treedyn_subject("treedyn_generate(TARGET MODEL|SCENE file [NAME name] [OPTIONS option...] [FOLDER folder] [CONTRACTION on|off])")
  if("${ARG_FOLDER}" STREQUAL "")
    set(ARG_FOLDER "${CMAKE_CURRENT_BINARY_DIR}/${target}")
  endif()
  get_filename_component(folder "${ARG_FOLDER}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  _treedyn_files("${ARG_NAME}" "${folder}" "${subject};${scenes}" "${settings}" ${arguments})
  list(GET files 0 header)
  _treedyn_warn_of_twins(${target} "${header}" ${arguments})
  set(depfile "${CMAKE_CURRENT_BINARY_DIR}/${target}.treedyn.d")
  add_custom_command(OUTPUT ${files}
                     COMMAND treedyn::treedyn generate ${arguments} -o "${folder}" --depfile "${depfile}"
                     COMMAND "${CMAKE_COMMAND}" -E touch_nocreate ${files}  # unchanged files keep their time else
                     DEPENDS "${subject}" treedyn::treedyn "$<TARGET_FILE:treedyn::treedyn>" DEPFILE "${depfile}"
                     COMMENT "treedyn generate ${ARG_MODEL}${ARG_SCENE}" VERBATIM)
  add_library(${target} STATIC ${files})
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${folder}>")
  set(language C)
  if("${files}" MATCHES "\\.hpp")
    set(language CXX)
  elseif(UNIX AND NOT APPLE)
    target_link_libraries(${target} PUBLIC m)  # of sin, cos and sqrt, which the drivers of C++ link themselves
  elseif(NOT WIN32 AND NOT APPLE)  # without a system: newlib, picolibc
    target_link_libraries(${target} PUBLIC "$<$<C_COMPILER_ID:GNU,Clang>:m>")
  endif()
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT language IN_LIST languages)
    message(FATAL_ERROR "treedyn_generate: writes ${language}; expected it among the LANGUAGES of project() (--language c99: C)")
  elseif(language STREQUAL "CXX")
    target_compile_features(${target} PUBLIC cxx_std_11)
  else()
    target_compile_features(${target} PRIVATE c_std_99)
  endif()
  set(gnu_like "$<${language}_COMPILER_ID:GNU,Clang,AppleClang>")
  target_compile_options(${target} PRIVATE "$<${gnu_like}:-fno-math-errno>")
  if("${ARG_CONTRACTION}" STREQUAL "on")
    target_compile_options(${target} PRIVATE "$<${gnu_like}:-ffp-contract=fast>")
  elseif("${ARG_CONTRACTION}" MATCHES "^(off)?$")
    target_compile_options(${target} PRIVATE "$<${gnu_like}:-ffp-contract=off>")
  else()
    message(FATAL_ERROR "treedyn_generate: CONTRACTION '${ARG_CONTRACTION}'; expected on or off")
  endif()
endfunction()

# treedyn_check(NAME MODEL|SCENE file FOLDER folder [STEM name] [OPTIONS option...])
#
# A test NAME that fails unless FOLDER holds what `treedyn generate` would write.
function(treedyn_check name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "MODEL;SCENE;FOLDER;STEM" "OPTIONS")
  set(ARG_NAME "${ARG_STEM}")
  if("${ARG_FOLDER}" STREQUAL "")
    list(APPEND ARG_KEYWORDS_MISSING_VALUES FOLDER)
  endif()
  _treedyn_subject("treedyn_check(NAME MODEL|SCENE file FOLDER folder [STEM name] [OPTIONS option...])")
  get_filename_component(folder "${ARG_FOLDER}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  add_test(NAME ${name} COMMAND treedyn::treedyn check ${arguments} -o "${folder}")
endfunction()
