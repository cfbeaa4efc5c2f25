#!/bin/sh
# A part of a search as a task of a Slurm array, which is queued again where its node fails:
#   sbatch --array=0-63 --requeue gearbox-slurm.sh WISH 64 FOLDER
# and then, once all tasks are done: geargraph-cli gearbox merge FOLDER/part-*.jsonl --json
#SBATCH --job-name=gearbox
#SBATCH --cpus-per-task=1
set -eu
wish=$1 parts=$2 folder=$3
mkdir -p "$folder"
exec "${GEARGRAPH_CLI:-geargraph-cli}" gearbox "$wish" --jobs 1 --shard "$SLURM_ARRAY_TASK_ID/$parts" --resume \
  -o "$folder/part-$SLURM_ARRAY_TASK_ID.jsonl"
