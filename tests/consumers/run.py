#!/usr/bin/env python3
"""Installs what others link, builds the programs of this folder against it, and runs them: run.py BUILD_FOLDER DRYDOCK SOURCE.
In the place of the build folder there may be a prefix, where a package has installed it. Nothing of the tree is in sight of their
compiler."""

import json
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import threading

BUILD, DRYDOCK, SOURCE = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
GOLDEN = SOURCE / "fixtures/pd0/golden.pd0"


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{words[0]} exits with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(what, got, wanted):
    if got != wanted:
        sys.exit(f"{what}: expected {wanted!r}, got {got!r}")
    print(f"ok  {what}")


def ensembles_of_golden():
    """The ensembles' numbers, by the layout: two bytes behind the id 0x0080, the third after the clock."""
    data, numbers = GOLDEN.read_bytes(), []
    for at in (m.start() for m in re.finditer(rb"\x7f\x7f", data)):
        size = int.from_bytes(data[at + 2:at + 4], "little")
        if int.from_bytes(data[at + size:at + size + 2], "little") != sum(data[at:at + size]) & 0xFFFF:
            continue
        for k in range(data[at + 5]):
            block = at + int.from_bytes(data[at + 6 + 2 * k:at + 8 + 2 * k], "little")
            if data[block:block + 2] == b"\x80\x00":
                numbers.append(int.from_bytes(data[block + 2:block + 4], "little") + (data[block + 11] << 16))
    return numbers


def served(data):
    """A TCP server for one client: it says `data` and closes."""
    server = socket.create_server(("127.0.0.1", 0))

    def serve():
        with server, server.accept()[0] as client:
            client.sendall(data)

    threading.Thread(target=serve, daemon=True).start()
    return server.getsockname()[1]


def lines_of_code(name):
    text = (SOURCE / "tests/consumers" / name).read_text()
    return sum(1 for line in text.splitlines() if line.strip() and not line.startswith("//"))


with tempfile.TemporaryDirectory(prefix="drydock-consumers-") as room:
    room = pathlib.Path(room)
    prefix, programs = room / "prefix", room / "build"
    if (BUILD / "CMakeCache.txt").exists():
        run("cmake", "--install", BUILD, "--component", "development", "--prefix", prefix)
    else:
        prefix = BUILD
    run("cp", "-r", SOURCE / "tests/consumers", room / "source")
    run("cmake", "-G", "Ninja", "-S", room / "source", "-B", programs, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release",
        "-DCMAKE_CXX_FLAGS_RELEASE=-O1")
    run("cmake", "--build", programs, "-j", "2")
    commands = (programs / "build.ninja").read_text()
    expect("no program sees the tree", str(SOURCE / "drivers") in commands, False)

    numbers = [int(word) for word in run(programs / "pd0_file", GOLDEN).split()]
    expect("pd0_file decodes the ensembles that have leaders", [n for n in numbers if n], ensembles_of_golden())
    port = served(GOLDEN.read_bytes())
    said = subprocess.run([programs / "live_dvl", f"tcp:127.0.0.1:{port}"], capture_output=True, text=True, timeout=60)
    # The first ensemble: the bed moves 1.5 m/s aft, 0.25 to port, 0.04 up; so the vehicle moves ahead, to starboard, down.
    expect("live_dvl gives the vehicle's velocity", [float(word) for word in said.stdout.split()[:3]], [1.5, 0.25, 0.04])
    expect("own_estimator finds 10 deg", run(programs / "own_estimator"), "10 deg at 100000000 ns\n")

    recording, summary = room / "dive.mcap", room / "dive.json"
    run(DRYDOCK, "run", SOURCE / "rig_config/rigs/demo.toml", "--for", "20s", "--speed", "max", "--record", recording, "--json", summary,
        cwd=SOURCE)
    devices = json.loads(summary.read_text())["devices"]
    expect("read_recording counts what the run counted",
           [line.split() for line in run(programs / "read_recording", recording).splitlines()],
           [[str(i), str(d["messages"])] for i, d in enumerate(devices)])
    run(programs / "emulated_dvl_test")
    print("ok  emulated_dvl_test passes")

    flags = run("pkg-config", "--cflags", "--libs", "drydock", env={"PKG_CONFIG_PATH": str(next(prefix.glob("lib/**/drydock.pc")).parent),
                                                                    "PATH": "/usr/bin:/bin"}).split()
    run("c++", room / "source/pd0_file.cpp", "-o", room / "by-pkg-config", *flags)
    expect("pkg-config's flags build the same program", run(room / "by-pkg-config", GOLDEN), "".join(f"{n}\n" for n in numbers))
    expect("the header has the program's version",
           re.search(r'VERSION_TEXT "(.*)"', (prefix / "include/drydock/version.hpp").read_text())[1], run(DRYDOCK, "--version").strip())

    unknown = room / "unknown"
    unknown.mkdir()
    (unknown / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(x CXX)\n"
                                            "find_package(Drydock CONFIG REQUIRED COMPONENTS wire sonar)\n")
    refused = subprocess.run(["cmake", "-G", "Ninja", "-S", unknown, "-B", unknown / "b", f"-DCMAKE_PREFIX_PATH={prefix}"],
                             capture_output=True, text=True)
    expect("an unknown component is refused by name", "Drydock has no component sonar" in re.sub(r"\s+", " ", refused.stderr), True)

expect("pd0_file has 15 lines", lines_of_code("pd0_file.cpp") <= 15, True)
expect("live_dvl has 30 lines", lines_of_code("live_dvl.cpp") <= 30, True)
