# The shared libraries for other programs: find_package(moontrace) and pkg-config. Only they are
# exported, none of the rooms. All files may be moved with what is installed. Those of the library for
# a MuJoCo have its version in their names, so that several can be installed.
include(CMakePackageConfigHelpers)
install(TARGETS moontrace_shared EXPORT moontrace
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(TARGETS moontrace_stepping_shared EXPORT moontrace_mujoco
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT stepping NAMELINK_COMPONENT stepping_development)
install(FILES sim/library/moontrace.h sim/library/moontrace.hpp sim/library/stepping/moontrace_mujoco.h
  sim/library/stepping/moontrace_mujoco.hpp TYPE INCLUDE COMPONENT development)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/moontrace)
install(EXPORT moontrace NAMESPACE moontrace:: FILE moontraceTargets.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(EXPORT moontrace_mujoco NAMESPACE moontrace:: FILE moontrace-mujoco-${mujoco_VERSION}.cmake
  DESTINATION ${package_folder} COMPONENT stepping_development)
install(FILES .cmake/moontraceConfig.cmake DESTINATION ${package_folder} COMPONENT development)
# As long as the soname is 0, whoever was made for an earlier version is served.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/moontraceConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/moontraceConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)

set(pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH up_to_prefix /${pkgconfig_folder} /)
string(REGEX REPLACE "/$" "" up_to_prefix ${up_to_prefix})
configure_file(.cmake/moontrace.pc.in moontrace.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/moontrace.pc DESTINATION ${pkgconfig_folder} COMPONENT development)
set(stepping_pc ${PROJECT_BINARY_DIR}/moontrace-mujoco-${mujoco_VERSION}.pc)
configure_file(.cmake/moontrace_mujoco.pc.in ${stepping_pc} @ONLY)
install(FILES ${stepping_pc} DESTINATION ${pkgconfig_folder} COMPONENT stepping_development)

# Where Debian's Python and Perl look below /usr.
install(FILES sim/library/python/moontrace.py DESTINATION lib/python3/dist-packages COMPONENT python)
install(FILES sim/library/perl/Moontrace.pm DESTINATION share/perl5 COMPONENT perl)
install(DIRECTORY tests/library/consumers/ COMPONENT development
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libmoontrace-dev/examples)
install(FILES models/proxy.xml COMPONENT development
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libmoontrace-dev/examples)
