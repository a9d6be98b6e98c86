"""Plants commands in pages and rows in tables, and asks whether the walk says what is wrong: walk_test.py SOURCE_FOLDER DRYDOCK."""

import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import walk
import walk_table
from command_lines import Command, commands_of
from markdown import Page
from typist import Typist

PAGE = """# Rig

## By hand

    drydock check rig.toml        # says ok
    rig.toml: ok
    tests/hil/x_test.cpp | 4 ++++
    CYCLONEDDS_URI="$(drydock dds-config)" ./listener topic

## Typed by another

```console
$ drydock doctor
ok      disk
$ grep ok log
```

```yaml
script:
  - drydock run rig.toml --for 1s \\
      --speed max
```

```python
drydock run rig.toml
```

```sh
# twice
any-program --at all    # each line
```
"""
LISTS = 'add_test(NAME program.rig COMMAND py ${DIR}/transcript.py\n  ${SOURCE}/docs/rig.md "Typed by another" x)\n'
ROOT, PROGRAM = (pathlib.Path(word).resolve() for word in sys.argv[1:3])


def rows(tables):
    """The tables of the walk with these rows, the others empty."""
    return mock.patch.multiple(walk_table, **({"NOT_TYPED": [], "BESIDE": [], "LASTS": [], "ANSWERS": []} | tables))


class Lines(unittest.TestCase):
    def test_commands_stand_at_prompts_and_where_a_line_begins_with_a_program(self):
        found = [(command.line, command.text, command.console) for command in commands_of("docs/rig.md", Page(PAGE))]
        self.assertEqual(found, [(5, "drydock check rig.toml", False), (8, 'CYCLONEDDS_URI="$(drydock dds-config)" ./listener topic', False),
                                 (13, "drydock doctor", True), (15, "grep ok log", True), (20, "drydock run rig.toml --for 1s  --speed max", False),
                                 (30, "any-program --at all", False)])


class Planned(unittest.TestCase):
    def plan(self, lists=LISTS, **tables):
        with tempfile.TemporaryDirectory() as folder, rows(tables):
            (pathlib.Path(folder) / "tests").mkdir()
            (pathlib.Path(folder) / "tests/CMakeLists.txt").write_text(lists)
            return walk.Plan(pathlib.Path(folder), {"docs/rig.md": Page(PAGE), "fixtures/NOTE.md": Page(PAGE)})

    def test_each_command_of_readme_and_docs_is_in_one_of_three_places(self):
        plan = self.plan(NOT_TYPED=[("domain 0", r"dds-config")])
        self.assertEqual((plan.total, plan.pages), (6, 1))
        self.assertEqual([command.line for command in plan.here], [5, 20, 30])
        self.assertEqual((dict(plan.elsewhere), dict(plan.untyped)), ({"program.rig": 2}, {"domain 0": 1}))
        self.assertEqual(plan.findings, [])

    def test_a_console_that_no_transcript_types_is_typed_here(self):
        self.assertEqual([command.line for command in self.plan(lists="").here], [5, 8, 13, 15, 20, 30])

    def test_a_reason_that_no_command_has_is_a_finding(self):
        self.assertEqual(self.plan(NOT_TYPED=[("needs root", "sudo")]).findings, ["NOT_TYPED: no command any more: needs root"])

    def test_a_row_that_no_typed_command_needs_is_a_finding(self):
        for table in "BESIDE", "LASTS", "ANSWERS":
            self.assertEqual(self.plan(**{table: [("of old", "sudo", "")]}).findings, [f"{table}: no command any more: of old"])

    def test_a_transcript_whose_heading_has_gone_is_a_finding(self):
        self.assertEqual(self.plan(LISTS.replace("another", "nobody")).findings, ["program.rig: no command stands under its heading"])


class Typed(unittest.TestCase):
    def findings_of(self, *texts):
        commands = [Command("docs/rig.md", 1, 1, "", text) for text in texts]
        return list(walk.type_all(commands, ROOT, PROGRAM, {"docs/rig.md": Page("")}))

    def test_a_command_finds_its_files_and_those_of_the_command_before(self):
        self.assertEqual(self.findings_of("drydock check rig.toml", "drydock new rig mine", "drydock check mine.toml"), [])

    def test_a_command_gets_a_whole_recording_where_ctrl_c_ended_the_one_before(self):
        self.assertEqual(self.findings_of("drydock record rig.toml -o dive.mcap", "drydock replay dive.mcap --quiet"), [])

    def test_a_command_that_fails_is_a_finding_with_its_place_code_and_words(self):
        (finding,) = self.findings_of("drydock check no-such-rig.toml")
        self.assertRegex(finding, r"^docs/rig\.md:1: drydock check no-such-rig\.toml\nexit code 2\n.*No such file")

    def test_an_answer_of_1_is_right_only_with_its_words(self):
        command = Command("docs/rig.md", 1, 1, "", "drydock doctor")
        self.assertTrue(walk.is_right(command, 1, "ok      disk\nwrong   modules", False))
        self.assertFalse(walk.is_right(command, 1, "ok      disk", False))
        self.assertFalse(walk.is_right(command, 2, "wrong   modules", False))
        self.assertFalse(walk.is_right(command, 130, "wrong   modules", False))


class CtrlC(unittest.TestCase):
    def type(self, script, until_ctrl_c):
        with tempfile.TemporaryDirectory() as top:
            typist = Typist(pathlib.Path(top), pathlib.Path(sys.executable).resolve())
            return typist.type(f"trap \"\" INT; {sys.executable} -c '{script}'", pathlib.Path(top), until_ctrl_c)

    def test_it_comes_when_the_program_handles_it(self):
        script = "import signal, time\nsignal.signal(signal.SIGINT, lambda *_: exit(7))\ntime.sleep(300)"  # ignored until then
        self.assertEqual(self.type(script, until_ctrl_c=True)[::2], (7, True))

    def test_a_program_that_ends_before_was_not_interrupted(self):
        self.assertEqual(self.type("print(5)\nexit(3)", until_ctrl_c=True), (3, "5\n", False))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
