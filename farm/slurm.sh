#!/usr/bin/env bash
#SBATCH --job-name=twister
#SBATCH --array=0-59
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --requeue
#SBATCH --output=twister-%A-%a.log
# Renders a film by a SLURM array; each task takes its share of the frames. Simulate first:
#   twister simulate scene.json -o /shared/shot.motion --frames 0-5999 --fps 60
#   sbatch --array=0-59 --cpus-per-task=16 farm/slurm.sh scene.json /shared/shot.motion /shared/shot 0 5999 --size 4k
# A task that is requeued, or submitted again, renders what is missing.
set -euo pipefail
if [ $# -lt 5 ]; then
    echo "usage: sbatch --array=1-TASKS farm/slurm.sh SCENE MOTION FOLDER FIRST LAST [RENDER OPTIONS]" >&2
    exit 2
fi
scene=$1 motion=$2 folder=$3 first=$4 last=$5
shift 5

tasks=$((SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1))
task=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN))
frames=$((last - first + 1))
from=$((first + frames * task / tasks))
to=$((first + frames * (task + 1) / tasks - 1))
[ "$to" -ge "$from" ] || exit 0

mkdir -p "$folder"
exec "${TWISTER:-twister}" render "$scene" --motion "$motion" --frames "$from-$to" \
    --output "$folder/f-######.png" --skip-existing --engine vector --progress lines "$@"
