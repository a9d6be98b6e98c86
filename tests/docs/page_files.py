"""The files that the commands of the pages read: made once, and put where a command is typed."""

import pathlib
import re
import shutil
import subprocess

DIVE_S = 100
DIVE_BEGINS_S = 1795248000  # UTC: where virtual time begins
FAULTS = '[[fault]]\ndevice = "dvl"\nfault = "hang"\nstart_s = 20\nfor_s = 10\n'
STEPS = "t,rudder,stern,bow,rpm\n0,0,0,0,500\n5,10,0,0,500\n60,-10,0,0,500\n"
ESTIMATES = "t_s,north_m,east_m,down_m\n" + "".join(f"{DIVE_BEGINS_S + i},{3 * i},0,1\n" for i in range(1, 60))
FAILING_PROGRAM = "#!/bin/sh\nexit 1\n"

FIXTURES = {"trace.asc": "capture/canutils.asc", "imu.dbc": "dbc/bus.dbc", "canboat.json": "pgns/table.json",
            "autopilot.mavlink": "mavlink/autopilot.mavlink", "unknown.bin": "described/stdbin.bin"}
TEXTS = {"F.toml": FAULTS, "steps.csv": STEPS, "mine.csv": ESTIMATES, "my_navigation": FAILING_PROGRAM}
# What a command with this option reads, if `kept` has no better file for the command.
CAPTURES = [(r"--dbc ", "dbc/frames.log"), (r"--pgns ", "pgns/frames.log"), (r"--protocol can ", "capture/canutils.asc")]
LONG_CAPTURES = re.compile(r"dive(-\d)?\.pd0|capture\.txt|characterize can\.asc")
FILE = re.compile(r"(?<![\w/.-])(?:\./)?([\w-]+\.(?:toml|mcap|json|log|bin|txt|nmea|ubx|pd\d|mavlink|asc|dbc|csv)\b|my_navigation)")
OUTPUT = re.compile(r"(?:\s(?:-o|--record|--write|--out|--report|--json|--junit|--plot|--csv|--allan|--update-refs)|>) ([\w./-]+)")


class PageFiles:
    """`source`: the tree. `kept`: an empty folder for what is made once. Raises if the program cannot make it."""

    def __init__(self, source, kept, program):
        self.source, self.kept = source, kept
        say = lambda *words: subprocess.run([program, *words], cwd=kept, check=True, capture_output=True).stdout
        record = lambda rig, seconds, to, *options: say("run", rig, "--for", f"{seconds}s", "--speed", "max", "--record", to, *options)
        demo = say("example", "demo")
        for name in ("rig", "my-rig", "bench", "other"):
            (kept / f"{name}.toml").write_bytes(demo)
        record("rig.toml", DIVE_S, "dive.mcap", "--json", "monday.json")
        record("rig.toml", DIVE_S, "after.mcap", "--json", "tuesday.json", "--seed", "2")
        shutil.copy(kept / "dive.mcap", kept / "before.mcap")
        whole = (kept / "dive.mcap").read_bytes()
        (kept / "cut.mcap").write_bytes(whole[: len(whole) // 2])
        say("export", "dive.mcap", "--to", "candump", "-o", "dive.log")
        say("export", "dive.mcap", "--to", "raw", "--only", "dvl", "-o", "raw")
        shutil.move(kept / "raw/dvl.bin", kept / "dive.pd0")
        stream = (kept / "dive.pd0").read_bytes()
        for i in range(3):
            (kept / f"dive-{i + 1}.pd0").write_bytes(stream[i * len(stream) // 3 : (i + 1) * len(stream) // 3])
        record("described", 30, "described.mcap")
        say("export", "described.mcap", "--to", "raw", "--only", "altimeter", "-o", "described")
        shutil.move(kept / "described/altimeter.bin", kept / "capture.txt")
        record("every-protocol", 20, "all.mcap")
        say("export", "all.mcap", "--to", "candump", "--only", "xsens", "-o", "can.asc")
        for name, fixture in FIXTURES.items():
            shutil.copy(source / "fixtures" / fixture, kept / name)
        for name, text in TEXTS.items():
            (kept / name).write_text(text)
        (kept / "my_navigation").chmod(0o755)

    def new_folder(self, folder):
        """What the pages name by its path in the tree is a link to the tree; where commands add a fixture, only the old ones are."""
        (folder / "fixtures/dives").mkdir(parents=True)
        for tree in ("rig_config", "drivers", "docs"):
            (folder / tree).symlink_to(self.source / tree)
        for old in [*self.source.glob("fixtures/*"), *self.source.glob("fixtures/dives/*")]:
            if old.name != "dives":
                (folder / old.relative_to(self.source)).symlink_to(old)

    def put(self, command, page, folder, written):
        """Puts what `command` reads into `folder`, but for the names in `written`, which commands of this folder wrote. Takes away what
        it writes, since the lines of a block may be alternatives, and returns those names."""
        outputs = set(OUTPUT.findall(command))
        for name in set(FILE.findall(command)) - outputs - written:
            if shown := re.search(rf"`{re.escape(name)}`:\n\n```toml\n(.*?)```", page.text, re.S):
                (folder / name).write_text(shown[1])
            elif origin := self.origin(name, command):
                shutil.copy(origin, folder / name)
        for name in outputs:
            path = folder / name
            shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)
        return outputs

    def origin(self, name, command):
        """The file that stands for `name`; None if the command itself must find it."""
        protocol = re.search(r"--protocol ([a-z0-9-]+)(?![\w.-])", command)
        if (self.kept / name).exists() and (not protocol or LONG_CAPTURES.search(command)):
            return self.kept / name
        fixtures = self.source / "fixtures"
        for pattern, fixture in CAPTURES:
            if re.search(pattern, command) and not name.endswith((".dbc", ".json")):
                return fixtures / fixture
        captures = [*fixtures.glob(f"{protocol[1]}/frames.log"), *sorted(fixtures.glob(f"{protocol[1]}/golden.*"))] if protocol else []
        return captures[0] if captures else self.kept / name if (self.kept / name).exists() else None
