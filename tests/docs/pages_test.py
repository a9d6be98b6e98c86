"""Plants one error after the other in a small tree, which is sound without them, and asks whether pages.py names it."""

import pathlib
import tempfile
import unittest

import commands
import pages

README = """# Bench

[use](docs/use.md), [a part of it](docs/use.md#one-rig-two-runs), ![picture](docs/live.png)
"""
USE = """# Use

## One rig, two `runs`

`drivers/wire/pd0.{hpp,cpp}`, `drivers/wire/*.hpp`, [home](../README.md), `drydock run rig.toml --for 60s | grep --count x`

    ./rig test          # all
    drydock fault RIG set [--for 5s]
                          [--json]

```console
$ drydock run rig.toml --speed max --run './mine --input {}'
```
"""
DRYDOCK = {"": {"--help"}, "run": {"--for", "--speed", "--run"}, "fault": {"--for", "--json"}}


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in {"README.md": README, "docs/use.md": USE, "docs/live.png": "", "drivers/wire/pd0.hpp": "",
                           "drivers/wire/pd0.cpp": "/// docs/use.md\n"}.items():
            self.write(name, text)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def found(self):
        return list(pages.findings(self.root, DRYDOCK, {"test", "demo"}))

    def finds(self, addition, finding, page="docs/use.md"):
        line = USE.count("\n") + 2
        self.write(page, (self.root / page).read_text(encoding="utf-8") + "\n" + addition + "\n")
        self.assertEqual(self.found(), [f"{page}:{line}: {finding}"])

    def test_nothing_is_found_in_a_sound_tree(self):
        self.assertEqual(self.found(), [])

    def test_a_link_to_a_file_that_is_not_there(self):
        self.finds("[x](run.md)", "the link run.md leads to no file")

    def test_a_link_to_a_heading_that_is_not_there(self):
        self.finds("[x](#one-rig)", "docs/use.md has no heading #one-rig")

    def test_a_heading_in_a_code_block_is_none(self):
        self.finds("[x](#all)\n\n```\n# all\n```", "docs/use.md has no heading #all")

    def test_a_link_in_a_code_block_is_none(self):
        self.write("docs/use.md", USE + "\n    [x](run.md)\n")
        self.assertEqual(self.found(), [])

    def test_a_file_that_is_not_there(self):
        self.finds("`drivers/wire/pd4.hpp`", "there is no drivers/wire/pd4.hpp")

    def test_one_of_two_files_in_braces_that_is_not_there(self):
        self.finds("`drivers/wire/pd0.{hpp,md}`", "there is no drivers/wire/pd0.md")

    def test_a_pattern_that_no_file_has(self):
        self.finds("`drivers/wire/pd4*`", "there is no drivers/wire/pd4*")

    def test_a_file_in_a_code_block(self):
        self.finds("    cat rig_config/demo.toml", "there is no rig_config/demo.toml")

    def test_a_command_that_is_not_there(self):
        self.finds("`build/bin/drydock sail rig.toml`", "drydock has no command sail")

    def test_an_option_that_its_command_does_not_have(self):
        self.finds("`drydock run rig.toml --json out.json`", "drydock run has no option --json")

    def test_an_option_in_the_second_line_of_a_command(self):
        self.finds("    drydock run rig.toml [--for 60s]\n                  [--quiet]", "drydock run has no option --quiet")

    def test_an_option_alone_that_no_command_has(self):
        self.finds("`--summary`", "no command of drydock has --summary")

    def test_a_command_of_rig_that_is_not_there(self):
        self.finds("`./rig sail`", "./rig has no command sail")

    def test_a_page_that_no_link_leads_to(self):
        self.write("docs/lost.md", "# Lost\n\n[x](lost.md)\n")
        self.assertEqual(self.found(), ["docs/lost.md:1: no link leads here from README.md"])

    def test_a_page_in_the_folder_of_pages_about_building(self):
        self.write("docs/build/develop.md", "`drivers/wire/pd4.hpp`\n")
        self.assertEqual(self.found(), ["docs/build/develop.md:1: no link leads here from README.md",
                                        "docs/build/develop.md:1: there is no drivers/wire/pd4.hpp"])

    def test_a_recipes_toy_need_not_be_there(self):
        self.write("docs/use.md", USE + "\n`drivers/wire/dvl/toy_dvl.hpp` `tests/fuzz/fuzz_toy_dvl.cpp`\n")
        self.assertEqual(self.found(), [])

    def test_a_page_that_a_comment_names_and_that_is_not_there(self):
        self.write("drivers/wire/pd0.cpp", "\n/// docs/pd0.md says why.\n")
        self.assertEqual(self.found(), ["drivers/wire/pd0.cpp:2: there is no docs/pd0.md"])


class Help(unittest.TestCase):
    TEXT = """Usage: drydock [OPTIONS] SUBCOMMAND

Options:
  -h,--help                   Print this help message and exit
  -o,--output TEXT            file
  --allow-faults Needs: --serve
                              see --for of run

Subcommands:
  run                         Runs a rig
  man                         A page
"""

    def test_options_are_those_at_the_start_of_a_line(self):
        self.assertEqual(commands.options_in(self.TEXT), {"--help", "--output", "--allow-faults"})

    def test_subcommands_are_those_that_are_listed(self):
        self.assertEqual(commands.subcommands_in(self.TEXT), ["run", "man"])


if __name__ == "__main__":
    unittest.main()
