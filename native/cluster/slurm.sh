#!/bin/sh
# A batch in parts with Slurm: slurm.sh PARTS FROM OUT [OPTIONS of abflat batch]
# Submits an array of parts, and a job that merges them once all are done. SBATCH_ARGS are further
# options of sbatch, such as "--partition=short --mem=4G".
set -eu
here=$(cd "$(dirname "$0")" && pwd)
parts=$1 from=$2 out=$3
shift 3
mkdir -p "$out/logs"
# shellcheck disable=SC2086 # several options
array=$(sbatch --parsable --array=0-$((parts - 1)) --output="$out/logs/part-%a.log" \
  ${SBATCH_ARGS:-} "$here/slurm-part.sh" "$here" "$from" "$out" "$@")
# shellcheck disable=SC2086
merge=$(sbatch --parsable --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  --output="$out/logs/merge.log" ${SBATCH_ARGS:-} "$here/slurm-merge.sh" "$out")
echo "parts: job $array, merge: job $merge"
