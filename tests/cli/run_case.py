#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs one golden command line: CASE/cmd in a shell, compared with CASE/stdout, CASE/stderr, CASE/exit.

`feelem` is the program under test, $SCRATCH an empty folder. An absent file means nothing printed, or exit 0.
FEELEM_UPDATE_GOLDEN=1 writes what came out instead; git diff is the review.
"""
import difflib
import os
import pathlib
import subprocess
import sys
import tempfile


def main() -> int:
    program, case, source = (pathlib.Path(text).resolve() for text in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "bin")
        path.mkdir()
        (path / "feelem").symlink_to(program)
        scratch = pathlib.Path(folder, "scratch")
        scratch.mkdir()
        environment = {**os.environ, "PATH": f"{path}:{os.environ['PATH']}", "SCRATCH": str(scratch), "LC_ALL": "C.UTF-8"}
        done = subprocess.run(["sh", "-c", (case / "cmd").read_text()], cwd=source, env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=120)
        found = {"stdout": done.stdout.decode(), "stderr": done.stderr.decode(), "exit": f"{done.returncode}\n"}
        found = {name: text.replace(str(scratch), "$SCRATCH") for name, text in found.items()}
    usual = {"stdout": "", "stderr": "", "exit": "0\n"}
    failed = False
    for name, text in found.items():
        file = case / name
        if os.environ.get("FEELEM_UPDATE_GOLDEN"):
            file.unlink(missing_ok=True)
            if text != usual[name]:
                file.write_text(text)
            continue
        expected = file.read_text() if file.exists() else usual[name]
        if text != expected:
            failed = True
            print("".join(difflib.unified_diff(expected.splitlines(True), text.splitlines(True), f"{name} expected", f"{name} found")))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
