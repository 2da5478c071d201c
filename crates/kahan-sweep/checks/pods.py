"""Plays the controller of an indexed Job: pods.py JOB.yaml MOUNT=FOLDER…

Each completion's container runs with the arguments and variables of the Job, and the variable that
Kubernetes adds; mounts are folders of this machine. The container of index 1 is killed once."""

import os
import subprocess
import sys
import time

import yaml

job = yaml.safe_load(open(sys.argv[1]))
mounts = dict(mount.split("=", 1) for mount in sys.argv[2:])
spec = job["spec"]
container = spec["template"]["spec"]["containers"][0]
assert spec["completionMode"] == "Indexed" and spec["template"]["spec"]["restartPolicy"] == "OnFailure"
assert {mount["mountPath"] for mount in container["volumeMounts"]} == set(mounts)


def on_this_machine(argument):
    for mount, folder in mounts.items():
        if argument == mount or argument.startswith(mount + "/"):
            return folder + argument[len(mount):]
    return argument


def start(index):
    said = {variable["name"]: variable["value"] for variable in container.get("env", [])}
    arguments = [on_this_machine(argument) for argument in container["args"]]
    environment = os.environ | said | {"JOB_COMPLETION_INDEX": str(index)}
    return subprocess.Popen(["kahan-sweep", *arguments], env=environment, stdout=subprocess.DEVNULL)


pods = {index: start(index) for index in range(spec["completions"])}
time.sleep(0.5)
pods[1].kill()
assert pods[1].wait() == -9, "the container ended before it could be killed"
pods[1] = start(1)
assert all(pod.wait() == 0 for pod in pods.values())
