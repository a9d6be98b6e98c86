"""second_run.py with commands that fail once, always and never."""
import os
import pathlib
import tempfile
import unittest

from second_run import run_twice


class SecondRun(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.ran = pathlib.Path(folder.name) / "ran"

    def shell(self, script):
        """Runs it with $RAN, a file that does not exist in the first run."""
        os.environ["RAN"] = str(self.ran)
        return run_twice(["sh", "-c", script])

    def test_a_command_that_passes_or_is_skipped_runs_once(self):
        for code in (0, 77):
            status, output = self.shell(f'echo one; [ ! -e "$RAN" ] || exit 9; exit {code}')
            self.assertEqual((status, output), (code, "one\n"))

    def test_only_the_tests_that_failed_run_again(self):
        status, output = self.shell(
            'echo "only:$GTEST_FILTER"; [ -e "$RAN" ] && exit 0; : >"$RAN"\n'
            'echo "[  FAILED  ] All/A.B/0, where GetParam() = x (12 ms)"; echo "[  FAILED  ] C.D (3 ms)"; echo "[  FAILED  ] C.D"; exit 1')
        self.assertEqual(status, 0)
        self.assertTrue(output.startswith("All/A.B/0, C.D: passed at the second run only\nonly:All/A.B/0:C.D\n"), output)
        self.assertIn("The first run:\nonly:\n", output)

    def test_a_fault_fails_twice_with_the_status_of_the_last_run(self):
        status, output = self.shell('[ -e "$RAN" ] && exit 3; : >"$RAN"; exit 1')
        self.assertEqual(status, 3)
        self.assertTrue(output.startswith("the command: failed in both runs\n"), output)


if __name__ == "__main__":
    unittest.main()
