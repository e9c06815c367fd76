#!/usr/bin/env bash
# Runs ctest in a build tree: bash tests/run.sh PRESET [OPTION of ctest...]
# Where only tests fail that tests/flaky.txt lists, those get one second try, and are told.
set -u
cd "${0%/*}/.." || exit 1
preset=$1
shift
failed=build/$preset/Testing/Temporary/LastTestsFailed.log

# The reason for a second try of test $1, from the first pattern that fits its name.
reason() {
  local pattern why
  while read -r pattern why; do
    case $pattern in '' | '#'*) continue ;; esac
    [[ $1 =~ ^($pattern) ]] && printf '%s' "$why" && return
  done <tests/flaky.txt
  return 1
}

run() { ctest --preset "$preset" --no-tests=error --output-on-failure "$@"; }

rm -f "$failed"
run "$@"
status=$?
[ "$status" = 8 ] && [ -f "$failed" ] || exit "$status"  # 8: tests failed
mapfile -t names < <(sed 's/^[0-9]*://' "$failed")
told=()
for name in "${names[@]}"; do
  why=$(reason "$name") || exit "$status"
  told+=("second try: $name ($why)")
done
echo "a second try for ${#names[@]} that tests/flaky.txt lists"
run "$@" --rerun-failed || exit
printf '%s\n' "${told[@]}"
