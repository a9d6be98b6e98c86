"""Finds what is wrong in the pages: links and anchors that lead nowhere, files, commands and options that are not there, pages
that the README does not lead to. Usage: pages.py SOURCE_FOLDER DRYDOCK. A line for each finding; exit code 1 if there is one."""

import glob
import os
import pathlib
import re
import sys

import commands
from markdown import Page

HERE = pathlib.Path(__file__).resolve().parent
FOLDERS = "drivers|hil|estimators|rig_config|fixtures|tests|docs|\\.ci"
PATH = re.compile(rf"(?<![\w./~$<>*-])((?:{FOLDERS})/(?:\{{[^{{}}\s]*\}}|[\w.*?/+-])*)")
SOURCES = {".cpp", ".hpp", ".c", ".h", ".toml", ".json", ".sh", ".py", ".cjs", ".txt", ".eds", ".dbc", ".idl", ".md"}

# Paths that stand for any of their kind, and what another project calls its own.
PLACEHOLDERS = {"drivers/capture/x.{hpp,cpp}", "fixtures/dives/lost-bottom-lock/"}
# The examples of docs/build/add-a-command.md and add-a-study.md.
PLACEHOLDERS |= {"hil/program/commands/hello.cpp", "hil/program/commands/NAME.cpp", "hil/study/NAME",
                 "hil/study/mean/CMakeLists.txt", "hil/study/mean/mean_study.hpp", "hil/study/mean/mean_study.cpp"}
EXAMPLE_COMMANDS = {"hello"}
OF_OTHERS = {"docs/spec.md"}  # github.com/foxglove/ws-protocol
# Options that pages name alone, of programs other than drydock.
OTHER_OPTIONS = {"--verbose", "--level"}


def is_elsewhere(path):
    """True for paths above, and for the toys of the recipes in docs/build, which were thrown away."""
    return path in PLACEHOLDERS or path in OF_OTHERS or re.search(r"(?<![a-z])toy[-_]", path)


def files_under(root):
    for folder, below, names in os.walk(root):
        left_out = {"node_modules"} if pathlib.Path(folder).name == "docs" else {"node_modules", "build"}  # docs/build: pages
        below[:] = [name for name in below if name not in left_out and (name == ".ci" or name[0] != ".")]
        for name in names:
            yield pathlib.Path(folder, name)


def pages_of(root):
    return {path.relative_to(root).as_posix(): Page(path.read_text(encoding="utf-8"))
            for path in sorted(files_under(root)) if path.suffix == ".md"}


def target_of(page, link):
    """The file that a relative link means, from the root, and its anchor; None: it leads out of the tree of files."""
    if re.match(r"[a-z]+:", link):
        return None
    path, _, anchor = link.partition("#")
    return os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page, anchor


def broken_links(root, pages):
    for name, page in pages.items():
        for line, link in page.links():
            target = target_of(name, link)
            if target is None:
                continue
            path, anchor = target
            if not (root / path).exists():
                yield f"{name}:{line}: the link {link} leads to no file"
            elif anchor and path in pages and anchor not in set(pages[path].anchors()):
                yield f"{name}:{line}: {path} has no heading #{anchor}"


def unlinked_pages(root, pages):
    """Pages and pictures of docs/ that no way of links leads to from the README."""
    seen, ahead = set(), ["README.md"]
    while ahead:
        page = ahead.pop()
        if page in seen:
            continue
        seen.add(page)
        if page in pages:
            ahead += [target[0] for _, link in pages[page].links() if (target := target_of(page, link))]
    for path in sorted(files_under(root / "docs")):
        if (name := path.relative_to(root).as_posix()) not in seen:
            yield f"{name}:1: no link leads here from README.md"


def expanded(path):
    if braces := re.search(r"\{([^{}]*)\}", path):
        for part in braces[1].split(","):
            yield from expanded(path[: braces.start()] + part + path[braces.end():])
    else:
        yield path


def missing_paths(root, pages):
    for name, page in pages.items():
        for line, code in page.code:
            if "(new)" in code:  # a file of an example, as git diff --compact-summary marks it
                continue
            for path in PATH.findall(code):
                path = path.rstrip(".")
                if is_elsewhere(path):
                    continue
                for one in expanded(path):
                    if not glob.glob(one, root_dir=root):
                        yield f"{name}:{line}: there is no {one}"


def missing_pages(root):
    """Pages that comments, help texts and plain words name."""
    for path in sorted(files_under(root)):
        if path.suffix not in SOURCES or path.parent == HERE:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            for page in re.findall(r"(?<![\w./-])docs/[\w/-]+\.(?:md|svg|png)", line):
                if not is_elsewhere(page) and not (root / page).exists():
                    yield f"{path.relative_to(root).as_posix()}:{number}: there is no {page}"


def wrong_commands(pages, drydock, rig):
    options_of_all = set().union(*drydock.values()) | OTHER_OPTIONS
    for name, page in pages.items():
        for line, code in page.code:
            if (alone := re.match(r"--[a-z][a-z-]*", code)) and alone[0] not in options_of_all:
                yield f"{name}:{line}: no command of drydock has {alone[0]}"
            for command in re.findall(r"(?:^|[\s;&|(])(?:\./|drydock/)rig +([a-z][\w-]*)", code):
                if command not in rig:
                    yield f"{name}:{line}: ./rig has no command {command}"
            for command, rest in re.findall(r"(?:^|[\s;&|(/])drydock +([a-z][\w-]*|--[a-z-]+)(.*)", code):
                if command.startswith("--"):
                    command, rest = "", f"{command} {rest}"
                if command in EXAMPLE_COMMANDS:
                    continue
                if command not in drydock:
                    yield f"{name}:{line}: drydock has no command {command}"
                    continue
                arguments = re.split(r"\s(?:\||\|\||&&?|#)(?:\s|$)|;", re.sub(r"'[^']*'|\"[^\"]*\"", "''", rest))[0]
                for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", arguments):
                    if option not in drydock[command]:
                        yield f"{name}:{line}: drydock {command} has no option {option}"


def findings(root, drydock, rig):
    pages = pages_of(root)
    yield from broken_links(root, pages)
    yield from unlinked_pages(root, pages)
    yield from missing_paths(root, pages)
    yield from missing_pages(root)
    yield from wrong_commands(pages, drydock, rig)


if __name__ == "__main__":
    source, program = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    known = commands.of_program(program)
    assert len(known) > 1, f"{program} --help lists no commands"
    found = list(findings(source, known, commands.of_rig(source / "rig")))
    print(*found, sep="\n")
    sys.exit(1 if found else 0)
