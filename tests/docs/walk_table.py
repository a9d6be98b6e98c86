"""What the walk along the pages knows of their commands. Each row has a reason and a pattern, which is searched in "PAGE: COMMAND"."""

import re

# Why a command is not typed. The first row that fits counts.
NOT_TYPED = [
    ("a synopsis", r"\[--|\[-o|\[SECONDS|\b(?:RIG|CAMPAIGN)\b|study NAME|--ephemeris F "),
    ("an example of a recipe, which the tree does not have", r"^docs/build/add-a"),
    ("builds, tests or measures the tree",
     r": (?:\./rig|cmake|PYTHONPATH=\S+|DRYDOCK_\w+=\S+ build/\S+_test|build/\S+/conformance) ?|ports_latency_test"),
    ("needs root", r": (?:sudo|apt-get|buildah) "),
    ("belongs to the build of a container or a package", r"packages\.example\.org|Containerfile"),
    ("needs a real port or sensor", r"^(?!.*drydock check ).*(?:tty(?:USB|ACM)\d|socketcan:|\bcan0\b|\bdvl\.toml|mixed\.toml|192\.168\.)"),
    ("needs another program", r": (?:ros2|gpsd|gpspipe|sim_vehicle\.py|pip|python3 -m can\.logconvert) |--engine slurm"),
    ("speaks on DDS domain 0, where others may be", r'"\$\(drydock dds-config\)" \./'),
    ("listens beyond this machine", r"\b0\.0\.0\.0:"),
    ("needs the right to run in real time", r"--realtime"),
    ("writes a reference of the tree, which another test compares", r"scorecard rig_config/\S+ --(?:check|update-refs) fixtures/"),
    ("takes minutes", r"soak \$rig --for 24h"),
]

# Typed beside the emulated devices of a rig, which it speaks to.
BESIDE = [
    ("demo",
     r"drydock (?:monitor|drive|record|diagnose|topic) (?:my-)?rig\.toml|drydock monitor '?(?:pty|can):|drydock fault \S+ set|: ls \$\{?XDG"),
    ("described", r"drydock probe pty:altimeter"),
]

# Ended with Ctrl-C when it is at work: what has no end, and what lasts too long for a test.
REAL_TIME = [
    ("works in real time until Ctrl-C, or for a given time",
     r"drydock (?:emulate|drive|record|estimate) |drydock monitor |drydock run (?!.*--speed max)"),
    ("listens for a given time", r"drydock diagnose rig\.toml|drydock topic \S+\.toml"),
    ("plays in real time", r"drydock replay .*(?:--serve|--onto auto)"),
]
LASTS = REAL_TIME + [
    ("computes for more than some seconds", r"velocity-paper\.toml --speed max|characterize bench\.toml .*--for 2h|study leveling --runs 1000"),
]

# An exit code of 1 is right where the output says this.
ANSWERS = [
    ("what is wrong with this machine", r"drydock doctor", r"(?m)^wrong |\"fitness\": ?\"wrong\""),
    ("what is wrong with the devices, on a busy machine", r"drydock probe pty:", r"listened for"),
    ("its port is another program's", r"--serve|ardusub\.toml", r"Address already in use"),
]


def key(command):
    return f"{command.page}: {command.text}"


def first_of(table, command):
    """What the first row that fits says; "" if none does."""
    return next((row[0] for row in table if re.search(row[1], key(command))), "")


def in_real_time(command):
    """True for what needs emulated devices, sockets or the bus of this machine."""
    return bool(first_of(BESIDE, command) or first_of(REAL_TIME, command))
