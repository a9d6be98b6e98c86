"""Runs the commands of a transcript in a page of docs and checks their output, so that the page stays correct.
Usage: transcript.py PAGE HEADING DRYDOCK SOURCE_FOLDER

The transcript is below the heading, in blocks that begin with ```console. `$ ` begins a command, `> ` continues it, and the next lines
are its output. Every output line must come, in any order; numbers and paths may differ. `...` stands for lines that are not shown.
Digits after a letter are no number (pd0 is a name). Bytes in hex are numbers. "0 bad" and "0 lost" must match exactly; in a table of the
monitor one bad frame may come, that in which it began to listen. A command must succeed unless the line after its output is `(exit code N)`."""

import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

page, heading, program, source = sys.argv[1:]
mark = "@@transcript"
number = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


class Step:
    def __init__(self, command):
        self.command, self.expected, self.code = command, [], 0

    @property
    def in_background(self):
        return self.command.endswith("&")


def steps_of(text):
    section = re.search(rf"^#+ {re.escape(heading)}\n(.*?)(?=^#+ |\Z)", code_aside(text), re.M | re.S)
    assert section, f"{page} has no section {heading}"
    steps = []
    for block in re.findall(r"^```console\n(.*?)^```", text[slice(*section.span(1))], re.M | re.S):
        for line in block.splitlines():
            if line.startswith("$ "):
                steps.append(Step(line[2:]))
            elif line.startswith("> ") or line == ">":
                steps[-1].command += "\n" + line[2:]
            elif code := re.fullmatch(r"\(exit code (\d+)\)", line):
                steps[-1].code = int(code[1])
            elif line and line != "...":
                steps[-1].expected.append(line)
    return steps


def code_aside(text):
    """Replaces "#" in code blocks, so that code does not look like headings. The length stays the same."""
    return re.sub(r"^```.*?^```", lambda block: block[0].replace("#", " "), text, flags=re.M | re.S)


def pattern_of(line):
    words = []
    in_table = line.rstrip().endswith(" s") and " age " in line
    for word, following in itertools.pairwise(line.split() + [""]):
        if word.startswith("/"):
            words.append(r"/\S+")
            continue
        if word == "0" and re.match("bad|lost", following):
            words.append("[01]" if in_table and following == "bad" else "0")
            continue
        if re.fullmatch(r"[0-9A-F]{2}", word):
            words.append(rf"(?:[0-9A-F]{{2}}|{number})")
            continue
        parts = re.split(rf"((?<![A-Za-z0-9_]){number})", word)
        words.append("".join(number if i % 2 else re.escape(part) for i, part in enumerate(parts)))
    return re.compile(r"\s*" + r"\s+".join(words) + r"\s*")


def script_of(steps):
    """Waits a second after a background command, like a person who types the next one."""
    lines = ["set -m"]
    for number, step in enumerate(steps):
        lines += [f"echo {mark} {number}", step.command]
        lines += ["sleep 1"] if step.in_background else [f"echo {mark} code $?"]
    return "\n".join(lines + [f"echo {mark} end", "kill $(jobs -p) 2>/dev/null; wait"])


def run(steps):
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(pathlib.Path(source) / "rig_config", pathlib.Path(folder) / "rig_config")
        links = pathlib.Path(folder) / "run"
        links.mkdir(mode=0o700)
        environment = dict(os.environ, XDG_RUNTIME_DIR=str(links), ROS_DOMAIN_ID=str(100 + os.getpid() % 100))
        environment["PATH"] = os.path.dirname(os.path.abspath(program)) + ":" + os.environ["PATH"]
        done = subprocess.run(["bash", "-c", script_of(steps)], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.stdout


def check(steps, output):
    """The output of a background command may come at any time after its start."""
    parts = re.split(rf"^{mark} (?:\d+|end)\n", output, flags=re.M)[1:]
    assert len(parts) == len(steps) + 1, output
    failures = []
    for number, step in enumerate(steps):
        own = "".join(parts[number:]) if step.in_background else parts[number]
        code = re.search(rf"{mark} code (\d+)", parts[number])
        if not step.in_background and int(code[1]) != step.code:
            failures.append(f"$ {step.command}\nexit code {code[1]}, not {step.code}; it said:\n{parts[number]}")
        came = own.splitlines()
        for line in step.expected:
            found = next((i for i, candidate in enumerate(came) if pattern_of(line).fullmatch(candidate)), None)
            if found is None:
                failures.append(f"$ {step.command}\ndid not say: {line}\nbut:\n{own}")
                break
            del came[found]
    return failures


steps = steps_of(pathlib.Path(page).read_text())
assert len(steps) > 5 and sum(len(step.expected) for step in steps) > 10, "not much of a transcript"
failures = check(steps, run(steps))
print("\n\n".join(failures) or f"{len(steps)} commands, {sum(len(s.expected) for s in steps)} lines of output as in {page}")
sys.exit(1 if failures else 0)
