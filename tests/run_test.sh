#!/usr/bin/env bash
# tests/run.sh against a made-up ctest: what gets a second try.
# Usage: run_test.sh SOURCE-FOLDER
set -u
source=$(cd "$1" && pwd) || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
mkdir -p "$work"/{bin,tests}
cp "$source/tests/run.sh" "$work/tests/"
printf '# a comment\n\nClocked\\. a busy machine is felt\n' >"$work/tests/flaky.txt"

# It fails the tests of $FAIL; where they are run again, those of $FAIL_AGAIN.
cat >"$work/bin/ctest" <<'TOOL'
#!/usr/bin/env bash
echo "ctest $*" >>calls
failing=$FAIL
case $* in *--rerun-failed*) failing=$FAIL_AGAIN ;; esac
mkdir -p build/some/Testing/Temporary
[ -z "$failing" ] && exit "${CODE:-0}"
printf '%s\n' $failing | sed 's/^/7:/' >build/some/Testing/Temporary/LastTestsFailed.log
exit 8
TOOL
chmod +x "$work/bin/ctest"

try() {  # try FAILING FAILING-AGAIN
  rm -f "$work/calls"
  said=$(FAIL=$1 FAIL_AGAIN=$2 PATH=$work/bin:$PATH bash "$work/tests/run.sh" some -L quick)
  code=$?
}
expect() {  # expect WHAT CONDITION...
  local what=$1
  shift
  if "$@"; then return; fi
  printf 'FAILED: %s; exit code %s, said: %s\n' "$what" "$code" "$said"
  failures=$((failures + 1))
}
code_is() { [ "$code" = "$1" ]; }
runs_are() { [ "$(wc -l <"$work/calls")" = "$1" ]; }
says() { grep -qF -- "$1" <<<"$said"; }

try '' ''
expect 'what passes runs once' runs_are 1
expect 'what passes ends with 0' code_is 0
expect 'options reach ctest' grep -q -- '--preset some .*-L quick' "$work/calls"

try Sad.Test ''
expect 'a test that is not listed has no second try' runs_are 1
expect 'a test that is not listed fails' code_is 8

try 'Clocked.Late Sad.Test' ''
expect 'beside one that is not listed there is no second try' runs_are 1
expect 'one that is not listed fails all' code_is 8

try 'Clocked.Late Clocked.Too' ''
expect 'listed tests have a second try' runs_are 2
expect 'a second try that passes ends with 0' code_is 0
expect 'a second try is told with its reason' says 'second try: Clocked.Too (a busy machine is felt)'

try Clocked.Late Clocked.Late
expect 'there is no third try' runs_are 2
expect 'a second try that fails ends with 8' code_is 8

try NotClocked.Late ''
expect 'a pattern fits the beginning of a name only' code_is 8

CODE=1 try '' ''
expect 'a failure of ctest itself passes through' code_is 1

[ "$failures" = 0 ] && printf 'all expectations of the second try hold\n'
exit $((failures > 0))
