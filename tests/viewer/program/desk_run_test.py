#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The whole feelem-xr, at the desk and in a scripted headset. 77: what it needs is not here.

desk_run_test.py FEELEM_XR FEELEM PROJECT SCRATCH SCRIPTED_RUNTIME.json
"""
import ctypes
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import unittest
import zlib

SKIPPED = 77
SCRIPT = """
0.0 move 0.5 0.45          # onto the boiler's shell
0.3 press left
0.4 glide 0.5 0.45 0.62 0.55 0.4
0.9 screenshot {folder}/sweep.png
1.0 release left
1.1 key C                  # a plane opens it
1.3 screenshot {folder}/cut.png
1.35 key Ctrl+S
1.4 quit
"""
HEADSET = """
0 pose right 0.15 1.2 -0.3 -0.1080 0.0810 0 0.9908  # at the boiler
5 input right trigger/value 1
"""


def read_png(path):
    """Width, height and rows of RGB bytes of a PNG without filters other than those that undo themselves row by row."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    width, height, depth, colour = size
    assert (depth, colour) == (8, 2), "8 bits, RGB"
    raw, stride, rows = zlib.decompress(packed), 3 * width, []
    before = bytearray(stride)
    for y in range(height):
        filtering, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up = row[i - 3] if i >= 3 else 0, before[i]
            corner = before[i - 3] if i >= 3 else 0
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[filtering]) & 255
        rows.append(bytes(row))
        before = row
    return width, height, rows


def die_with_parent():
    """For preexec_fn: a test that is killed leaves nothing running."""
    pr_set_pdeathsig = 1
    ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGKILL)


class Screen:
    """An X server of our own, which nobody sees."""

    def __enter__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
            pass_fds=[writing], preexec_fn=die_with_parent, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as told:
            number = told.readline().strip()
        if not number:
            self.server.wait(20)
            raise unittest.SkipTest("Xvfb does not start here")
        return ":" + number

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait(20)


class DeskRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if cls.scratch.exists():
            shutil.rmtree(cls.scratch)
        cls.scratch.mkdir(parents=True)
        boiler = cls.project / "examples/boiler"
        cls.scene = cls.scratch / "boiler.glb"
        subprocess.run(
            [cls.feelem, "convert", boiler / "boiler.frd", "-o", cls.scene, "--length-unit", "mm", "--unit", "temperature=degC",
             "--unit", "displacement=mm", "--unit", "stress=MPa", "--present", boiler / "boiler.presentation.json"],
            check=True, capture_output=True, timeout=120)

    def run_viewer(self, name, display=None, extra=()):
        folder = self.scratch / name
        folder.mkdir()
        (folder / "script.txt").write_text(SCRIPT.format(folder=folder))
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        environment.update(LIBGL_ALWAYS_SOFTWARE="1", SDL_AUDIODRIVER="dummy", XDG_RUNTIME_DIR=str(folder))
        if display:
            environment["DISPLAY"] = display
        ran = subprocess.run(
            [self.viewer, self.scene, "--xr=off", "--script", folder / "script.txt", "--record", folder / "session", *extra],
            env=environment, capture_output=True, text=True, timeout=300)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        lines = (folder / "session/session.jsonl").read_text().splitlines()
        return folder, [json.loads(line) for line in lines[1:]]

    def check_pictures(self, folder):
        pictures = {}
        for name in ("sweep", "cut"):
            width, height, rows = read_png(folder / f"{name}.png")
            self.assertEqual((width, height), (1280, 800))
            pictures[name] = rows
            colours = {row[x:x + 3] for row in rows[::4] for x in range(0, len(row), 12)}
            self.assertGreater(len(colours), 30, f"{name}.png is almost empty")
        changed = sum(a != b for a, b in zip(pictures["sweep"], pictures["cut"]))
        self.assertGreater(changed, 200, "the plane opened the model")

    def check_readings(self, frames):
        held = [f for f in frames if f.get("held") and f.get("probed")]
        self.assertGreater(len(held), 20, "the press was heard and felt on the way")
        for frame in held[:: max(1, len(held) // 5)]:
            probed = frame["probed"]
            place = ",".join(repr(c) for c in probed["model"])
            said = json.loads(subprocess.run([self.feelem, "probe", self.scene, f"--point={place}", "--json"],
                                             check=True, capture_output=True, text=True, timeout=60).stdout)
            self.assertLess(said["distance"], 1e-3, "the place that was read lies on the skin")
            values = {r["key"]: r for r in said["results"]}
            for reading in probed["readings"]:
                other = values[reading["key"]]
                size = max(abs(other["value"]), 1e-3)
                self.assertLess(abs(reading["value"] - other["value"]), 2e-5 * size, reading["key"])
            self.assertGreater(frame["sound"]["hz"], 130)

    def test_in_a_window_the_script_sweeps_cuts_and_leaves_pictures(self):
        with Screen() as display:
            folder, frames = self.run_viewer("window", display)
        self.check_pictures(folder)
        self.check_readings(frames)
        saved = json.loads((self.scratch / "boiler.presentation.json").read_text())
        self.assertEqual([r["key"] for r in saved["results"]], ["T", "U", "S"])
        # The converter takes it as it is.
        subprocess.run([self.feelem, "convert", self.project / "examples/boiler/boiler.frd", "-o", self.scratch / "again.glb",
                        "--present", self.scratch / "boiler.presentation.json"], check=True, capture_output=True, timeout=120)

    def test_without_a_screen_it_does_the_same_and_twice_gives_the_same_bytes(self):
        first, frames = self.run_viewer("first")
        second, _ = self.run_viewer("second")
        self.check_pictures(first)
        self.check_readings(frames)
        for name in ("sweep.png", "cut.png", "session/session.jsonl", "session/sound.wav"):
            self.assertEqual((first / name).read_bytes(), (second / name).read_bytes(), name)

    def test_end_of_the_program_stills_a_hand_that_shakes(self):
        folder = self.scratch / "headset"
        folder.mkdir()
        (folder / "script").write_text(HEADSET)
        record = folder / "record.jsonl"
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
        environment.update(LIBGL_ALWAYS_SOFTWARE="1", XR_RUNTIME_JSON=str(self.runtime),
                           FEELEM_XR_SCRIPT=str(folder / "script"), FEELEM_XR_RECORD=str(record))
        told = []
        for seconds in (4, 16, 64):  # On a busy machine it takes a while until the model is there.
            record.unlink(missing_ok=True)
            ran = subprocess.run([self.viewer, self.scene, "--xr=require", "--seconds", str(seconds)],
                                 env=environment, capture_output=True, text=True, timeout=150)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            told = [json.loads(line) for line in record.read_text().splitlines()]
            if any(line.get("haptic") not in (None, "stop") for line in told):
                break
        told = [line for line in told if "haptic" in line or "session" in line]
        self.assertEqual(told[-1]["session"], "destroyed")
        self.assertEqual(told[-2].get("haptic"), "stop", "the last pulse is ended while there is a session")
        self.assertGreater(len(told), 3, "and there was one")

    def test_what_cannot_be_is_said_with_the_right_exit_code(self):
        def run(*given):
            return subprocess.run([self.viewer, *given], capture_output=True, text=True, timeout=60,
                                  env={k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")})
        self.assertEqual(run().returncode, 2)
        self.assertIn("Usage: feelem-xr SCENE", run().stderr)
        self.assertEqual(run(self.scene, "--recrod", "x").returncode, 2)
        broken = self.scratch / "broken.bin"
        broken.write_bytes(self.scene.read_bytes()[:1000])
        ran = run(broken, "--screenshot", self.scratch / "none.png")
        self.assertEqual(ran.returncode, 1)
        self.assertIn("broken.bin", ran.stderr)
        self.assertFalse((self.scratch / "none.png").exists())
        no_screen = run(self.scene, "--xr=off")
        self.assertEqual(no_screen.returncode, 1)
        self.assertIn("screen", no_screen.stderr)


if __name__ == "__main__":
    if not shutil.which("Xvfb"):
        print("skipped: Xvfb is not installed")
        sys.exit(SKIPPED)
    viewer, feelem, project, scratch = (pathlib.Path(a).resolve() for a in sys.argv[1:5])
    DeskRun.viewer, DeskRun.feelem, DeskRun.project, DeskRun.scratch = viewer, feelem, project, scratch
    DeskRun.runtime = pathlib.Path(sys.argv[5]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[6:]], verbosity=2)
