#!/bin/sh
#SBATCH --job-name=abflat-merge
#SBATCH --mem=2G
# One manifest and one report of all parts; slurm.sh submits it.
set -eu
exec "${ABFLAT:-abflat}" batch --merge --out "$1" --quiet
