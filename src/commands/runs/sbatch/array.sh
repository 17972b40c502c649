array=$(sbatch "${options[@]}" --job-name="$name" --array="${SHARDS:-1-$shards}" << JOB
#!/bin/bash
cd $folder || exit 1
exec $run --shard "\$SLURM_ARRAY_TASK_ID/$shards"
JOB
)
