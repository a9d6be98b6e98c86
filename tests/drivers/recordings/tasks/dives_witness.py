"""What others read in the bytes of fixtures/dives is what their references say: gpsd's gpsdecode for the receiver, canmatrix
(Debian: python3-canmatrix) for CAN, and a few lines here, by the protocols' documents, for sentences of text.
Usage: dives_witness.py DRYDOCK SOURCE_FOLDER; exit status 77 where a program of others is missing."""

import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import canmatrix.formats
except ImportError:
    print("python3-canmatrix is not installed")
    sys.exit(77)
if not shutil.which("gpsdecode"):
    print("gpsdecode is not installed (package gpsd-clients)")
    sys.exit(77)

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
work = tempfile.TemporaryDirectory()
knot = 1852 / 3600
checked = 0


def same(got, want, tolerance, what):
    global checked
    if want is None or got is None:
        assert got is None and want is None, (what, got, want)
    else:
        assert abs(got - want) <= tolerance, (what, got, want)
    checked += 1


def lines_of(dive, kind):
    text = (root / "fixtures/dives" / dive / "expected.jsonl").read_text()
    found = [line for line in map(json.loads, text.splitlines()) if line.get("type") == kind]
    assert len(found) > 20, dive
    return found


def exported(dive, form, *more):
    target = pathlib.Path(work.name) / f"{dive}.{form}"
    recording = root / "fixtures/dives" / dive / "dive.mcap"
    subprocess.run([program, "export", recording, "--to", form, *more, "-o", target], check=True, stderr=subprocess.DEVNULL)
    return target


def crc8(data):
    """Polynomial 07h from 0: "DVL A50/A125 serial protocol", the checksum."""
    crc = 0
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ 0x07) & 0xFF if crc & 0x80 else crc << 1
    return crc


def exclusive_or(data):
    total = 0
    for byte in data:
        total ^= byte
    return total


def sentences(file, start, checksum):
    for line in file.read_bytes().splitlines():
        body, digits = line.split(b"*")
        assert checksum(body[start:]) == int(digits, 16), line
        yield body[start:].decode().split(",")


def dvl():
    reports = [s for s in sentences(exported("dvl-finds-the-bottom", "raw") / "dvl.bin", 0, crc8) if s[0] == "wrz"]
    expected = lines_of("dvl-finds-the-bottom", "bottom_velocity")
    assert len(reports) == len(expected)
    assert {report[4] for report in reports} == {"y", "n"}  # it finds the bottom and loses it
    for report, line in zip(reports, expected):
        locked = report[4] == "y"
        for axis in range(3):
            wanted = line["velocity_mps"][axis] if line["velocity_mps"] else None
            same(float(report[1 + axis]) if locked else None, wanted, 1e-9, line)
        same(float(report[5]) if locked else None, line["altitude_m"], 1e-9, line)


def emlog():
    """VBW is of both axes, and VHW of the same sample says nothing new; VLW is the distance."""
    seen, wanted = [], []
    for s in sentences(exported("log-drops-out", "raw") / "emlog.bin", 1, exclusive_or):
        if s[0] == "VMVBW":
            seen += [float(s[1]) * knot, float(s[2]) * knot]
        elif s[0] == "VMVLW":
            seen.append(float(s[1]) * 1852)
    for line in lines_of("log-drops-out", "water_speed"):
        if line["transverse_mps"] is not None:
            wanted += [line["longitudinal_mps"], line["transverse_mps"]]
        elif line["distance_m"] is not None:
            wanted.append(line["distance_m"])
    assert len(seen) == len(wanted), (len(seen), len(wanted))
    for got, want in zip(seen, wanted):
        same(got, want, 1e-9, "emlog")


def gnss():
    raw = (exported("antenna-dives", "raw") / "gnss.bin").read_bytes()
    text = subprocess.run(["gpsdecode", "-j"], input=raw, stdout=subprocess.PIPE, check=True).stdout
    reports = {}
    for report in map(json.loads, text.splitlines()):
        if report["class"] == "TPV":
            reports.setdefault(report.get("time"), report)  # the second of an epoch repeats the first
    dry = [line for line in lines_of("antenna-dives", "gnss_fix") if line["fix_type"] == 3]
    wet = [line for line in lines_of("antenna-dives", "gnss_fix") if line["fix_type"] == 0]
    assert len(dry) > 10 and len(wet) > 5
    for line in dry + wet:
        seconds = int(line["utc_s"]) % 60
        report = next(r for time, r in reports.items() if time and int(time[17:19]) == seconds)
        same(report["mode"], 3 if line in dry else 1, 0, line)
        if line in dry:
            same(report["lat"], line["latitude_deg"], 1e-9, line)
            same(report["lon"], line["longitude_deg"], 1e-9, line)
            same(report["altHAE"], line["ellipsoidal_height_m"], 1e-9, line)
            same(report["speed"], line["ground_speed_mps"], 1e-3, line)
            same(report["track"], line["course_deg"], 1e-4, line)


def frames(dive, dbc):
    """Name and physical values of each received frame that the DBC file has."""
    matrix = canmatrix.formats.loadp_flat(str(root / "rig_config/dbc" / dbc))
    for line in exported(dive, "candump", "--direction").read_text().splitlines():
        identifier, data, way = re.fullmatch(r"\(\S+\) \S+ ([0-9A-F]+)#([0-9A-F]*) ([RT])", line).groups()
        for message in matrix.frames:
            id = message.arbitration_id
            # Of J1939 the lowest byte is the sender, of CANopen the low seven bits are the node.
            low = 8 if id.extended else 7
            if way == "R" and id.extended == (len(identifier) == 8) and id.id >> low == int(identifier, 16) >> low:
                decoded = message.decode(bytes.fromhex(data)[: message.size])
                yield message.name, {name: float(value.phys_value) for name, value in decoded.items()}


def imu():
    """Acceleration, then angular rate, of one sample."""
    expected = iter(lines_of("imu-is-set-up", "imu"))
    for name, values in frames("imu-is-set-up", "aceinna.dbc"):
        if name == "acceleration":
            force = [values[f"acceleration_{axis}_mps2"] for axis in "xyz"]
        elif name == "angular_rate":
            line = next(expected)
            for axis in range(3):
                same(force[axis], line["specific_force_mps2"][axis], 1e-9, line)
                same(values[f"rate_{'xyz'[axis]}_degps"], line["angular_rate_degps"][axis], 1e-9, line)
    assert next(expected, None) is None


def depth():
    """Hundredths of a kilopascal above the air."""
    expected = iter(lines_of("pressure-node-starts", "depth"))
    for name, values in frames("pressure-node-starts", "cia404-pressure.dbc"):
        if name == "process_value":
            line = next(expected)
            same(101325 + 10 * values["integer"], line["pressure_pa"], 1e-6, line)
            same(10 * values["integer"] / (1027 * 9.80665), line["depth_m"], 1e-9, line)
    assert next(expected, None) is None


def actuators():
    """A rudder that turns the vessel to starboard is positive there, and negative in a measurement."""
    expected = iter(lines_of("rudder-swings", "actuator_state"))
    for name, values in frames("rudder-swings", "nmea2000.dbc"):
        if name == "rudder":
            line, key = next(expected), ["rudder_deg", "stern_plane_deg", "bow_plane_deg"][int(values["instance"])]
            sign = -1 if key == "rudder_deg" else 1
            same(sign * math.degrees(values["position_rad"]), line[key], 1e-9, line)
        elif name == "engine":
            line = next(expected)
            same(values["speed_radps"], line["propeller_radps"], 1e-6, line)
    assert next(expected, None) is None


for witness in (dvl, emlog, gnss, imu, depth, actuators):
    before = checked
    witness()
    print(f"{witness.__name__}: {checked - before} values agree")
