"""Types the commands of all pages: walk.py SOURCE_FOLDER DRYDOCK [PAGE ...]. Each page has a folder with the files that it speaks of,
and the demo rig's emulated sensors run beside it, in the place of a serial port and a CAN bus. A command that still works after some
seconds gets Ctrl-C. A command must not be refused as wrong usage (2), must not crash, and may fail (1) only where FAILS says why.
Prints how many were typed, how many were not, and why; exit code 1 if one was not as it should be."""

import collections
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

import page_stage
import pages

PATIENCE_S = 3
# What a page's real hardware is here.
EMULATED = [(r"'?serial:/dev/tty(?:USB|ACM)0(?:\?baud=\d+)?'?", "pty:dvl"), (r"(?:/dev/)?tty(?:USB|ACM)0", "pty:dvl"),
            (r"socketcan:v?can0|\bcan0\b", "'can:auto?name=drydock0'"), (r"\bLINK --protocol ubx", "pty:gnss --protocol ubx"),
            (r"\bLINK --protocol can", "'can:auto?name=drydock0' --protocol can")]
UNTYPED = [  # the first that fits
    ("a synopsis", r"\[--|\[-|\b(?:RIG|CAMPAIGN|DEVICE|NAME|INDEX)\b| F --at T| \.\.\."),
    ("the toy of a recipe", r"toy|steady\.toml|study mean|\bhello\b"),
    ("writes a reference of this tree", r"--update-refs fixtures|--as-fixture"),
    ("needs the reader's own program or file", r"my_navigation|mine\.csv|joint_orders|imu_listener|packages\.example|my-imu\.toml"),
    ("needs Slurm", r"slurm"),
    ("needs another machine", r"192\.168|0\.0\.0\.0"),
]
TRANSCRIPTS = "typed and compared with its output by tests/hil/program/transcript.py"
# May exit with 1, by the page or by what the stage lacks.
FAILS = [
    (r"doctor", "this machine may lack what it looks for"),
    (r"diagnose|monitor|probe", "what is wrong with the emulated sensors or the machine is their answer"),
    (r"load|validity|drive|record|--serve", "in real time, on a busy machine"),
    (r"--expect|compare|scorecard|calibrate|describe|characterize|track", "30 s of a dive, or a golden file, tell too little"),
    (r"proxy|bridge|--onto", "the other end is not there"),
    (r"decode --dbc|replay can|replay capture|--pgns", "a capture of another page"),
]


def commands_of(page):
    """(line, command or None, why it is not typed)."""
    lines = page.text.splitlines()
    for number, code in page.code:
        if lines[number - 1].strip().startswith("$ "):
            if "drydock " in code:
                yield number, None, TRANSCRIPTS
            continue
        command = re.sub(r"\s+#.*", "", code.strip())
        if not re.match(r"(?:cat \S+ \| |CYCLONEDDS_URI\S+ )?(?:build/release/bin/)?drydock [a-z-]", command) or f"`{command}`" in lines[number - 1]:
            continue
        why = next((why for why, pattern in UNTYPED if re.search(pattern, command)), None)
        yield number, command, why


def here(command, program):
    for real, emulated in EMULATED:
        command = re.sub(real, emulated, command)
    command = command.replace("cat pty:dvl", "head -c 2000 rig_config/rigs/demo.toml")
    return re.sub(r"(?:build/release/bin/)?\bdrydock (?=[a-z])", f"{program} ", command)


def typed(command, folder, environment):
    """The exit code: 130 also where Ctrl-C came first."""
    process = subprocess.Popen(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
    try:
        return process.communicate(timeout=PATIENCE_S)[0], process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGINT)
    try:
        said, code = process.communicate(timeout=30)[0], process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return process.communicate()[0] + "does not end after Ctrl-C", 137
    return said, 130 if code in (0, 1, 130, -signal.SIGINT) else code


def is_right(command, code):
    return code in (0, 130) or code == 1 and any(re.search(pattern, command) for pattern, _ in FAILS)


def walk(source, program, wanted):
    count, left, wrong = 0, collections.Counter(), []
    with tempfile.TemporaryDirectory() as top:
        top = pathlib.Path(top)
        (top / "links").mkdir(mode=0o700)
        environment = dict(os.environ, XDG_RUNTIME_DIR=str(top / "links"), ROS_DOMAIN_ID=str(100 + os.getpid() % 100))
        environment.pop("CYCLONEDDS_URI", None)
        os.environ.update(environment)
        (top / "stage").mkdir()
        page_stage.make(top / "stage", source, program)
        with subprocess.Popen([program, "emulate", "demo"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as sensors:
            for name, page in pages.pages_of(source).items():
                if wanted and name not in wanted or name.startswith("fixtures/"):
                    continue
                folder = top / name.replace("/", "-")
                for number, command, why in commands_of(page):
                    if why:
                        left[why] += 1
                        continue
                    if not folder.exists():
                        page_stage.copy_of(top / "stage", folder)
                    page_stage.clear_outputs(command, folder)
                    page_stage.capture_for(command, folder, source)
                    said, code = typed(here(command, program), folder, environment)
                    count += 1
                    if not is_right(command, code):
                        wrong.append(f"{name}:{number}: {command}\nexit code {code}\n{said[-600:]}")
            sensors.terminate()
    return count, left, wrong


if __name__ == "__main__":
    count, left, wrong = walk(pathlib.Path(sys.argv[1]).resolve(), str(pathlib.Path(sys.argv[2]).resolve()), sys.argv[3:])
    print(*wrong, sep="\n")
    print(f"{count} commands typed, {len(wrong)} not as they should be; not typed:")
    for why, number in left.most_common():
        print(f"  {number}: {why}")
    sys.exit(1 if wrong else 0)
