"""The ledger of witnesses, docs/witnesses.md. Usage:
  witnesses.py write SOURCE                 the lists of SHA-256 and the page, from the rows
  witnesses.py check SOURCE BUILD DRYDOCK   a line for each claim without its witness; exit code 1 if there is one
  witnesses.py captures SOURCE              the same for the captures' files; exit code 77 if they are not here"""

import json
import os
import pathlib
import sys

import findings
import ledger
from page import page

CAPTURES, FIXTURES = ledger.HERE / "captures.sha256", ledger.HERE / "fixtures.sha256"
PAGE = "docs/witnesses.md"


def of_kind(witnesses, kind):
    return [witness for witness in witnesses if witness.kind == kind]


def captures_folder(source):
    return pathlib.Path(os.environ.get("DRYDOCK_CORPORA", source / "../shared/corpora"))


def page_of(source, claims, witnesses):
    lock = json.loads((source / "tests/npm/package-lock.json").read_text())
    return page(claims, witnesses, ledger.sums(CAPTURES), ledger.sums(FIXTURES), lock)


def write_sums(file, root, witnesses):
    before = ledger.sums(file) if file.exists() else {}
    paths = ledger.files_of(root, [pattern for witness in witnesses for pattern in witness.files + witness.beside])
    after = {path: ledger.sum_of(root / path) for path in paths}
    for path in sorted(before.keys() | after.keys()):
        if path in before and before[path] != after.get(path):
            print(f"{file.name}: {path} {'is another file than before' if path in after else 'is lost'}")
    file.write_text("".join(f"{digest}  {path}\n" for path, digest in sorted(after.items())))


def write(source):
    claims, witnesses = ledger.claims(), ledger.witnesses()
    write_sums(FIXTURES, source, of_kind(witnesses, "fixtures"))
    if captures_folder(source).exists():
        write_sums(CAPTURES, captures_folder(source), of_kind(witnesses, "captures"))
    else:
        print(f"no captures in {captures_folder(source)}: {CAPTURES.name} stays as it is")
    (source / PAGE).write_text(page_of(source, claims, witnesses))
    return []


def check(source, build, drydock):
    claims, witnesses = ledger.claims(), ledger.witnesses()
    lists = {line for file in source.glob(".ci/packages-*.txt") for line in file.read_text().split()}
    yield from findings.of_names(claims, witnesses)
    yield from findings.of_coverage(claims, findings.built_in_names(source, drydock))
    yield from findings.of_tests(claims, findings.tests_of(build))
    yield from findings.of_files(of_kind(witnesses, "fixtures"), source, ledger.sums(FIXTURES), FIXTURES.name)
    yield from findings.of_packages(witnesses, lists, json.loads((source / "tests/npm/package-lock.json").read_text()),
                                    findings.debian_version)
    if page_of(source, claims, witnesses) != (source / PAGE).read_text():
        yield f"{PAGE} is not what the ledger says; ./rig witnesses makes it"


def captures(source):
    root = captures_folder(source)
    if not root.exists():
        print(f"no captures in {root}")
        sys.exit(77)
    witnesses = of_kind(ledger.witnesses(), "captures")
    yield from findings.of_files(witnesses, root, ledger.sums(CAPTURES), CAPTURES.name)
    yield from findings.of_strays(witnesses, root)


if __name__ == "__main__":
    command = {"write": write, "check": check, "captures": captures}[sys.argv[1]]
    found = list(command(pathlib.Path(sys.argv[2]).resolve(), *sys.argv[3:]))
    for line in found:
        print(line)
    sys.exit(1 if found else 0)
