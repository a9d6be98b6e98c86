#!/usr/bin/env python3
"""Estimators that are Python functions, in step with a rig."""

import importlib.util
import pathlib
import tempfile
import unittest

import numpy as np

import drydock
from tree import ROOT

DEMO = ROOT / "rig_config/rigs/demo.toml"
CLIENT = ROOT / "docs/build/clients/leveling_client.py"


def client():
    """The page's outside estimator as a module."""
    spec = importlib.util.spec_from_file_location("leveling_client", CLIENT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def rig_with_client(folder):
    """The demo rig with that estimator as a program of its own."""
    text = DEMO.read_text().replace('"../', f'"{ROOT}/rig_config/')
    text += f'\n[[estimator]]\nname = "mine"\nkind = "external"\nimu = "imu"\ngives = "attitude"\ncommand = ["/usr/bin/python3", "{CLIENT}"]\n'
    path = pathlib.Path(folder, "rig.toml")
    path.write_text(text)
    return path


class Estimator(unittest.TestCase):
    def test_a_function_gives_what_the_same_program_gives_over_its_pipe(self):
        leveled = client().leveled

        def by_function(step):
            return [leveled({"valid_at_ns": m.valid_at_ns, "specific_force_mps2": m.specific_force_mps2.tolist()})
                    for m in step.measurements if m.type == "imu"]

        with tempfile.TemporaryDirectory() as folder:
            rig = rig_with_client(folder)
            by_pipe = drydock.run(rig, 20).estimates["mine"]
            in_process = drydock.run(rig, 20, estimators={"mine": by_function}).estimates["mine"]
        self.assertGreater(len(by_pipe["valid_at_ns"]), 1900)
        for name in by_pipe:
            np.testing.assert_array_equal(by_pipe[name], in_process[name], err_msg=name)

    def test_faults_are_a_text_or_the_path_of_a_file(self):
        text = '[[fault]]\ndevice = "dvl"\nfault = "hang"\nstart_s = 1\n'
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "faults.toml")
            path.write_text(text)
            runs = [drydock.run(DEMO, 5, faults=faults).summary["faults"] for faults in (text, path, str(path))]
        self.assertEqual(len(runs[0]), 1)
        self.assertEqual(runs[1], runs[0])
        self.assertEqual(runs[2], runs[0])
        with self.assertRaisesRegex(FileNotFoundError, "nope.toml"):
            drydock.run(DEMO, 1, faults="nope.toml")

    def test_a_name_is_one_that_a_rig_file_may_have(self):
        for name in ("truth", "", "mi ne/../x", "2nd"):
            with self.assertRaisesRegex(ValueError, "an estimator is named"):
                drydock.run(DEMO, 1, estimators={name: lambda step: None})

    def test_steps_come_at_exact_virtual_times_with_older_measurements_in_order(self):
        steps = []
        drydock.run(DEMO, 10, estimators={"watch": drydock.Estimator(steps.append, step_s=0.25)})
        self.assertEqual([s.number for s in steps], list(range(1, len(steps) + 1)))
        ends = np.array([s.now_ns for s in steps[:-1]])
        self.assertTrue((np.diff(ends) == 250_000_000).all())
        for before, step in zip(steps, steps[1:]):
            # The log's sentences take longer at 4800 baud than the rig's reorder window of 0.2 s.
            times = [m.valid_at_ns for m in step.measurements if m.device != "emlog"]
            self.assertEqual(times, sorted(times))
            self.assertTrue(all(before.now_ns <= t < step.now_ns for t in times))

    def test_a_function_sees_every_measurement_of_the_run_with_its_values(self):
        seen = []
        run = drydock.run(DEMO, 10, estimators={"watch": lambda step: seen.extend(step.measurements)})
        for device, tables in run.measurements.items():
            for kind, table in tables.items():
                mine = [m for m in seen if m.device == device and m.type == kind]
                order = np.argsort(table["valid_at_ns"], kind="stable")
                self.assertEqual([m.valid_at_ns for m in mine], table["valid_at_ns"][order].tolist())
        depths = [m.depth_m for m in seen if m.type == "depth"]
        np.testing.assert_array_equal(np.array(depths, dtype=float), run.measurements["depth"]["depth"]["depth_m"])

    def test_it_is_judged_against_the_truth_as_the_others_are(self):
        def truth(step):  # the rig's own filter is within 2 degrees; a constant is not
            return {"valid_at_ns": step.measurements[-1].valid_at_ns, "roll_deg": 30, "pitch_deg": np.float32(0)} if step.measurements else None

        summary = drydock.run(DEMO, 20, estimators={"off": truth}).summary
        mine = next(e for e in summary["estimators"] if e["name"] == "off")
        self.assertGreater(mine["whole_run"]["roll_rms_deg"], 20)

    def test_a_run_without_functions_is_the_run_of_the_program(self):
        first, again = drydock.run(DEMO, 10), drydock.run(DEMO, 10, estimators={"idle": lambda step: None})
        for name, column in first.estimates["leveling"].items():
            np.testing.assert_array_equal(column, again.estimates["leveling"][name], err_msg=name)
        self.assertNotEqual(first.summary["seed"], drydock.run(DEMO, 1, seed=5).summary["seed"])

    def test_an_exception_of_a_function_ends_the_run_and_reaches_the_caller(self):
        calls = []

        def breaks(step):
            calls.append(step.number)
            raise ZeroDivisionError("of mine")

        with self.assertRaisesRegex(ZeroDivisionError, "of mine"):
            drydock.run(DEMO, 3600, estimators={"breaks": breaks})
        self.assertEqual(calls, [1])

    def test_an_estimate_that_cannot_be_is_refused_with_words(self):
        def at(step, **values):
            return {"valid_at_ns": step.now_ns, **values}

        cases = [(lambda s: at(s, roll_deg=1), "without roll_deg and pitch_deg"),
                 (lambda s: at(s, roll_deg=1, pitch_deg=float("nan")), "pitch_deg that is not finite"),
                 (lambda s: at(s, roll_deg=1, pitch_deg=2, valid_at_ns=s.now_ns + 10**9), "allowed: up to"),
                 (lambda s: {"roll_deg": 1, "pitch_deg": 2}, "without valid_at_ns"),
                 (lambda s: object(), "type object, allowed"),
                 (lambda s: "level", "estimator x gave")]
        for function, words in cases:
            with self.assertRaisesRegex((ValueError, TypeError), words):
                drydock.run(DEMO, 5, estimators={"x": function})

    def test_a_wrong_call_says_what_is_allowed(self):
        with self.assertRaisesRegex(ValueError, "an estimator leveling of its own"):
            drydock.run(DEMO, 5, estimators={"leveling": lambda step: None})
        with self.assertRaisesRegex(ValueError, "allowed: attitude, navigation, velocity"):
            drydock.run(DEMO, 5, estimators={"x": drydock.Estimator(lambda step: None, gives="roll")})
        with self.assertRaisesRegex(ValueError, "step_s = 0"):
            drydock.run(DEMO, 5, estimators={"x": drydock.Estimator(lambda step: None, step_s=0)})
        with self.assertRaisesRegex(ValueError, "no-such.toml"):
            drydock.run("no-such.toml", 5)
        with self.assertRaisesRegex(ValueError, "sonar"):
            drydock.run(DEMO, 5, faults='[[fault]]\ndevice = "sonar"\nfault = "hang"\nstart_s = 1\n')

    def test_an_unknown_field_of_a_measurement_names_the_others(self):
        def asks(step):
            for m in step.measurements:
                m.colour

        with self.assertRaisesRegex(AttributeError, "has no colour, but: "):
            drydock.run(DEMO, 5, estimators={"x": asks})


if __name__ == "__main__":
    unittest.main()
