# Debian packages, under build/package: cmake --preset package && cmake --build --preset package &&
# cpack --preset package. Who makes them stands in DEBEMAIL and DEBFULLNAME, as for Debian's own tools.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME moontrace)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(maker "$ENV{DEBFULLNAME}")
set(maker_address "$ENV{DEBEMAIL}")
if(NOT maker)
  set(maker "The Moontrace developers")
endif()
if(NOT maker_address)
  set(maker_address moontrace@moontrace.invalid)
endif()
set(CPACK_PACKAGE_CONTACT "${maker} <${maker_address}>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL program data library development stepping stepping_development python perl doc)

# package(COMPONENT NAME SECTION SUMMARY DESCRIPTION): lines of the description end with a newline.
function(package component name section summary description)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  # what Debian asks of every package
  install(FILES ${package_folder}/copyright DESTINATION share/doc/${name} COMPONENT ${component})
  install(FILES ${package_folder}/changelog.gz DESTINATION share/doc/${name} COMPONENT ${component})
endfunction()

set(package_folder ${PROJECT_BINARY_DIR}/package)
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(.cmake/debian_changelog.in ${package_folder}/changelog @ONLY)
configure_file(.cmake/debian_copyright.in ${package_folder}/copyright @ONLY)
find_program(GZIP gzip REQUIRED)
execute_process(COMMAND ${GZIP} -9nkf changelog WORKING_DIRECTORY ${package_folder}
  COMMAND_ERROR_IS_FATAL ANY)
# what CPack would do by scripts
file(WRITE ${package_folder}/triggers "activate-noawait ldconfig\n")
file(WRITE ${package_folder}/shlibs "libmoontrace 0 libmoontrace0 (>= ${PROJECT_VERSION})\n")
file(CHMOD ${package_folder}/triggers ${package_folder}/shlibs
  PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${package_folder}/triggers ${package_folder}/shlibs)
# by the soname, libmoontrace-mujoco-VERSION.so.0: one for each MuJoCo can be installed
set(stepping_package libmoontrace-mujoco-${mujoco_VERSION}-0)
file(MAKE_DIRECTORY ${package_folder}/stepping)
file(WRITE ${package_folder}/stepping/shlibs
  "libmoontrace-mujoco-${mujoco_VERSION} 0 ${stepping_package} (>= ${PROJECT_VERSION})\n")
file(CHMOD ${package_folder}/stepping/shlibs PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
set(CPACK_DEBIAN_STEPPING_PACKAGE_CONTROL_EXTRA ${package_folder}/triggers ${package_folder}/stepping/shlibs)

package(program moontrace misc "learn and read Moon, the raised script, by touch"
"Moon is a script of raised lines and curves for people who go blind late.
This program engraves Moon, Braille and other scripts as texture fields that a
force-feedback device lets you feel: lessons, books, labels on MuJoCo models,
studies with simulated learners, and swell paper. Everything is said in plain
lines, made for screen readers.")
package(data moontrace-data misc "scripts, lessons, device profiles and models of Moontrace"
"Data that the program moontrace and the library libmoontrace0 read: scripts as
strokes, courses, profiles of haptic devices, and sample MuJoCo models.")
package(library libmoontrace0 libs "tactile text as a texture field, shared library"
"The library sets a text on pages in Moon or another tactile script and answers
what a tip would feel there: displacement, gradient and force at one point or
at many. It needs neither MuJoCo nor a device.")
package(development libmoontrace-dev libdevel "tactile text as a texture field, for developers"
"Headers for C and C++, a file for pkg-config, one for CMake's find_package, and
examples: programs that use libmoontrace0.")
package(stepping ${stepping_package} libs "tactile text on models of MuJoCo ${mujoco_VERSION}, shared library"
"For programs that have a MuJoCo ${mujoco_VERSION} of their own: the library steps their
model with the force of the text on it, traces the text by a simulated hand,
records and scores. Another MuJoCo takes the library of its version.")
package(stepping_development libmoontrace-mujoco-${mujoco_VERSION}-dev libdevel
"tactile text on models of MuJoCo ${mujoco_VERSION}, for developers"
"What programs that use ${stepping_package} are linked with: files for
pkg-config and for CMake's find_package. Headers are in libmoontrace-dev.")
package(python python3-moontrace python "tactile text as a texture field, for Python"
"A module over libmoontrace0: pages of Moon as height maps, and the forces along
a path, as arrays of NumPy.")
package(perl libmoontrace-perl perl "tactile text as a texture field, for Perl"
"A module over libmoontrace0, by FFI::Platypus: pages of Moon, their letters,
and what a tip would feel there.")
package(doc moontrace-doc doc "manual of Moontrace"
"The manual as pages of HTML: for learners, tutors, researchers, builders of
devices, and programmers.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(same "(= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "moontrace-data ${same}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-dejavu-core, libgl1-mesa-dri, liblouis-data, hyphen-en-us")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "moontrace-doc")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "moontrace-data ${same}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libmoontrace0 ${same}")
set(CPACK_DEBIAN_STEPPING_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_STEPPING_PACKAGE_DEPENDS "moontrace-data ${same}")
set(CPACK_DEBIAN_STEPPING_DEVELOPMENT_PACKAGE_DEPENDS
  "${stepping_package} ${same}, libmoontrace-dev ${same}, libmujoco-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, libmoontrace0 ${same}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-numpy")
set(CPACK_DEBIAN_PERL_PACKAGE_DEPENDS "perl, libffi-platypus-perl, libmoontrace0 ${same}")
foreach(independent DATA PYTHON PERL DOC)
  set(CPACK_DEBIAN_${independent}_PACKAGE_ARCHITECTURE all)
endforeach()
include(CPack)
