#!/usr/bin/env python3
"""Costs beside a floor or a peer in the same run: ratios.py FOLDER_OF_BENCHMARKS SOURCE [--check | --update] [--json FILE]

Each cost and its floor are measured in turns. A ratio is that of the least times, which other load hardly changes; its noise is
the difference between the two halves of the turns. --check compares with fixtures/bench/ratios.json, which has a
reference for each processor, and exits with 1 where a ratio is 5 % and its noise above it, or too noisy to tell 10 %."""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ALLOWED, TOO_NOISY = 0.05, 0.05
TURNS, MOST_TRIES = 12, 3

# What is measured: a program, the benchmark, what it stands beside.
RATIOS = {
    "SDINS and 15 states beside full matrices": ("navigation_bench", "navigation: SDINS + 15 states, IMU sample", "floor: 15 states by full matrices"),
    "aiding by velocity and depth beside full matrices": ("navigation_bench", "navigation: aiding by velocity and depth", "floor: 15 states by full matrices"),
    "mixing type 2 beside type 1": ("estimator_bench", "mixing_step/type2", "mixing_step/type1"),
    "mixing type 3 beside type 1": ("estimator_bench", "mixing_step/type3", "mixing_step/type1"),
    "vehicle's partial derivatives beside its right-hand side": ("estimator_bench", "vehicle: partial derivatives", "vehicle: right-hand side"),
    "three axes of a sensor beside three normal numbers": ("sensor_bench", "three axes: bias, white noise", "three normal numbers"),
    "Water Linked described beside compiled": ("wire_bench", "described_codec/water_linked", "water_linked"),
    "Nortek described beside compiled": ("wire_bench", "described_codec/nortek", "nortek"),
    "NMEA headings described beside compiled": ("wire_bench", "described_codec/nmea0183_headings", "nmea0183_headings"),
    "Xsens described beside compiled": ("can_bench", "described_xsens_sample", "xsens_sample"),
}


def is_run_of(run, benchmark):
    """Benchmark's own additions to a name begin behind a slash."""
    return run["run_type"] == "iteration" and re.fullmatch(re.escape(benchmark) + "(/(iterations:\\d+|manual_time))*", run["run_name"])


def times_of(runs, benchmark):
    of_it = sorted((run for run in runs if is_run_of(run, benchmark)), key=lambda run: run["repetition_index"])
    return [run["real_time" if run["run_name"].endswith("manual_time") else "cpu_time"] for run in of_it]


def ratio_of(times, floors):
    """The ratio of the least times, and its noise as a share of it."""
    halves = [min(times[k::2]) / min(floors[k::2]) for k in (0, 1)]
    ratio = min(times) / min(floors)
    return ratio, abs(halves[0] - halves[1]) / ratio


def measured(program, names):
    # POSIX knows no backslash before a blank, which re.escape writes.
    words = sorted({re.sub(r"[.+()]", r"\\\g<0>", benchmark) for name in names for benchmark in RATIOS[name][1:]})
    said = subprocess.run([program, "--benchmark_format=json", f"--benchmark_repetitions={TURNS}", "--benchmark_min_time=0.05",
                           "--benchmark_enable_random_interleaving=true",
                           "--benchmark_filter=^(" + "|".join(words) + ")(/|$)"],
                          capture_output=True, text=True, check=True).stdout
    runs = json.loads(said)["benchmarks"]
    return {name: ratio_of(times_of(runs, RATIOS[name][1]), times_of(runs, RATIOS[name][2])) for name in names}


def all_measured(folder):
    """What is too noisy is measured again."""
    found = {}
    for program in dict.fromkeys(row[0] for row in RATIOS.values()):
        names = [name for name, row in RATIOS.items() if row[0] == program]
        for _ in range(MOST_TRIES):
            again = measured(folder / program, names)
            found |= {name: again[name] for name in names if name not in found or again[name][1] < found[name][1]}
            names = [name for name in names if found[name][1] > TOO_NOISY]
            if not names:
                break
    return found


def verdict(ratio, noise, known):
    if known is None:
        return "NEW  "
    if ratio / known - 1 > ALLOWED + noise:
        return "WORSE"
    return "NOISY" if noise > TOO_NOISY else "ok   "


def compared(found, reference):
    """True if every ratio is known, quiet and no worse."""
    good = True
    for name, (ratio, noise) in found.items():
        known = reference.get(name)
        word = verdict(ratio, noise, known)
        good &= word == "ok   "
        print(f"{word} {name}: {ratio:.3f} +- {100 * noise:.1f} %" + (f", {100 * (ratio / known - 1):+.1f} % of {known:.3f}" if known else ""))
    return good


def processor():
    named = re.search(r"^model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    return named[1] if named else "unknown"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("source", type=pathlib.Path)
    arguments.add_argument("--check", action="store_true")
    arguments.add_argument("--update", action="store_true")
    arguments.add_argument("--json", type=pathlib.Path)
    options = arguments.parse_args()
    file = options.source / "fixtures/bench/ratios.json"
    references = json.loads(file.read_text()) if file.exists() else {}
    found = all_measured(options.folder)
    if options.json:
        options.json.write_text(json.dumps({"processor": processor(), "ratios": {
            name: {"ratio": ratio, "noise": noise} for name, (ratio, noise) in found.items()}}, indent=2) + "\n")
    if options.update:
        references[processor()] = {name: round(ratio, 3) for name, (ratio, _) in found.items()}
        file.write_text(json.dumps(references, indent=2) + "\n")
    good = compared(found, references.get(processor(), {}))
    if processor() not in references:
        print(f"there is no reference for {processor()}: ./rig bench --update makes one")
    sys.exit(0 if good or not options.check else 1)


if __name__ == "__main__":
    main()
