#!/usr/bin/env bash
# The header, alone and beside that of plug-ins, is clean C99 and C++20.
#   header_test.sh C_COMPILER CXX_COMPILER SOURCE_TREE
set -euo pipefail
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only)
both='#include "moontrace.h"
#include "moontrace_device.h"
#include "moontrace.h"
int first(void);
int first(void) { return (int)(moontrace_check(MOONTRACE_INTERFACE) + MOONTRACE_DONE); }'
folders=(-I "$3/sim/library" -I "$3/devices")
"$1" -x c -std=c99 "${warnings[@]}" -Wstrict-prototypes "${folders[@]}" - <<<"$both"
"$2" -x c++ -std=c++20 "${warnings[@]}" "${folders[@]}" - <<<"${both/(void);/();}"
