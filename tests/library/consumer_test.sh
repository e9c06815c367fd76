#!/usr/bin/env bash
# The library as it is installed, in any folder: programs of others find, compile and run it, with its
# own data.
#   consumer_test.sh CMAKE BUILD_TREE SOURCE_TREE C_COMPILER CXX_COMPILER MUJOCO_VERSION MUJOCO_CONFIG_FOLDER
set -euo pipefail
cmake=$1 build=$2 consumers=$3/tests/library/consumers c=$4 cxx=$5 mujoco=$6 mujoco_folder=$7
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { printf '%s\n' "$@"; exit 1; }

for part in library development stepping stepping_development data python perl; do
  "$cmake" --install "$build" --prefix "$folder/first" --component "$part" >"$folder/log"
done
mv "$folder/first" "$folder/prefix"  # it may be moved
prefix=$folder/prefix
# which data are read: these, not those of the source tree
sed -i 's/^title = .*/title = "Installed Moon"/' "$prefix/share/moontrace/textures/scripts/moon.toml"

# what belongs to one version of MuJoCo has it in its name, so that several lie side by side
"$cmake" --install "$build" --prefix "$folder/one" --component stepping >"$folder/log"
"$cmake" --install "$build" --prefix "$folder/one" --component stepping_development >"$folder/log"
unnamed=$(find "$folder/one" ! -type d ! -name "*moontrace-mujoco-$mujoco*")
[ -z "$unnamed" ] || fail 'without the version of MuJoCo in their names:' "$unnamed"

# nothing but the libraries is offered
mapfile -t offered < <(find "$prefix" -name '*.a' -o -name '*.h' -o -name '*.hpp' | sort)
[ "${#offered[@]}" = 4 ] || fail 'offered:' "${offered[@]}"
config=$(dirname "$(find "$prefix" -name moontraceConfig.cmake)")
grep -ho 'add_library(moontrace::[^ ]* SHARED' "$config"/*.cmake | sort -u >"$folder/targets"
printf 'add_library(moontrace::%s SHARED\n' moontrace "mujoco-$mujoco" | diff - "$folder/targets" || fail 'other targets are offered'

# C++ by find_package
"$cmake" -S "$consumers/cpp" -B "$folder/cpp" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$cxx" \
  -DCMAKE_BUILD_TYPE=Debug >"$folder/log" 2>&1 && "$cmake" --build "$folder/cpp" >>"$folder/log" 2>&1 || fail "$(cat "$folder/log")"
said=$("$folder/cpp/consumer" "$folder/i.svg") || fail "the consumer in C++ ended with $?"
# half of a groove 0.1165 em wide of letters 20 mm high is 1.165 mm; points are 0.1 mm apart
grep -qE '^Installed Moon: i, 1\.1[0-9] mm deep$' <<<"$said" || fail "$said"
grep -q '<svg' "$folder/i.svg" || fail 'no picture'

# C by pkg-config
pc=$(dirname "$(find "$prefix" -name moontrace.pc)")
flags=$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs moontrace)
# shellcheck disable=SC2086  # several words
"$c" -std=c99 -Wall -Wextra -Wpedantic -Werror "$consumers/c/consumer.c" -o "$folder/c" $flags
library=$(dirname "$(find "$prefix" -name 'libmoontrace.so.0')")
said=$(LD_LIBRARY_PATH=$library "$folder/c") || fail "the consumer in C ended with $?"
[ "$(sed 's/ at.*//' <<<"$said" | tr '\n' ' ')" = 'Installed Moon m o o n ' ] || fail "$said"
# programs with a MuJoCo of their own
mkdir "$folder/model"
cp "$prefix/share/doc/libmoontrace-dev/examples/"*.xml "$folder/model"
"$cmake" -S "$consumers/mujoco_cpp" -B "$folder/mujoco_cpp" -DCMAKE_PREFIX_PATH="$prefix" -Dmujoco_DIR="$mujoco_folder" \
  -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=Debug >"$folder/log" 2>&1 && "$cmake" --build "$folder/mujoco_cpp" >>"$folder/log" 2>&1 || fail "$(cat "$folder/log")"
said=$("$folder/mujoco_cpp/consumer" "$folder/model/page.xml") || fail "the consumer of MuJoCo in C++ ended with $?"
[[ $said == '0.25 N on the paper, 9'[0-9]' % of the text traced' || $said == *' 100 % of the text traced' ]] || fail "$said"
flags=$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs "moontrace-mujoco-$mujoco")
# shellcheck disable=SC2086  # several words
"$c" -std=c99 -Wall -Wextra -Wpedantic -Werror "$consumers/mujoco_c/consumer.c" -o "$folder/mujoco_c" $flags -lmujoco
said=$(LD_LIBRARY_PATH=$library "$folder/mujoco_c" "$folder/model/page.xml") || fail "the consumer of MuJoCo in C ended with $?"
# 0.3 mm into paper and coupling of 1000 N/m each
grep -qE '^MuJoCo [0-9.]+: 2\.0 s, 0\.1[0-9] N$' <<<"$said" || fail "$said"
# Python and Perl by the modules beside it
if [ -x /usr/bin/python3 ]; then
  said=$(PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$prefix/lib/python3/dist-packages /usr/bin/python3 \
    "$consumers/python/consumer.py")
  [ "$(sed -n '1,5{s/ at.*//;p}' <<<"$said" | tr '\n' ' ')" = 'Installed Moon m o o n ' ] || fail "$said"
fi
if perl -MFFI::Platypus -e 1 2>/dev/null; then
  said=$(perl -I "$prefix/share/perl5" "$consumers/perl/consumer.pl")
  # 0.5 mm deep in paper of 1000 N/m
  [ "$(sed 's/ at.*//' <<<"$said" | tr '\n' ' ')" = 'm o o n 0.50 N on flat paper ' ] || fail "$said"
fi
echo 'consumers in C++ and C find, compile and run the libraries'
