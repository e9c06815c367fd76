#!/usr/bin/env bash
# Writes a program's tests for ctest, a suite together: bash tests/suites.sh PROGRAM LIBRARIES >FILE
# A sanitizer's start and its search for leaks take longer than most tests. By itself stays what
# flaky.txt lists, which has a second try, what .ci/run leaves out by a test's own name, and what takes
# so long that two processors share it.
set -euo pipefail
program=$1 libraries=$2
alone='Kill|NoNetwork|^(IoFault|Reading)[.]'
while read -r pattern _; do
  case $pattern in '' | '#'*) ;; *) alone+="|^$pattern" ;; esac
done <"${0%/*}/flaky.txt"

"$program" --gtest_list_tests | alone=$alone awk -v program="$program" -v libraries="$libraries" '
  function add(name, filter) {
    printf "add_test([==[%s]==] [==[%s]==] [==[--gtest_filter=%s]==])\n", name, program, filter
    printf "set_tests_properties([==[%s]==] PROPERTIES LABELS %s", name, name ~ /(^|\/)Slow/ ? "slow" : "quick"
    printf " ENVIRONMENT_MODIFICATION [==[LD_LIBRARY_PATH=path_list_prepend:%s]==])\n", libraries
  }
  function end_suite() {
    if (together > 0) add(suite "*", suite "*" (apart == "" ? "" : "-" substr(apart, 2)))
    together = 0
    apart = ""
  }
  { sub(/ +#.*/, "") }  # parameters
  /^[^ ]/ { end_suite(); suite = $1; next }
  {
    test = suite $1
    if (test ~ ENVIRON["alone"]) { add(test, test); apart = apart ":" test } else ++together
  }
  END { end_suite() }'
