"""The compiled part waits for ever for the lock of a sub-interpreter, so it is not loaded in one."""

import importlib


def check() -> None:
    try:
        interpreters = importlib.import_module("_xxsubinterpreters")
    except ImportError:
        return
    if interpreters.get_current() != interpreters.get_main():
        raise ImportError("drydock works in the main interpreter of a process alone, not in a sub-interpreter")


check()
