#!/usr/bin/env python3
"""Counts the instructions of ten paths under valgrind's cachegrind: instructions.py DRYDOCK SOURCE [--check | --update] [--json FILE]

Each path is a command in two sizes. The difference of the two, divided by what the larger one has more, is the cost of one unit,
without the start of the program. Counts repeat to 1 % whatever else the machine does; times do not. --check compares them with
fixtures/bench/instructions.json and exits with 1 if one is 5 % above it."""

import argparse
import json
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ALLOWED = 1.05


def capture(name, protocol, copies):
    """Decoding a capture of fixtures that is repeated so many times, and once more as often. Both files are longer than the head
    in which decode looks for the form of a log, once a file."""
    def words(room, source, twice):
        path = room / f"{name.replace('/', '-')}-{twice}"
        path.write_bytes((source / "fixtures" / name).read_bytes() * (copies * (2 if twice else 1)))
        return ["decode", "--quiet", "--protocol", protocol, path]
    return words, copies


def sized(command, option, less, more):
    def words(_room, source, twice):
        return [*(str(source / word) if word.startswith("rig_config/") else word for word in command.split()), option, more if twice else less]
    return words, float(more.rstrip("s")) - float(less.rstrip("s"))


PATHS = {
    "decode PD0, a file of 5 ensembles": capture("pd0/golden.pd0", "pd0", 400),
    "decode UBX, a golden file": capture("ubx/golden.ubx", "ubx", 800),
    "decode NMEA 0183, a golden file": capture("nmea0183/golden.nmea", "nmea0183", 800),
    "decode Nortek sentences, a golden file": capture("nortek/golden.nmea", "nortek", 800),
    "decode NMEA 2000, a golden trace": capture("nmea2000/frames.log", "nmea2000", 20),
    "decode Aceinna, a golden trace": capture("aceinna/frames.log", "aceinna", 20),
    "demo rig in lockstep, a second": sized("run rig_config/rigs/demo.toml --speed max", "--for", "4s", "12s"),
    "soak of the demo rig, a second": sized("soak rig_config/rigs/demo.toml --no-faults", "--for", "20s", "40s"),
    "leveling study, a run": sized("study leveling --jobs 1", "--runs", "1", "2"),
    "IMU errors with Allan deviation, a second": sized("sensor rig_config/sensors/xsens-mti-630.toml", "--for", "60s", "120s"),
}


def instructions(drydock, words):
    done = subprocess.run(["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null", str(drydock),
                           *map(str, words)], capture_output=True, text=True)
    found = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)
    if not found:
        sys.exit(f"valgrind says nothing about {' '.join(map(str, words))}:\n{done.stderr[-2000:]}")
    return int(found[1].replace(",", ""))


def cost(drydock, source, room, path):
    words, units = path
    less, more = (instructions(drydock, words(room, source, twice)) for twice in (False, True))
    return round((more - less) / units)


def compared(found, reference):
    """True if no path needs more than it may."""
    good = True
    for name, count in found.items():
        known = reference.get(name)
        ratio = count / known if known else None
        worse = ratio is None or ratio > ALLOWED
        good &= not worse
        print(f"{'WORSE' if worse else 'ok   '} {name}: {count:,}" + (f", {100 * (ratio - 1):+.2f} % of {known:,}" if known else ", not in the reference"))
    return good


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("drydock", type=pathlib.Path)
    arguments.add_argument("source", type=pathlib.Path)
    arguments.add_argument("--check", action="store_true")
    arguments.add_argument("--update", action="store_true")
    arguments.add_argument("--json", type=pathlib.Path)
    options = arguments.parse_args()
    source, file = options.source.resolve(), options.source.resolve() / "fixtures/bench/instructions.json"
    with tempfile.TemporaryDirectory() as room, ThreadPoolExecutor(2) as pool:
        counts = pool.map(lambda path: cost(options.drydock.resolve(), source, pathlib.Path(room), path), PATHS.values())
        found = dict(zip(PATHS, counts))
    text = json.dumps({"compiler": subprocess.run(["c++", "-dumpfullversion"], capture_output=True, text=True).stdout.strip(),
                       "machine": platform.machine(), "instructions": found}, indent=2) + "\n"
    if options.json:
        options.json.write_text(text)
    if options.update:
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
    reference = json.loads(file.read_text())["instructions"] if file.exists() else {}
    good = compared(found, reference)
    sys.exit(0 if good or not options.check else 1)


if __name__ == "__main__":
    main()
