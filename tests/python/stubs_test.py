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


def mypy(module, *words):
    with tempfile.TemporaryDirectory() as cache:
        return subprocess.run([sys.executable, "-m", module, *words], capture_output=True, text=True,
                              env={**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": cache})


@unittest.skipIf(subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode, "mypy is not installed")
class Stubs(unittest.TestCase):
    def test_the_package_is_typed_throughout(self):
        done = mypy("mypy", "--strict", str(PACKAGE))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_stub_says_what_the_compiled_module_has(self):
        done = mypy("mypy.stubtest", "--ignore-missing-stub", "drydock._core")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_wrong_call_of_a_user_is_found_before_it_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "program.py")
            program.write_text("import drydock\ndrydock.run('demo', 10, estimator={})\n")
            done = mypy("mypy", str(program))
        self.assertIn('Unexpected keyword argument "estimator"', done.stdout)


if __name__ == "__main__":
    unittest.main()
