"""failures.py says why a test failed: its assertions, else its last lines."""
import pathlib
import tempfile
import unittest

import failures

GTEST = """Running main()
[ RUN      ] Wire.IsRead
tests/wire_test.cpp:7: Failure
Expected equality of these values:
  2
  3

[  FAILED  ] Wire.IsRead (0 ms)
"""
JUNIT = """<?xml version="1.0"?><testsuite>
<testcase name="a" status="run"><system-out>fine</system-out></testcase>
<testcase name="b" status="fail"><failure/><system-out>one&#10;two&#10;</system-out></testcase>
<testcase name="c" status="notrun"><skipped/></testcase></testsuite>"""


class Failures(unittest.TestCase):
    def test_an_assertion_is_said_without_what_stands_around_it(self):
        self.assertEqual(failures.words_of(GTEST),
                         ["tests/wire_test.cpp:7: Failure", "Expected equality of these values:", "  2", "  3"])

    def test_a_test_that_failed_twice_says_so_before_its_assertions(self):
        self.assertEqual(failures.words_of("Wire.IsRead: failed in both runs\n" + GTEST)[0], "Wire.IsRead: failed in both runs")

    def test_the_last_lines_stand_for_a_program_without_assertions(self):
        self.assertEqual(failures.words_of("\n".join(map(str, range(30))))[-1], "29")
        self.assertEqual(len(failures.words_of("\n".join(map(str, range(30))))), failures.LINES)

    def test_what_is_left_out_is_counted(self):
        self.assertEqual(failures.words_of("a.cpp:1: Failure\n" + "x\n" * 20)[-1], "... 9 lines more")
        self.assertTrue(failures.report([("t", "x")] * 23).endswith("failed too: 3 others\n"))

    def test_only_what_failed_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "tests.xml"
            path.write_text(JUNIT)
            self.assertEqual(failures.report(failures.failed(path)), "failed: b\n    one\n    two\n")


if __name__ == "__main__":
    unittest.main()
