"""Runs commands and measures them; for the benchmark scripts of this folder."""
import collections
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77  # the exit code of a program that lacks a tool or a scene (bench/regions.txt)

# Seconds of wall clock, of user CPU and of system CPU; the peak of resident memory.
Cost = collections.namedtuple("Cost", "wall user system peak_bytes")


def run(command, limit=None):
    """Runs a command without output; returns its cost, or nothing if it fails or exceeds the limit in seconds."""
    guarded = ["timeout", str(limit), *map(str, command)] if limit else list(map(str, command))
    begin = time.monotonic()
    process = subprocess.Popen(guarded, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, cwd=ROOT)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        return None
    return Cost(wall, usage.ru_utime, usage.ru_stime, 1024 * usage.ru_maxrss)


def skip(program, words):
    """Ends a program that lacks a tool or a scene."""
    print(f"{program}: {words}", file=sys.stderr)
    sys.exit(SKIPPED)


def row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |")


def head(*cells):
    """Prints the head of a table."""
    row(*cells)
    print("|---" * len(cells) + "|")


def seconds(value):
    """Returns a time with two or three digits."""
    return f"{value:.3f}" if value < 1 else f"{value:.2f}" if value < 10 else f"{value:.1f}"
