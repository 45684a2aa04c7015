# Writes the committed output of every model, or checks it.
#   cmake -DTREEDYN=build/treedyn [-DCHECK=ON] -P generated/regenerate.cmake
cmake_minimum_required(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
get_filename_component(models ${here}/../models ABSOLUTE)
get_filename_component(TREEDYN ${TREEDYN} ABSOLUTE)
set(command generate)
if(CHECK)
  set(command check)
endif()

# Every model with the default options, and what is committed beyond that: folder, model, options.
set(jobs "biped_float biped.yaml --scalar float" "biped_axes biped.yaml --base axes")
file(GLOB files RELATIVE ${models} ${models}/*.yaml)
foreach(file IN LISTS files)
  string(REPLACE ".yaml" "" folder ${file})
  list(APPEND jobs "${folder} ${file}")
endforeach()

set(folders "")
foreach(job IN LISTS jobs)
  separate_arguments(words UNIX_COMMAND "${job}")
  list(POP_FRONT words folder model)
  list(APPEND folders ${folder})
  execute_process(COMMAND ${TREEDYN} ${command} -q ${model} ${words} -o ${here}/${folder}
                  WORKING_DIRECTORY ${models} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "generated/${folder} (${job}): treedyn ${command} returned ${status}")
  endif()
endforeach()

file(GLOB present RELATIVE ${here} ${here}/*)
list(REMOVE_ITEM present README.md regenerate.cmake ${folders})
if(present)
  message(SEND_ERROR "generated/ holds ${present}: no model makes that")
endif()
