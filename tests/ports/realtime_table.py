#!/usr/bin/env python3
"""The rows of docs/real-time.md for one kernel: the demo rig without and with --realtime, beside two programs that never wait and
cyclictest (package rt-tests), in the machine whose clock counts instructions. Some minutes; not a test.
usage: [DRYDOCK_PORTS_PACKAGE=linux-image-rt-amd64 DRYDOCK_PORTS_KERNEL=FOLDER] realtime_table.py DRYDOCK [SECONDS]"""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
HEAD = "| kernel | | jitter of the IMU, us | longest IMU interval, ms | jitter of the DVL, us | cyclictest mean, us | cyclictest max, us |"


def commands(drydock, seconds, realtime):
    """What the guest runs; its output is the summary of the run, then cyclictest's last line."""
    rig = HERE.parents[1] / "rig_config/rigs/demo.toml"
    run = f"{shlex.quote(drydock)} run {shlex.quote(str(rig))} --for {seconds}s --json /run/summary.json {realtime} >/dev/null"
    return ("for i in 1 2; do while :; do :; done & done; "
            f"cyclictest -q -m -p90 -i10000 -D {seconds} >/run/cyclictest & {run}; sleep 1; "
            "/run/busybox cat /run/summary.json /run/cyclictest")


def measured(drydock, seconds, realtime):
    done = subprocess.run([sys.executable, "-B", HERE / "with-ports.py", "--virtual", "--seconds", "900",
                           "sh", "-c", commands(drydock, seconds, realtime)], capture_output=True, text=True)
    try:
        summary, end = json.JSONDecoder().raw_decode(done.stdout)
        cycles = re.search(r"Avg:\s*(\d+).*Max:\s*(\d+)", done.stdout[end:])
    except ValueError:
        cycles = None
    if not cycles:
        sys.exit(f"no figures; the machine said:\n{done.stdout}{done.stderr}")
    return {device["name"]: device for device in summary["devices"]}, cycles


def main():
    drydock, seconds = str(pathlib.Path(sys.argv[1]).resolve()), int((sys.argv + ["20"])[2])
    kernel = os.environ.get("DRYDOCK_PORTS_PACKAGE", "linux-image-amd64")
    print(HEAD, "|---|---|---|---|---|---|---|", sep="\n")
    for realtime in ("", "--realtime"):
        devices, cycles = measured(drydock, seconds, realtime)
        imu, dvl = devices["imu"], devices["dvl"]
        print(f"| {kernel} | {realtime or 'normal'} | {imu['jitter_s'] * 1e6:.1f} | {imu['longest_interval_s'] * 1e3:.3f} | "
              f"{dvl['jitter_s'] * 1e6:.1f} | {cycles[1]} | {cycles[2]} |", flush=True)


if len(sys.argv) < 2:
    sys.exit(__doc__)
main()
