# Warnings, sanitizers and floating-point rules, for our own targets only.
add_library(moontrace_flags INTERFACE)
# -ffp-contract=off: replays are bit-equal, so no compiler may fuse a multiply and an add.
# The other two change no result: nobody reads errno after sqrt or traps on floating-point flags.
target_compile_options(moontrace_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off -fno-math-errno -fno-trapping-math
  $<$<BOOL:${MOONTRACE_WERROR}>:-Werror>)
if(MOONTRACE_SANITIZE)
  target_compile_options(moontrace_flags INTERFACE
    -fsanitize=${MOONTRACE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(moontrace_flags INTERFACE -fsanitize=${MOONTRACE_SANITIZE})
  # code of others' headers, a quarter of the time to build
  file(RELATIVE_PATH ignorelist ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/.ci/sanitizer.ignore)
  target_compile_options(moontrace_flags INTERFACE -fsanitize-ignorelist=${ignorelist})
endif()

# moontrace_room(<room> [PUBLIC libraries...] [PRIVATE libraries...]): one target for one room,
# from every .cpp below it. What a room may use is what it links; nothing else is found.
function(moontrace_room room)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE;EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(pattern IN LISTS ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  add_library(moontrace_${room} STATIC ${sources})
  add_library(moontrace::${room} ALIAS moontrace_${room})
  target_include_directories(moontrace_${room} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(moontrace_${room} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} moontrace_flags)
endfunction()
