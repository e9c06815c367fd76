#!/usr/bin/env bash
# What only the real program can show: signals that the system sends to whoever cannot write.
# Usage: program_test.sh MOONTRACE
set -u
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

expect() {  # expect WHAT CONDITION...
  local what=$1
  shift
  if "$@"; then return; fi
  printf 'FAILED: %s; exit code %s\n' "$what" "$code"
  sed 's/^/  said: /' "$work/said"
  failures=$((failures + 1))
}
code_is() { [ "$code" = "$1" ]; }
one_line() { [ "$(wc -l <"$work/said")" = 1 ]; }
silent() { [ ! -s "$work/said" ]; }
nothing_left() { [ -z "$(ls "$work/out")" ]; }

limited() {  # limited KIB ARGUMENT...: runs the program, which may write files of so many at most
  local kib=$1
  shift
  rm -rf "$work/out"
  mkdir "$work/out"
  (
    ulimit -f "$kib"
    exec "$program" "$@" 2>"$work/said" >/dev/null
  )
  code=$?
}

limited 64 trace IT --record "$work/out/record"  # about 1 MB of samples
expect 'a record beyond the limit lacks room' code_is 4
expect 'a record beyond the limit gives one line' one_line
expect 'a record beyond the limit leaves nothing' nothing_left

limited 1 page "THE QUICK BROWN FOX" --picture "$work/out/page.svg"
expect 'a picture beyond the limit lacks room' code_is 4
expect 'a picture beyond the limit gives one line' one_line
expect 'a picture beyond the limit leaves nothing' nothing_left

# What is to be typed begins as the program was called, which the launcher tells.
called() { grep -q "^$1 demo: " "$work/said" && ! grep -q "^moontrace $2" "$work/said"; }
MOONTRACE_CALLED=./moontrace "$program" >"$work/said" 2>&1
code=$?
expect 'through the launcher its lines name the launcher' called ./moontrace .
"$program" >"$work/said" 2>&1
code=$?
expect 'by itself they name the program' called moontrace nothing

mkfifo "$work/pipe"
exec 3<>"$work/pipe" 4>"$work/pipe" 3>&-  # a pipe that nobody reads
"$program" page IT >&4 2>"$work/said"
code=$?
expect 'a pipe that nobody reads ends it by the code for that' code_is 141
expect 'a pipe that nobody reads is nothing to complain of' silent
mkfifo "$work/open"
exec 5<>"$work/open"  # input that goes on
for command in 'loop moon --seconds 60' 'loop moon' 'learn --device simulated' 'help --markdown'; do
  timeout 30 "$program" $command >&4 2>"$work/said" <&5
  code=$?
  expect "nobody reads: $command" code_is 141
  sed -i '/^To say a word/d; /^The force may/d' "$work/said"  # before it could know
  expect "nobody reads, nothing is said: $command" silent
done
exec 4>&- 5>&-

# Input that has ended ends the loop, and what reads it may leave.
timeout 30 "$program" loop moon </dev/null 2>"$work/said" | head -1 >"$work/first"
code=${PIPESTATUS[0]}
expect 'the first line has come' grep -q 'On the page: moon' "$work/first"
ended_or_left() { [ "$code" = 0 ] || [ "$code" = 141 ]; }
expect 'a loop without input ends' ended_or_left

# A stop request while nobody writes into the pipe that is to be read.
"$program" page --file "$work/pipe" >/dev/null 2>"$work/said" &
reader=$!
catches_term() { (((0x$(awk '/^SigCgt/ {print $2}' "/proc/$reader/status") >> 14) & 1)); }
for _ in {1..100}; do
  sleep 0.1
  catches_term && break
done
sleep 0.5  # from there to the pipe
kill -TERM "$reader"
for _ in {1..100}; do
  kill -0 "$reader" 2>/dev/null || break
  sleep 0.1
done
kill -KILL "$reader" 2>/dev/null
wait "$reader"
code=$?
expect 'a stop request ends a wait for a pipe' code_is 130
expect 'a stop request gives one line' one_line

# A stop request while a device is being pushed (an emulated joystick, tests/devices/fake).
yes | MOONTRACE_FAKE_HID=pid MOONTRACE_FAKE_LOG=$work/forces \
  "$program" devices test openffboard >/dev/null 2>"$work/said" &
tester=$!
pushes() { awk '$3 == "force" && ($4 != 0 || $5 != 0) {found = 1} END {exit !found}' "$work/forces"; }
last_is_zero() {
  awk '$3 == "force" {force = $4 " " $5} END {exit !(force == "" || force + 0 == 0)}' "$work/forces"
}
for _ in {1..300}; do
  sleep 0.1
  [ -e "$work/forces" ] && pushes && break
done
kill -TERM "$tester"
wait "$tester"
code=$?
expect 'the joystick was pushed' pushes
expect 'a stop request ends a push' code_is 130
expect 'a stop request leaves no force' last_is_zero

# The same while the loop runs: the last force that the joystick is given is zero.
MOONTRACE_FAKE_HID=pid MOONTRACE_FAKE_LOG=$work/loop_forces \
  "$program" loop MOON --device openffboard --size-mm 6 --seconds 120 \
  >/dev/null 2>"$work/said" </dev/null &
looper=$!
mv "$work/forces" "$work/test_forces" 2>/dev/null
for _ in {1..300}; do
  sleep 0.1
  [ -e "$work/loop_forces" ] || continue
  cp "$work/loop_forces" "$work/forces"
  pushes && break
done
kill -TERM "$looper"
wait "$looper"
code=$?
cp "$work/loop_forces" "$work/forces"
expect 'the loop pushed the joystick' pushes
expect 'a stop request ends the loop' code_is 130
expect 'a stopped loop leaves no force' last_is_zero

[ "$failures" = 0 ]
