"""The ledger as a page: docs/witnesses.md."""

import hashlib
import pathlib

HEAD = """# Witnesses

What others confirm of Drydock. A claim stands only as long as somebody who is not Drydock agrees with it in a test: a capture with what
another program read in it, bytes packed from a maker's document, a program that reads what Drydock writes, numbers of a paper.

`./rig witnesses` makes this page from `tests/witnesses`. The test `witnesses.EveryClaimHasItsWitness` fails when a test is gone or renamed, a
protocol, description, capture format or kind of estimator has no claim, a file of a witness has another SHA-256, a program of a
witness is not installed by CI or is of another version, or this page is not what the command makes.

A test that lacks its captures or its program is skipped. `./rig test` ends with the number of such checks and their reasons, and fails
with `CI=true` on a machine that has captures or names them. [Conformance](build/conformance.md) is the scoreboard of the captures.
"""
KINDS = {"protocols": "Protocols", "descriptions": "Described sensors", "formats": "Files and sockets",
         "estimators": "Estimators and studies", "world": "The emulated world"}


def table(head, rows):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield "| " + " | ".join(row) + " |"
    yield ""


def code(words):
    return " ".join(f"`{word}`" for word in words)


def digest(paths, sums):
    """Of one file its own; of several, that of their lines in the list."""
    if len(paths) == 1:
        return sums[paths[0]]
    return hashlib.sha256("".join(f"{sums[path]}  {path}\n" for path in paths).encode()).hexdigest()


def paths_in(sums, patterns):
    return sorted(path for path in sums if any(pathlib.PurePosixPath(path).match(pattern) for pattern in patterns))


def claim_tables(claims):
    for kind, title in KINDS.items():
        yield f"## {title}\n"
        rows = [(code(c.about), c.says, code(c.by), "<br>".join(f"`{test}`" for test in c.tests))
                for c in claims if c.kind == kind]
        yield from table(("about", "claim", "witnesses", "shown by the tests"), rows)


def file_tables(witnesses, capture_sums, fixture_sums):
    yield "## Captures of others\n"
    yield "They are not in the repository. `sha256sum -c` with `tests/witnesses/captures.sha256` checks them in their folder. The last column is"
    yield "the sum of the file, or of the lines of the witness's files in that list. `unread` counts licence texts, notes and other forms of"
    yield "the same values, which no test reads.\n"
    rows = []
    for w in (w for w in witnesses if w.kind == "captures"):
        paths, unread = paths_in(capture_sums, w.files), paths_in(capture_sums, w.beside)
        rows.append((f"`{w.name}`", w.title, w.repository, w.commit, w.licence, str(len(paths)), str(len(unread)),
                     f"`{digest(paths, capture_sums)}`"))
    yield from table(("witness", "what", "repository", "commit", "licence", "files", "unread", "SHA-256"), rows)
    yield "## Bytes in the repository\n"
    yield "Our encoders did not make them. `fixtures/*/NOTE.md` says how each was made.\n"
    rows = []
    for w in (w for w in witnesses if w.kind == "fixtures"):
        paths = paths_in(fixture_sums, w.files)
        rows.append((f"`{w.name}`", w.title, code(w.files), f"`{digest(paths, fixture_sums)}`"))
    yield from table(("witness", "from", "files", "SHA-256"), rows)


def program_table(witnesses, lock):
    yield "## Programs of others\n"
    rows = []
    for w in (w for w in witnesses if w.kind == "programs"):
        locked = lock["packages"].get(f"node_modules/{w.npm}", {})
        package = f"npm `{w.npm}`" if w.npm else f"Debian `{w.package}`"
        rows.append((f"`{w.name}`", w.title, w.repository, package, locked.get("version", w.version), locked.get("license", w.licence)))
    yield from table(("witness", "what", "repository", "package", "version", "licence"), rows)


def document_table(witnesses):
    yield "## Papers, standards, closed forms\n"
    yield "Their numbers stand in the tests.\n"
    yield from table(("witness", "what"), [(f"`{w.name}`", w.title) for w in witnesses if w.kind == "documents"])


def page(claims, witnesses, capture_sums, fixture_sums, lock):
    lines = [HEAD, *claim_tables(claims), *file_tables(witnesses, capture_sums, fixture_sums),
             *program_table(witnesses, lock), *document_table(witnesses)]
    return "\n".join(lines).rstrip("\n") + "\n"
