"""Which commands and long options there are, by the programs' own help."""

import re
import subprocess


def help_of(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=60).stdout


def options_in(text):
    return set(re.findall(r"^ +(?:-\w,)?(--[a-z][a-z-]*)", text, re.M))


def subcommands_in(text):
    listed = re.search(r"^Subcommands:\n((?: .*\n)+)", text, re.M)
    return re.findall(r"^  ([a-z][a-z-]*)", listed[1], re.M) if listed else []


def of_program(program):
    """Long options of each subcommand, those of its own subcommands with them; "" has those of the program itself."""
    top = help_of(program, "--help")
    found = {"": options_in(top)}
    for name in subcommands_in(top):
        text = help_of(program, name, "--help")
        found[name] = options_in(text)
        for inner in subcommands_in(text):
            found[name] |= options_in(help_of(program, name, "any", inner, "--help"))
    return found


def of_rig(script):
    """The commands that ./rig lists."""
    return set(re.findall(r"^  ([a-z]+(?:-[a-z]+)*)(?:  | \[)", help_of("bash", script), re.M))
