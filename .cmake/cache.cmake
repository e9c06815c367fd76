# A compiler cache, where there is one, that also serves clones in other folders: paths below the tree
# are made relative before they are looked up and in what is compiled, debug information included.
find_program(CCACHE ccache)
if(NOT CCACHE)
  return()
endif()
set(cache_launcher ${CMAKE_COMMAND} -E env
  CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_COMPILERCHECK=content
  CCACHE_EXTRAFILES=${PROJECT_SOURCE_DIR}/.ci/sanitizer.ignore
  # A message's language changes no object; the other two are what a precompiled header needs.
  CCACHE_SLOPPINESS=locale,pch_defines,time_macros
  ${CCACHE})
set(CMAKE_C_COMPILER_LAUNCHER ${cache_launcher})
set(CMAKE_CXX_COMPILER_LAUNCHER ${cache_launcher})
file(RELATIVE_PATH up ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -ffile-prefix-map=${up}=)
# Clang's precompiled headers hold the folder's path, but at least not the time at which they were made.
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  list(APPEND CMAKE_CXX_COMPILE_OPTIONS_CREATE_PCH -Xclang -fno-pch-timestamp)
endif()
