# The manual page and bash's completion are made of the program's own help once it is built, the
# manual in HTML of the README files, if cmark-gfm is there.
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${manual_folder})
add_custom_command(OUTPUT ${manual_folder}/moontrace.1.gz ${manual_folder}/moontrace.bash
  COMMAND moontrace help --man >${manual_folder}/moontrace.1
  COMMAND gzip -9nf ${manual_folder}/moontrace.1
  COMMAND moontrace help --bash >${manual_folder}/moontrace.bash
  DEPENDS moontrace)
add_custom_target(moontrace_manual ALL DEPENDS ${manual_folder}/moontrace.1.gz)
install(FILES ${manual_folder}/moontrace.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${manual_folder}/moontrace.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME moontrace)
install(FILES .cmake/moontrace.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)

if(NOT CMARK)
  return()
endif()
set(html_folder ${manual_folder}/html)
foreach(page README CHANGELOG CONTRIBUTING textures/README devices/README devices/raw_protocol
    lessons/README sim/README sim/OPTIONS sim/library/README models/README tests/README)
  cmake_path(GET page PARENT_PATH folder)
  string(REGEX REPLACE "[^/]+" ".." up "${folder}")
  if(up)
    string(APPEND up /)
  endif()
  add_custom_command(OUTPUT ${html_folder}/${page}.html
    COMMAND ${CMAKE_COMMAND} -DCMARK=${CMARK} -DFROM=${page}.md -DROOT=${up}
      -DTO=${html_folder}/${page}.html -P .cmake/html_page.cmake
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DEPENDS ${page}.md .cmake/html_page.cmake VERBATIM)
  list(APPEND html_pages ${html_folder}/${page}.html)
endforeach()
add_custom_target(moontrace_html_manual ALL DEPENDS ${html_pages})
set(html_destination ${CMAKE_INSTALL_DOCDIR}/html)
install(DIRECTORY ${html_folder}/ DESTINATION ${html_destination} COMPONENT doc)
install(DIRECTORY models/pictures DESTINATION ${html_destination}/models COMPONENT doc
  FILES_MATCHING PATTERN *.png)
