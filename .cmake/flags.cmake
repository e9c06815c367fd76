# Warnings, sanitizers and floating-point rules, for our own targets only.
add_library(moontrace_flags INTERFACE)
# -Werror=switch, in every build: what handles each kind of a closed family has no default, so that a
# kind that is added stops the compiler wherever it is forgotten.
# -ffp-contract=off: replays are bit-equal, so no compiler may fuse a multiply and an add.
# The other two change no result: nobody reads errno after sqrt or traps on floating-point flags.
target_compile_options(moontrace_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror=switch -ffp-contract=off -fno-math-errno -fno-trapping-math
  $<$<BOOL:${MOONTRACE_WERROR}>:-Werror>)
if(MOONTRACE_SANITIZE)
  target_compile_options(moontrace_flags INTERFACE
    -fsanitize=${MOONTRACE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # Of the tests' own code only memory and threads are checked, and it guides no search: a third of it
  # remains, compiled in three quarters of the time.
  target_compile_options(moontrace_flags INTERFACE
    $<$<BOOL:$<TARGET_PROPERTY:MOONTRACE_IS_TEST>>:-fno-sanitize=undefined>)
  target_link_options(moontrace_flags INTERFACE -fsanitize=${MOONTRACE_SANITIZE})
  # The address sanitizer's tables hold two million addresses: where the program may lie anywhere, each
  # start moves them all, a third of a second for each test.
  if(MOONTRACE_SANITIZE MATCHES address)
    target_link_options(moontrace_flags INTERFACE $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)
  endif()
  # code of others' headers, a quarter of the time to build
  file(RELATIVE_PATH ignorelist ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/.ci/sanitizer.ignore)
  target_compile_options(moontrace_flags INTERFACE -fsanitize-ignorelist=${ignorelist})
endif()

# moontrace_room(<room> [FOLDER folder] [PUBLIC libraries...] [PRIVATE libraries...]): one leaf room, a
# target from every .cpp of the folder of its name. What a room may include is what it links, itself
# or through others' PUBLIC lines; a test holds every file to it (tests/rooms_test.sh).
function(moontrace_room room)
  cmake_parse_arguments(ARG "" "FOLDER" "PUBLIC;PRIVATE" ${ARGN})
  if(NOT ARG_FOLDER)
    set(ARG_FOLDER ${room})
  endif()
  cmake_path(SET folder NORMALIZE ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_FOLDER})
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  if(sources)
    add_library(moontrace_${room} STATIC ${sources})
    target_include_directories(moontrace_${room} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(moontrace_${room} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} moontrace_flags)
    # Of an inline function that stands in several objects the linker takes the first. In a program that
    # is not optimised itself (the tests) that must be the room's, or rooms run at a quarter of their speed.
    target_link_options(moontrace_${room} INTERFACE
      $<$<BOOL:$<TARGET_PROPERTY:MOONTRACE_IS_TEST>>:LINKER:--whole-archive,$<TARGET_FILE:moontrace_${room}>,--no-whole-archive>)
    # What most sources include is read once, where that pays: Clang compiles a source in a third less
    # time, GCC in hardly less. A missing #include is found by the builds without.
    list(LENGTH sources number)
    if(MOONTRACE_SANITIZE AND number GREATER 4)
      target_precompile_headers(moontrace_${room} PRIVATE <algorithm> <array> <atomic> <cmath> <functional> <map>
        <memory> <optional> <set> <span> <sstream> <string> <unordered_map> <variant> <vector>
        <glm/geometric.hpp> <glm/vec2.hpp> <glm/vec3.hpp>)
    endif()
  else()  # headers only
    add_library(moontrace_${room} INTERFACE)
    target_include_directories(moontrace_${room} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(moontrace_${room} INTERFACE ${ARG_PUBLIC})
  endif()
  add_library(moontrace::${room} ALIAS moontrace_${room})
  moontrace_allow(moontrace_${room} ${folder})
endfunction()

# moontrace_allow(<target> <folder>): notes what the sources of a folder may include.
function(moontrace_allow target folder)
  string(REGEX REPLACE "/$" "" folder ${folder})
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_property(GLOBAL APPEND PROPERTY moontrace_rooms
    "${target}|${folder}|$<TARGET_PROPERTY:${target},LINK_LIBRARIES>|$<TARGET_PROPERTY:${target},INTERFACE_LINK_LIBRARIES>")
endfunction()
