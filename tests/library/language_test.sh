#!/usr/bin/env bash
# Runs a test in another language, or says in a plain line why not.
#   language_test.sh NAME INTERPRETER SCRIPT
case $2 in
  *NOTFOUND) echo "skipped: this machine has no $1"; exit 77 ;;
esac
exec "$2" "$3"
