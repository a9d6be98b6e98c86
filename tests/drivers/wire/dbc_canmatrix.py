"""The golden frames, read by canmatrix (Debian: python3-canmatrix) with our DBC files, are what fixtures/*/frames.expected.jsonl
say: neither the reading nor the expectation is ours. Usage: dbc_canmatrix.py SOURCE_FOLDER; exit status 77 without canmatrix."""

import collections
import json
import pathlib
import re
import sys

try:
    import canmatrix.formats
except ImportError:
    print("python3-canmatrix is not installed")
    sys.exit(77)

root = pathlib.Path(sys.argv[1])
checked = 0


def frames(log):
    for line in log.read_text().splitlines():
        identifier, data = re.fullmatch(r"\(\S+\) \S+ ([0-9A-F]+)#([0-9A-F]*)", line).groups()
        yield int(identifier, 16), len(identifier) == 8, bytes.fromhex(data)


def fits(message, identifier, extended):
    """J1939: the same PGN; CANopen: the same function code."""
    if message.arbitration_id.extended != extended:
        return False
    ours = message.arbitration_id.id
    if not extended:
        return ours >> 7 == identifier >> 7
    mask = 0x3FF00 if (identifier >> 16 & 0xFF) < 240 else 0x3FFFF
    return ours >> 8 & mask == identifier >> 8 & mask


def is_of(message, line):
    """A message of several frames stands as type_1, type_2, ..."""
    return re.fullmatch(line["type"] + "(_[0-9])?", message.name)


def wanted(line, name):
    """Components of an array stand as name_0, name_1, ..."""
    if name[-2:-1] == "_" and name[-1].isdigit() and isinstance(line.get(name[:-2]), list):
        return line[name[:-2]][int(name[-1])]
    return line.get(name)


def check(message, data, expected):
    global checked
    for name, decoded in message.decode(data).items():
        want = wanted(expected, name)
        if want is None:
            continue
        signal = message.signal_by_name(name)
        if isinstance(want, str):
            got = signal.values[decoded.raw_value]
            assert got == want, (message.name, name, got, want)
        else:
            got = float(decoded.phys_value)
            assert abs(got - want) <= 1e-6 * max(1.0, abs(want)), (message.name, name, got, want)
        checked += 1


for file in sorted((root / "rig_config/dbc").glob("*.dbc")):
    matrix = canmatrix.formats.loadp_flat(str(file))
    assert len(matrix.frames) > 1, file
    log = root / "fixtures" / file.stem / "frames.log"
    if not log.exists():
        continue
    expected = [json.loads(line) for line in log.with_name("frames.expected.jsonl").read_text().splitlines()]
    turn = collections.Counter()  # the n-th frame of a message belongs to the n-th line of its type
    for identifier, extended, data in frames(log):
        exact = [m for m in matrix.frames if m.arbitration_id.id == identifier]
        for message in exact or [m for m in matrix.frames if fits(m, identifier, extended)]:
            lines = [e for e in expected if is_of(message, e)]
            if lines and message.size <= len(data):
                check(message, data[: message.size], lines[turn[message.name]])
            turn[message.name] += 1
print(f"canmatrix agrees in {checked} values")
assert checked > 100
