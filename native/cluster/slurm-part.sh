#!/bin/sh
#SBATCH --job-name=abflat
#SBATCH --cpus-per-task=2
#SBATCH --mem=8G
#SBATCH --requeue
#SBATCH --open-mode=append
# One part of a batch as a task of a job array; slurm.sh submits it. A node that is drained or fails
# has its part done elsewhere, from where it ended.
set -eu
here=$1 from=$2 out=$3
shift 3
exec "$here/shard.sh" "$SLURM_ARRAY_TASK_ID" "$SLURM_ARRAY_TASK_COUNT" "$from" "$out" \
  --jobs "${SLURM_CPUS_PER_TASK:-1}" "$@"
