# cmake --install: the program with its man page, the libraries of the house, their headers, and the package that find_package(pencil) finds.
# A user links pencil::render, and a reader of scenes.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY PENCIL_LIBRARIES)
list(REMOVE_ITEM libraries pencil_app)
install(TARGETS pencil)
install(TARGETS pencil_shared ${libraries} EXPORT pencil ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/pencil)
install(DIRECTORY host/ DESTINATION include/pencil FILES_MATCHING PATTERN "*.h" PATTERN "app" EXCLUDE)
install(DIRECTORY kernels/shared DESTINATION include/pencil FILES_MATCHING PATTERN "*.h")

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/pencil)
install(EXPORT pencil NAMESPACE pencil:: FILE pencilTargets.cmake DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/pencilConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/pencilConfig.cmake ${CMAKE_BINARY_DIR}/pencilConfigVersion.cmake DESTINATION ${package})

# The man page is the program's own table of options.
add_custom_command(TARGET pencil POST_BUILD COMMAND pencil document man > ${CMAKE_BINARY_DIR}/pencil.1 VERBATIM)
install(FILES ${CMAKE_BINARY_DIR}/pencil.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
