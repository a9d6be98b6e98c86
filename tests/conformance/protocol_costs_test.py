"""Protocol costs: whose a file is, and when the page is stale."""

import pathlib
import unittest

from protocol_costs import is_near, numbers, owner_of, part_of, rounded


class ProtocolCosts(unittest.TestCase):
    def test_a_file_is_of_the_protocol_whose_name_fits_best(self):
        for path, owner in (("drivers/wire/dvl/water_linked_json.cpp", "water-linked-json"), ("drivers/wire/dvl/water_linked.cpp", "water-linked"),
                            ("drivers/device/dvl/nortek_ad2cp_driver.cpp", "nortek-ad2cp"), ("hil/emulate/dvl/nortek_dvl.cpp", "nortek"),
                            ("drivers/wire/nmea2000/fast_packet.cpp", "nmea2000"), ("fixtures/pd5/make_golden.py", "pd4, pd5"),
                            ("drivers/wire/dvl/dvl_frame.cpp", None)):
            self.assertEqual(owner_of(pathlib.PurePosixPath(path)), owner, path)

    def test_a_fuzzer_is_no_test(self):
        self.assertEqual(part_of(pathlib.PurePosixPath("tests/fuzz/fuzz_sbg.cpp")), "fuzzer")
        self.assertEqual(part_of(pathlib.PurePosixPath("tests/drivers/wire/sbg_test.cpp")), "tests")

    def test_a_fifth_more_is_about_the_same_and_a_quarter_more_is_stale(self):
        self.assertTrue(is_near(numbers("| `pd0` | 12: 1,160 |"), numbers("| `pd0` | 12: 1,390 |")))
        self.assertFalse(is_near(numbers("| `pd0` | 12: 1,160 |"), numbers("| `pd0` | 12: 1,460 |")))
        self.assertFalse(is_near(numbers("| `pd0` |  |"), numbers("| `pd0` | 1: 10 |")))

    def test_lines_are_told_to_tens_unless_there_are_fewer(self):
        self.assertEqual((rounded(1164), rounded(4)), ("1,160", "4"))


if __name__ == "__main__":
    unittest.main()
