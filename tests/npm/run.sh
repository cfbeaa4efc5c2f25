#!/bin/sh
# run.sh install SOURCE FOLDER: what SOURCE/package-lock.json pins, into FOLDER. run.sh check SOURCE FOLDER FILE
# [PROGRAM]: the tests of SOURCE/FILE, there. 77, which ctest shows as skipped, where there is no node or no PROGRAM, or the
# packages cannot be fetched.
set -eu
for program in node npm ${5:-}; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program (tools/packages.txt)"; exit 77; }
done
mkdir -p "$3"
if [ "$1" = install ]; then
  # What is there already is not fetched again. The copy of the lock is written last: half of the packages are none.
  [ -d "$3/node_modules" ] && cmp -s "$2/package-lock.json" "$3/installed.json" && exit 0
  rm -f "$3/installed.json"
  cp "$2"/package.json "$2"/package-lock.json "$3"
  cd "$3"
  # Without a network npm would try for longer than a test may take.
  timeout 100 npm ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=60000 || {
    rm -rf node_modules
    echo "skipped: the packages could not be fetched"
    exit 77
  }
  cp package-lock.json installed.json
else
  cp "$2"/*.mjs "$3"
  cd "$3"
  [ -f installed.json ] || { echo "skipped: the packages are not there"; exit 77; }
  node --test --test-reporter=spec "$4"
fi
