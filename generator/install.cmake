# cmake --install: the program, the templates, the CMake package and the licence.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/treedyn)
configure_package_config_file(${PROJECT_SOURCE_DIR}/templates/treedynConfig.cmake.in
                              ${CMAKE_CURRENT_BINARY_DIR}/treedynConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/treedynConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)  # it runs on the machine that builds

install(TARGETS treedyn RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/treedynConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/treedynConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/templates/treedynFunctions.cmake DESTINATION ${package_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/templates/ DESTINATION ${CMAKE_INSTALL_DATADIR}/treedyn/templates)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
