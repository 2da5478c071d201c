"""Tests the command `kahan` that the wheel contains."""

import subprocess
import sys


def run(*arguments):
    return subprocess.run([sys.executable, "-m", "kahan_command", *arguments], capture_output=True, text=True)


def test_it_is_the_command():
    done = run("eval", "e1", "--eps", "1/2", "--at", "1,1,1")
    assert done.returncode == 0 and done.stdout.startswith("system")
    assert run("eval", "e6", "--eps", "1", "--at", "1/2,0,1/2").returncode == 1
    refused = run("eval", "e11")
    assert refused.returncode == 2 and refused.stderr.startswith("error:")


def test_it_needs_no_numpy():
    code = "import sys; sys.modules['numpy'] = None; sys.argv = ['kahan', '--version']; import kahan_command; kahan_command.main()"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("kahan "), done.stderr
