#!/bin/bash
# An array of @shards@ tasks, a shard each; `sbatch` this file. A task that is cut short goes on where it
# stopped when this is submitted again.
#SBATCH --job-name=kahan-sweep
#SBATCH --array=1-@shards@
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --output=kahan-sweep-%A-%a.log
#SBATCH --requeue
set -eu
exec kahan-sweep @plan@ --out @out@ --shard "$SLURM_ARRAY_TASK_ID/@shards@" --threads "${SLURM_CPUS_PER_TASK:-1}"
# When all tasks are done: kahan-sweep @plan@ --out @out@ --merge
