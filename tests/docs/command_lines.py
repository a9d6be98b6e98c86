"""The command lines in the code blocks of a page."""

import dataclasses
import re

from markdown import Page, joined_lines

# Beside `$ ` of a console, a line of a block is a command where it begins with one of these.
PROGRAMS = ("drydock", "apt-get", "buildah", "candump", "cat", "cc", "cmake", "cp", "ctest", "curl", "docker", "git", "gpsd", "gpspipe", "idlc",
            "ls", "ninja", "podman", "ros2", "sim_vehicle.py", "slcand", "sleep", "sudo")
SHELL = r"export [A-Z_]+=|for \w+ in .*; do "
PATHS = r"\./[\w.-]+ |(?:build|tests|fixtures)/[\w./-]+/[\w.-]+(?:_test|\.py|\.sh)\b|build/\w+/bin/\w+"
PYTHON = r"python3(?: |$)"
START = re.compile(rf"(?:[A-Z_]+=(?:\"[^\"]*\"|\S+) +)*(?:(?:{'|'.join(map(re.escape, PROGRAMS))}) |{SHELL}|{PATHS}|{PYTHON})")


def after_prompt(line):
    return line.strip().removeprefix("$ ") if line.strip().startswith("$ ") else ""


def after_indent(line):
    """The command of a line, also of one in a CI server's YAML; "" where it is something else, such as output."""
    line = re.sub(r"^(?:- )?(?:run: )?", "", line.strip())
    is_command = START.match(line + " ") and not re.search(r"\(new\)|\| +\d+ [+-]+$", line)  # else a row of git diff --stat
    return re.sub(r"\s+# .*", "", line).strip() if is_command else ""


def whole_line(line):
    return "" if re.match(r" *(?:```|#|$)", line) else re.sub(r"\s+# .*", "", line).strip()


READERS = {"console": after_prompt, "sh": whole_line, "bash": whole_line, "": after_indent, "yaml": after_indent}  # of blocks by their language


@dataclasses.dataclass(frozen=True)
class Command:
    """`text`: without prompt and comment. `block`: the line where its block begins. `heading`: the one above it.
    `console`: it stands behind a prompt, with its output below."""

    page: str
    line: int
    block: int
    heading: str
    text: str
    console: bool = False

    def __str__(self):
        return f"{self.page}:{self.line}: {self.text}"


def commands_of(name, page: Page):
    for begin, text in sorted(page.blocks):
        fence = re.match(r" *(?:```+|~~~+)(\w*)", text)
        language = fence[1] if fence else ""
        if language not in READERS:
            continue
        heading = next((title for line, title in reversed(page.headings_at) if line < begin), "")
        for offset, line in joined_lines(text):
            if command := READERS[language](line):
                yield Command(name, begin + text.count("\n", 0, offset), begin, heading, command, language == "console")
