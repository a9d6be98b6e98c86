"""The smallest outside estimator: roll and pitch from the specific force of each IMU sample.

docs/build/external-estimator.md describes the lines. Use it in a rig file:

    [[estimator]]
    name = "mine"
    kind = "external"
    imu = "imu"
    gives = "attitude"
    command = ["python3", "leveling_client.py"]
"""

import json
import math
import sys

SIGMA_DEG = 5.0  # the vehicle's own acceleration is taken for gravity: this much, 1 sigma


def leveled(sample):
    x, y, z = sample["specific_force_mps2"]
    return {
        "valid_at_ns": sample["valid_at_ns"],
        "roll_deg": math.degrees(math.atan2(-y, -z)),
        "pitch_deg": math.degrees(math.atan2(x, math.hypot(y, z))),
        "attitude_sigma_deg": [SIGMA_DEG, SIGMA_DEG, 180.0],
    }


def say(message):
    print(json.dumps(message), flush=True)  # without flush, both sides would wait for ever


def main():
    hello = json.loads(sys.stdin.readline())
    if hello["drydock"] != 1:
        sys.exit("this program speaks version 1")
    say({"drydock": 1})
    for line in sys.stdin:
        step = json.loads(line)
        samples = (m for m in step["measurements"] if m["type"] == "imu")
        say({"step": step["step"], "estimates": [leveled(sample) for sample in samples]})


if __name__ == "__main__":
    main()
