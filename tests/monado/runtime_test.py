#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Does the test runtime do what the other tests build on? Asked by xr_probe, a small OpenXR program.

runtime_test.py XR_PROBE PICTURES [CASE...]
"""
import re
import time

import remote
from cases import Case, Lines, json_lines, main
from monado import Monado
from screen import Screen

given = {}
PULSE = re.compile(r"\[Qwerty (Left|Right) Controller\] Haptic output:\s*"
                   r"frequency=([\d.]+) amplitude=([\d.]+) duration=(\d+)")


def pulses_at_driver(log):
    """Each pulse that reached the driver: hand, Hz, amplitude, nanoseconds."""
    return [(hand.lower(), float(hz), float(amplitude), int(duration)) for hand, hz, amplitude, duration in PULSE.findall(log)]


def shares_of_eyes(picture):
    """How much of the screen is as it should be, of the worse eye: the runtime's window fills it, left green, right blue."""
    return min(picture.share(lambda r, g, b: g > 200 and r < 60 and b < 60, (0, 0.5)),
               picture.share(lambda r, g, b: b > 200 and r < 60 and g < 60, (0.5, 1)))


class RuntimeTest(Case):
    def test_session_is_focused_and_painted(self):
        with Monado("simulated") as runtime:
            result = runtime.run([given["xr_probe"], "--seconds", "60", "--frames", "20"], seconds=90)
        lines = json_lines(result.stdout)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:])
        states = [line["state"] for line in lines if line["event"] == "state"]
        self.assertEqual(states[:5], ["IDLE", "READY", "SYNCHRONIZED", "VISIBLE", "FOCUSED"])
        self.assertEqual(states[-1], "EXITING")
        end = next(line for line in lines if line["event"] == "end")
        self.assertGreater(end["painted"], 5)
        self.assertEqual(end["gl_error"], 0)

    def test_scripted_hands_are_where_they_were_put(self):
        with Monado("remote") as runtime:
            person = remote.Person()
            person.connect()
            person.head = (0.1, 1.7, 0.2)
            lines = Lines(runtime.popen([given["xr_probe"], "--seconds", "120"]).stdout)
            for place, trigger, is_there in (((0.3, 1.1, -0.4), 0.0, True), ((0.25, 1.2, -0.6), 1.0, False)):
                hand, other = person.right, person.left
                hand.position, hand.trigger, other.active = place, trigger, is_there
                hand.orientation = remote.looking_from_to(place, (0.0, 1.0, -1.0))
                person.send()
                frame = lines.until(lambda line: line["event"] == "frame" and line["right"]["tracked"]
                                    and abs(line["right"]["position"][0] - place[0]) < 1e-6, "moved hand")
                for found, sent in zip(frame["right"]["position"] + frame["right"]["orientation"] + frame["head"]["position"],
                                       (*place, *hand.orientation, *person.head)):
                    self.assertAlmostEqual(found, sent, places=5)
                frame = lines.until(lambda line: line["event"] == "frame" and line["right_trigger"] == trigger, "trigger")
                self.assertEqual(frame["left"]["tracked"], is_there)
            person.close()

    def test_pulses_reach_the_driver_as_sent(self):
        with Monado("qwerty") as runtime:
            result = runtime.run([given["xr_probe"], "--seconds", "60", "--frames", "1", "--pulses", "8"], seconds=90)
            log = runtime.said()
        sent = [line for line in json_lines(result.stdout) if line["event"] == "pulse"]
        self.assertEqual(len(sent), 8)
        felt = pulses_at_driver(log)
        self.assertEqual(len(felt), 8, log[-2000:])
        for pulse, (hand, hz, amplitude, duration) in zip(sent, felt):
            self.assertEqual((hand, duration), (pulse["hand"], pulse["duration"]))
            self.assertAlmostEqual(hz, pulse["frequency"], places=2)
            self.assertAlmostEqual(amplitude, pulse["amplitude"], delta=0.0051)  # Two digits in the log.

    def test_killed_service_is_found_again(self):
        with Monado("simulated") as runtime:
            program = runtime.popen([given["xr_probe"], "--seconds", "120", "--frames", "60", "--reconnect"])
            lines = Lines(program.stdout)
            lines.until(lambda line: line.get("state") == "FOCUSED", "focus")
            runtime.kill()
            lost = lines.event("failed")
            self.assertEqual((lost["result"], lost["keepsake"]), (-13, True), "XR_ERROR_INSTANCE_LOST, textures kept")
            self.assertEqual(lines.event("failed")["result"], -2, "XR_ERROR_RUNTIME_FAILURE while nobody listens")
            runtime.start()
            lines.event("runtime")
            lines.until(lambda line: line.get("state") == "FOCUSED", "focus")
            self.assertEqual(lines.rest()[-1], {"event": "bye", "keepsake": True})
            self.assertEqual(program.wait(10), 0)

    def test_absent_runtime_has_its_own_code(self):
        with Monado("simulated") as runtime:
            result = runtime.run([given["xr_probe"]], environment={"XR_RUNTIME_JSON": "/nowhere/runtime.json"})
        self.assertEqual(json_lines(result.stdout)[-1]["result"], -51)  # XR_ERROR_RUNTIME_UNAVAILABLE

    def test_compositor_shows_both_eyes_on_a_screen(self):
        with Screen() as screen, Monado("xcb", environment={"DISPLAY": screen.display}) as runtime:
            program = runtime.popen([given["xr_probe"], "--seconds", "120"])
            Lines(program.stdout).until(lambda line: line.get("n", 0) > 10, "10 frames")
            # The first frames reach the screen a while after they were submitted.
            end = time.monotonic() + 30
            while shares_of_eyes(picture := screen.picture()) < 0.9 and time.monotonic() < end:
                time.sleep(0.25)
        picture.save(given["pictures"] / "runtime.png")
        self.assertGreater(shares_of_eyes(picture), 0.9)



if __name__ == "__main__":
    remote.in_own_network()
    main(given, "XR_PROBE PICTURES")
