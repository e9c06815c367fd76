#!/usr/bin/env bash
# Holds every source to its room: what a file includes, of ours or of a library, its room must link.
#   rooms_test.sh SOURCE_TREE ROOMS.TXT
# A line of ROOMS.TXT is "target|folder|libraries|public libraries", as CMake links them
# (moontrace_room in .cmake/flags.cmake).
set -euo pipefail
cd "$1"
rooms=$2

# check_rooms < "file:include" lines: one line for each include that is not allowed.
check_rooms() {
  awk -v rooms="$rooms" '
    function base(name) { gsub(/^\$<LINK_ONLY:|>$/, "", name); sub(/^moontrace::/, "moontrace_", name); return name }
    # What includes may come from: the libraries themselves, and what those link in public.
    function allow(target, name,   i, n, parts) {
      if (allowed[target, name]++) return
      n = split(public[name], parts, ";")
      for (i = 1; i <= n; ++i) if (parts[i] !~ /LINK_ONLY/) allow(target, base(parts[i]))
    }
    BEGIN {
      FS = "|"
      while ((getline line < rooms) > 0) {
        split(line, part, "|")
        folder_of[part[1]] = part[2]; target_of[part[2]] = part[1]
        links[part[1]] = part[3]; public[part[1]] = part[4]; ++count
      }
      if (count < 20) { print rooms ": only " count + 0 " rooms"; exit }
      for (target in folder_of) {
        n = split(links[target], parts, ";")
        for (i = 1; i <= n; ++i) allow(target, base(parts[i]))
        # a room of headers only has nothing but public libraries
        n = split(public[target], parts, ";")
        for (i = 1; i <= n; ++i) if (parts[i] !~ /LINK_ONLY/) allow(target, base(parts[i]))
      }
      library["mujoco/"] = "mujoco::mujoco"; library["glm/"] = "glm::glm"; library["fmt/"] = "fmt::fmt"
      library["nlohmann/"] = "nlohmann_json::nlohmann_json"; library["CLI/"] = "CLI11::CLI11"
      library["toml++/"] = "PkgConfig::tomlplusplus"; library["pugixml.hpp"] = "pugixml::pugixml"
      library["utf8proc.h"] = "PkgConfig::utf8proc"; library["hidapi.h"] = "PkgConfig::hidapi"
      library["liblouis.h"] = "PkgConfig::louis"; library["sqlite3.h"] = "PkgConfig::sqlite"
      library["hyphen.h"] = "hyphen::hyphen"; library["cairo.h"] = "PkgConfig::cairo"; library["portaudio.h"] = "PkgConfig::portaudio"
      library["EGL/"] = "PkgConfig::egl"; library["GLFW/"] = "PkgConfig::glfw"
      library["imgui.h"] = library["backends/"] = "PkgConfig::imgui"; library["fontconfig/"] = "PkgConfig::fontconfig"
    }
    {
      file = $1; name = $2; folder = file; sub(/\/[^\/]*$/, "", folder)
      if (!(folder in target_of)) { print file ": lies in no room: " folder; next }
      target = target_of[folder]
      if (name ~ /^"/) {
        gsub(/"/, "", name); from = name; sub(/\/[^\/]*$/, "", from)
        if (from == folder) next
        if (!(from in target_of)) { print file ": includes " name ", which lies in no room"; next }
        if (!allowed[target, target_of[from]]) print file ": includes " name ", which " target " does not link"
      } else {
        gsub(/[<>]/, "", name)
        for (prefix in library)
          if (index(name, prefix) == 1 && !allowed[target, library[prefix]])
            print file ": includes " name ", but " target " does not link " library[prefix]
      }
    }'
}

includes() { grep -HoE '^#include ("[^"]+"|<[^>]+>)' "$@" | sed 's/:#include /|/'; }

mapfile -t sources < <(find textures lessons devices sim -name '*.h' -o -name '*.cpp' | sort)
faults=$(includes "${sources[@]}" | check_rooms)
if [ -n "$faults" ]; then
  printf '%s\n' "$faults"
  exit 1
fi

# It would notice: a lower room that includes a higher one, and a library that is not its own.
printf 'textures/base/error.h|"sim/app/cli.h"\ntextures/field/field.h|<mujoco/mujoco.h>\n' |
  check_rooms | awk 'END { exit NR != 2 }' || { echo 'planted faults are not found'; exit 1; }

# Nothing goes in a circle: no room is linked by what it links.
awk -F'|' '
  { folder[$1] = $2; n = split($3, parts, ";")
    for (i = 1; i <= n; ++i) { sub(/^moontrace::/, "moontrace_", parts[i]); if (parts[i] ~ /^moontrace_/) uses[$1] = uses[$1] " " parts[i] } }
  function visit(t,   i, n, parts) {
    if (state[t] == 1) { print "a circle through " t; bad = 1; return }
    if (state[t] == 2) return
    state[t] = 1; n = split(uses[t], parts, " ")
    for (i = 1; i <= n; ++i) if (parts[i] in folder) visit(parts[i])
    state[t] = 2
  }
  END { for (t in folder) visit(t); exit bad }' "$rooms"
printf 'each of %d files includes only what its room links\n' "${#sources[@]}"
