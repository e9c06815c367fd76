#!/usr/bin/env bash
# What the shared library shows is what its list says, also by version; and the header declares the same.
#   symbols_test.sh LIBRARY MAP HEADER NM READELF SONAME
set -euo pipefail
library=$1 map=$2 header=$3 nm=$4 readelf=$5 soname=$6
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# "name@@VERSION", from the list and from the library
awk '/^[A-Z_0-9]+ \{/ { version = $1 } /^    [a-z_0-9]+;/ { sub(/;/, ""); print $1 "@@" version }' "$map" | sort >"$folder/listed"
"$nm" --dynamic --defined-only --with-symbol-versions "$library" |
  awk '$2 != "A" { print $3 }' | sort >"$folder/shown"
diff "$folder/listed" "$folder/shown" || { echo 'the library shows (>) other names than its list has (<)'; exit 1; }

sed 's/@@.*//' "$folder/listed" | sort >"$folder/names"
grep -oE '\bmoontrace_[a-z_]+\(' <(grep -A 1 '^MOONTRACE_API' "$header") | tr -d '(' | sort >"$folder/declared"
diff "$folder/names" "$folder/declared" || { echo 'the header declares (>) other functions than the list has (<)'; exit 1; }

"$readelf" -d "$library" | grep -qF "soname: [$soname]" || { echo "the soname is not $soname"; exit 1; }
case $soname in
  *mujoco*) "$readelf" -d "$library" | grep -q 'NEEDED.*mujoco' || { echo 'the library does not bring its MuJoCo'; exit 1; } ;;
  *) ! "$readelf" -d "$library" | grep 'NEEDED.*mujoco' || { echo 'the library needs MuJoCo'; exit 1; } ;;
esac
! "$readelf" -d "$library" | grep TEXTREL || { echo 'the library is not position-independent'; exit 1; }
printf '%d functions are shown, all listed and declared\n' "$(wc -l <"$folder/shown")"
