"""`drydock decode --dbc` and canmatrix (Debian: python3-canmatrix) read the same values out of random frames, for our DBC files and for
those of the corpora; and what canmatrix encodes, drydock decodes. Usage: dbc_canmatrix.py SOURCE_FOLDER DRYDOCK; exit status 77 without
canmatrix."""

import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import canmatrix.formats
except ImportError:
    print("python3-canmatrix is not installed")
    sys.exit(77)

root, drydock = pathlib.Path(sys.argv[1]), sys.argv[2]
corpora = pathlib.Path(os.environ.get("DRYDOCK_CORPORA", root / "../shared/corpora"))
random.seed(1)
REFUSED = {"fca_giorgio"}  # canmatrix refuses identifiers without bit 31


def files():
    ours = sorted((root / "rig_config/dbc").glob("*.dbc")) + [root / "fixtures/dbc/bus.dbc"]
    others = sorted(corpora.glob("dbc/files/*.dbc")) + sorted(corpora.glob("can_imu/*.dbc"))
    return [f for f in ours + others if f.stem not in REFUSED]


def load(file):
    try:
        file.read_text("utf-8")
        encoding = "utf-8"
    except UnicodeDecodeError:
        encoding = "cp1252"
    return canmatrix.formats.loadp_flat(str(file), dbcImportEncoding=encoding, dbcImportCommentEncoding=encoding)


def line(message, data):
    number = message.arbitration_id.id
    digits = f"{number:08X}" if message.arbitration_id.extended else f"{number:03X}"
    return f"(1.000000) can0 {digits}#{'' if len(data) <= 8 else '#0'}{data.hex().upper()}"


def decode(file, lines):
    with tempfile.NamedTemporaryFile("w", suffix=".log") as log:
        log.write("\n".join(lines) + "\n")
        log.flush()
        done = subprocess.run([drydock, "decode", "--dbc", str(file), "--quiet", log.name], capture_output=True, text=True)
    assert done.returncode == 0, (file, done.stderr)
    return [json.loads(text) for text in done.stdout.splitlines()]


def same(ours, theirs):
    if math.isnan(theirs) or math.isinf(theirs):
        return ours is None  # JSON has neither
    return ours is not None and abs(ours - theirs) <= 1e-9 * max(abs(ours), abs(theirs), 1e-300)


OWN_KEYS = ("type", "time_s", "interface", "source", "destination")


def key(signal):
    name = signal.attributes.get("SystemSignalLongSymbol", signal.name).strip('"')
    return "device_" + name if name in OWN_KEYS else name


compared = encoded = 0
for file in files():
    matrix = load(file)
    plain = [m for m in matrix.frames if m.signals and m.size in (*range(1, 9), 12, 16, 20, 24, 32, 48, 64)
             and m.name != "VECTOR__INDEPENDENT_SIG_MSG"]
    sent = [(m, random.randbytes(m.size)) for m in plain for _ in range(20)]
    if not sent:
        continue
    read = decode(file, [line(m, data) for m, data in sent])
    assert len(read) == len(sent), file
    for (message, data), ours in zip(sent, read):
        try:
            theirs = message.decode(data)
        except KeyError:  # it needs a selector's value to have a signal
            continue
        for name, value in theirs.items():
            signal = message.signal_by_name(name)
            assert same(ours[key(signal)], float(value.phys_value)), (file.stem, message.name, name, ours, value.phys_value)
            compared += 1

    back = []
    for m in plain:
        if any(s.multiplex is not None or s.is_float for s in m.signals):
            continue
        raw = {}
        for s in m.signals:
            low, high = (-(1 << s.size - 1), (1 << s.size - 1) - 1) if s.is_signed else (0, (1 << s.size) - 1)
            raw[s.name] = random.randint(low, high)  # canmatrix encodes raw values
        back.append((m, {name: m.signal_by_name(name).raw2phys(r) for name, r in raw.items()}, m.encode(raw)))
    for (message, values, data), ours in zip(back, decode(file, [line(m, bytes(d)) for m, _, d in back]) if back else []):
        for name, value in values.items():
            assert same(ours[key(message.signal_by_name(name))], float(value)), (file.stem, message.name, name, value, ours)
            encoded += 1

print(f"canmatrix and drydock agree in {compared} values; {encoded} values that canmatrix encoded come back")
assert compared > 1000 and encoded > 50
