#!/usr/bin/env python3
"""What instructions.py calls a loss."""

import json
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
import instructions  # noqa: E402


class Instructions(unittest.TestCase):
    def test_a_loss_of_ten_percent_is_seen_and_noise_of_one_percent_is_not(self):
        self.assertFalse(instructions.compared({"a": 1_000_000, "b": 1_100_000}, {"a": 1_000_000, "b": 1_000_000}))
        self.assertTrue(instructions.compared({"a": 1_010_000, "b": 700_000}, {"a": 1_000_000, "b": 1_000_000}))

    def test_a_path_without_a_reference_is_not_good(self):
        self.assertFalse(instructions.compared({"new": 1}, {}))

    def test_there_are_ten_paths_and_the_reference_has_each(self):
        file = pathlib.Path(__file__).resolve().parents[2] / "fixtures/bench/instructions.json"
        self.assertEqual(set(json.loads(file.read_text())["instructions"]), set(instructions.PATHS))
        self.assertEqual(len(instructions.PATHS), 10)


if __name__ == "__main__":
    unittest.main()
