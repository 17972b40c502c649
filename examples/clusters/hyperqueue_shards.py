"""The shards of a study as tasks of HyperQueue, then the merge: python hyperqueue_shards.py STUDY DIR SHARDS [SERVER]

SERVER is the folder of a server that runs; if left out, a server and a worker are started on this machine.
"""

import subprocess
import sys

from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig


def submit(client, study, out, shards):
    job = Job(name="slipgap")
    logs = {name: f"{out}-jobs/%{{TASK_ID}}.{name}" for name in ("stdout", "stderr")}
    # HyperQueue repeats a task whose worker is lost, but not one that fails.
    run = 'for i in 1 2 3 4; do slipgap run "$0" --out "$1" --jobs 1 --shard "$2" && exit; done; exit 1'
    names = [f"{index}/{shards}" for index in range(1, int(shards) + 1)]
    tasks = [job.program(["sh", "-c", run, study, out, name], name=f"shard {name}", crash_limit=3, **logs) for name in names]
    # 3: a case has no solution, which failures.csv names; the results are complete.
    merge = 'slipgap merge "$0" --out "$1" --shards "$2" || [ $? -eq 3 ]'
    job.program(["sh", "-c", merge, study, out, shards], name="merge", deps=tasks, **logs)
    client.wait_for_jobs([client.submit(job)])


def main(study, out, shards, server=None):
    # A mistake in the study ends here, before any shard.
    if code := subprocess.run(["slipgap", "list", study], stdout=subprocess.DEVNULL).returncode:
        sys.exit(code)
    if server:
        submit(Client(server), study, out, shards)
        return
    with LocalCluster(worker_config=WorkerConfig()) as cluster:
        submit(cluster.client(), study, out, shards)


if __name__ == "__main__":
    main(*sys.argv[1:])
