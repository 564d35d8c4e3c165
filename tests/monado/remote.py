# SPDX-License-Identifier: Apache-2.0
"""A headset and two controllers moved by a script: the other end of Monado's remote driver.

The driver listens on port 4242 of every network of the machine, so it is started in a network of its own:
`in_own_network()` first of all. It takes the whole state as one packet of 376 bytes (drivers/remote/r_interface.h).
"""
import fcntl
import os
import socket
import struct
import subprocess
import sys
import time

PORT = 4242
HEADER = b"mndrmt3\0"
IDENTITY = (0.0, 0.0, 0.0, 1.0)  # x y z w


def in_own_network():
    """Starts this script again where no other machine, and no other program, can reach the driver."""
    if os.environ.get("FEELEM_OWN_NETWORK") != "1":
        environment = os.environ | {"FEELEM_OWN_NETWORK": "1"}
        for unshare in (["unshare", "-rn"], ["unshare", "-n"]):
            if subprocess.run([*unshare, "true"], capture_output=True, check=False).returncode == 0:
                os.execvpe("unshare", [*unshare, sys.executable, *sys.argv], environment)
        print("skipped: no network namespace can be made here, and the remote driver listens to everybody")
        sys.exit(77)
    # "ip link set lo up", where there may be no ip.
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        up_and_running = 0x1 | 0x40
        fcntl.ioctl(any_socket, 0x8914, struct.pack("16sH14x", b"lo", up_and_running))


class Hand:
    def __init__(self, x):
        self.active = True
        self.position = (x, 1.3, -0.5)
        self.orientation = IDENTITY
        self.trigger = self.squeeze = 0.0
        self.stick = (0.0, 0.0)
        self.a = self.b = self.stick_pressed = False

    def packed(self):
        numbers = struct.pack("<7f 3f 3f 5f", *self.orientation, *self.position, *[0.0] * 11)
        analog = struct.pack("<f f f 2f f 2f", self.trigger, self.squeeze, 0.0, *self.stick, 0.0, 0.0, 0.0)
        # hand tracking, active, system 2x, a 2x, b 2x, trigger 2x, stick 2x, pad, three of no meaning
        bits = [False, self.active, False, False, self.a, self.a, self.b, self.b, self.trigger > 0.5, self.trigger > 0.0,
                self.stick_pressed, self.stick_pressed, False, False, False, False]
        return numbers + analog + bytes(bits)


class Person:
    """What the headset and the hands do; `send` makes it so."""

    def __init__(self):
        self.head = (0.0, 1.6, 0.0)
        self.head_orientation = IDENTITY
        self.left = Hand(-0.2)
        self.right = Hand(0.2)
        self.socket = None

    def packed(self):
        no_views = bytes(2 * 48)  # The driver has its own.
        head = struct.pack("<7f", *self.head_orientation, *self.head) + bytes(4)
        packet = HEADER + no_views + head + self.left.packed() + self.right.packed()
        assert len(packet) == 376
        return packet

    def connect(self, seconds=5.0):
        end = time.monotonic() + seconds
        while True:
            try:
                self.socket = socket.create_connection(("127.0.0.1", PORT), timeout=seconds)
                break
            except ConnectionRefusedError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.02)
        # The driver greets with its reset state and its latest one.
        greeting = b""
        while len(greeting) < 2 * 376:
            part = self.socket.recv(2 * 376 - len(greeting))
            if not part:
                raise RuntimeError("the remote driver hung up")
            greeting += part
        # It has no header; that both of us mean the same layout shows where the hands wait.
        for start, x in ((136, -0.2), (256, 0.2)):
            found = struct.unpack_from("<7f", greeting, start)
            if max(abs(a - b) for a, b in zip(found, (*IDENTITY, x, 1.3, -0.5))) > 1e-6:
                raise RuntimeError(f"the remote driver speaks another protocol: a hand waits at {found}")

    def send(self):
        self.socket.sendall(self.packed())

    def close(self):
        if self.socket:
            self.socket.close()


def looking_from_to(place, target):
    """Orientation that turns -Z from `place` to `target` (x y z w)."""
    d = [t - p for p, t in zip(place, target)]
    length = sum(c * c for c in d) ** 0.5
    d = [c / length for c in d]
    # Shortest turn of (0, 0, -1) onto d.
    w = 1.0 - d[2]
    if w < 1e-9:
        return (0.0, 1.0, 0.0, 0.0)
    x, y = d[1], -d[0]
    n = (x * x + y * y + w * w) ** 0.5
    return (x / n, y / n, 0.0, w / n)
