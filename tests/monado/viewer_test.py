#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""feelem-xr in a real runtime: what scripted hands read, hear and feel of the boiler is what the files say.

viewer_test.py FEELEM_XR FEELEM WORK PICTURES [CASE...]
"""
import json
import math
import subprocess

import contract
import remote
from cases import Case, Lines, follow, main
from fingers import Fingers
from monado import ROOT, Monado
from runtime_test import pulses_at_driver
from screen import Screen

given = {}
BOILER = ROOT / "examples/boiler"
MODEL = (0.0, 1.0, -1.2)  # Where feelem-xr puts it for a person at the origin.
HAND = (0.15, 1.2, -0.3)
HEADLESS = {"DISPLAY": None, "WAYLAND_DISPLAY": None, "SDL_AUDIODRIVER": "dummy"}


def feelem(*arguments):
    done = subprocess.run([given["feelem"], *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if done.returncode:
        raise AssertionError(f"feelem {arguments[0]}: {done.stderr}")
    return done.stdout


def boiler_scene():
    """The boiler, converted once a run of this script."""
    scene = given["work"] / "boiler.glb"
    if "scene" not in given:
        given["work"].mkdir(parents=True, exist_ok=True)
        feelem("convert", BOILER / "boiler.frd", "-o", scene, "--length-unit", "mm", "--unit", "temperature=degC",
               "--unit", "displacement=mm", "--unit", "stress=MPa", "--present", BOILER / "boiler.presentation.json")
        given["scene"] = scene
    return scene


class Viewer:
    """feelem-xr with the boiler in a runtime, and its recording as it grows."""

    def __init__(self, runtime, name, *options, environment=None):
        folder = given["work"] / name
        for old in ("session.jsonl", "sound.wav"):
            (folder / old).unlink(missing_ok=True)
        self.program = runtime.popen(
            [given["feelem_xr"], boiler_scene(), "--record", folder, *options], environment=HEADLESS | (environment or {}))
        self.lines = Lines(follow(folder / "session.jsonl", self.program))

    def pulses(self):
        """All that were sent up to the last frame that was looked at."""
        return [pulse for line in self.lines.seen for pulse in line.get("pulses", [])]

    def until(self, wanted, what, seconds=120.0):
        return self.lines.until(lambda line: "frame" in line and wanted(line), what, seconds)

    def in_headset(self, seconds=120.0):
        """The first frame with a model before the person: loading takes its time on a busy machine."""
        return self.until(lambda frame: frame["headset"] and frame["focused"] and "hands" in frame, "frame in the headset", seconds)


def hand_of(frame, side):
    return next((hand for hand in frame.get("hands", []) if hand["side"] == side), None)


def aims(frame, side, orientation):
    hand = hand_of(frame, side)
    return hand is not None and math.dist(hand["aim"]["orientation"], orientation) < 1e-4


class SweepTest(Case):
    """A hand sweeps the boiler by the remote driver: every reading is checked against the program `feelem`."""

    def check_reading(self, probed):
        told = json.loads(feelem("probe", boiler_scene(), "--json", "--point=" + ",".join(map(repr, probed["model"]))))
        results = {(result["key"]): result for result in reversed(told["results"])}
        self.assertLess(told["distance"], 1e-9)
        for reading in probed["readings"]:
            result = results[reading["key"]]
            self.assertAlmostEqual(reading["value"], result["value"], delta=1e-12 * max(1.0, abs(result["value"])))
            self.assertEqual(reading["state"], result["state"])
        node = json.loads(feelem("probe", boiler_scene(), "--json", "--node", probed["node"]))
        for reading in probed["readings"]:
            result = next(result for result in node["results"] if result["key"] == reading["key"])
            self.assertEqual(reading["nodeValue"], result["nodeValue"], "the solver's own number, bit for bit")

    def check_senses(self, frame, presentation):
        """Sound and touch of a held frame are what the contract makes of its values."""
        readings = {reading["key"]: reading for reading in frame["probed"]["readings"]}
        ranges = {result["key"]: result["range"] for result in presentation["results"]}
        for reading in readings.values():
            span = ranges[reading["key"]]
            self.assertAlmostEqual(reading["u"], contract.share(reading["value"], span["lo"], span["hi"]), places=12)
        for effect in presentation["effects"]:
            reading = readings[effect["result"]]
            if effect["type"] == "pitch":
                self.assertAlmostEqual(frame["sound"]["hz"], contract.tone_hz(reading["u"], effect["midi"], effect["gamma"]), places=6)
            elif effect["type"] == "pulses":
                touch = next(touch for touch in frame["touch"] if touch["side"] == "right")
                rate, amplitude = contract.beat(reading["u"], effect["rateHz"], effect["ampMin"])
                self.assertAlmostEqual(touch["rate"], rate, places=9)
                self.assertAlmostEqual(touch["amplitude"], amplitude, places=9)
                self.assertEqual(touch["alarm"], reading["beyondLimit"])
                self.assertEqual(reading["beyondLimit"], reading["value"] > 250)

    def test_scripted_hand_reads_what_feelem_probe_says(self):
        contract.check()
        presentation = json.loads(feelem("info", boiler_scene(), "--json"))["scene"]["presentation"]
        frames = []
        with Monado("remote") as runtime:
            person = remote.Person()
            person.connect()
            viewer = Viewer(runtime, "sweep", "--xr=require")
            person.left.active = False
            hand = person.right
            hand.position, hand.orientation = HAND, remote.looking_from_to(HAND, MODEL)
            person.send()
            viewer.until(lambda frame: frame["headset"] and "probed" in frame, "the boiler before the hand")
            hand.trigger = 1.0
            person.send()
            viewer.until(lambda frame: frame.get("held"), "the boiler felt")
            for i in range(36):
                # Along a wave over the boiler, and beyond it.
                target = (-0.45 + 0.9 * i / 35, MODEL[1] + 0.2 * math.sin(i / 3), MODEL[2])
                hand.orientation = remote.looking_from_to(hand.position, target)
                person.send()
                frames.append(viewer.until(lambda frame, q=hand.orientation: aims(frame, "right", q), "the hand's turn"))
            hand.trigger = 0.0
            person.send()
            let_go = viewer.until(lambda frame: hand_of(frame, "right")["trigger"] == 0, "release")
            person.close()
        self.assertNotIn("sound", let_go)
        self.assertNotIn("touch", let_go)
        met = [frame for frame in frames if "probed" in frame]
        self.assertGreater(len(met), 15, "the hand should meet the boiler")
        self.assertGreater(len({frame["probed"]["element"] for frame in met}), 10)
        for frame in met:
            with self.subTest(frame=frame["frame"]):
                self.assertEqual(frame["pointer"], "right")
                self.check_reading(frame["probed"])
                if frame.get("held"):
                    self.check_senses(frame, presentation)
        self.assertGreater(sum(1 for frame in met if frame.get("held")), 10)

    def test_killed_runtime_leaves_the_scene_and_comes_back(self):
        with Screen(1280, 800) as screen, Monado("remote") as runtime:
            person = remote.Person()
            person.connect()
            aim = remote.looking_from_to(HAND, MODEL)
            person.left.active = False
            person.right.position, person.right.orientation = HAND, aim
            person.send()
            viewer = Viewer(runtime, "killed", environment={"DISPLAY": screen.display})
            before = viewer.until(lambda frame: frame["headset"] and aims(frame, "right", aim) and "probed" in frame,
                                  "reading before")
            runtime.kill()
            person.close()
            at_desk = viewer.until(lambda frame: not frame["headset"], "frame at the desk")
            # The desk goes on drawing while nobody answers.
            viewer.until(lambda frame: not frame["headset"] and frame["time"] > at_desk["time"] + 1, "a second at the desk")
            self.assertIsNone(viewer.program.poll(), "it must live")
            runtime.start()
            person.connect()
            person.send()
            after = viewer.until(lambda frame: frame["headset"] and aims(frame, "right", aim) and "probed" in frame,
                                 "reading after")
            self.assertGreater(after["frame"], before["frame"])
            self.check_reading(before["probed"])
            self.check_reading(after["probed"])
            self.assertEqual(after["probed"]["element"], before["probed"]["element"], "the same model at the same place")
            person.close()


class TouchTest(Case):
    """Monado's qwerty devices: keyboard and mouse of a screen are the controllers, and the driver says each pulse."""

    def test_pulses_at_the_driver_are_those_of_the_plan(self):
        with Screen(1024, 768) as screen, Monado("qwerty", environment={"DISPLAY": screen.display, "XRT_DEBUG_GUI": "1"}) as runtime:
            fingers = Fingers(screen.display)
            self.addCleanup(fingers.close)
            fingers.point(900, 700)
            viewer = Viewer(runtime, "touch", "--xr=require")
            viewer.in_headset()
            fingers.press("left alt")  # The keys now move the right controller, until its ray meets the model.
            fingers.press("a")
            viewer.until(lambda frame: frame.get("pointer") == "right", "the model before the hand")
            fingers.release("a")
            fingers.press("left")
            viewer.until(lambda frame: frame.get("held") and "touch" in frame, "touch")
            fingers.press("q")  # Down over the boiler while it is felt.
            viewer.until(lambda frame: len(viewer.pulses()) >= 4, "four pulses")
            fingers.release("q")
            viewer.until(lambda frame: len(viewer.pulses()) >= 10, "ten pulses")
            fingers.release("left")
            viewer.until(lambda frame: not frame.get("held"), "release")
            # What was sent before is with the driver by now: it was sent before this frame.
            viewer.until(lambda frame: True, "a frame")
            log = runtime.said()
            sent = viewer.pulses()
        felt = pulses_at_driver(log)
        self.assertEqual(len(felt), len(sent))
        for pulse, (side, frequency, amplitude, duration) in zip(sent, felt):
            self.assertEqual(side, pulse["side"])
            self.assertEqual(frequency, 0, "left to the device: amplitude and rhythm carry the value")
            self.assertAlmostEqual(amplitude, pulse["strength"], delta=0.0051)  # Two digits in the log.
            self.assertAlmostEqual(duration, pulse["milliseconds"] * 1e6, delta=1)
        self.check_plan([line for line in viewer.lines.seen if "touch" in line])

    def check_plan(self, frames):
        """A beat has the amplitude of the touch of its frame, and none comes too soon."""
        beats = [(pulse, frame) for frame in frames for pulse in frame.get("pulses", []) if pulse["cause"] == "beat"]
        self.assertGreater(len(beats), 3)
        for pulse, frame in beats:
            touch = next(touch for touch in frame["touch"] if touch["side"] == pulse["side"])
            if not touch["still"]:
                self.assertAlmostEqual(pulse["strength"], touch["amplitude"], places=9)
            self.assertEqual(pulse["milliseconds"], touch["milliseconds"])
        for (one, _), (next_one, _) in zip(beats, beats[1:]):
            self.assertGreaterEqual(next_one["time"] - one["time"], 0.079)


class PictureTest(Case):
    def test_compositor_shows_the_boiler_to_both_eyes(self):
        with Screen(960, 540) as screen, Monado("remote_xcb", environment={"DISPLAY": screen.display}) as runtime:
            person = remote.Person()
            person.connect()
            person.left.active = False
            hand = person.right
            hand.position, hand.orientation = HAND, remote.looking_from_to(HAND, MODEL)
            person.head_orientation = remote.looking_from_to(person.head, MODEL)
            person.send()
            viewer = Viewer(runtime, "picture", "--xr=require")
            viewer.until(lambda frame: frame["headset"] and "probed" in frame, "the boiler before the hand")
            hand.trigger = 1.0
            person.send()
            felt = viewer.until(lambda frame: frame.get("held") and "probed" in frame, "the boiler felt")
            viewer.until(lambda frame: frame["frame"] > felt["frame"] + 3, "three frames more")
            picture = screen.picture()
            person.close()
        picture.save(given["pictures"] / "viewer_in_headset.png")

        def coloured(red, green, blue):
            return max(red, green, blue) - min(red, green, blue) > 60
        left, right = picture.share(coloured, (0, 0.5)), picture.share(coloured, (0.5, 1))
        self.assertGreater(left, 0.02, "the boiler's colours for the left eye")
        self.assertGreater(right, 0.02, "and for the right one")
        self.assertLess(abs(left - right), 0.5 * max(left, right))


class DoctorTest(Case):
    def test_doctor_sees_the_runtime_come_and_go(self):
        with Monado("simulated") as runtime:
            well = runtime.run([given["feelem_xr"], "doctor"], environment=HEADLESS)
            self.assertIn("runtime    yes   Monado, chosen by XR_RUNTIME_JSON\n", well.stdout)
            self.assertIn("service    yes   Monado(XRT)", well.stdout)
            self.assertIn("headset    yes   Monado: Simulated HMD\n", well.stdout)
            self.assertIn("graphics   poor  OpenGL 4.5, llvmpipe", well.stdout)
            runtime.kill()
            killed = runtime.run([given["feelem_xr"], "doctor"], environment=HEADLESS)
            self.assertIn("nobody answers: the service has crashed or hangs\n", killed.stdout)
            self.assertIn("headset    no    not asked\n", killed.stdout)
            self.assertIn("In a headset: no.\n", killed.stdout)
            without = runtime.run([given["feelem_xr"], "doctor"], environment=HEADLESS | {"XR_RUNTIME_JSON": "/nowhere/runtime.json"})
            self.assertIn("runtime    no    XR_RUNTIME_JSON names /nowhere/runtime.json, which is not there\n", without.stdout)


if __name__ == "__main__":
    remote.in_own_network()
    main(given, "FEELEM_XR FEELEM WORK PICTURES")
