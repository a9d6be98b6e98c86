#!/usr/bin/env python3
"""What failed in a run of ctest, in the tests' own words, from its JUnit file: failures.py JUNIT
Behind ctest's list of names it saves the search through the output: of each test the lines of its failed assertions, else its last
lines; at most LINES of one test and TESTS tests, and how many are left out."""
import re
import sys
import xml.etree.ElementTree

LINES, TESTS = 12, 20
# GoogleTest's place and what follows it up to the next of its marks; second_run.py's verdict; what Python and shells end with.
ASSERTION = re.compile(r"^\S+:\d+: Failure\n(?:(?!\[ |\S+:\d+: Failure).*\n?)+|^.*: failed in both runs$|^\w*(?:Error|Exception): .*$", re.M)


def words_of(output):
    """The lines of `output` that say why, shortened."""
    found = [line for match in ASSERTION.finditer(output) for line in match[0].splitlines() if line.strip()]
    lines = found or [line for line in output.splitlines() if line.strip()][-LINES:]
    return lines[:LINES] + ([f"... {len(lines) - LINES} lines more"] if len(lines) > LINES else [])


def failed(junit):
    """Name and output of each test that failed."""
    for case in xml.etree.ElementTree.parse(junit).getroot().iter("testcase"):
        if case.get("status") == "fail":
            yield case.get("name"), case.findtext("system-out") or ""


def report(tests):
    """What to print of these (name, output)."""
    tests = list(tests)
    text = ""
    for name, output in tests[:TESTS]:
        text += f"failed: {name}\n" + "".join(f"    {line[:300]}\n" for line in words_of(output))
    return text + (f"failed too: {len(tests) - TESTS} others\n" if len(tests) > TESTS else "")


if __name__ == "__main__":
    print(report(failed(sys.argv[1])), end="")
