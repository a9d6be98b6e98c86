#!/usr/bin/env python3
"""Captures as arrays: the numbers that other hands wrote into the golden files, and what the program prints of the same file."""

import pathlib
import tempfile
import unittest

import numpy as np

import drydock
from tree import ROOT, lines

GOLDEN = ROOT / "fixtures/pd0/golden.pd0"


class Capture(unittest.TestCase):
    def test_columns_hold_the_numbers_that_the_golden_file_was_packed_from(self):
        track = drydock.decode_capture(GOLDEN, "pd0")["bottom_velocity"]
        # make_golden.py: the bed moves 250 mm/s to port, 1500 aft, 40 up; the vehicle moves the other way.
        np.testing.assert_allclose(track["velocity_mps"][0], [1.5, 0.25, 0.04], atol=1e-12)
        np.testing.assert_allclose(track["range_m"][0], [12.34, 13.0, 700.0, 1310.77], atol=1e-9)
        self.assertEqual(track["sound_speed_mps"][0], 1500)

    def test_what_the_sensor_did_not_give_is_nan(self):
        track = drydock.decode_capture(GOLDEN, "pd0")["bottom_velocity"]
        self.assertTrue(np.isnan(track["range_m"][1, [1, 3]]).all())
        self.assertTrue(np.isfinite(track["range_m"][1, [0, 2]]).all())

    def test_every_value_is_the_one_that_the_program_prints(self):
        tables = drydock.decode_capture(GOLDEN, "pd0")
        rows = {kind: iter(range(len(table["valid_at_ns"]))) for kind, table in tables.items()}
        printed = lines("replay", GOLDEN, "--protocol", "pd0")
        self.assertEqual(len(printed), 3)  # the NOTE: one of five has no leaders, one no bottom track
        for line in printed:
            table, row = tables[line["type"]], next(rows[line["type"]])
            for name in line.keys() - {"type", "valid_at_s", "received_at_s"}:
                wanted = np.array(line[name], dtype=float)  # null is NaN
                np.testing.assert_array_equal(table[name][row], np.broadcast_to(wanted, table[name][row].shape), err_msg=name)
        self.assertEqual([next(left, None) for left in rows.values()], [None] * len(rows))

    def test_a_file_without_any_measurement_is_told(self):
        with self.assertWarnsRegex(RuntimeWarning, "golden.pd0: no measurement of ubx in it: .* bytes skipped; drydock probe"):
            self.assertEqual(drydock.decode_capture(GOLDEN, "ubx"), {})

    def test_an_array_is_the_memory_that_the_decoder_filled(self):
        table = drydock.decode_capture(GOLDEN, "pd0")["bottom_velocity"]
        for name, array in table.items():
            if array.dtype.kind != "U":
                self.assertEqual(type(array.base).__name__, "PyCapsule", name)
        velocity = table["velocity_mps"]
        del table
        velocity[0, 0] = 7  # it outlives its table and may be written
        self.assertEqual(velocity[0, 0], 7)

    def test_a_sequence_is_flat_with_offsets_for_each_row(self):
        satellites = drydock.decode_capture(ROOT / "fixtures/ubx/golden.ubx", "ubx")["gnss_satellites"]
        offsets = satellites["satellites_offsets"]
        self.assertEqual(offsets[0], 0)
        self.assertEqual(len(offsets), len(satellites["valid_at_ns"]) + 1)
        for name in ("number", "cno_dbhz", "gnss", "used"):
            self.assertEqual(len(satellites[f"satellites.{name}"]), offsets[-1])
        printed = [line["satellites"] for line in lines("replay", ROOT / "fixtures/ubx/golden.ubx", "--protocol", "ubx")
                   if line["type"] == "gnss_satellites"]
        self.assertEqual([s["number"] for row in printed for s in row], satellites["satellites.number"].tolist())
        self.assertEqual([s["gnss"] for row in printed for s in row], satellites["satellites.gnss"].tolist())

    def test_a_wrong_call_says_what_is_allowed(self):
        with self.assertRaisesRegex(ValueError, 'no driver speaks "pd7"'):
            drydock.decode_capture(GOLDEN, "pd7")
        with self.assertRaisesRegex(ValueError, "allowed: emlog, gnss"):
            drydock.decode_capture(GOLDEN, "nmea0183")
        with self.assertRaisesRegex(FileNotFoundError, "no-such-file"):
            drydock.decode_capture("no-such-file", "pd0")

    def test_a_file_of_noise_has_no_measurements_and_does_no_harm(self):
        with tempfile.TemporaryDirectory() as folder:
            noise = pathlib.Path(folder, "noise")
            noise.write_bytes(np.random.default_rng(1).bytes(100_000))
            self.assertEqual(drydock.decode_capture(noise, "pd0"), {})


if __name__ == "__main__":
    unittest.main()
