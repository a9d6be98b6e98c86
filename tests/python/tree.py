"""Where the tests find the tree and the program, which is their first argument."""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


def said(*words, **options):
    """What the program prints; its exit code is 0."""
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=True, **options).stdout


def lines(*words, **options):
    """The JSON Lines that the program prints."""
    return [json.loads(line) for line in said(*words, **options).splitlines()]
