# The manual page and bash's completion are made of the program's own help once it is built.
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${manual_folder})
add_custom_command(OUTPUT ${manual_folder}/moontrace.1 ${manual_folder}/moontrace.bash
  COMMAND moontrace help --man >${manual_folder}/moontrace.1
  COMMAND moontrace help --bash >${manual_folder}/moontrace.bash
  DEPENDS moontrace)
add_custom_target(moontrace_manual ALL DEPENDS ${manual_folder}/moontrace.1)
install(FILES ${manual_folder}/moontrace.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${manual_folder}/moontrace.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME moontrace)
install(FILES .cmake/moontrace.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
