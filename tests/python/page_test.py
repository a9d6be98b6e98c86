#!/usr/bin/env python3
"""docs/build/python.md as it is written: its code runs from top to bottom, prints what the page says, and draws its pictures.
--update writes both into the tree."""

import contextlib
import io
import os
import pathlib
import re
import sys
import tempfile
import unittest

import matplotlib

from tree import ROOT

PAGE = ROOT / "docs/build/python.md"
BLOCK = re.compile(r"```python\n(.*?)```\n(?:\n```text\n(.*?)```\n)?", re.S)
NUMBER = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")

os.environ["SOURCE_DATE_EPOCH"] = "0"  # a picture has no date of its own
matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "drydock", "figure.figsize": (7, 2.8), "figure.autolayout": True,
                            "savefig.format": "svg"})


@contextlib.contextmanager
def room():
    """A folder that looks like the tree to the page's code, and keeps what it writes."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("rig_config", "fixtures"):
            os.symlink(ROOT / name, pathlib.Path(folder, name))
        before = os.getcwd()
        os.chdir(folder)
        try:
            yield pathlib.Path(folder)
        finally:
            os.chdir(before)


def typed(text):
    """(code, what the page says that it prints, what it prints) of each block."""
    names = {}
    for code, says in BLOCK.findall(text):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(code, str(PAGE), "exec"), names)
        yield code, says, out.getvalue()


def differ(one, other):
    """Another processor's sine may differ in its last digit; the drawing of it by less than this."""
    if NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return True
    pairs = zip(NUMBER.findall(one), NUMBER.findall(other))
    return any(abs(float(a) - float(b)) > 0.01 + 1e-3 * abs(float(b)) for a, b in pairs)


class Page(unittest.TestCase):
    def test_its_code_prints_and_draws_what_the_page_shows(self):
        with room() as folder:
            for code, says, prints in typed(PAGE.read_text()):
                self.assertFalse(differ(prints, says), f"after\n{code}the page says\n{says}and it prints\n{prints}")
            drawn = sorted(folder.glob("*.svg"))
            self.assertEqual([path.name for path in drawn], sorted(path.name for path in PAGE.parent.glob("python-*.svg")))
            for path in drawn:
                self.assertFalse(differ(path.read_text(), (PAGE.parent / path.name).read_text()), path.name)


def update():
    text = PAGE.read_text()
    with room() as folder:
        for code, says, prints in typed(text):
            old = f"```python\n{code}```\n" + (f"\n```text\n{says}```\n" if says else "")
            text = text.replace(old, f"```python\n{code}```\n" + (f"\n```text\n{prints}```\n" if prints else ""))
        for path in folder.glob("*.svg"):
            (PAGE.parent / path.name).write_bytes(path.read_bytes())
    PAGE.write_text(text)


if __name__ == "__main__":
    if "--update" in sys.argv:
        update()
    else:
        unittest.main()
