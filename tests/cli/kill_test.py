#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""50 conversions killed at random moments or fed broken input: the output is whole or not there.

Odd runs are killed (the seed is fixed, the moment is not: it depends on the machine); even runs read a file with
a random cut or random bytes in it.
"""
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

RUNS = 50
chance = random.Random(7)


def convert(program, source, output):
    return subprocess.Popen([program, "convert", source, "-o", output, "--length-unit", "mm"], stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)


def fail(text):
    print(f"FAILED: {text}")
    sys.exit(1)


def broken(good: bytes) -> bytes:
    if chance.random() < 0.5:
        return good[: chance.randrange(len(good))]
    data = bytearray(good)
    for _ in range(20):
        data[chance.randrange(len(data))] = chance.randrange(256)
    return bytes(data)


def check_folder(folder, name, whole):
    """Only the whole output and temporary names may be there."""
    for path in folder.iterdir():
        if re.search(r"\.tmp-\d+$", path.name) or path.name in ("input.frd", pathlib.Path(name).stem + ".d"):
            continue
        if path.name != name:
            fail(f"left behind: {path.name}")
        if path.read_bytes() != whole:
            fail(f"{name} is neither the old nor the new output")


def check_hung_up_view(program, source, folder):
    """The terminal is closed while only the shape is shown: nothing stays in the folder for what passes."""
    folder.mkdir()
    process = subprocess.Popen([program, "view", source, "--no-open"], stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True, env={**os.environ, "TMPDIR": str(folder)},
                               preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
    for line in process.stdout:
        if line.startswith("Its shape is there"):
            break
    process.send_signal(signal.SIGHUP)
    code = process.wait(timeout=60)
    # 0: the results were there already.
    if code not in (0, 1) or os.listdir(folder):
        fail(f"a view whose terminal was closed ended with {code} and left {os.listdir(folder)}")


def main():
    program, source = sys.argv[1], pathlib.Path(sys.argv[2]) / "examples/boiler/hex_linear/static.frd"
    good = source.read_bytes()
    killed = refused = finished = 0
    with tempfile.TemporaryDirectory() as scratch:
        wholes, seconds = {}, {}
        for name in ("a.glb", "a.gltf", "a.vtu"):
            whole = pathlib.Path(scratch, "whole", name)
            whole.parent.mkdir(exist_ok=True)
            start = time.monotonic()
            if convert(program, source, whole).wait() != 0:
                fail(f"the good input does not convert to {name}")
            seconds[name], wholes[name] = time.monotonic() - start, whole.read_bytes()
        for run in range(RUNS):
            name = ("a.glb", "a.gltf", "a.vtu")[run % 3]
            folder = pathlib.Path(scratch, f"run{run}")
            folder.mkdir()
            if run % 2:
                process = convert(program, source, folder / name)
                time.sleep(chance.random() * seconds[name])
                process.send_signal(signal.SIGKILL)
                killed += process.wait() == -signal.SIGKILL
                check_folder(folder, name, wholes[name])
                # The next run cleans up what the killed one left, and works.
                if convert(program, source, folder / name).wait() != 0:
                    fail(f"{name} cannot be made after a kill")
                check_folder(folder, name, wholes[name])
                left = [path.name for path in folder.iterdir() if ".tmp-" in path.name]
                if left:
                    fail(f"the next run left {left}")
                continue
            (folder / "input.frd").write_bytes(broken(good))
            code = convert(program, folder / "input.frd", folder / name).wait(timeout=60)
            if code not in (0, 1):
                fail(f"broken input of run {run} ended with {code}")
            refused += code == 1
            finished += code == 0
            if code == 1 and sorted(os.listdir(folder)) != ["input.frd"]:
                fail(f"a refused input left {sorted(os.listdir(folder))}")
            if code == 0 and not (folder / name).exists():
                fail("success without an output")
        cancelled = 0
        for run in range(10):  # Ctrl-C
            folder = pathlib.Path(scratch, f"cancel{run}")
            folder.mkdir()
            process = convert(program, source, folder / "a.gltf")
            time.sleep(0.5 * chance.random() * seconds["a.gltf"])
            process.send_signal(signal.SIGINT)
            code = process.wait(timeout=60)
            # -2: it came before the program listened.
            if code not in (0, 1, -signal.SIGINT) or (code != 0 and os.listdir(folder)):
                fail(f"Ctrl-C ended with {code} and left {os.listdir(folder)}")
            cancelled += code == 1
        for run in range(5):
            check_hung_up_view(program, source, pathlib.Path(scratch, f"hung{run}"))
    print(f"{cancelled} cancelled, {killed} killed, {refused} refused, {finished} used in part, {RUNS // 2 - killed} finished before the kill")
    if killed < 5 or refused + finished == 0:
        fail("too few runs were killed to mean anything")


if __name__ == "__main__":
    main()
