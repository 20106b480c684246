#!/bin/bash
# A study as a Slurm array: each task takes every eighth row, one processor a row.
#     sbatch slurm_array.sh
# Every task writes sweep.csv from all rows that are done by then; the last one sees all of them. Rows that were cut
# off go on when the array is submitted again.
#SBATCH --job-name=study
#SBATCH --array=0-7
#SBATCH --cpus-per-task=4
#SBATCH --time=01:00:00
set -euo pipefail

archard sweep cases/pin_on_disc \
    --over "motion.sliding.load=5 N:20 N:4" \
    --over "body.pin.profile.sphere.radius=25 mm,35 mm,50 mm" \
    --task "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" \
    -o results/study
