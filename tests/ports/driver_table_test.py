"""The table of kernel drivers, of reports as GoogleTest writes them."""
import json
import pathlib
import tempfile
import unittest

from driver_table import table


def test(name, **more):
    return {"name": name, "classname": "Ports/Line", "status": "RUN"} | more


class ATable(unittest.TestCase):
    def of(self, *tests):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "0.tests.json"
            path.write_text(json.dumps({"testsuites": [{"testsuite": list(tests)}]}))
            return table([path])

    def test_counts_the_tests_of_each_driver_and_those_that_failed(self):
        rows = self.of(test("Streams/a", kernel_drivers="usb-serial/ftdi_sio"),
                       test("Streams/b", kernel_drivers="usb-serial/ftdi_sio", failures=[{}]),
                       test("IsProbed", kernel_drivers="pnp/serial usb-serial/ftdi_sio")).splitlines()
        self.assertEqual([row.split() for row in rows[1:]],
                         [["pnp/serial", "1", "0", "Line.IsProbed"], ["usb-serial/ftdi_sio", "1", "0", "Line.IsProbed"],
                          ["usb-serial/ftdi_sio", "1", "1", "Line.Streams"]])

    def test_leaves_out_what_did_not_run_or_names_no_driver(self):
        self.assertEqual(self.of(test("Other"), test("Skipped", kernel_drivers="pnp/serial") | {"status": "NOTRUN"}), "")


if __name__ == "__main__":
    unittest.main()
