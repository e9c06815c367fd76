#!/usr/bin/env bash
# The Debian packages in a bare Debian: they install, the program and the examples in C, C++, Python
# and Perl run, and nothing is left when they are removed. As root; takes minutes and the network.
#   packages_test.sh ROOT FOLDER
#     ROOT    a root file system for this test alone: debootstrap --variant=minbase bookworm ROOT
#     FOLDER  with the packages: build/package
set -euo pipefail
root=$(realpath "$1") folder=$2
in_root() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
fail() { printf '%s\n' "$@"; exit 1; }
files() { (cd "$root" && find . -xdev \( -path ./proc -o -path ./sys -o -path ./tmp -o -path ./var/cache -o -path ./var/log \
  -o -path ./var/lib/apt -o -path ./var/lib/dpkg \) -prune -o -print | sort); }

mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
cp /etc/resolv.conf "$root/etc/resolv.conf"
in_root apt-get update -q >/dev/null
# what the examples need besides
in_root apt-get install -qy --no-install-recommends g++ cmake make pkg-config python3-numpy libffi-platypus-perl libgl-dev libopengl-dev >/dev/null
files >"$root/tmp/before"

mkdir -p "$root/tmp/debs"
cp "$folder"/*.deb "$root/tmp/debs"
in_root sh -c 'apt-get install -qy --no-install-recommends /tmp/debs/*.deb' >"$root/tmp/log" 2>&1 || fail "$(tail -n 20 "$root/tmp/log")"
in_root moontrace version
in_root sh -c 'cd /tmp && rm -rf moontrace-demo && moontrace demo' | tail -n 3
examples=/usr/share/doc/libmoontrace-dev/examples
in_root sh -c "cd /tmp && cc -std=c99 -Wall -Wextra -Wpedantic -Werror $examples/c/consumer.c -o c \$(pkg-config --cflags --libs moontrace) && ./c"
in_root sh -c "cmake -S $examples/cpp -B /tmp/cpp >/tmp/log && cmake --build /tmp/cpp >>/tmp/log && /tmp/cpp/consumer /tmp/i.svg"
mujoco=$(basename "$(ls "$folder"/libmoontrace-mujoco-*-dev_*.deb)" | sed 's/libmoontrace-mujoco-\(.*\)-dev_.*/\1/')
in_root sh -c "cd /tmp && cc -std=c99 -Wall -Wextra -Wpedantic -Werror $examples/mujoco_c/consumer.c -o mujoco_c \$(pkg-config --cflags --libs moontrace-mujoco-$mujoco) -lmujoco && ./mujoco_c $examples/page.xml"
in_root sh -c "cmake -S $examples/mujoco_cpp -B /tmp/mujoco_cpp >/tmp/log && cmake --build /tmp/mujoco_cpp >>/tmp/log && /tmp/mujoco_cpp/consumer $examples/page.xml"
in_root python3 "$examples/python/consumer.py"
in_root perl "$examples/perl/consumer.pl"
in_root sh -c 'gzip -t /usr/share/man/man1/moontrace.1.gz && test -s /usr/share/doc/moontrace/html/README.html'

in_root sh -c 'apt-get purge -qy moontrace moontrace-data moontrace-doc libmoontrace0 "libmoontrace-mujoco-*" && apt-get autoremove -qy --purge' >"$root/tmp/log" 2>&1 ||
  fail "$(tail -n 20 "$root/tmp/log")"
files >"$root/tmp/after"
left=$(comm -13 "$root/tmp/before" "$root/tmp/after" | grep -v '__pycache__' || true)
ours=$(grep -i moontrace <<<"$left" || true)
[ -z "$ours" ] || fail 'left:' "$ours"
[ -z "$left" ] || printf 'left by packages of others: %s\n' "$(wc -l <<<"$left")"
echo 'packages install, run and leave nothing'
