# cmake --install: the program, the templates, the CMake package, manual page, completion, documents, models and the licence; `cpack`,
# with dpkg-dev, packs the same as a Debian package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/treedyn)
configure_package_config_file(${PROJECT_SOURCE_DIR}/templates/treedynConfig.cmake.in
                              ${CMAKE_CURRENT_BINARY_DIR}/treedynConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/treedynConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)  # it runs on the machine that builds

# Manual page and completion are the program's own words; where it does not run on this machine there are none.
if(NOT CMAKE_CROSSCOMPILING)
  foreach(page man bash)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/treedyn.${page})
    add_custom_command(OUTPUT ${file} COMMAND treedyn pages ${page} > ${file} DEPENDS treedyn VERBATIM)
    list(APPEND pages ${file})
  endforeach()
  add_custom_target(treedyn_pages ALL DEPENDS ${pages})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/treedyn.man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME treedyn.1)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/treedyn.bash
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME treedyn)
endif()

install(TARGETS treedyn RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/treedynConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/treedynConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/templates/treedynFunctions.cmake DESTINATION ${package_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/templates/ DESTINATION ${CMAKE_INSTALL_DATADIR}/treedyn/templates)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# On their paths of the source tree, so that links between them lead somewhere.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/data/hard_cases DESTINATION ${CMAKE_INSTALL_DOCDIR}/tests/data)
foreach(document IN ITEMS
        generator/cli/INTERFACE.md generator/equations/EQUATIONS.md generator/accuracy/core.cpp
        generator/emit/taken_names.cpp generated/README.md templates/treedynFunctions.cmake
        tests/benchmark/results/firmware.md tests/benchmark/results/lanes.md)
  cmake_path(GET document PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${document} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "treedyn maintainers")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # versions of the libraries
# Without dpkg-dev CPack would make a package that depends on nothing; folders that it makes are as closed as the umask says.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/before_cpack.cmake [[
  find_program(shlibdeps dpkg-shlibdeps)
  if(CPACK_GENERATOR STREQUAL "DEB" AND NOT shlibdeps)
    message(FATAL_ERROR "cpack: there is no dpkg-shlibdeps, which finds what the program needs; expected the package dpkg-dev")
  endif()
  file(CHMOD_RECURSE ${CPACK_TEMPORARY_INSTALL_DIRECTORY} DIRECTORY_PERMISSIONS
       OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
]])
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_BINARY_DIR}/before_cpack.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_STRIP_FILES ON)
include(CPack)
