# SPDX-License-Identifier: Apache-2.0
"""Presses keys and buttons of a Screen, as a person at it would: the X11 protocol and its extension XTEST, by hand.

Monado's qwerty devices take the keyboard and mouse of its debug window: the left button is the trigger of the right
controller; with the left Alt key held, W A S D Q E move that controller and a drag by the right button turns it.
"""
import socket
import struct

KEYS = {"left alt": 64, "left control": 37, "w": 25, "a": 38, "s": 39, "d": 40, "q": 24, "e": 26}  # Xvfb's own layout.
BUTTONS = {"left": 1, "middle": 2, "right": 3}
KEY_PRESS, KEY_RELEASE, BUTTON_PRESS, BUTTON_RELEASE, MOTION = 2, 3, 4, 5, 6


class Fingers:
    def __init__(self, display):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(f"/tmp/.X11-unix/X{display.removeprefix(':')}")
        self.socket.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, 0, 0))
        status, _, _, _, words = struct.unpack("<BBHHH", self._take(8))
        self._take(4 * words)
        if status != 1:
            raise RuntimeError("the screen does not let us in")
        name = b"XTEST"
        self.socket.sendall(struct.pack("<BxHHxx8s", 98, 4, len(name), name))
        reply = self._take(32)
        if not reply[8]:
            raise RuntimeError("the screen has no XTEST")
        self.xtest = reply[9]

    def close(self):
        self.socket.close()

    def _take(self, count):
        data = b""
        while len(data) < count:
            part = self.socket.recv(count - len(data))
            if not part:
                raise RuntimeError("the screen hung up")
            data += part
        return data

    def _send(self, kind, detail, x=0, y=0):
        self.socket.sendall(struct.pack("<BBHBBxxII8xhh8x", self.xtest, 2, 9, kind, detail, 0, 0, x, y))

    def press(self, what):
        self._send(*((KEY_PRESS, KEYS[what]) if what in KEYS else (BUTTON_PRESS, BUTTONS[what])))

    def release(self, what):
        self._send(*((KEY_RELEASE, KEYS[what]) if what in KEYS else (BUTTON_RELEASE, BUTTONS[what])))

    def point(self, x, y):
        self._send(MOTION, 0, x, y)
