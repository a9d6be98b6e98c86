"""Types the commands of README.md and docs as they stand there: walk.py SOURCE_FOLDER DRYDOCK [WHICH ...].
WHICH: `real-time` (what speaks to emulated devices on this machine), `virtual-time` (the rest), PAGE or PAGE:LINE; default all.

Each block of a page has a folder of its own, with the files that its commands read; its commands are typed in their order. A command
must end with 0, or, after Ctrl-C, as docs/use/run.md says; walk_table.py has what is not typed, and when 1 is right. Each
command and each row that is not as it should be is a finding. The last line counts; exit code 1 if there is a finding."""

import collections
import contextlib
import pathlib
import re
import sys
import tempfile

import pages
import walk_table
from command_lines import commands_of
from page_files import PageFiles
from typist import Typist

TRANSCRIPT = re.compile(r"add_test\(NAME (\S+)[^)]*?transcript\.py\s+\S*?/(docs/\S+\.md) \"([^\"]+)\"", re.S)


def transcripts(root):
    """{(page, heading): the test of ctest that types its commands and compares their output}"""
    lists = "\n".join(path.read_text() for path in sorted((root / "tests").rglob("CMakeLists.txt")))
    return {(page, heading): test for test, page, heading in TRANSCRIPT.findall(lists)}


class Plan:
    """Which commands are typed here; `elsewhere` and `untyped` count the others by test and by reason. `findings`: rows of no use."""

    def __init__(self, root, found_pages):
        self.here, self.elsewhere, self.untyped, self.findings = [], collections.Counter(), collections.Counter(), []
        tests, self.total = transcripts(root), 0
        of_pages = {name: list(commands_of(name, page)) for name, page in found_pages.items() if re.match(r"README|docs/", name)}
        self.pages = sum(1 for commands in of_pages.values() if commands)
        for command in (command for commands in of_pages.values() for command in commands):
            self.total += 1
            if test := tests.get((command.page, command.heading) if command.console else None):
                self.elsewhere[test] += 1
            elif why := walk_table.first_of(walk_table.NOT_TYPED, command):
                self.untyped[why] += 1
            else:
                self.here.append(command)
        self.findings += [f"{test}: no command stands under its heading" for test in set(tests.values()) - set(self.elsewhere)]
        self.findings += [f"NOT_TYPED: no command any more: {why}" for why, _ in walk_table.NOT_TYPED if not self.untyped[why]]
        for table in ("BESIDE", "LASTS", "ANSWERS"):
            self.findings += [f"{table}: no command any more: {row[0]}" for row in getattr(walk_table, table)
                              if not any(re.search(row[1], walk_table.key(command)) for command in self.here)]


def is_right(command, code, said, interrupted):
    """By the rule of docs/use/run.md a command that was told no end tells by 0 or 1 what it saw until Ctrl-C, any other ends with 130."""
    if code == 0 or interrupted and code in (1, 130):
        return True
    return code == 1 and any(re.search(pattern, walk_table.key(command)) and re.search(says, said)
                             for _, pattern, says in walk_table.ANSWERS)


def type_all(commands, root, program, found_pages):
    """A finding for each command that is not right."""
    with tempfile.TemporaryDirectory(prefix="drydock-walk-") as top:
        top = pathlib.Path(top)
        typist = Typist(top, program)
        (top / "kept").mkdir()
        files, written_of = PageFiles(root, top / "kept", program), {}
        for command in commands:
            folder = top / f"{command.page.replace('/', '-')}-{command.block}"
            if folder not in written_of:
                files.new_folder(folder)
                written_of[folder] = set()
            outputs = files.put(command.text, found_pages[command.page], folder, written_of[folder])
            lasts = walk_table.first_of(walk_table.LASTS, command)
            rig = walk_table.first_of(walk_table.BESIDE, command)
            with typist.beside(f"drydock emulate {rig}", folder) if rig else contextlib.nullcontext():
                code, said, interrupted = typist.type(command.text.removesuffix("&"), folder, bool(lasts))
            if not interrupted:  # else little is in them
                written_of[folder] |= outputs
            if not is_right(command, code, said, interrupted):
                yield f"{command}\nexit code {code}\n{said[-1000:]}"


def main(source, program, *wanted):
    root, found_pages = pathlib.Path(source).resolve(), pages.pages_of(pathlib.Path(source).resolve())
    plan = Plan(root, found_pages)
    part = lambda command: "real-time" if walk_table.in_real_time(command) else "virtual-time"
    here = [command for command in plan.here if not wanted or {part(command), command.page, f"{command.page}:{command.line}"} & set(wanted)]
    findings = plan.findings + list(type_all(here, root, pathlib.Path(program).resolve(), found_pages))
    print(*findings, sep="\n\n")
    counted = lambda counter: ", ".join(f"{number} {name}" for name, number in counter.most_common())
    ctrl_c = sum(1 for command in plan.here if walk_table.first_of(walk_table.LASTS, command))
    print(f"{plan.total} commands of {plan.pages} pages: {len(plan.here)} typed here ({ctrl_c} of them until Ctrl-C; {len(here)} in this run), "
          f"{plan.elsewhere.total()} typed by other tests ({counted(plan.elsewhere)}), {plan.untyped.total()} not typed ({counted(plan.untyped)})")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
