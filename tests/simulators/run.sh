#!/bin/sh
# run.sh install FOLDER: the engine into FOLDER, as package-lock.json pins it. run.sh check FOLDER: the tests.
# 77, which ctest shows as skipped, where there is no node or the engine cannot be fetched.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
for program in node npm; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done
mkdir -p "$2"
cp "$here"/*.mjs "$here"/package.json "$here"/package-lock.json "$2"
cd "$2"
if [ "$1" = install ]; then
  npm ci --ignore-scripts --no-audit --no-fund || { echo "skipped: the engine could not be fetched"; exit 77; }
else
  [ -d node_modules ] || { echo "skipped: the engine is not there"; exit 77; }
  node --test --test-reporter=spec check.mjs
fi
