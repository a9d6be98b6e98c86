#!/usr/bin/env python3
"""mypy reads the package's types, compares the stubs with the compiled module, and checks a user's program."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import drydock

PACKAGE = pathlib.Path(drydock.__file__).parent


# pybind11 makes all classes of a metaclass of its own, with an __init__ that takes anything and refuses it.
OF_PYBIND11 = r"drydock\._core\.(Measurement|Moment|Step)(\.__init__)?"


@unittest.skipIf(subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode, "mypy is not installed")
class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.room = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))

    def mypy(self, module, *words):
        return subprocess.run([sys.executable, "-m", module, *map(str, words)], capture_output=True, text=True,
                              env={**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": str(self.room / "cache")})

    def test_the_package_is_typed_throughout(self):
        done = self.mypy("mypy", "--strict", PACKAGE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_stub_says_what_the_compiled_module_has(self):
        (self.room / "known").write_text(OF_PYBIND11 + "\n")
        done = self.mypy("mypy.stubtest", "--allowlist", self.room / "known", "drydock._core")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_wrong_call_of_a_user_is_found_before_it_runs(self):
        program = self.room / "program.py"
        program.write_text("import drydock\ndrydock.run('demo', 10, estimator={})\n")
        self.assertIn('Unexpected keyword argument "estimator"', self.mypy("mypy", program).stdout)

    def test_a_controller_may_give_a_list_or_an_array(self):
        program = self.room / "controllers.py"
        program.write_text("import drydock\nimport numpy as np\n"
                           "drydock.run('ardusub', 1, controller=lambda moment: [0.0, 0.5])\n"
                           "drydock.run('ardusub', 1, controller=lambda moment: np.zeros(6))\n")
        done = self.mypy("mypy", "--strict", program)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
