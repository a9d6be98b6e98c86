#!/usr/bin/env python3
"""What a Python function in a run costs: PYTHONPATH=build/release/python tests/bench/callback.py RIG.toml [SECONDS]"""

import sys
import time

import drydock

RIG, SECONDS = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 300.0


def best_s(**options):
    """Processor time of the cheapest of five runs, and the last of them."""
    times = []
    for _ in range(5):
        begun = time.process_time()
        run = drydock.run(RIG, SECONDS, **options)
        times.append(time.process_time() - begun)
    return min(times), run


def reads_imu(step):
    for m in step.measurements:
        if m.type == "imu":
            m.specific_force_mps2


def estimates(step):
    return {"valid_at_ns": step.now_ns - 1, "roll_deg": 0.0, "pitch_deg": 0.0, "attitude_sigma_deg": [1.0, 1.0, 180.0]}


if __name__ == "__main__":
    drydock.run(RIG, SECONDS / 10)
    alone, _ = best_s()
    print(f"{RIG}, {SECONDS:g} s: {alone:.2f} s without a function, {SECONDS / alone:.0f} times real time")
    for name, function in (("that does nothing", lambda step: None), ("that reads each IMU sample", reads_imu),
                           ("that gives an estimate", estimates)):
        for step_s in (0.05, 0.01):
            took, run = best_s(estimators={"mine": drydock.Estimator(function, step_s=step_s)})
            program = next(e for e in run.summary["estimators"] if e["name"] == "mine")["program"]
            print(f"a function {name}, every {step_s * 1000:g} ms: {took:.2f} s, {SECONDS / took:.0f} times real time; "
                  f"{1e6 * (took - alone) / program['steps']:.1f} us a call")
