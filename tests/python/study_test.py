#!/usr/bin/env python3
"""Studies from Python are those of the program."""

import json
import pathlib
import tempfile
import unittest

import numpy as np

import drydock
from tree import said


class Study(unittest.TestCase):
    def test_a_study_has_the_numbers_that_the_program_writes(self):
        study = drydock.study("leveling", runs=3, seed=7, jobs=1)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "study.json")
            said("study", "leveling", "--runs", 3, "--seed", 7, "--json", path)
            written = json.loads(path.read_text())
        del written["study"]
        self.assertEqual(study.values, written)

    def test_figures_have_arrays_that_are_the_memory_of_the_study(self):
        study = drydock.study("leveling", runs=2)
        curves = [curve for figure in study.figures for curve in figure["curves"]]
        self.assertGreater(len(curves), 3)
        for curve in curves:
            self.assertEqual(curve["x"].shape, curve["y"].shape)
            self.assertEqual(type(curve["y"].base).__name__, "PyCapsule")
            self.assertTrue(np.isfinite(curve["y"]).all())
        for table in study.tables:
            self.assertTrue(all(len(row) == len(table["columns"]) for row in table["rows"]))

    def test_a_wrong_call_says_what_is_allowed(self):
        with self.assertRaisesRegex(ValueError, "allowed: leveling, mixing"):
            drydock.study("levelling")
        with self.assertRaisesRegex(ValueError, "runs = 0, allowed: 1 to 1000000"):
            drydock.study("leveling", runs=0)
        with self.assertRaisesRegex(TypeError, 'cases is a text, allowed: a sequence of names, as \\["x"\\]'):
            drydock.study("velocity", cases="x")
        with self.assertRaisesRegex(ValueError, "has no cases"):
            drydock.study("leveling", cases=["x"])
        with self.assertRaisesRegex(ValueError, "'x' is not known, allowed: "):
            drydock.study("velocity", cases=["x"])


if __name__ == "__main__":
    unittest.main()
