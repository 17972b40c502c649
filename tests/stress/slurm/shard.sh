#!/bin/bash
# Used in the test instead of the program. The first attempt of every shard except the first is stopped in the middle of its work,
# so that the test can kill, requeue or cancel its task. `merge` and later attempts run as they are.
shard=${!#}
attempt=$MARKS/shard-${shard%/*}
if [ "$1" != run ] || [ "$shard" = 1/6 ] || [ -e "$attempt" ]; then
    exec "$SLIPGAP" "$@"
fi
touch "$attempt"
"$SLIPGAP" "$@" &
sleep 0.05
kill -STOP $!
echo $! > "$attempt.new"
mv "$attempt.new" "$attempt.pid"
wait $!
