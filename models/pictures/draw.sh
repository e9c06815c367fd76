#!/usr/bin/env bash
# Draws the pictures of the READMEs, without a display: draw.sh PROGRAM, where
# PROGRAM is the built moontrace.
set -euo pipefail
program=$(realpath "${1:?the program, build/release/sim/moontrace}")
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$program" view abcdefghijklmnopqrstuvwxyz --line-pitch-mm 25 --picture "$here/alphabet.png"
"$program" view 'The moon is bright tonight, and the sea is still.' \
  --size-mm 10 --line-pitch-mm 20 --seconds 16 --picture "$here/page.png"

# The models with labels. What each shows is said as well, and stands in models/README.md.
models=$(dirname "$here")
for model in sign mug globe dice door panel; do
  "$program" view --model "$models/$model.xml" --width-px 640 --picture "$here/$model.png"
done
"$program" view --model "$models/mug.xml" --seconds 11.5 --width-px 680 --picture "$here/mug-traced.png"

# A lesson, some seconds of it: a tutor goes to the first letters, and gives help.
export XDG_RUNTIME_DIR=$work
"$program" learn --device simulated --learner anna --records "$work/records.sqlite" --tutor \
  --frames "$work/frames" --seconds 24 < <(sleep 1; echo n; sleep 40) &
lesson=$!
until [ -S "$work/moontrace/tutor-anna.sock" ]; do sleep 0.2; done
(echo 'lesson 05'; sleep 2; echo 'size 30'
 sleep 1; echo 'help 6'; echo 'mode rail'; sleep 1; echo 'depth 120 %'; sleep 20) |
  "$program" tutor --learner anna > "$work/tutor.txt" || true
wait "$lesson"
# of the last seconds, but not the very end, the picture with the most on it
cd "$work/frames"
cp "$(printf '%s\n' *.png | tail -180 | head -150 | xargs ls -S | head -1)" "$here/lesson.png"
