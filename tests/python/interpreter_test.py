#!/usr/bin/env python3
"""A run and the rest of the interpreter: other threads, Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import unittest

import drydock
from tree import ROOT

DEMO = ROOT / "rig_config/rigs/demo.toml"


class Interpreter(unittest.TestCase):
    def test_other_threads_run_while_a_rig_runs(self):
        begun, ended, during = threading.Event(), threading.Event(), []

        def other():
            begun.wait()
            while not ended.is_set():
                during.append(None)
                ended.wait(0.001)

        thread = threading.Thread(target=other)
        thread.start()
        first = []

        def once(step):
            if not first:
                first.append(step)
                begun.set()

        # One call at the start, then a minute of virtual time in which only the rig works.
        drydock.run(DEMO, 600, estimators={"once": drydock.Estimator(once, step_s=300)})
        ended.set()
        thread.join()
        self.assertGreater(len(during), 20)

    def test_two_rigs_run_at_the_same_time_and_give_what_they_give_alone(self):
        alone = drydock.run(DEMO, 30).estimates["leveling"]["roll_deg"]
        found = [None, None]

        def work(k):
            calls = []
            found[k] = drydock.run(DEMO, 30, estimators={"idle": calls.append}).estimates["leveling"]["roll_deg"]

        threads = [threading.Thread(target=work, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for roll in found:
            self.assertEqual(roll.tolist(), alone.tolist())
        with self.assertRaises(KeyboardInterrupt):  # the handler is Python's again
            signal.raise_signal(signal.SIGINT)

    def test_ctrl_c_ends_a_run_as_it_ends_python(self):
        script = (f"import drydock, os, signal\n"
                  f"def press(step):\n"
                  f"    if step.number == 1: os.kill(os.getpid(), signal.SIGINT)\n"
                  f"try:\n"
                  f"    drydock.run({str(DEMO)!r}, 36000, estimators={{'press': press}})\n"
                  f"except KeyboardInterrupt:\n"
                  f"    print('interrupted')\n"
                  f"try:\n"
                  f"    signal.raise_signal(signal.SIGINT)\n"
                  f"except KeyboardInterrupt:\n"
                  f"    print('the handler is the old one')\n")
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, env=dict(os.environ))
        self.assertEqual((done.stdout, done.returncode), ("interrupted\nthe handler is the old one\n", 0), done.stderr)


if __name__ == "__main__":
    unittest.main()
