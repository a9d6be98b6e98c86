#!/usr/bin/env python3
"""A Python function steers the vehicle of a rig."""

import math
import unittest

import numpy as np

import drydock
from tree import ROOT

RIG = ROOT / "rig_config/rigs/ardusub.toml"  # a BlueROV2, afloat


class Controller(unittest.TestCase):
    def test_calls_come_at_exact_virtual_times_with_what_arrived_since(self):
        moments = []

        def watch(moment):
            moments.append(moment)
            return []

        run = drydock.run(RIG, 10, controller=watch, controller_period_s=0.125)
        start = moments[0].now_ns
        self.assertEqual([m.now_ns - start for m in moments], [k * 125_000_000 for k in range(81)])
        self.assertEqual([m.time_s for m in moments], [k / 8 for k in range(81)])
        for before, moment in zip(moments, moments[1:]):
            self.assertTrue(all(before.now_ns <= m.received_at_ns <= moment.now_ns for m in moment.measurements))
        heard = sum(len(m.measurements) for m in moments)
        self.assertEqual(heard, sum(len(t["valid_at_ns"]) for tables in run.measurements.values() for t in tables.values()))

    def test_full_ahead_ends_at_the_speed_where_drag_equals_push(self):
        # bluerov2.toml: thrusters 3 and 4 push 51.5 N each at 45 degrees; drag is 4.03 u + 18.18 u^2.
        run = drydock.run(RIG, 20, controller=lambda moment: [0, 0, 1, 1])
        push = 2 * 51.5 * math.cos(math.radians(45))
        speed = (-4.03 + math.sqrt(4.03**2 + 4 * 18.18 * push)) / (2 * 18.18)
        self.assertAlmostEqual(run.truth["velocity_body_mps"][-1, 0], speed, delta=0.01 * speed)
        np.testing.assert_allclose(run.truth["velocity_body_mps"][:, 1], 0, atol=1e-3)

    def test_sensors_see_the_motion_that_the_function_made(self):
        run = drydock.run(RIG, 20, controller=lambda moment: [0, 0, 1, 1])
        track, truth = run.measurements["dvl"]["bottom_velocity"], run.truth
        times = (track["valid_at_ns"] - truth["at_ns"][0]) / 1e9
        ahead = np.interp(times, (truth["at_ns"] - truth["at_ns"][0]) / 1e9, truth["velocity_body_mps"][:, 0])
        seen = np.isfinite(track["velocity_mps"][:, 0])
        self.assertGreater(seen.sum(), 50)
        np.testing.assert_allclose(track["velocity_mps"][seen, 0], ahead[seen], atol=0.02)

    def test_a_closed_loop_holds_its_heading(self):
        def hold(moment):
            error = (180 - moment.truth["heading_deg"] + 180) % 360 - 180
            turn = max(-0.5, min(0.5, 0.003 * error - 0.001 * moment.truth["angular_rate_degps"][2]))
            return [turn, -turn, 0.3 - turn, 0.3 + turn]

        run = drydock.run(RIG, 40, controller=hold)
        heading = run.truth["heading_deg"] % 360
        self.assertAlmostEqual(heading[0], 270, delta=1e-6)
        self.assertAlmostEqual(heading[-1], 180, delta=0.1)

    def test_a_wrong_answer_or_call_says_what_is_allowed(self):
        with self.assertRaisesRegex(ValueError, "output of 1.5, allowed: -1 to 1"):
            drydock.run(RIG, 5, controller=lambda moment: [1.5])
        for wrong in ("ahead", None, 1.0, [None]):
            with self.assertRaisesRegex(ValueError, "the controller gave .*, allowed: a list of numbers"):
                drydock.run(RIG, 5, controller=lambda moment: wrong)
        with self.assertRaisesRegex(ValueError, "gave 7 outputs, allowed: at most the 6 of the vehicle"):
            drydock.run(RIG, 5, controller=lambda moment: [0] * 7)
        with self.assertRaisesRegex(ValueError, "give duration_s"):
            drydock.run(RIG, controller=lambda moment: [])
        with self.assertRaisesRegex(ValueError, "has no vehicle"):
            drydock.run(ROOT / "rig_config/rigs/demo.toml", 5, controller=lambda moment: [])


if __name__ == "__main__":
    unittest.main()
