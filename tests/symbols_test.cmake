# Fails if the libraries of the generator do not refer to what their work is made of, or refer to what they must not see.
#   cmake -DNM=<nm> -DFORMULATE=<libtreedyn_formulate.a> -DDERIVE=.. -DVERIFY=.. -P symbols_test.cmake
cmake_minimum_required(VERSION 3.25)

function(expect library)
  cmake_parse_arguments(ARG "" "" "TAKES;NOT" ${ARGN})
  execute_process(COMMAND ${NM} -C ${library} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  foreach(scope IN LISTS ARG_TAKES)
    if(NOT symbols MATCHES " [Uu] [^\n]*${scope}::")  # u: constants that headers share
      message(SEND_ERROR "${library} takes nothing from ${scope}::")
    endif()
  endforeach()
  foreach(scope IN LISTS ARG_NOT)
    if(symbols MATCHES "[^\n]*${scope}::[^\n]*")
      message(SEND_ERROR "${library} sees ${CMAKE_MATCH_0}")
    endif()
  endforeach()
endfunction()

expect(${FORMULATE} TAKES treedyn::equations treedyn::derive)
expect(${DERIVE} TAKES GiNaC treedyn::equations)
expect(${VERIFY} TAKES treedyn::engine treedyn::program NOT treedyn::derive treedyn::formulate treedyn::optimise treedyn::emit GiNaC)
