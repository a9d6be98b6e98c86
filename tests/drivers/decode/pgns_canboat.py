"""`drydock decode --pgns` reads what canboat's analyzer reads: every value of its expected files, with canboat's own table of PGNs (npm:
@canboat/ts-pgns) and its own captures. Usage: pgns_canboat.py SOURCE_FOLDER DRYDOCK; exit status 77 without the table or the captures."""

import collections
import json
import os
import pathlib
import re
import subprocess
import sys

root, drydock = pathlib.Path(sys.argv[1]), sys.argv[2]
corpora = pathlib.Path(os.environ.get("DRYDOCK_CORPORA", root / "../shared/corpora")) / "n2k/canboat"
table_file = root / "build/npm/node_modules/@canboat/ts-pgns/canboat.json"
if not table_file.exists() or not corpora.exists():
    print("no table in build/npm or no captures")
    sys.exit(77)

forms = {}  # (PGN, description) -> Id
ids = {}  # (PGN, the field's name) -> its Ids in all forms of the PGN
steps = {}  # (PGN, Id) -> resolution
for definition in json.loads(table_file.read_text())["PGNs"]:
    forms[definition["PGN"], definition["Description"]] = definition["Id"]
    for field in definition["Fields"]:
        ids.setdefault((definition["PGN"], field["Name"].lower()), set()).add(field["Id"])
        steps[definition["PGN"], field["Id"]] = field.get("Resolution", 1)

NOT_COMPARED = {"Reserved", "Spare"}  # they are no values


def number(text):
    return float(text) if re.fullmatch(r"-?[0-9.]+(e-?[0-9]+)?", str(text)) else None


def same(theirs, ours, step):
    """canboat prints numbers rounded to the step, times and dates as counts or as text."""
    if isinstance(theirs, dict):
        if "value" not in theirs:
            return False
        value = theirs["value"]
        if isinstance(ours, str) and re.fullmatch(r"\d{4}-\d\d-\d\d", ours):
            return theirs.get("name", "").replace(".", "-") == ours
        if isinstance(ours, (int, float)) and isinstance(value, int) and abs(ours - value * step) <= 0.51 * step:
            return True
        return same(value, ours, step)
    if isinstance(ours, str):
        return str(theirs).strip() == ours.strip() or str(theirs).replace(" ", "").upper() == ours.upper()
    value = number(theirs)
    if ours is None or value is None:
        return False
    printed = 10.0 ** -len(str(theirs).partition(".")[2])  # canboat prints fewer digits than a position has
    return abs(ours - value) <= 0.51 * max(step, printed) + 1e-9 * abs(value)


class Comparison:
    def __init__(self):
        self.agree, self.names, self.different, self.missing = 0, 0, collections.Counter(), collections.Counter()

    def differ(self, what, theirs, ours):
        self.different[what] += 1
        examples.setdefault(what, (theirs, ours))

    def fields(self, pgn, theirs, ours):
        for name, value in theirs.items():
            if re.sub(r" ?\d+$", "", name) in NOT_COMPARED:
                continue
            if name in ("list", "list2"):
                lists = [one for one in value if one], ours.get(name, [])  # canboat prints one that is empty
                for one, other in zip(*lists):
                    self.fields(pgn, one, other)
                if len(lists[0]) != len(lists[1]):
                    self.differ((pgn, name), value, ours)
                continue
            known = [i for i in ids.get((pgn, name.lower()), ()) if i in ours]
            if not known:
                self.missing[pgn, name] += 1
                continue
            key = known[0]
            if not same(value, ours[key], steps[pgn, key]):
                self.differ((pgn, name), value, ours[key])
                continue
            self.agree += 1
            self.names += isinstance(value, dict) and "name" in value and value["name"] == ours.get(key + "_label")
        return self


# Where we read more than canboat's analyzer: it gives the rest of the message as bytes when it does not know the length of a parameter,
# because it does not look at the manufacturer among the parameters.
BETTER = {(126208, "Value"), (126208, "list")}
# Fields that this table has not, and the messages of a pseudo PGN of Actisense, which no bus carries.
UNKNOWN_FIELDS = {(130842, "Roll Rate"), (130842, "Pitch Rate"), (130842, "Yaw Rate")}
NOT_READ = {(262386, "Actisense: System status"): 43}

examples, messages, not_read, total = {}, 0, collections.Counter(), Comparison()
for sample in sorted((corpora / "samples").iterdir()):
    expected = corpora / "expected" / (sample.name + ".json")
    if not expected.exists():
        continue
    done = subprocess.run([drydock, "decode", "--pgns", str(table_file), str(sample)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    ours = collections.defaultdict(list)
    for line in done.stdout.splitlines():
        message = json.loads(line)
        ours[message["pgn"], message["source"], message["type"]].append(message["fields"])
    for line in expected.read_text().splitlines():
        theirs = json.loads(line)
        if "pgn" not in theirs or "Manufacturer Proprietary" in theirs["description"] or "Manufacturer Specific" in theirs["description"]:
            continue
        pgn = theirs["pgn"]
        queue = ours[pgn, theirs["src"], forms.get((pgn, theirs["description"]))]
        if not queue:
            not_read[pgn, theirs["description"]] += 1
            continue
        # canboat loses two fast packets that begin within another: then ours is the one after.
        tried = [Comparison().fields(pgn, theirs["fields"], one) for one in queue[:3]]
        at = min(range(len(tried)), key=lambda i: len(tried[i].different))
        del queue[: at + 1]
        total.agree += tried[at].agree
        total.names += tried[at].names
        total.different += tried[at].different
        total.missing += tried[at].missing
        messages += 1

print(f"{messages} messages: canboat and drydock agree in {total.agree} values, {total.names} of them with a name")
for title, counts in (("different", total.different), ("not in the table", total.missing), ("not read", not_read)):
    for what, count in counts.most_common(40):
        print(f"  {title}: {what} {count} {examples.get(what, '') if title == 'different' else ''}")
assert messages > 15000 and total.agree > 50000 and total.names > 10000
assert set(total.different) <= BETTER and set(total.missing) <= UNKNOWN_FIELDS and not_read == NOT_READ
