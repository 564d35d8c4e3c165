# SPDX-License-Identifier: Apache-2.0
"""A screen that exists in memory only (Xvfb), and what is to be seen on it."""
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import zlib

from monado import Skipped, die_with_parent


class Screen:
    """with Screen(640, 360) as screen: environment = {"DISPLAY": screen.display}"""

    def __init__(self, width=640, height=360):
        self.size = f"{width}x{height}x24"

    def __enter__(self):
        if not shutil.which("Xvfb"):
            raise Skipped("there is no Xvfb: run ./dev setup native")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="feelem-screen-"))
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", self.size, "-fbdir", self.folder, "-nolisten", "tcp"],
            pass_fds=[write_end], preexec_fn=die_with_parent, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.display = ":" + number.readline().strip()
        if self.display == ":":
            self.__exit__()
            raise RuntimeError("Xvfb does not start")
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def picture(self):
        """What stands on the screen now."""
        data = (self.folder / "Xvfb_screen0").read_bytes()  # An XWD file: header, colours, pixels b g r x.
        head = struct.unpack(">25I", data[:100])
        header, width, height, bits, line, colours = head[0], head[4], head[5], head[11], head[12], head[19]
        assert bits == 32, f"{bits} bits a pixel"
        start = header + 12 * colours
        rows = [data[start + y * line:start + y * line + 4 * width] for y in range(height)]
        return Picture(width, height, rows)


class Picture:
    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def at(self, x, y):
        blue, green, red = self.rows[y][4 * x:4 * x + 3]
        return red, green, blue

    def share(self, wanted, columns):
        """Share of the pixels in `columns` (fractions of the width) for which wanted(red, green, blue) holds."""
        first, last = (round(c * self.width) for c in columns)
        hits = sum(wanted(*self.at(x, y)) for y in range(0, self.height, 4) for x in range(first, last, 4))
        return hits / max(1, len(range(0, self.height, 4)) * len(range(first, last, 4)))

    def save(self, path):
        """As PNG."""
        lines = bytearray()
        for row in self.rows:
            rgb = bytearray(3 * self.width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
            lines += b"\0" + rgb
        path = pathlib.Path(path)
        path.parent.mkdir(parents=True, exist_ok=True)

        def chunk(kind, content):
            return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", self.width, self.height, 8, 2, 0, 0, 0))
                         + chunk(b"IDAT", zlib.compress(bytes(lines), 6)) + chunk(b"IEND", b""))
