#!/bin/sh
# Searches a wish in parts with GNU parallel, on this machine or on those of a list of hosts with one folder in common.
#   gearbox-parallel.sh WISH PARTS FOLDER [HOSTS]
# Run it again after a failure: finished parts are skipped, the others go on where they were.
set -eu
wish=$1 parts=$2 folder=$3 hosts=${4:-}
cli=${GEARGRAPH_CLI:-geargraph-cli}
mkdir -p "$folder"
parallel ${hosts:+--sshloginfile "$hosts"} --workdir "$PWD" --joblog "$folder/joblog" \
  "$cli" gearbox "$wish" --jobs 1 --shard "{}/$parts" --resume -o "$folder/part-{}.jsonl" ::: $(seq 0 $((parts - 1)))
"$cli" gearbox merge "$folder"/part-*.jsonl --json > "$folder/gearboxes.json"
