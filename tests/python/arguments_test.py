#!/usr/bin/env python3
"""What wrong arguments are told: the name of the argument, what it was, what is allowed."""

import unittest
import warnings

import drydock
import numpy as np
from tree import ROOT

DEMO = ROOT / "rig_config/rigs/demo.toml"
GOLDEN = ROOT / "fixtures/pd0/golden.pd0"
DIVE = ROOT / "fixtures/dives/log-drops-out/dive.mcap"


class Arguments(unittest.TestCase):
    def check(self, exception, words, call):
        with self.assertRaises(exception) as caught:
            call()
        self.assertEqual(str(caught.exception), words)

    def test_a_whole_number_out_of_its_range_is_told_the_range(self):
        for words, call in (
            ("seed = -1, allowed: 0 to 18446744073709551615", lambda: drydock.run(DEMO, 1, seed=-1)),
            ("seed = 18446744073709551616, allowed: 0 to 18446744073709551615", lambda: drydock.study("roll", seed=2**64)),
            ("runs = -1, allowed: 1 to 1000000", lambda: drydock.study("roll", runs=-1)),
            ("jobs = -2, allowed: 0 to 1024", lambda: drydock.study("roll", jobs=-2)),
            ("address = 256, allowed: 0 to 255", lambda: drydock.decode_capture(GOLDEN, "pd0", address=256)),
            ("start_ns = 9223372036854775807, allowed: -8000000000000000000 to 8000000000000000000",
             lambda: drydock.truth("s-path", [1e8], start_ns=2**63 - 1)),
            ("baud = -9600, allowed: 0 to 4294967295", lambda: drydock.decode_capture(GOLDEN, "pd0", baud=-9600)),
        ):
            self.check(ValueError, words, call)

    def test_an_argument_of_a_wrong_type_is_named(self):
        for words, call in (
            ("duration_s is '60s', allowed: a number of seconds", lambda: drydock.run(DEMO, "60s")),
            ("to_s is [3], allowed: a number of seconds", lambda: drydock.decode_recording(DIVE, to_s=[3])),
            ("seed is 1.5, allowed: a whole number", lambda: drydock.run(DEMO, 1, seed=1.5)),
            ("protocol is None, allowed: a text", lambda: drydock.decode_capture(GOLDEN, None)),
            ("only is 3, allowed: a sequence of names", lambda: drydock.read_recording(DIVE, only=3)),
            ("a name of only is 3, allowed: a text", lambda: drydock.read_recording(DIVE, only=[3])),
            ("estimators is a list, allowed: a dict of functions by name", lambda: drydock.run(DEMO, 1, estimators=[print])),
            ("estimator mine is 3, allowed: a function or a drydock.Estimator", lambda: drydock.run(DEMO, 1, estimators={"mine": 3})),
            ("times_s has the type complex128, allowed: numbers", lambda: drydock.truth("s-path", [1j])),
            ("times_s has the type <U1, allowed: numbers", lambda: drydock.truth("s-path", ["a"])),
            ("controller is 3, allowed: a function", lambda: drydock.run(DEMO, 1, controller=3)),
            ("faults is a dict, allowed: a TOML text or the path of a .toml file", lambda: drydock.run(DEMO, 1, faults={"device": "imu"})),
        ):
            self.check(TypeError, words, call)

    def test_numbers_of_numpy_are_numbers(self):
        run = drydock.run(DEMO, np.float32(1), seed=np.int64(7), truth_period_s=np.float64(0.5))
        self.assertEqual((run.summary["seed"], run.summary["duration_s"], len(run.truth["at_ns"])), (7, 1.0, 3))

    def test_any_callable_is_a_function(self):
        class Counts:
            steps = 0

            def __call__(self, step):
                self.steps += 1

        counts = Counts()
        drydock.run(DEMO, 1, estimators={"counts": counts})
        self.assertEqual(counts.steps, 20)  # of 50 ms

    def test_a_file_that_is_not_there_is_an_error_of_the_system(self):
        for call in (lambda name: drydock.decode_capture(name, "pd0"), drydock.decode_recording, drydock.read_recording,
                     drydock.calibrate, drydock.read_scorecard, drydock.read_calibration):
            with self.assertRaises(FileNotFoundError) as caught:
                call("not/there")
            self.assertEqual(caught.exception.filename, "not/there")

    def test_the_problems_of_a_rig_are_lines_without_an_empty_one(self):
        with self.assertRaises(ValueError) as caught:
            drydock.run("no-such.toml", 1)
        self.assertEqual(str(caught.exception), "no-such.toml: cannot be read: No such file or directory")

    def test_a_warning_names_the_line_of_the_caller(self):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            drydock.decode_capture(GOLDEN, "ubx")
        self.assertEqual([warning.filename for warning in said], [__file__])


if __name__ == "__main__":
    unittest.main()
