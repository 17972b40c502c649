# A minute before its time is over a task puts itself into the queue again, at most 100 times: a case that takes longer than the
# time of a task would never end. The name with _ is that of one task; SLURM_JOB_ID may be that of the whole array.
array=$(sbatch "${options[@]}" --signal=B:USR1@60 --job-name="$name" --array="${SHARDS:-1-$shards}" << JOB
#!/bin/bash
cd $folder || exit 1
again() {
    if [ "\${SLURM_RESTART_COUNT:-0}" -lt 100 ]; then
        scontrol requeue "\${SLURM_ARRAY_JOB_ID}_\$SLURM_ARRAY_TASK_ID"
    fi
}
trap again USR1
$run --shard "\$SLURM_ARRAY_TASK_ID/$shards" &
# A signal ends a wait, but not the program.
while code=0; wait \$! || code=\$?; kill -0 \$! 2> /dev/null; do :; done
exit "\$code"
JOB
)
