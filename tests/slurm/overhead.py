#!/usr/bin/env python3
"""What Slurm costs: overhead.py DRYDOCK [SHARDS]. Prints how long so many shards take to submit, and the time of a task beside the
sleep that it consists of."""

import pathlib
import re
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from cluster import Cluster, wait_until  # noqa: E402

FILE = '[campaign]\nname = "overhead"\ncommand = "sh {{file:run.sh}}"\nrepetitions = {runs}\n[[file]]\nname = "run.sh"\n' \
       'text = "sleep {seconds}; echo {{\\"y\\": 1}}"\n[[figure]]\nname = "y"\nat = "/y"\n'


def submitted(cluster, room, drydock, shards):
    """Seconds for the submission of so many shards, which are cancelled then."""
    file = room / "many.toml"
    file.write_text(FILE.format(runs=shards, seconds=60))
    words = [drydock, "campaign", str(file), "--out", str(room / "many")]
    begin = time.monotonic()
    said = cluster.run(*words, "--engine", "slurm", "--shard-runs", "1", "--detach")
    took = time.monotonic() - begin
    print(said.stdout.strip() or said.stderr.strip())
    cluster.run(*words, "--cancel")
    wait_until("all are cancelled", lambda: not cluster.run("squeue", "-h").stdout.strip(), 300)
    return took


def journal_times(out):
    """First begin and last end of the runs of each shard, by their journals."""
    for path in sorted(out.glob("runs/*.journal")):
        lines = path.read_text().splitlines()
        ends = [int(re.search(r'"ended_ms":(\d+)', line)[1]) / 1000 for line in lines]
        took = [float(re.search(r'"took_s":([\d.e-]+)', line)[1]) for line in lines]
        yield ends[0] - took[0], ends[-1], took


def task_cost(cluster, room, drydock, tasks, runs, seconds):
    """Wall seconds of one slot of a task beyond the sleep of its runs: the time of the whole campaign on all slots, without it."""
    file = room / "tasks.toml"
    file.write_text(FILE.format(runs=tasks * runs, seconds=seconds))
    out = room / "tasks"
    words = [drydock, "campaign", str(file), "--out", str(out), "--engine", "slurm", "--shard-runs", str(runs)]
    begin = time.time()
    cluster.run(*words)
    times = list(journal_times(out))
    own = sum(sum(took) - runs * seconds for _, _, took in times) / len(times)
    span = max(end for _, end, _ in times) - begin
    slots = 6
    ideal = tasks / slots * runs * seconds
    print(f"{tasks} tasks of {runs} runs of {seconds} s on {slots} slots: {span:.1f} s from the command to the last run, "
          f"{ideal:.1f} s of sleep in each slot: {(span - ideal) / (tasks / slots):.2f} s a task; "
          f"inside of a task {own / runs * 1000:.0f} ms a run")


def main():
    drydock = str(pathlib.Path(sys.argv[1]).resolve())
    shards = int(sys.argv[2]) if len(sys.argv) > 2 else 10000
    with tempfile.TemporaryDirectory(prefix="drydock-slurm-") as folder:
        with Cluster(folder) as cluster:
            print(f"{submitted(cluster, pathlib.Path(folder), drydock, shards):.1f} s for {shards} shards")
            task_cost(cluster, pathlib.Path(folder), drydock, tasks=18, runs=5, seconds=2)


main()
