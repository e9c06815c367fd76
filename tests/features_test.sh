#!/usr/bin/env bash
# Each optional library that was found is used by the program: a definition that no longer reaches its file
# would leave the feature out in silence.
#   features_test.sh PROGRAM LIBRARY...    the libraries that were found, as CMake names them
set -euo pipefail
program=$1
shift
declare -A function_of=([cairo]=cairo_create [hidapi]=hid_enumerate [louis]=lou_translate
  [portaudio]=Pa_OpenStream [sqlite]=sqlite3_prepare_v2 [egl]=eglInitialize [imgui]=ImGui [glfw]=glfwInit
  [hyphen]=hnj_hyphen_load [gumbo]=gumbo_parse_with_options [libzip]=zip_open_from_source)
for library in "$@"; do
  name=${function_of[$library]:?$library: no function of it is known here}
  grep -qa "$name" "$program" || { echo "$library was found, but $program does not call $name"; exit 1; }
done
echo "used: $*"
