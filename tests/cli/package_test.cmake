# Installs treedyn, moves the installation, and builds a project that uses it: the program and the
# package have to be relocatable.
#   cmake -DBUILD=<build> -DSOURCE=<source> -DCXX=<compiler> -P package_test.cmake
cmake_minimum_required(VERSION 3.25)
set(scratch ${BUILD}/package_test)
file(REMOVE_RECURSE ${scratch})

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${scratch}/first --component Unspecified
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${scratch}/first ${scratch}/second)

file(WRITE ${scratch}/project/CMakeLists.txt [[
cmake_minimum_required(VERSION 3.16)  # with policies that the package does not share
project(consumer C CXX)
set(CMAKE_CXX_STANDARD 11)  # generated code asks for no more
find_package(treedyn 0.1 REQUIRED)
treedyn_generate(arm MODEL arm.yaml OPTIONS --scalar float --functions gravity_force)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE arm)
enable_testing()
treedyn_generate(swing SCENE swing.yaml NAME swing OPTIONS --effort 0 CONTRACTION off)
target_link_libraries(consumer PRIVATE swing)
treedyn_generate(in_c MODEL arm.yaml NAME in_c OPTIONS --settings=own.txt --functions mass_matrix,own CONTRACTION on)
target_link_libraries(consumer PRIVATE in_c)
treedyn_generate(in_c_by_libm MODEL arm.yaml NAME by_libm OPTIONS --language c99 --sincos libm --functions gravity_force)
add_executable(consumer_in_c main.c)
target_link_libraries(consumer_in_c PRIVATE in_c_by_libm)
treedyn_generate(default MODEL arm.yaml NAME no FOLDER off OPTIONS ${nothing})  # words like others
treedyn_generate(commented MODEL arm.yaml NAME commented OPTIONS --settings commented.txt)
add_custom_command(OUTPUT made.yaml COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/own.yaml made.yaml)
add_custom_command(OUTPUT two_link.yaml COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/two_link.yaml two_link.yaml)
add_custom_command(OUTPUT swing.yaml COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/swing.yaml swing.yaml)
set(made ${CMAKE_CURRENT_BINARY_DIR})
treedyn_generate(of_made MODEL arm.yaml NAME of_made OPTIONS --equations ${made}/made.yaml --functions own --effort 0)
treedyn_generate(swing_of_made SCENE ${made}/swing.yaml NAME swing_of_made OPTIONS --effort 0 DEPENDS ${made}/two_link.yaml)
target_link_libraries(consumer PRIVATE of_made swing_of_made)
set_target_properties(default commented PROPERTIES EXCLUDE_FROM_ALL TRUE)
install(TARGETS arm EXPORT arms ARCHIVE DESTINATION lib)
install(EXPORT arms DESTINATION lib/cmake/arms)
treedyn_check(swing_is_fresh SCENE swing.yaml STEM swing FOLDER ${CMAKE_CURRENT_BINARY_DIR}/swing OPTIONS --effort 0)
treedyn_check(arm_is_fresh MODEL arm.yaml FOLDER ${CMAKE_CURRENT_BINARY_DIR}/arm
              OPTIONS --scalar float --functions gravity_force)
]])
file(WRITE ${scratch}/project/own.yaml "equations: [{name: own, value: T(ones) * m_d * ones}]\n")
set(settings "effort = 0\nequations = own.yaml\n")  # a file beside the settings
file(WRITE ${scratch}/project/own.txt "${settings}language = c99\n")
file(WRITE ${scratch}/project/commented.txt "effort = 0\n# – language = c99 # is for the firmware – language = c99\n")
file(WRITE ${scratch}/project/main.cpp [[
#include "in_c.h"
#include "swing.hpp"
#include "two_link.hpp"

int main() {
  const two_link::Scalar q[2] = {0, 0};
  two_link::Scalar G[2];
  two_link::gravity_force(q, G);
  const double pose[IN_C_DOF] = {0, 0};
  double A[4];
  in_c_mass_matrix(pose, A);
  return G[two_link::joint::elbow] > 0 && A[0] > 0 ? 0 : 1;
}
]])
file(WRITE ${scratch}/project/main.c [[
#include "by_libm.h"

int main(void) {
  const double q[BY_LIBM_DOF] = {0, 0};
  double G[BY_LIBM_DOF];
  by_libm_gravity_force(q, G);
  return G[0] > 0 ? 0 : 1;
}
]])
file(COPY_FILE ${SOURCE}/models/two_link.yaml ${scratch}/project/arm.yaml)
file(COPY_FILE ${SOURCE}/models/two_link.yaml ${scratch}/project/two_link.yaml)
file(WRITE ${scratch}/project/swing.yaml [[
scene: swing
model: two_link.yaml
effects:
  gravity: [0, 0, -9.81]
initial:
  q: {elbow: 0.5}
stepping: {integrator: rk4, step: 0.01}
duration: 1
]])

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(build ${scratch}/build)
run(${CMAKE_COMMAND} -S ${scratch}/project -B ${build} -G Ninja -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${scratch}/second)
run(${CMAKE_COMMAND} --build ${build} --verbose)
if(NOT output MATCHES "-ffp-contract=fast [^\n]*in_c\\.c" OR NOT output MATCHES "-ffp-contract=off [^\n]*swing\\.cpp")
  message(FATAL_ERROR "CONTRACTION did not reach the compiler:\n${output}")
endif()
if(NOT output MATCHES "-std=gnu\\+\\+11 [^\n]*swing\\.cpp" OR output MATCHES "-std=gnu\\+\\+1[2-9]")
  message(FATAL_ERROR "C++11 is not what the project is compiled as:\n${output}")
endif()
run(${build}/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${build})

# Clocks of file systems may count whole seconds: a file written now is surely younger than what stands there after a second.
function(a_second_later)
  run(${CMAKE_COMMAND} -E sleep 1)
endfunction()

run(${CMAKE_COMMAND} --build ${build} --target default commented)
if(NOT EXISTS ${scratch}/project/off/no.hpp)
  message(FATAL_ERROR "NAME no FOLDER off: there is no off/no.hpp")
endif()
run(${CMAKE_COMMAND} --build ${build})  # nothing is left to do
if(NOT output MATCHES "no work to do")
  message(FATAL_ERROR "the second build did something:\n${output}")
endif()
file(READ ${scratch}/project/arm.yaml model)
string(REPLACE "a1: 1," "a1: 2," changed "${model}")
a_second_later()
file(WRITE ${scratch}/project/arm.yaml "${changed}")
run(${CMAKE_COMMAND} --build ${build})
if(changed STREQUAL model OR NOT output MATCHES "treedyn generate arm.yaml")
  message(FATAL_ERROR "a changed model was not generated again:\n${output}")
endif()
run(${CMAKE_CTEST_COMMAND} --test-dir ${build} -R swing)
file(READ ${scratch}/project/two_link.yaml model)  # which only the scene names
string(REPLACE "a1: 1," "a1: 3," changed "${model}")
a_second_later()
file(WRITE ${scratch}/project/two_link.yaml "${changed}")
run(${CMAKE_COMMAND} --build ${build})
if(changed STREQUAL model OR NOT output MATCHES "treedyn generate swing.yaml")
  message(FATAL_ERROR "the model of a scene changed, and it was not generated again:\n${output}")
endif()

# A scene that options or settings name decides what files are called.
function(write_named name)
  file(READ ${scratch}/project/swing.yaml scene)
  string(REGEX REPLACE "scene: [a-z_]+" "scene: ${name}" scene "${scene}")
  file(WRITE ${scratch}/project/by_option.yaml "${scene}")
  file(WRITE ${scratch}/project/by_setting.yaml "${scene}")
endfunction()
write_named(first_name)
file(WRITE ${scratch}/project/scene.txt "effort = 0\nscene = [ 'by_setting.yaml' ]\n")
file(READ ${scratch}/project/CMakeLists.txt project)
file(APPEND ${scratch}/project/CMakeLists.txt "
treedyn_generate(by_option MODEL two_link.yaml OPTIONS --scene by_option.yaml --effort 0)
treedyn_generate(by_word MODEL two_link.yaml OPTIONS --scene=by_option.yaml --effort 0 --prefix w --language c99)
treedyn_generate(by_setting MODEL two_link.yaml OPTIONS --settings scene.txt --namespace s)
")
run(${CMAKE_COMMAND} --build ${build} --target by_option by_word by_setting)
a_second_later()
write_named(second_name)
run(${CMAKE_COMMAND} --build ${build} --target by_option by_word by_setting)
foreach(source IN ITEMS by_option/second_name.cpp by_word/second_name.c by_setting/second_name.cpp)
  if(NOT output MATCHES "Building [^\n]*${source}\\.o")
    message(FATAL_ERROR "a scene was renamed, and ${source} was not compiled:\n${output}")
  endif()
endforeach()
file(WRITE ${scratch}/project/CMakeLists.txt "${project}")

# Settings that choose the other language change what is built.
file(WRITE ${scratch}/project/own.txt "${settings}language = c++\n")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} OUTPUT_VARIABLE output RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT output MATCHES "in_c\\.cpp")  # the consumer wants C
  message(FATAL_ERROR "the language of settings changed, and files of the other one were built:\n${output}")
endif()
file(WRITE ${scratch}/project/own.txt "${settings}language = c99\n")

# The package that is found is the one that runs, also in a build that found another one before.
file(RENAME ${scratch}/second ${scratch}/third)
run(${CMAKE_COMMAND} -S ${scratch}/project -B ${build} -DCMAKE_PREFIX_PATH=${scratch}/third -Dtreedyn_DIR=)
run(${CMAKE_COMMAND} --build ${build})
file(RENAME ${scratch}/third ${scratch}/second)

# A package that one folder finds serves the others.
file(WRITE ${scratch}/folders/CMakeLists.txt "cmake_minimum_required(VERSION 3.16)\nproject(folders C CXX)\nadd_subdirectory(package)\nadd_subdirectory(arm)\n")
file(WRITE ${scratch}/folders/package/CMakeLists.txt "find_package(treedyn 0.1 REQUIRED)\n")
file(WRITE ${scratch}/folders/arm/CMakeLists.txt "treedyn_generate(arm MODEL arm.yaml OPTIONS --functions gravity_force)\n")
file(COPY ${scratch}/project/arm.yaml DESTINATION ${scratch}/folders/arm)
run(${CMAKE_COMMAND} -S ${scratch}/folders -B ${scratch}/folders_build -G Ninja -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${scratch}/second)
run(${CMAKE_COMMAND} --build ${scratch}/folders_build)

# Calls that are wrong say what is wrong with them.
file(READ ${scratch}/project/CMakeLists.txt project)
file(COPY ${scratch}/project/ DESTINATION ${scratch}/wrong PATTERN CMakeLists.txt EXCLUDE)
function(expect_refusal from to message)  # more arguments are those of cmake
  string(REPLACE "${from}" "${to}" wrong "${project}")
  file(WRITE ${scratch}/wrong/CMakeLists.txt "${wrong}")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${scratch}/wrong -B ${scratch}/wrong_build -G Ninja -DCMAKE_CXX_COMPILER=${CXX}
                          -DCMAKE_PREFIX_PATH=${scratch}/second ${ARGN}
                  OUTPUT_QUIET ERROR_VARIABLE error RESULT_VARIABLE status)
  string(REGEX REPLACE "[ \n]+" " " error "${error}")
  string(FIND "${error}" "${message}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "'${to}' for '${from}' was not refused by '${message}':\n${error}")
  endif()
endfunction()
expect_refusal("CONTRACTION on" "CONTRACTION fast" "treedyn_generate: CONTRACTION 'fast'; expected on or off")
expect_refusal("NAME in_c" "STEM in_c" "'STEM;in_c' is not expected in treedyn_generate(TARGET")
expect_refusal("SCENE swing.yaml NAME swing" "NAME swing" "exactly one of MODEL and SCENE is needed; expected treedyn_generate(TARGET")
expect_refusal("FOLDER \${CMAKE_CURRENT_BINARY_DIR}/arm" "" "FOLDER has no value; expected treedyn_check(NAME")
expect_refusal("project(consumer C CXX)" "project(consumer C)" "treedyn_generate: writes CXX; expected it among the LANGUAGES of project()")
expect_refusal("CONTRACTION on" "CONTRACTION on" "there is no program '/nowhere/treedyn'; expected TREEDYN_EXECUTABLE"
               -DTREEDYN_EXECUTABLE=/nowhere/treedyn)

# A processor with 32 bits: the package is that of the machine that builds.
if(EXISTS /usr/bin/arm-none-eabi-g++)
  run(${CMAKE_COMMAND} -S ${scratch}/project -B ${scratch}/cross -G Ninja -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_SYSTEM_PROCESSOR=arm
      -DCMAKE_CXX_COMPILER=arm-none-eabi-g++ -DCMAKE_CXX_FLAGS=-mcpu=cortex-m4\ -mthumb -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY
      -DCMAKE_C_COMPILER=arm-none-eabi-gcc -DCMAKE_C_FLAGS=-mcpu=cortex-m4\ -mthumb -DCMAKE_EXE_LINKER_FLAGS=--specs=nosys.specs
      -DCMAKE_PREFIX_PATH=${scratch}/second)
  run(${CMAKE_COMMAND} --build ${scratch}/cross --target arm consumer_in_c)  # with libm
else()
  message(STATUS "arm-none-eabi-g++ is not there: no cross build")
endif()

# Make, by the stamp: a second run does nothing, a changed model is generated again.
file(WRITE ${scratch}/make/Makefile "all: arm.stamp\narm.stamp: arm.yaml\n\t${scratch}/second/bin/treedyn generate arm.yaml --effort 0 -o . --depfile arm.d --stamp arm.stamp\n-include arm.d\n")
file(COPY_FILE ${SOURCE}/models/two_link.yaml ${scratch}/make/arm.yaml)
run(make -C ${scratch}/make)
run(make -C ${scratch}/make)
if(output MATCHES "generate")
  message(FATAL_ERROR "make did something twice:\n${output}")
endif()
a_second_later()
file(TOUCH ${scratch}/make/arm.yaml)
run(make -C ${scratch}/make)
if(NOT output MATCHES "generate")
  message(FATAL_ERROR "make did not see the touched model:\n${output}")
endif()

file(RENAME ${scratch}/make/arm.yaml ${scratch}/make/renamed.yaml)  # the rule of the Makefile follows, arm.d does not
file(READ ${scratch}/make/Makefile makefile)
string(REPLACE "arm.yaml" "renamed.yaml" makefile "${makefile}")
file(WRITE ${scratch}/make/Makefile "${makefile}")
run(make -C ${scratch}/make)
if(NOT output MATCHES "generate renamed.yaml")
  message(FATAL_ERROR "make did not see the renamed model:\n${output}")
endif()

# add_subdirectory with a program that is there: nothing else is built, and C is all the project needs.
file(WRITE ${scratch}/small/CMakeLists.txt "
cmake_minimum_required(VERSION 3.25)
project(small C)
add_subdirectory(${SOURCE} treedyn)
treedyn_generate(falling SCENE falling.yaml NAME falling OPTIONS --settings=c.toml)
treedyn_generate(beside MODEL arm.yaml NAME beside OPTIONS --settings c.toml --scene beside.yaml)
treedyn_generate(again MODEL arm.yaml NAME again OPTIONS --settings c.toml --scene=beside.yaml)
treedyn_generate(same SCENE falling.yaml OPTIONS --settings=c.toml)
set_target_properties(again same PROPERTIES EXCLUDE_FROM_ALL TRUE)
if(TWIN)
  treedyn_generate(twin SCENE falling.yaml OPTIONS --settings=c.toml --scalar float)
  treedyn_generate(other_symbols SCENE falling.yaml OPTIONS --settings=c.toml --prefix other)
  treedyn_generate(like_other SCENE falling.yaml NAME like OPTIONS --settings=c.toml --prefix other --scalar float)
endif()
")
file(WRITE ${scratch}/small/c.toml "language = [ 'c99' ]\neffort = 0\nfunctions = gravity_force\n")
file(COPY_FILE ${SOURCE}/models/two_link.yaml ${scratch}/small/arm.yaml)
file(COPY_FILE ${SOURCE}/models/two_link.yaml ${scratch}/small/before.yaml)
function(write_scene name model)
  file(WRITE ${scratch}/small/${name}.yaml "scene: ${name}\nmodel: ${model}\neffects: {gravity: [0, 0, -9.81]}\nduration: 1\n")
endfunction()
write_scene(beside arm.yaml)
foreach(generator IN ITEMS Ninja "Unix Makefiles" "Ninja Multi-Config")
  write_scene(falling before.yaml)
  set(small ${scratch}/small_build/${generator})
  run(${CMAKE_COMMAND} -S ${scratch}/small -B ${small} -G ${generator} -DTREEDYN_EXECUTABLE=${scratch}/second/bin/treedyn)
  if(output MATCHES "Warning")
    message(FATAL_ERROR "a warning without a reason:\n${output}")
  endif()
  run(${CMAKE_COMMAND} --build ${small})
  run(${CMAKE_COMMAND} --build ${small})
  set(twice "${output}")
  a_second_later()
  file(RENAME ${scratch}/small/before.yaml ${scratch}/small/after.yaml)  # a file that only the dependency file names
  write_scene(falling after.yaml)
  run(${CMAKE_COMMAND} --build ${small})
  set(renamed "${output}")
  run(${CMAKE_COMMAND} --build ${small})
  if(NOT renamed MATCHES "treedyn generate falling.yaml" OR "${twice}${output}" MATCHES "treedyn generate")
    message(FATAL_ERROR "${generator}: expected a run behind a renamed file, and no other:\n${twice}${renamed}${output}")
  endif()
  file(RENAME ${scratch}/small/after.yaml ${scratch}/small/before.yaml)
endforeach()
write_scene(falling before.yaml)
run(${CMAKE_COMMAND} --build ${scratch}/small_build/Ninja --target again)

# Targets with the same symbols for something else.
run(${CMAKE_COMMAND} -S ${scratch}/small -B ${scratch}/small_build/Ninja -DTWIN=ON)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
if(NOT output MATCHES "falling and twin both write functions of falling, and not the same.*other_symbols and like_other both write functions of other" OR output MATCHES "and other_symbols both")
  message(FATAL_ERROR "expected warnings of falling and twin, other_symbols and like_other, and no other:\n${output}")
endif()

foreach(file IN ITEMS share/doc/treedyn/LICENSE share/doc/treedyn/generator/cli/INTERFACE.md
        share/doc/treedyn/models/scenes/README.md share/treedyn/templates/model.cpp.in bin/treedyn
        share/man/man1/treedyn.1 share/bash-completion/completions/treedyn)
  if(NOT EXISTS ${scratch}/second/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()
