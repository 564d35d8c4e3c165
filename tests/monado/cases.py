# SPDX-License-Identifier: Apache-2.0
"""What the tests with the real runtime share: unittest's cases, and "skipped" as CTest understands it."""
import json
import pathlib
import queue
import sys
import threading
import time
import unittest

from monado import SKIPPED, Skipped


class Lines:
    """The JSON lines of a running program, as they come. Those that were asked for are kept in `seen`."""

    def __init__(self, stream):
        self.seen = []
        self.waiting = queue.SimpleQueue()
        threading.Thread(target=self._read, args=(stream,), daemon=True).start()

    def _read(self, stream):
        for line in stream:
            if line.startswith("{"):
                self.waiting.put(json.loads(line))
        self.waiting.put(None)
        if hasattr(stream, "close"):
            stream.close()

    def until(self, wanted, what, seconds=60.0):
        """The next line for which wanted(line) holds."""
        end = time.monotonic() + seconds
        while True:
            try:
                line = self.waiting.get(timeout=max(0.0, end - time.monotonic()))
            except queue.Empty:
                raise AssertionError(f"in {seconds} s came no {what}; last: {self.seen[-3:]}") from None
            if line is None:
                raise AssertionError(f"the program ended before {what}; last: {self.seen[-3:]}")
            self.seen.append(line)
            if wanted(line):
                return line

    def event(self, name, seconds=60.0):
        return self.until(lambda line: line["event"] == name, f'"{name}"', seconds)

    def rest(self, seconds=60.0):
        """All up to the program's end."""
        end = time.monotonic() + seconds
        while (line := self.waiting.get(timeout=max(0.0, end - time.monotonic()))) is not None:
            self.seen.append(line)
        return self.seen


def follow(path, program):
    """The lines of a file that `program` is writing, until it has ended."""
    while not path.exists() and program.poll() is None:
        time.sleep(0.02)
    if not path.exists():
        return
    with open(path, encoding="utf-8") as file:
        line = ""
        while True:
            has_ended = program.poll() is not None
            line += file.readline()
            if line.endswith("\n"):
                yield line
                line = ""
            elif has_ended:
                return
            else:
                time.sleep(0.01)


def json_lines(text):
    return [json.loads(line) for line in text.splitlines() if line.startswith("{")]


def main(folder, argument_names):
    """Runs the cases of the calling script: SCRIPT ARGUMENT... [CASE...]. 77 when none could be run."""
    names = argument_names.split()
    given = sys.argv[1:1 + len(names)]
    if len(given) < len(names):
        sys.exit(f"usage: {sys.argv[0]} {argument_names} [CASE...]")
    values = {name.lower(): pathlib.Path(value).resolve() for name, value in zip(names, given)}
    folder.update(values)
    program = unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[1 + len(names):]], exit=False, verbosity=2, warnings="ignore")
    result = program.result
    if result.wasSuccessful() and result.testsRun == len(result.skipped):
        sys.exit(SKIPPED)
    sys.exit(0 if result.wasSuccessful() else 1)


class Case(unittest.TestCase):
    """A case; Skipped skips it."""

    def _callTestMethod(self, method):
        try:
            super()._callTestMethod(method)
        except Skipped as reason:
            self.skipTest(str(reason))
