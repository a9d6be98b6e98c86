"""The ledger of witnesses: what others confirm of Drydock, as the files beside this one say it. Reading only, nothing is judged here."""

import dataclasses
import hashlib
import pathlib
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
NOTES = {"SOURCES.md"}  # of the captures' folder itself


@dataclasses.dataclass(frozen=True)
class Witness:
    """Somebody who is not Drydock. `files` are patterns below the captures' folder (captures) or the tree (fixtures)."""
    name: str
    kind: str  # captures, fixtures, programs, documents
    title: str
    repository: str = ""
    commit: str = ""
    licence: str = ""
    files: tuple = ()
    beside: tuple = ()
    package: str = ""  # of Debian
    version: str = ""
    npm: str = ""


@dataclasses.dataclass(frozen=True)
class Claim:
    kind: str  # protocols, descriptions, formats, estimators, world
    about: tuple
    says: str
    by: tuple
    tests: tuple
    where: str


def witnesses(folder=HERE):
    found = []
    for file in sorted((folder / "witnesses").glob("*.toml")):
        for name, row in tomllib.loads(file.read_text()).items():
            row = {key: tuple(value) if isinstance(value, list) else value for key, value in row.items()}
            found.append(Witness(name, file.stem, **row))
    return found


def claims(folder=HERE):
    found = []
    for file in sorted((folder / "claims").glob("*.toml")):
        for number, row in enumerate(tomllib.loads(file.read_text())["claim"], 1):
            found.append(Claim(file.stem, tuple(row[file.stem]), row["says"], tuple(row["by"]), tuple(row["tests"]),
                               f"{file.name}: claim {number}"))
    return found


def sums(file):
    """SHA-256 of each path, as sha256sum writes and checks them."""
    return {path: digest for digest, path in (line.split("  ", 1) for line in file.read_text().splitlines())}


def sum_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def files_of(root, patterns):
    """Paths below the root, without those of hidden files."""
    return sorted({path.relative_to(root).as_posix() for pattern in patterns for path in root.glob(pattern) if path.is_file()})


def all_files(root):
    return sorted(path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file())
