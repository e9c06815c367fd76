#!/usr/bin/env bash
# The manual in HTML: every page has a title and text, and what it refers to is there.
#   manual_test.sh HTML_FOLDER SOURCE_TREE
set -u
html=$1 source=$2 pages=0 failures=0
complain() { printf '%s\n' "$*"; failures=$((failures + 1)); }
while read -r page; do
  pages=$((pages + 1))
  folder=$(dirname "$page")
  grep -q '<title>..*</title>' "$html/$page" || complain "$page has no title"
  [ "$(sed 's/<[^>]*>//g' "$html/$page" | wc -w)" -gt 100 ] || complain "$page has hardly a word"
  while read -r target; do
    case $target in http*|address|\#*) continue ;; esac
    [ -e "$html/$folder/$target" ] || [ -e "$source/$folder/$target" ] || complain "$page leads to $target, which is not there"
  done < <(grep -oE '(href|src)="[^"]*"' "$html/$page" | cut -d '"' -f 2)
done < <(cd "$html" && find . -name '*.html' | sed 's|^\./||' | sort)
[ "$pages" -gt 8 ] || complain "$pages pages"
[ "$failures" = 0 ] && echo "$pages pages, all that they lead to is there"
exit $((failures > 0))
