#!/usr/bin/env python3
"""What ratios.py calls a loss."""

import json
import pathlib
import random
import sys
import unittest

sys.dont_write_bytecode = True
import ratios  # noqa: E402


class Ratios(unittest.TestCase):
    def test_a_loss_of_ten_percent_is_seen_in_the_noise_that_is_allowed(self):
        for noise in (0, 0.02, ratios.TOO_NOISY - 0.001):
            self.assertEqual(ratios.verdict(1.1 * 3, noise, 3), "WORSE")

    def test_what_the_noise_explains_is_no_loss(self):
        self.assertEqual(ratios.verdict(1.06 * 3, 0.02, 3), "ok   ")
        self.assertEqual(ratios.verdict(0.5 * 3, 0.02, 3), "ok   ")

    def test_a_ratio_that_says_nothing_is_not_good(self):
        self.assertEqual(ratios.verdict(3, 0.06, 3), "NOISY")
        self.assertFalse(ratios.compared({"a": (3, 0.06)}, {"a": 3}))
        self.assertFalse(ratios.compared({"a": (3, 0)}, {}))

    def test_load_that_only_adds_time_does_not_move_the_ratio(self):
        draw = random.Random(1)
        loaded = [[base * (1 + draw.expovariate(2)) for _ in range(ratios.TURNS)] for base in (300, 100)]
        for times in loaded:  # a quiet moment comes in each half
            times[2] = times[7] = min(times)
        ratio, noise = ratios.ratio_of(*loaded)
        self.assertAlmostEqual(ratio, min(loaded[0]) / min(loaded[1]))
        self.assertEqual(noise, 0)

    def test_the_turns_of_a_benchmark_are_found_by_its_name_alone(self):
        runs = [{"run_type": "iteration", "run_name": name, "repetition_index": k, "real_time": 7 + k, "cpu_time": 3 + k}
                for name in ("step/type1/iterations:200/manual_time", "step/type10/iterations:200/manual_time", "step") for k in (1, 0)]
        self.assertEqual(ratios.times_of(runs, "step/type1"), [7, 8])
        self.assertEqual(ratios.times_of(runs, "step"), [3, 4])

    def test_every_reference_has_every_ratio(self):
        file = pathlib.Path(__file__).resolve().parents[2] / "fixtures/bench/ratios.json"
        for processor, known in json.loads(file.read_text()).items():
            self.assertEqual(set(known), set(ratios.RATIOS), processor)


if __name__ == "__main__":
    unittest.main()
