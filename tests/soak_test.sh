#!/usr/bin/env bash
# The loop for ten minutes with the simulated stylus (20 s where CI is set): it goes on to the end,
# is felt, and nothing that safety watches for has come about. How late it was depends on the
# machine: the figures are printed, not judged.
# Usage: soak_test.sh MOONTRACE
set -u
seconds=600
[ -n "${CI:-}" ] && seconds=20
said=$("$1" loop --seconds "$seconds" --json 2>/dev/null </dev/null) || {
  printf 'FAILED: exit code %s\n' "$?"
  exit 1
}
printf '%s\n' "$said"
number() { sed -n "s/.*\"$1\":\([0-9.e+-]*\).*/\1/p" <<<"$said"; }
failures=0
expect() {  # expect WHAT AWK-CONDITION
  awk "BEGIN { exit !($2) }" && return
  printf 'FAILED: %s\n' "$1"
  failures=1
}
expect 'every period is a tick or counted as lost' \
  "$(number ticks) + $(number lost_ticks) >= 1000 * $seconds - 100"
expect 'the page is felt' "$(number touching) > 0.1 && $(number mean_force_n) > 0.1"
expect 'no sample is dropped' "$(number samples_dropped) == 0"
for what in not_a_number jump power_cap silence device_lost not_ready physics_fault stopped; do
  expect "no $what" "$(number "$what") == 0"
done
exit "$failures"
