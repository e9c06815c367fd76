#!/usr/bin/env bash
# A bounded search: bash search.sh TARGET SEEDS SECONDS. From the kept seeds and a fixed start, so many
# runs and no longer than that; what it makes on the way is thrown away. An input that breaks
# something is shown, so that it can be kept wherever the search ran.
set -u
target=$1 seeds=$2 seconds=$3
found=$(mktemp -d) || exit 1
trap 'rm -rf "$found"' EXIT
mkdir "$found/corpus" "$found/broken"
"$target" -seed=1 -runs=100000 -max_total_time="$seconds" -timeout=25 -rss_limit_mb=2048 -verbosity=0 \
  -print_final_stats=1 -artifact_prefix="$found/broken/" "$found/corpus" "$seeds"
status=$?
for input in "$found"/broken/*; do
  [ -f "$input" ] || continue
  printf 'keep this in %s: base64 -d >NAME <<<%s\n' "$seeds" "$(base64 -w 0 "$input")"
done
exit "$status"
