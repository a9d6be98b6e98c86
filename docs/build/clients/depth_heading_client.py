"""The smallest autopilot outside: holds a heading and a depth by what the sensors say.

docs/world/steering-program.md describes the lines. Use it in a mission file:

    [steering]
    from = "program"
    command = ["python3", "depth_heading_client.py", "90", "5"]    # degrees, metres
"""

import json
import math
import sys

LENGTH_M, SPEED_MPS, ADVANCE_M = 5.3, 1.8, 0.012  # of the vehicle, and of its propeller each radian
NU = SPEED_MPS / LENGTH_M  # lengths a second


def say(message):
    print(json.dumps(message), flush=True)  # without flush, both sides would wait for ever


def within(value, limit):
    return max(-limit, min(limit, value))


class Autopilot:
    """The gains are those of docs/world/vehicle.md. Degrees, metres."""

    def __init__(self, heading_deg, depth_m):
        self.wanted_heading, self.wanted_depth = heading_deg, depth_m
        self.seen = {}
        self.heading_sum = self.depth_sum = self.pitch_sum = 0.0

    def see(self, measurement):
        for key in ("heading_deg", "pitch_deg", "depth_m", "angular_rate_degps"):
            if measurement.get(key) is not None:
                self.seen[key] = measurement[key]

    def orders(self, step_s):
        orders = [{"joint": "propeller", "velocity_radps": SPEED_MPS / ADVANCE_M}]
        if len(self.seen) < 4:
            return orders  # some sensor has not spoken yet
        pitch_rate, turn_rate = self.seen["angular_rate_degps"][1:]
        off = (self.wanted_heading - self.seen["heading_deg"] + 180) % 360 - 180
        high = self.wanted_depth - self.seen["depth_m"]
        self.heading_sum = within(self.heading_sum + 0.1 * NU * off * step_s, 5)
        self.depth_sum = within(self.depth_sum + 0.0016 * NU * NU * high * step_s, 0.1)
        descent_mps = within(0.08 * NU * high + self.depth_sum, SPEED_MPS / 2)
        low = -math.degrees(math.asin(descent_mps / SPEED_MPS)) - self.seen["pitch_deg"]
        self.pitch_sum = within(self.pitch_sum + 0.25 * NU * low * step_s, 10)
        rudder = -(off + self.heading_sum - 0.57 * turn_rate / NU)  # positive turns to port
        planes = -(1.5 * low + self.pitch_sum - 0.35 * pitch_rate / NU)  # and the nose down
        orders.append({"joint": "rudder", "position_deg": within(rudder, 20)})
        orders.append({"joint": "stern_planes", "position_deg": within(planes, 20)})
        return orders


def main():
    hello = json.loads(sys.stdin.readline())
    if hello["drydock"] != 1:
        sys.exit("this program speaks version 1")
    say({"drydock": 1})
    autopilot = Autopilot(float(sys.argv[1]), float(sys.argv[2]))
    for line in sys.stdin:
        step = json.loads(line)
        for measurement in step["measurements"]:
            autopilot.see(measurement)
        say({"step": step["step"], "orders": autopilot.orders(hello["step_s"])})


if __name__ == "__main__":
    main()
