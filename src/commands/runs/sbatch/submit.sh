
# Printed values as words of a job's script.
folder=$(printf %q "$folder")
run=$(printf '%q ' "$slipgap" run "${arguments[@]}" --jobs "$cores")
merge=$(printf '%q ' "$slipgap" merge "${arguments[@]}" --jobs "$cores" --shards "$shards")
# A task that is preempted, or whose node fails, is put into the queue again. Finished parts are kept.
options+=(--parsable --requeue --open-mode=append --cpus-per-task="$cores")

