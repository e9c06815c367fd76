#!/usr/bin/env bash
# The launcher against a tiny tree and made-up tools that write down how they were called.
# Usage: launcher_test.sh SOURCE-FOLDER
set -u
source=$(cd "$1" && pwd) || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
calls=$work/calls
unset CI CMAKE_PREFIX_PATH CXX CXXFLAGS LDFLAGS

expect() {  # expect WHAT CONDITION...
  local what=$1
  shift
  if "$@"; then return; fi
  printf 'FAILED: %s\n' "$what"
  [ -f "$work/said" ] && sed 's/^/  said: /' "$work/said"
  failures=$((failures + 1))
}
called() { grep -q -- "$1" "$calls"; }
not() { ! "$@"; }
said() { grep -q -- "$1" "$work/said"; }
code_is() { [ "$code" = "$1" ]; }

tool() {  # tool NAME: a made-up program; its body comes on standard input
  { printf '#!/usr/bin/env bash\nprintf "%%s %%s\\n" "%s" "$*" >>"%s"\n' "$1" "$calls"; cat; } \
    >"$work/tools/$1"
  chmod +x "$work/tools/$1"
}

start() {  # start [ARGUMENT...]: runs the launcher without a terminal
  : >"$calls"
  PATH=$work/tools "$tree/moontrace" "$@" >"$work/said" 2>&1 </dev/null
  code=$?
}

# A tree as the launcher knows it, and only the commands that a bare system has.
new_tree() {
  rm -rf "$work/tools" "$work/tree"
  tree=$work/tree
  mkdir -p "$work/tools" "$tree"/{.cmake,textures/field,devices,lessons,sim,tests}
  cp "$source/moontrace" "$tree/"
  cp "$source"/tests/{run.sh,flaky.txt} "$tree/tests/"
  touch "$tree"/{CMakeLists.txt,CMakePresets.json,sim/main.cpp,textures/field/field.cpp}
  find "$tree" -exec touch -d '1 hour ago' {} +
  local command
  for command in bash env cat cp mv rm mkdir find grep tail sed tr wc fold sleep flock nproc head chmod; do
    ln -s "$(command -v "$command")" "$work/tools/$command"
  done
  tool id <<<'echo 0'
  tool apt-get <<<'[ ! -f "$FAIL_APT" ]'
  tool dpkg-query <<<'for p in "${@:3}"; do [ "$p" = "${LACK:-}" ] || printf "%s=installed " "$p"; done'
  tool cmake <<<'
    case $1 in
      --preset) mkdir -p build/release && : >build/release/build.ninja >build/release/CMakeCache.txt
        case $* in *TESTS=ON*) echo MOONTRACE_TESTS:BOOL=ON >build/release/CMakeCache.txt ;; esac ;;
      --build) [ ! -f broken ] || { echo "main.cpp:1: error: broken"; exit 1; }
        mkdir -p build/release/sim
        printf "#!/usr/bin/env bash\necho ran \"\$@\" in \$PWD\necho called \"\$MOONTRACE_CALLED\"\nexit 7\n" >build/release/sim/moontrace
        chmod +x build/release/sim/moontrace ;;
    esac'
  tool ctest <<<'
    if [ -f failing ]; then
      printf "50%% tests passed, 1 tests failed out of 2\n\nThe following tests FAILED:\n\t1 - Sad\n"
      exit 8
    fi
    printf "100%% tests passed, 0 tests failed out of 2\n"'
  export FAIL_APT=$work/fail-apt LACK=
}

# Makes what was built look older, so that a change now is a change after it.
age() { find "$tree" -exec touch -d '1 minute ago' {} +; }

new_tree
cd "$work" && start trace hello
expect 'the first start configures' called 'cmake --preset release'
expect 'the first start leaves tests out' called 'MOONTRACE_TESTS=OFF'
expect 'the first start builds the program alone' called 'cmake --build .*--target moontrace'
expect 'the first start says how long building takes' said 'a first build takes 5 to 11 minutes'
expect 'installed packages are left alone' not called apt-get
expect 'the program gets arguments and folder' said "ran trace hello in $work"
expect 'the exit code of the program passes through' code_is 7

expect 'the program learns how it was called' said "^called $tree/moontrace$"
for call in "cd $tree && ./moontrace" "cd $tree/sim && ../moontrace"; do
  PATH=$work/tools bash -c "$call page" >"$work/said" 2>&1 </dev/null
  expect "called as it was typed: $call" said "^called ${call##* }$"
done
(cd "$tree" && PATH=$work/tools bash moontrace page) >"$work/said" 2>&1 </dev/null
expect 'given to bash it is called from its folder' said '^called ./moontrace$'
ln -s "$tree/moontrace" "$work/tools/moontrace"
ln -s "$(command -v readlink)" "$work/tools/readlink"
PATH=$work/tools bash -c 'moontrace page' >"$work/said" 2>&1 </dev/null
expect 'found by its name it is called by it' said '^called moontrace$'
mkdir "$work/my files"
ln -s "$tree/moontrace" "$work/my files/moontrace"
PATH=$work/tools "$work/my files/moontrace" page >"$work/said" 2>&1 </dev/null
expect 'a path with a blank can be typed' grep -qF "called $work/my\ files/moontrace" "$work/said"

start page
expect 'a second start asks no tool at all' not grep -q . "$calls"
expect 'a second start says nothing itself' not said building

for change in 'edited textures/field/field.cpp' 'added lessons/new.h' 'edited CMakeLists.txt' \
  'removed textures/field/field.cpp'; do
  age
  case $change in removed*) rm "$tree/${change#* }" ;; *) echo >"$tree/${change#* }" ;; esac
  start
  expect "$change: builds again" called 'cmake --build'
  expect "$change: does not configure by itself" not called 'cmake --preset'
done

age
echo >"$tree/tests/new_test.cpp"
start
expect 'a new test does not rebuild the program' not called cmake

age
touch "$tree/broken" "$tree/sim/main.cpp"
start
expect 'a failed build ends with 1' code_is 1
expect 'a failed build shows the last lines' said 'error: broken'
expect 'a failed build names the log' said "$tree/build/moontrace.log"
expect 'a failed build does not run the program' not said '^ran'
start
expect 'after a failed build the next start builds again' called 'cmake --build'
rm "$tree/broken"
start
expect 'a mended build runs' code_is 7

age
CMAKE_PREFIX_PATH=/somewhere start
expect 'another CMAKE_PREFIX_PATH configures anew' called 'cmake --preset release --fresh'

start test
expect 'test says how long its first build takes' said 'a first build takes 10 to 25 minutes'
expect 'test turns tests on' called 'MOONTRACE_TESTS=ON'
expect 'test builds everything' called 'cmake --build .*--target all'
expect 'test runs the quick tests' called 'ctest .*-L quick'
expect 'test ends with 0' code_is 0
expect 'test gives the closing line' said '^100% tests passed, 0 tests failed out of 2'
start test -L slow
expect 'test takes another label' called 'ctest .*-L slow'
expect 'another label takes the place of quick' not called quick
expect 'built tests are not built again' not called cmake
touch "$tree/failing"
start test
expect 'failing tests end with 1' code_is 1
expect 'failing tests are named' said 'Sad'
expect 'failing tests name the log' said "$tree/build/moontrace.log"

new_tree
LACK=libglm-dev start
expect 'as root without a terminal it installs' \
  called 'apt-get install .*--no-install-recommends libglm-dev$'
expect 'it says what and why' said 'missing Debian packages: 1, to build and run Moontrace'
expect 'then it runs' code_is 7

new_tree
touch "$FAIL_APT"
LACK=libglm-dev start
expect 'packages that cannot be had end with 4' code_is 4
rm "$FAIL_APT"
start
expect 'a failed installation is tried again' code_is 7

new_tree
tool id <<<'echo 1000'
LACK=libglm-dev start
expect 'without root and terminal it ends with 4' code_is 4
expect 'and says the line to type' said '^apt-get install --no-install-recommends libglm-dev$'
expect 'and does not call apt-get' not called apt-get

new_tree
rm "$work/tools/apt-get"
tool c++ <<<'! grep -q glm'
tool ninja <<<''
tool pkg-config <<<''
start
expect 'elsewhere it names what is missing' said '^glm/glm.hpp$'
expect 'elsewhere nothing else is named' not said 'mujoco'
expect 'elsewhere it ends with 4' code_is 4
tool c++ <<<''
start
expect 'elsewhere it builds when all is there' code_is 7

new_tree
mkdir "$tree/build"
(exec 9>"$tree/build/.lock" && flock 9 && sleep 2) &
sleep 0.5
start
expect 'a second start waits for the first' said 'another start works here'
expect 'a second start runs in the end' code_is 7
wait

new_tree
tool cmake <<<'sleep 20'
: >"$calls"
set -m
PATH=$work/tools "$tree/moontrace" >"$work/said" 2>&1 </dev/null &
started=$!
set +m
sleep 1
kill -INT "$started"
wait "$started"
code=$?
expect 'Ctrl-C ends with 130' code_is 130

[ "$failures" = 0 ] && printf 'all expectations of the launcher hold\n'
exit $((failures > 0))
