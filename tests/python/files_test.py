#!/usr/bin/env python3
"""Scorecards and calibrations as arrays."""

import json
import pathlib
import tempfile
import unittest

import numpy as np

import drydock
from tree import ROOT, said

CARD = next((ROOT / "fixtures/scorecard").glob("demo*.json"))


class Files(unittest.TestCase):
    def test_a_scorecard_is_a_row_for_each_pair_with_nan_where_nothing_was_seen(self):
        card, text = drydock.read_scorecard(CARD), json.loads(CARD.read_text())
        pairs = card["pairs"]
        self.assertEqual((card["rig"], card["seed"]), (text["rig"], text["seed"]))
        self.assertEqual(pairs["fault"].tolist(), [pair["fault"] for pair in text["pairs"]])
        self.assertEqual(pairs["lost"].dtype, float)
        np.testing.assert_array_equal(np.isnan(pairs["detect_s"]), [pair["detect_s"] is None for pair in text["pairs"]])
        self.assertEqual(pairs["others_accused"].tolist(), [pair["others_accused"] for pair in text["pairs"]])
        self.assertEqual(pairs["leveling.error_deg"].tolist(), [pair["leveling"]["error_deg"] for pair in text["pairs"]])

    def test_a_calibration_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            dive, file = pathlib.Path(folder, "dive.mcap"), pathlib.Path(folder, "calibration.json")
            drydock.run(ROOT / "rig_config/rigs/shelf.toml", 60, record=dive)
            file.write_text(said("calibrate", dive, "--json"))
            read, made = drydock.read_calibration(file), drydock.calibrate(dive)
        self.assertGreater(len(read["findings"]["value"]), 3)
        for name, column in read["findings"].items():
            np.testing.assert_array_equal(column, made["findings"][name], err_msg=name)
        np.testing.assert_array_equal(read["correlation"], made["correlation"])
        np.testing.assert_allclose(np.diag(read["correlation"]), 1, atol=1e-9)

    def test_another_file_is_refused_with_the_command_that_writes_one(self):
        with self.assertRaisesRegex(ValueError, "drydock calibrate --json"):
            drydock.read_calibration(CARD)
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder, "other.json")
            other.write_text("[1, 2]")
            with self.assertRaisesRegex(ValueError, "drydock scorecard --json"):
                drydock.read_scorecard(other)
            other.write_text("{]")
            with self.assertRaisesRegex(ValueError, "other.json is no scorecard: "):
                drydock.read_scorecard(other)


if __name__ == "__main__":
    unittest.main()
