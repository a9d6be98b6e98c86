"""Each signal of rig_config/dbc/nmea2000.dbc stands where canboat's database of PGNs has it, with the same bits, sign and step. That our codec
reads as the DBC file does is another test. Usage: canboat_layout.py SOURCE_FOLDER; exit status 77 without the captures of others."""

import json
import math
import os
import pathlib
import re
import sys

# canboat's units, where they are not ours.
FACTOR = {"deg": math.pi / 180, "rpm": 2 * math.pi / 60, "hPa": 100, "NM": 1852, "kn": 1852 / 3600}

root = pathlib.Path(sys.argv[1])
database = pathlib.Path(os.environ.get("DRYDOCK_CORPORA", root / "../shared/corpora")) / "n2k/canboat/canboat_nav_subset.json"
if not database.exists():
    print(f"no captures: {database}")
    sys.exit(77)


def pgn_of(identifier):
    """Of a 29-bit identifier with the mark of DBC files, bit 31."""
    group = identifier >> 8 & 0x3FFFF
    return group & 0x3FF00 if group >> 8 & 0xFF < 240 else group


def messages(dbc):
    """PGN, name, and (name, bit, bits, signed, step) of each signal."""
    for block in re.split(r"^(?=BO_ )", dbc, flags=re.M)[1:]:
        identifier, name = re.match(r"BO_ (\d+) (\w+):", block).groups()
        signals = re.findall(r"^ SG_ (\w+) : (\d+)\|(\d+)@1([+-]) \(([^,]+),", block, re.M)
        yield pgn_of(int(identifier)), name, [(s, int(bit), int(bits), sign == "-", float(step)) for s, bit, bits, sign, step in signals]


def fields_of(pgn):
    """canboat's fields by their first bit; a set that repeats stands there as often as a message of 223 bytes can have it."""
    fields = {f["BitOffset"]: f for f in pgn["Fields"] if "BitOffset" in f}
    first = pgn.get("RepeatingFieldSet1StartField", 0)
    repeated = [f for f in pgn["Fields"] if 0 < first <= f["Order"] < first + pgn["RepeatingFieldSet1Size"]]
    period = sum(f["BitLength"] for f in repeated)
    for again in range(223 * 8 // period if period else 0):
        fields |= {f["BitOffset"] + again * period: f for f in repeated}
    return fields


def wrong(signal, fields):
    """Why the signal is not one of the fields; None: it is."""
    name, bit, bits, signed, step = signal
    field = fields.get(bit)
    if field is None:
        return f"{name}: canboat has no field at bit {bit}"
    theirs = field.get("Resolution", 1) * FACTOR.get(field.get("Unit"), 1)
    if (bits, signed) != (field["BitLength"], field.get("Signed", False)):
        return f"{name}: {bits} bits, signed {signed}; canboat: {field['BitLength']}, {field.get('Signed', False)} ({field['Name']})"
    if not math.isclose(step, theirs, rel_tol=1e-9):
        return f"{name}: a step of {step}; canboat: {theirs} ({field['Name']})"
    return None


theirs = {}
for pgn in json.loads(database.read_text())["PGNs"]:
    theirs.setdefault(pgn["PGN"], fields_of(pgn))
compared, findings = 0, []
for number, message, ours in messages((root / "rig_config/dbc/nmea2000.dbc").read_text()):
    for signal in ours if number in theirs else []:
        compared += 1
        if why := wrong(signal, theirs[number]):
            findings.append(f"PGN {number} {message}: {why}")
print(*findings, f"{compared} signals compared", sep="\n")
sys.exit(1 if findings or compared < 50 else 0)
