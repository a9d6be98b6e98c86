"""The tree, and the program that was built from it."""

import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("DRYDOCK_PROGRAM", ROOT / "build/release/bin/drydock")


def said(*words):
    """What the program prints; its exit code is 0."""
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=True).stdout


def lines(*words):
    """The JSON Lines that the program prints."""
    return [json.loads(line) for line in said(*words).splitlines()]
