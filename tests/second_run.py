#!/usr/bin/env python3
"""Runs a command in a machine in software, and what fails a second time: such a machine keeps no real time beside busy neighbours.
A fault fails twice; a machine that stood still does not. The first line says what needed the second run.
A GoogleTest program runs only those of its tests again that failed, any other command the whole.
usage: second_run.py COMMAND [ARGUMENT...]      exit status of the last run; "skipped" (77) is final"""
import os
import re
import subprocess
import sys

SKIPPED = 77
FAILED = re.compile(r"^\[  FAILED  \] ([\w./]+)(?:, where .*)? \(\d+ ms\)$", re.M)


def run(command, only=()):
    """Exit status and output. `only`: names of GoogleTest's tests; none of them means all."""
    chosen = {"GTEST_FILTER": ":".join(only)} if only else {}
    done = subprocess.run(command, env=dict(os.environ, **chosen), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace")
    return done.returncode, done.stdout


def run_twice(command):
    """Exit status of the last run, and what to print."""
    status, first = run(command)
    if status in (0, SKIPPED):
        return status, first
    failed = FAILED.findall(first)
    status, second = run(command, failed)
    verdict = "failed in both runs" if status else "passed at the second run only"
    return status, f"{', '.join(failed) or 'the command'}: {verdict}\n{second}\nThe first run:\n{first}"


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    code, output = run_twice(sys.argv[1:])
    print(output, end="")
    sys.exit(code)
