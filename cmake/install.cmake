# What goes to a user's machine: program, library with header and package files, man page, completion; and a Debian package of it.
if(KEYBLOCK_FUZZ)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(pages ${PROJECT_BINARY_DIR}/pages)
add_custom_command(OUTPUT ${pages}/keyblock.1 ${pages}/keyblock
  COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}
  COMMAND keyblock shell man > ${pages}/keyblock.1
  COMMAND keyblock shell bash > ${pages}/keyblock
  DEPENDS keyblock VERBATIM)
add_custom_target(keyblock_pages ALL DEPENDS ${pages}/keyblock.1 ${pages}/keyblock)

install(TARGETS keyblock RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS keyblock_library EXPORT keyblock LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/keyblock DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES ${pages}/keyblock.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${pages}/keyblock DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/keyblock)
install(EXPORT keyblock NAMESPACE keyblock:: FILE keyblockConfig.cmake DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/keyblockConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/keyblockConfigVersion.cmake DESTINATION ${package})
file(RELATIVE_PATH KEYBLOCK_TO_PREFIX /p/${CMAKE_INSTALL_LIBDIR}/pkgconfig /p)
configure_file(${PROJECT_SOURCE_DIR}/cmake/keyblock.pc.in ${PROJECT_BINARY_DIR}/keyblock.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/keyblock.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(CPACK_PACKAGE_VENDOR "Keyblock")
set(CPACK_PACKAGE_CONTACT "the authors of Keyblock")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "discontinuous deformation analysis and numerical manifold method")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# CHOLMOD is loaded on demand, which the search for needed libraries does not see.
get_filename_component(cholmod_file ${CHOLMOD_LIBRARY} REALPATH)
execute_process(COMMAND dpkg-query --search ${cholmod_file} OUTPUT_VARIABLE cholmod_package ERROR_QUIET)
if(cholmod_package MATCHES "^([^:]+)")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS ${CMAKE_MATCH_1})
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Two packages: all of the above, and the Python package if its module is built (python/CMakeLists.txt).
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME keyblock)
if(TARGET keyblock_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DEPENDS Unspecified)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-keyblock)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "discontinuous deformation analysis and numerical manifold method in Python")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)  # its libraries are those of the other package
  set(CPACK_DEBIAN_PYTHON_PACKAGE_GENERATE_SHLIBS OFF)
  get_property(python_versions TARGET keyblock_python PROPERTY KEYBLOCK_PYTHON_VERSIONS)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${python_versions}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-matplotlib, python3-distributed")
endif()
set(CPACK_STRIP_FILES ON)
include(CPack)
