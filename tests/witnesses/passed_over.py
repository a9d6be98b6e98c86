"""What a run of ctest passed over, from its JUnit file. Usage: passed_over.py JUNIT. A line for each reason, with the number of checks, and
the number of those whose claims of docs/witnesses.md nobody confirmed then. With CI=true the exit code is 1 if there is one, but where
the machine has no captures and none are named: such a machine checks the rest."""

import collections
import os
import re
import sys
import xml.etree.ElementTree

import ledger
from findings import forms

ABSENT = "captures of others are absent: set DRYDOCK_CORPORA, or put them into ../shared/corpora"


def skipped(junit):
    """Name and output of each test that was skipped."""
    for case in xml.etree.ElementTree.parse(junit).getroot().iter("testcase"):
        if case.find("skipped") is not None and case.get("status") == "notrun":
            yield case.get("name"), case.findtext("system-out") or ""


def late(junit):
    """What tests say of checks that passed at their second run only (tests/second_run.py)."""
    for case in xml.etree.ElementTree.parse(junit).getroot().iter("testcase"):
        yield from re.findall(r".+: passed at the second run only$", case.findtext("system-out") or "", re.M)


def reason_of(output, needs_captures):
    """In the test's own words: of gtest the line after its place, of others the first line."""
    if needs_captures:
        return ABSENT
    if said := re.search(r": Skipped\n(.+)", output):
        return said[1].strip()
    return next((line.strip() for line in output.splitlines() if line.strip()), "no reason given")


def captures_are_here():
    named = os.environ.get("DRYDOCK_CORPORA", ledger.HERE / "../../../shared/corpora")
    return os.path.isdir(named)


def every_witness_must_be_heard(env, here):
    """Whoever names captures means to have them: a wrong name is a failure, too."""
    return env.get("CI") == "true" and (here or "DRYDOCK_CORPORA" in env)


def tests_by_claim(claims, witnesses, here):
    """Each test that a claim names, and whether it is passed over because there are no captures."""
    captures = {witness.name for witness in witnesses if witness.kind == "captures"}
    named = {"witnesses.CapturesAreTheFilesThatAgreed": not here}
    for claim in claims:
        for test in claim.tests:
            named[test] = named.get(test, False) or (not here and bool(captures & set(claim.by)))
    return named


def summary(passed_over, named):
    """Reasons with their numbers, and how many of the tests bear a claim. `passed_over`: names and outputs."""
    reasons, lost = collections.Counter(), 0
    for name, output in passed_over:
        form = next((form for form in forms(name) if form in named), None)
        lost += form is not None
        reasons[reason_of(output, form is not None and named[form])] += 1
    return reasons, lost


def main(junit):
    print("".join(f"{line}\n" for line in late(junit)), end="")
    reasons, lost = summary(skipped(junit), tests_by_claim(ledger.claims(), ledger.witnesses(), captures_are_here()))
    if not reasons:
        print("passed over: no check")
        return 0
    print(f"passed over: {reasons.total()} checks, {lost} of them witnesses of docs/witnesses.md")
    for reason, count in reasons.most_common():
        print(f"{count:>8}  {reason}")
    if lost and every_witness_must_be_heard(os.environ, captures_are_here()):
        print("with CI=true and captures each witness has to be heard")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
