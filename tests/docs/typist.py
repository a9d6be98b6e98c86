"""Types a command line as a person at a terminal would, who ends with Ctrl-C what does not end by itself."""

import contextlib
import os
import pathlib
import re
import signal
import subprocess
import time

STUCK_S = 300  # however busy the machine is, a command that takes longer hangs
SILENT_S = 1  # a program that has said nothing for so long works in silence; nothing depends on it but how much is seen


class Typist:
    """`top`: an empty folder for the home, sockets and ptys of the programs. `program`: the first on their PATH."""

    def __init__(self, top, program):
        self.program, self.home, links = program, top / "home", top / "links"
        self.home.mkdir()
        links.mkdir(mode=0o700)
        self.environment = dict(os.environ, XDG_RUNTIME_DIR=str(links), HOME=str(self.home), TMPDIR=str(self.home),
                                ROS_DOMAIN_ID=str(100 + os.getpid() % 100), PATH=f"{program.parent}:{os.environ['PATH']}")
        for name in ("CYCLONEDDS_URI", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"):
            self.environment.pop(name, None)
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job would hand on that it is ignored

    def type(self, command, folder, until_ctrl_c):
        """(exit code, what it said, whether Ctrl-C ended it). `until_ctrl_c`: it is typed as soon as the program is at work."""
        with self.running(command, folder) as (process, said):
            interrupted = []
            if until_ctrl_c:
                self.wait_for(lambda: process.poll() is not None or self.handling_ctrl_c(process.pid))
                self.wait_for(lambda: process.poll() is not None or said(), SILENT_S)
                interrupted = self.handling_ctrl_c(process.pid)
                for pid in interrupted:
                    os.kill(pid, signal.SIGINT)
            with contextlib.suppress(subprocess.TimeoutExpired):
                return process.wait(STUCK_S), said(), bool(interrupted)
            return None, said() + f"\ndoes not end in {STUCK_S} s", bool(interrupted)

    @contextlib.contextmanager
    def beside(self, command, folder):
        """The command works until the end of the context, which begins when it has said something."""
        with self.running(command, folder) as (process, said):
            self.wait_for(lambda: process.poll() is not None or said())
            if process.poll() is not None:
                raise RuntimeError(f"{command} has ended: {said()}")
            yield

    @contextlib.contextmanager
    def running(self, command, folder):
        """The process, and a function that gives what it has said so far. All that is left of it in the end is killed."""
        name = self.home / f"said-{time.monotonic_ns()}"
        with open(name, "wb") as output:
            process = subprocess.Popen(["bash", "-c", f"set -o pipefail; {command}"], cwd=folder, env=self.environment,
                                       stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            yield process, lambda: name.read_text(errors="replace")
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    @staticmethod
    def wait_for(condition, longest_s=STUCK_S):
        until = time.monotonic() + longest_s
        while not condition() and time.monotonic() < until:
            time.sleep(0.02)

    def handling_ctrl_c(self, session):
        """The processes of our program in a session that have a handler of SIGINT."""
        found = []
        for path in pathlib.Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):  # those of others, and those that have just ended
                if os.getsid(int(path.name)) == session and os.path.samefile(path / "exe", self.program):
                    handled = re.search(r"^SigCgt:\s*(\w+)", (path / "status").read_text(), re.M)
                    if int(handled[1], 16) >> (signal.SIGINT - 1) & 1:
                        found.append(int(path.name))
        return found
