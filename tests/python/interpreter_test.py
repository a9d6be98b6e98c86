#!/usr/bin/env python3
"""A run and the rest of the interpreter: other threads, Ctrl-C."""

import os
import signal
import subprocess
import sys
import textwrap
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

    def test_a_program_keeps_its_own_handlers_of_signals_while_a_rig_runs(self):
        said = self.program("""
            heard = []
            def press(number):
                def once(step):
                    if step.number == 1: os.kill(os.getpid(), number)
                return {'press': once}
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, lambda number, frame: heard.append(number))
                assert drydock.run(DEMO, 30, estimators=press(number)).summary['duration_s'] == 30
            print(heard == [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
            signal.signal(signal.SIGINT, signal.SIG_IGN)
            print(drydock.run(DEMO, 30, estimators=press(signal.SIGINT)).summary['duration_s'])""")
        self.assertEqual(said, ("True\n30.0\n", "", 0))

    def test_a_broken_connection_of_another_thread_does_not_end_a_run(self):
        said = self.program("""
            ours, theirs = socket.socketpair()
            theirs.close()
            def write(step):
                if step.number == 1:
                    try: ours.send(b'x')
                    except BrokenPipeError: print('broken')
            print(drydock.run(DEMO, 30, estimators={'write': write}).summary['duration_s'])""")
        self.assertEqual(said, ("broken\n30.0\n", "", 0))

    def test_an_alarm_of_the_program_ends_a_run_that_has_no_function_of_python(self):
        said = self.program("""
            def late(number, frame): raise TimeoutError('too long')
            signal.signal(signal.SIGALRM, late)
            for work in (lambda: drydock.run(DEMO, 1e7), lambda: drydock.study('leveling', runs=1000000, jobs=2)):
                signal.setitimer(signal.ITIMER_REAL, 0.05)
                try: work()
                except TimeoutError as error: print(error)""")
        self.assertEqual(said, ("too long\ntoo long\n", "", 0))

    def test_sigterm_ends_a_program_in_a_run_as_it_ends_python(self):
        said = self.program("""
            drydock.run(DEMO, 1e7, estimators={'press': lambda step: os.kill(os.getpid(), signal.SIGTERM)})""")
        self.assertEqual(said, ("", "", -signal.SIGTERM))

    def test_a_program_ends_while_its_daemon_threads_run_rigs(self):
        said = self.program("""
            begun = threading.Barrier(3)
            def once(step):
                if step.number == 1: begun.wait()
            def work(): drydock.run(DEMO, 1e7, estimators={'once': once})
            for _ in range(2): threading.Thread(target=work, daemon=True).start()
            begun.wait()""")
        self.assertEqual(said, ("", "", 0))

    def test_a_sub_interpreter_is_refused(self):
        said = self.program("""
            import _xxsubinterpreters as interpreters
            try: interpreters.run_string(interpreters.create(), 'import drydock')
            except interpreters.RunFailedError as error: print(error)""")
        self.assertIn("drydock works in the main interpreter of a process alone", said[0])

    def program(self, text):
        """What a program with these lines prints, on both, and how it ends."""
        head = f"import drydock, os, signal, socket, threading\nDEMO = {str(DEMO)!r}\n"
        done = subprocess.run([sys.executable, "-c", head + textwrap.dedent(text)], capture_output=True, text=True, timeout=60)
        return done.stdout, done.stderr, done.returncode


if __name__ == "__main__":
    unittest.main()
