"""The shards of a sweep as futures of Dask: dask_shards.py SCHEDULER PLAN.toml DIR SHARDS

DIR is a folder that all workers see. Where a worker dies, another takes its shard."""

import subprocess
import sys

from dask.distributed import Client


def shard(plan, folder, index, of):
    command = ["kahan-sweep", plan, "--out", folder, "--shard", f"{index}/{of}", "--threads", "1"]
    subprocess.run(command, check=True)


scheduler, plan, folder, shards = sys.argv[1:]
with Client(scheduler) as client:
    futures = [client.submit(shard, plan, folder, i, shards, retries=3) for i in range(1, int(shards) + 1)]
    client.gather(futures)
subprocess.run(["kahan-sweep", plan, "--out", folder, "--merge"], check=True)
