# cmake --install, and find_package(blysk) for other projects.
include(CMakePackageConfigHelpers)
set(BLYSK_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/blysk)

install(TARGETS blysk EXPORT blysk-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/blysk DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT blysk-targets NAMESPACE blysk:: DESTINATION ${BLYSK_CONFIG_DIR})
configure_package_config_file(cmake/blysk-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/blysk-config.cmake
  INSTALL_DESTINATION ${BLYSK_CONFIG_DIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/blysk-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/blysk-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/blysk-config-version.cmake
  cmake/FindDeflate.cmake cmake/FindPng16.cmake DESTINATION ${BLYSK_CONFIG_DIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET blysk_command)
  install(TARGETS blysk_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
