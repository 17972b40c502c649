"""The shards of a study as tasks of Dask, then the merge: python dask_shards.py STUDY DIR SHARDS [SCHEDULER]

SCHEDULER is the address of a scheduler whose workers see the folder; if left out, workers are started on this machine.
"""

import subprocess
import sys

from dask.distributed import Client


def shard(study, out, index, shards):
    command = ["slipgap", "run", study, "--out", out, "--jobs", "1", "--shard", f"{index}/{shards}"]
    subprocess.run(command, check=True)


def main(study, out, shards, scheduler=None):
    # A mistake in the study ends here, before any shard.
    if code := subprocess.run(["slipgap", "list", study], stdout=subprocess.DEVNULL).returncode:
        sys.exit(code)
    options = {"address": scheduler} if scheduler else {"threads_per_worker": 1, "dashboard_address": None}
    with Client(**options) as client:
        numbers = range(1, int(shards) + 1)
        # A shard whose worker is lost runs again on another one.
        tasks = [client.submit(shard, study, out, index, shards, pure=False, retries=3) for index in numbers]
        client.gather(tasks)
    # 3: a case has no solution, which failures.csv names; the results are complete.
    sys.exit(subprocess.run(["slipgap", "merge", study, "--out", out, "--shards", shards]).returncode)


if __name__ == "__main__":
    main(*sys.argv[1:])
