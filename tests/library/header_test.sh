#!/usr/bin/env bash
# The headers, alone and beside that of plug-ins, are clean C99 and C++20; the one for MuJoCo also
# without MuJoCo's own.
#   header_test.sh C_COMPILER CXX_COMPILER SOURCE_TREE
set -euo pipefail
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only)
both='#include "moontrace.h"
#include "moontrace_device.h"
#include "moontrace.h"
#include "moontrace_mujoco.h"
int first(void);
int first(void) { return (int)(moontrace_check(MOONTRACE_INTERFACE) + MOONTRACE_DONE + MOONTRACE_WRONG_MUJOCO); }'
folders=(-I "$3/sim/library" -I "$3/sim/library/stepping" -I "$3/devices")
"$1" -x c -std=c99 "${warnings[@]}" -Wstrict-prototypes "${folders[@]}" - <<<"$both"
"$2" -x c++ -std=c++20 "${warnings[@]}" "${folders[@]}" - <<<"${both/(void);/();}"
"$1" -x c -std=c99 "${warnings[@]}" "${folders[@]}" - <<<'#include "moontrace_mujoco.h"'
for wrapper in moontrace.hpp moontrace_mujoco.hpp; do
  "$2" -x c++ -std=c++17 "${warnings[@]}" "${folders[@]}" - <<<"#include \"$wrapper\""
done
