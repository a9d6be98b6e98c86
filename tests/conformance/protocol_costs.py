"""What a protocol costs: the files and lines of each, counted in the tree. Usage:
  protocol_costs.py print SOURCE           the tables of docs/sensors/costs.md
  protocol_costs.py write SOURCE           writes them into the page
  protocol_costs.py check SOURCE DRYDOCK   a line for each protocol that the page does not have, that leaves out a part of the recipe, or
                                           whose lines are no longer about those of the page; exit code 1 if there is one"""

import pathlib
import re
import subprocess
import sys

PAGE = "docs/sensors/costs.md"
ALLOWED = 0.2  # lines may grow and shrink so far before the page is stale

# How the names of a protocol's files begin. Protocols of one row have them in common.
BEGINNINGS = {
    "pd0": ["pd0"], "pd4, pd5": ["pd4", "pd5"], "pd6": ["pd6"], "water-linked": ["water_linked", "water-linked"],
    "water-linked-json": ["water_linked_json", "water-linked-json", "json_reader"], "nortek": ["nortek"],
    "nortek-ad2cp": ["nortek_ad2cp", "nortek-ad2cp", "ad2cp"], "wayfinder": ["wayfinder"], "nmea0183": ["nmea0183", "nmea_"],
    "ubx, ubx+nmea0183": ["ubx", "ublox", "rtcm3"], "aceinna": ["aceinna", "j1939-imu"], "microstrain-mv5": ["mv5", "microstrain"],
    "cia404-imu": ["cia404_imu", "cia404-imu"], "epson-g550, epson-g552": ["epson"], "xsens": ["xsens"], "sbg": ["sbg"],
    "nmea2000": ["nmea2000"], "cia404-pressure": ["cia404_pressure", "cia404-pressure", "pressure_driver"], "cia402": ["cia402"],
    "mavlink": ["mavlink"], "slcan": ["slcan"],
}
WHOLE_FOLDERS = {"nmea2000": ["drivers/wire/nmea2000"], "mavlink": ["drivers/wire/mavlink"]}
PARTS = {
    "codec": ["drivers/wire"], "driver": ["drivers/device"], "emulated device": ["hil/emulate"], "tests": ["tests"],
    "fuzzer": ["tests/fuzz"], "DBC, EDS": ["rig_config/dbc", "rig_config/eds"], "golden bytes": ["fixtures"],
    "page": ["docs/sensors/protocols"],
}
CODE = {".cpp", ".hpp", ".py", ".cjs", ".md", ".dbc", ".eds"}
READ_WITHOUT_KIND = {"mavlink", "slcan"}  # no driver and no emulated device
NO_CODEC_OF_THEIR_OWN = {"can", "j1939"}  # frames as they are, and what all protocols of J1939 have in common
MAY_BE_SHARED = {"driver"}  # a driver may read several protocols: dvl_driver.cpp, cia404_imu_driver.cpp


def owner_of(path):
    """The protocol whose beginning fits best: water_linked_json_test.cpp is not of water-linked."""
    for name, folders in WHOLE_FOLDERS.items():
        if any(path.as_posix().startswith(folder + "/") for folder in folders):
            return name
    words = [path.name.removeprefix("fuzz_").removeprefix("make_")]
    if path.parts[0] == "fixtures":
        words = [path.parts[1]]
    fits = [(len(begin), name) for name, begins in BEGINNINGS.items() for begin in begins for word in words if word.startswith(begin)]
    return max(fits)[1] if fits else None


def part_of(path):
    folders = [(len(folder), part) for part, all_of_it in PARTS.items() for folder in all_of_it
               if path.as_posix().startswith(folder + "/")]
    return max(folders)[1] if folders else None


def lines_of(file):
    return file.read_bytes().count(b"\n")


def counted(source):
    """protocol -> part -> (files, lines)"""
    found = {name: {part: [0, 0] for part in PARTS} for name in BEGINNINGS}
    for folder in sorted({folder for folders in PARTS.values() for folder in folders}):
        for file in sorted((source / folder).rglob("*")):
            path = file.relative_to(source)
            if not file.is_file() or file.suffix not in CODE or (folder == "tests" and path.as_posix().startswith("tests/fuzz/")):
                continue
            part, owner = part_of(path), owner_of(path)
            if part and owner:
                found[owner][part][0] += 1
                found[owner][part][1] += lines_of(file)
    return found


def descriptions(source):
    return {file.name: lines_of(file) for file in sorted((source / "rig_config/devices").glob("*.toml"))}


def rounded(lines):
    return f"{round(lines, -1) or lines:,}"


def tables(source):
    yield "| protocol | " + " | ".join(PARTS) + " | all |"
    yield "|---" * (len(PARTS) + 2) + "|"
    for name, parts in counted(source).items():
        cells = [f"{files}: {rounded(lines)}" if files else "" for files, lines in parts.values()]
        files, lines = (sum(part[i] for part in parts.values()) for i in (0, 1))
        yield "| " + " ".join(f"`{one}`" for one in name.split(", ")) + " | " + " | ".join(cells) + f" | {files}: {rounded(lines)} |"
    yield ""
    yield "| description | lines |"
    yield "|---|---|"
    for name, lines in descriptions(source).items():
        yield f"| `{name}` | {lines} |"


def with_tables(text, source):
    head, _, rest = text.partition("<!-- counted -->\n")
    return head + "<!-- counted -->\n" + "\n".join(tables(source)) + "\n<!-- end -->\n" + rest.partition("<!-- end -->\n")[2]


def numbers(row):
    return [int(word.replace(",", "")) for word in re.findall(r"\d[\d,]*", re.sub(r"`[^`]*`", "", row))]


def is_near(told, true):
    return len(told) == len(true) and all(abs(a - b) <= max(3, ALLOWED * b) for a, b in zip(told, true))


def check(source, drydock):
    text = (source / PAGE).read_text()
    rows = {row.split(" | ")[0]: row for row in text.splitlines() if row.startswith("| `")}
    for row in tables(source):
        name = row.split(" | ")[0]
        if row.startswith("| `") and not (name in rows and is_near(numbers(rows.pop(name)), numbers(row))):
            yield f"{PAGE}: the row is now: {row}"
    for name in rows:
        yield f"{PAGE}: nothing is called {name[2:]}"
    said = subprocess.run([drydock, "decode", "--protocol", "?"], stdin=subprocess.DEVNULL, capture_output=True, text=True).stderr
    known = set(re.search(r"allowed: (.*)", said)[1].split(", ")) - NO_CODEC_OF_THEIR_OWN
    for name in sorted(known ^ {one for names in BEGINNINGS for one in names.split(", ")}):
        yield f"BEGINNINGS and the program differ in {name}"
    for name, parts in counted(source).items():
        no_device = {"driver", "emulated device"} if name in READ_WITHOUT_KIND else MAY_BE_SHARED
        for part in set(PARTS) - {"DBC, EDS", "golden bytes", "page"} - no_device:
            if parts[part][0] == 0:
                yield f"{name}: no {part}"


def main():
    command, source = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    if command == "print":
        print("\n".join(tables(source)))
    elif command == "write":
        (source / PAGE).write_text(with_tables((source / PAGE).read_text(), source))
    else:
        found = list(check(source, sys.argv[3]))
        for line in found:
            print(line)
        sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
