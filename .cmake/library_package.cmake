# The shared library for other programs: find_package(moontrace) and pkg-config. Only it is exported,
# none of the rooms. Both files may be moved with all that is installed.
include(CMakePackageConfigHelpers)
install(TARGETS moontrace_shared EXPORT moontrace
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(FILES sim/library/moontrace.h sim/library/moontrace.hpp TYPE INCLUDE COMPONENT development)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/moontrace)
install(EXPORT moontrace NAMESPACE moontrace:: FILE moontraceConfig.cmake
  DESTINATION ${package_folder} COMPONENT development)
# As long as the soname is 0, whoever was made for an earlier version is served.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/moontraceConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/moontraceConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)

set(pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH up_to_prefix /${pkgconfig_folder} /)
string(REGEX REPLACE "/$" "" up_to_prefix ${up_to_prefix})
configure_file(.cmake/moontrace.pc.in moontrace.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/moontrace.pc DESTINATION ${pkgconfig_folder} COMPONENT development)

# Where Debian's Python and Perl look below /usr.
install(FILES sim/library/python/moontrace.py DESTINATION lib/python3/dist-packages COMPONENT python)
install(FILES sim/library/perl/Moontrace.pm DESTINATION share/perl5 COMPONENT perl)
install(DIRECTORY tests/library/consumers/ COMPONENT development
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libmoontrace-dev/examples)
