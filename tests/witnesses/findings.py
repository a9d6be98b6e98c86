"""What is wrong with the ledger: a line for each claim that has lost a witness. No line, and each claim has one."""

import fnmatch
import json
import re
import subprocess

from ledger import NOTES, all_files, files_of, sum_of

# What each kind of claim has to cover; `external` is an estimator of others.
LISTS = {"protocols": "the program knows", "descriptions": "rig_config/devices has", "formats": "the program reads",
         "estimators": "a rig file may name"}


def of_names(claims, witnesses):
    """Claims and witnesses name each other, and nobody else."""
    known, named = {w.name for w in witnesses}, {name for claim in claims for name in claim.by}
    for claim in claims:
        for name in claim.by:
            if name not in known:
                yield f"{claim.where}: there is no witness {name}"
        if not claim.by or not claim.tests:
            yield f"{claim.where}: a claim needs a witness and a test"
    for witness in witnesses:
        if witness.name not in named:
            yield f"{witness.kind}.toml: no claim calls the witness {witness.name}"


def of_coverage(claims, built_in):
    """`built_in`: names of each kind that have to be claimed. Formats and estimators may be claimed beyond them."""
    for kind, names in built_in.items():
        claimed = {name for claim in claims if claim.kind == kind for name in claim.about}
        for name in sorted(names - claimed):
            yield f"claims/{kind}.toml: {LISTS[kind]} {name}, and no claim is about it"
        if kind in ("protocols", "descriptions"):
            for name in sorted(claimed - names):
                yield f"claims/{kind}.toml: a claim is about {name}, which is not there"


def forms(test):
    """The names under which a claim may call a test of ctest: whole, and without the parts of a parametrized one."""
    yield test
    test = re.sub(r"<.*>$", "", test)  # Suite.Name<Type>
    yield test
    bare = re.sub(r"^[^./]+/(?=[^./]+\.)", "", test)  # Prefix/Suite.Name
    yield bare
    yield re.sub(r"/[^/]*$", "", bare)  # Suite.Name/parameter


def of_tests(claims, tests):
    """`tests`: the names that ctest knows."""
    there = {form for test in tests for form in forms(test)}
    unbuilt = sorted(test for test in tests if test.endswith("_NOT_BUILT"))
    if unbuilt:
        yield f"not built, so their tests are not known: {', '.join(unbuilt)}"
    for claim in claims:
        for test in claim.tests:
            if test not in there:
                yield f"{claim.where}: ctest has no test {test}"


def of_files(witnesses, root, sums, what):
    """Each file of a witness has the SHA-256 that the ledger says. `what`: the list's name."""
    for witness in witnesses:
        for pattern in witness.files + witness.beside:
            if not files_of(root, [pattern]):
                yield f"{witness.kind}.toml: {witness.name}: no file is {pattern}"
    listed = [path for witness in witnesses for path in files_of(root, witness.files + witness.beside)]
    for path in sorted(set(listed)):
        if listed.count(path) > 1:
            yield f"{path}: two witnesses have it"
        if path not in sums:
            yield f"{path}: not in {what}; ./rig witnesses adds it"
        elif sum_of(root / path) != sums[path]:
            yield f"{path}: its SHA-256 is not that of {what}: it is another file than the one that was the witness"
    for path in sorted(set(sums) - set(listed)):
        yield f"{what}: {path} is lost, or no witness has it"


def of_strays(witnesses, root):
    """Files among the captures that nobody answers for."""
    known = {path for witness in witnesses for path in files_of(root, witness.files + witness.beside)} | NOTES
    for path in all_files(root):
        if path not in known:
            yield f"{path}: a capture without a witness; give it a row in captures.toml"


def of_packages(witnesses, lists, lock, installed):
    """`lists`: the Debian packages that the tests install. `lock`: of npm. `installed`: version of a Debian package, or None."""
    for witness in witnesses:
        if witness.npm and f"node_modules/{witness.npm}" not in lock["packages"]:
            yield f"programs.toml: {witness.name}: tests/npm/package-lock.json has no {witness.npm}"
        if not witness.package:
            continue
        if witness.package not in lists:
            yield f"programs.toml: {witness.name}: .ci installs no package {witness.package}"
        version = installed(witness.package)
        if version and not fnmatch.fnmatch(re.sub(r"^\d+:", "", version), witness.version + "*"):
            yield f"programs.toml: {witness.name}: {witness.package} is {version}, the witness was {witness.version}"


def debian_version(package):
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status} ${Version}", package],
                           capture_output=True, text=True)
    status, _, version = asked.stdout.partition(" ")
    return version if asked.returncode == 0 and status == "installed" else None


def tests_of(build):
    asked = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    return [test["name"] for test in json.loads(asked.stdout)["tests"]]


def built_in_names(source, drydock):
    def allowed(*arguments):
        said = subprocess.run([drydock, "decode", *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True).stderr
        return set(re.search(r"allowed: (.*)", said)[1].split(", "))

    schema = json.loads((source / "rig_config/schema/rig.schema.json").read_text())
    return {"protocols": allowed("--protocol", "?"),
            "descriptions": {file.stem for file in (source / "rig_config/devices").glob("*.toml")},
            "formats": allowed("--protocol", "can", "--format", "?"),
            "estimators": set(schema["definitions"]["estimator"]["properties"]["kind"]["enum"]) - {"external"}}
