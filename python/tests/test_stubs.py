"""Checks the types of the package strictly, and the stub against the compiled module."""

import subprocess
import sys

import pytest


def run(*arguments):
    done = subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_package_is_typed():
    pytest.importorskip("mypy")
    run("mypy", "--strict", "--no-error-summary", "--ignore-missing-imports", "--cache-dir", "/dev/null", "-p", "kahan")


def test_the_stub_is_true():
    pytest.importorskip("mypy")
    run("mypy.stubtest", "kahan._kahan", "--ignore-missing-stub", "--concise")
