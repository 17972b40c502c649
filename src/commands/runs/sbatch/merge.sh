# Where clusters are joined, sbatch prints JOB;CLUSTER.
array=${array%%;*}

# afterany: also after tasks that failed. The merge then names their shards. afterok would never be satisfied after a failed task,
# even if the task succeeds later.
merge=$(sbatch "${options[@]}" --job-name="$name-merge" --dependency="afterany:$array" << JOB
#!/bin/bash
cd $folder || exit 1
exec $merge
JOB
)
echo "array $array: shards ${SHARDS:-1-$shards} of $shards; then job ${merge%%;*}: merge"
