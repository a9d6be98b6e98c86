"""The files that the commands of the pages speak of, made in a folder: rigs, recordings, captures, faults."""

import pathlib
import re
import shutil
import subprocess

RIGS = ("rig", "my-rig", "my-bench", "bench", "other", "dvl", "mixed", "demo", "calibrated")
RECORDINGS = ("dive", "run", "before", "after", "cut", "slice")
CAPTURES = {"imu.dbc": "dbc/bus.dbc", "trace.asc": "capture/canutils.asc", "canboat.json": "pgns/table.json",
            "autopilot.mavlink": "mavlink/autopilot.mavlink", "unknown.bin": "described/stdbin.bin",
            "capture.txt": "described/valeport-vat.txt", "dive.pd0": "pd0/golden.pd0", "can.log": "dbc/frames.log",
            "dive.log": "candump/canutils.log", "can.asc": "capture/canutils.asc"}
FAULTS = '[[fault]]\ndevice = "dvl"\nfault = "hang"\nstart_s = 2\nfor_s = 3\n'


def make(folder, source, drydock):
    """Fills `folder`. What the pages name by its path in the tree is a link to the tree."""
    for tree in ("rig_config", "fixtures"):
        (folder / tree).symlink_to(source / tree)
    said = lambda *words: subprocess.run([drydock, *words], cwd=folder, check=True, capture_output=True).stdout
    demo = said("example", "demo")
    for rig in RIGS:
        (folder / f"{rig}.toml").write_bytes(demo)
    said("run", "demo", "--for", "30s", "--speed", "max", "--record", "dive.mcap", "--json", "monday.json")
    for name in RECORDINGS[1:]:
        shutil.copy(folder / "dive.mcap", folder / f"{name}.mcap")
    shutil.copy(folder / "monday.json", folder / "tuesday.json")
    said("replay", "dive.mcap", "--quiet", "--update-refs", "refs.json")
    said("twin", "dive.mcap", "-o", "twin")
    for name, origin in CAPTURES.items():
        shutil.copy(source / "fixtures" / origin, folder / name)
    for name in ("F.toml", "f.toml"):
        (folder / name).write_text(FAULTS)


def copy_of(stage, folder):
    shutil.copytree(stage, folder, symlinks=True)


def capture_for(command, folder, source):
    """The last word of a command with `--protocol P` becomes a capture of P, if there is none of that name."""
    protocol = re.search(r"--protocol ([a-z0-9+-]+)", command)
    named = re.findall(r"(?<![\w/.>-])([\w-]+\.(?:log|bin|txt|nmea|ubx|pd\d|mavlink))\b", command)
    if not protocol or not named:
        return
    kept = source / "fixtures" / protocol[1].split("+")[0]
    for capture in [*kept.glob("frames.log"), *kept.glob("golden.*")][:1]:
        shutil.copy(capture, folder / named[-1])


def clear_outputs(command, folder):
    """A page's next command may write the file that the stage has under that name."""
    for name in re.findall(r"(?:-o|--record|--write|--out|--as-fixture) ([\w./-]+)", command):
        path = pathlib.Path(folder, name)
        if path.is_dir():
            shutil.rmtree(path)
        elif path.is_file():
            path.unlink()
