#!/usr/bin/env python3
"""Recordings as arrays, beside what was measured when they were made and what the program exports."""

import csv
import json
import pathlib
import tempfile
import unittest
import warnings

import numpy as np

import drydock
from tree import ROOT, said

DIVES = ROOT / "fixtures/dives"


def written_then(dive, device):
    """The measurements of a device in the file that was written when the dive was cut."""
    for line in map(json.loads, (DIVES / dive / "expected.jsonl").read_text().splitlines()):
        if line.get("device") == device and "type" in line:
            yield line


class Recording(unittest.TestCase):
    def test_the_bytes_give_the_measurements_that_they_gave_when_the_dive_was_cut(self):
        for dive in ("log-drops-out", "rudder-swings", "antenna-dives"):
            compared = 0
            for device, tables in drydock.decode_recording(DIVES / dive / "dive.mcap").items():
                rows = {kind: 0 for kind in tables}
                for line in written_then(dive, device):
                    kind, row = line["type"], rows[line["type"]]
                    rows[kind] += 1
                    for name, value in line.items():
                        if name in tables[kind] and tables[kind][name].dtype.kind == "f":
                            got = tables[kind][name][row]
                            np.testing.assert_allclose(got, np.broadcast_to(np.array(value, dtype=float), got.shape), rtol=1e-9,
                                                       atol=1e-9, err_msg=f"{dive} {device} {name}")
                            compared += 1
                self.assertEqual(rows, {kind: len(table["valid_at_ns"]) for kind, table in tables.items()})
            self.assertGreater(compared, 50, dive)

    def test_messages_are_those_that_the_program_exports(self):
        recording = DIVES / "log-drops-out/dive.mcap"
        topics = drydock.read_recording(recording)
        self.assertGreater(len(topics), 2)
        with tempfile.TemporaryDirectory() as folder:
            said("export", recording, "--to", "csv", "-o", pathlib.Path(folder, "csv"))
            for topic, table in topics.items():
                with open(pathlib.Path(folder, "csv", topic.strip("/").replace("/", "_") + ".csv"), encoding="utf-8") as file:
                    rows = list(csv.reader(file))[1:]
                self.assertEqual(len(table["log_time_ns"]), len(rows), topic)
                times = [int(row[0].replace(".", "")) for row in rows]
                self.assertEqual(table["log_time_ns"].tolist(), times, topic)

    def test_a_part_is_the_same_as_the_whole_within_its_times(self):
        recording = DIVES / "log-drops-out/dive.mcap"
        whole, part = drydock.read_recording(recording), drydock.read_recording(recording, from_s=5, to_s=10)
        begin = min(table["log_time_ns"][0] for table in whole.values())
        for topic, table in part.items():
            self.assertTrue((table["log_time_ns"] >= begin).all())
            inside = np.isin(whole[topic]["log_time_ns"], table["log_time_ns"])
            for name in table:
                if not name.endswith("_offsets") and len(whole[topic][name]) == len(inside):
                    np.testing.assert_array_equal(whole[topic][name][inside], table[name], err_msg=name)

    def test_what_cannot_be_read_is_said(self):
        recording = DIVES / "log-drops-out/dive.mcap"
        with self.assertRaisesRegex(ValueError, "sonar"):
            drydock.read_recording(recording, only=["sonar"])
        for read in (drydock.read_recording, drydock.decode_recording):
            with self.assertRaisesRegex(TypeError, 'only is a text, allowed: a sequence of names, as \\["imu"\\]'):
                read(recording, only="imu")
            with self.assertRaisesRegex(ValueError, "allowed: from_s before to_s"):
                read(recording, from_s=20, to_s=10)
            for name in ("from_s", "to_s"):
                for seconds in (float("nan"), float("inf"), 1e10):
                    with self.assertRaisesRegex(ValueError, f"{name} is .*, allowed: seconds since the first message"):
                        read(recording, **{name: seconds})
        with self.assertRaisesRegex(FileNotFoundError, "no-such.mcap"):
            drydock.decode_recording("no-such.mcap")
        with tempfile.TemporaryDirectory() as folder:
            cut = pathlib.Path(folder, "cut.mcap")
            cut.write_bytes(recording.read_bytes()[:-2000])
            for read in (drydock.read_recording, drydock.decode_recording):
                with warnings.catch_warnings(record=True) as said_of_it:
                    warnings.simplefilter("always")
                    read(cut)
                self.assertEqual([w.category for w in said_of_it], [RuntimeWarning], read.__name__)


if __name__ == "__main__":
    unittest.main()
