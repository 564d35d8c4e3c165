#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What scenes cost on their way to the page: bytes a triangle with and without a bound, each further step, and time of one core
to unpack, on an irregular sheet of two million triangles and on the boiler cut finely; then the files that `feelem convert` writes
of the boiler, all their arrays counted. Draco and zfp beside them, where they are installed. Writes bench/results/wire.json.

    bench/wire.py [--side 1000] [--bin build/release/bin]"""
import argparse
import json
import os
import struct
import subprocess
import tempfile
from pathlib import Path

from measure import HERE, run_process, write_report

BOILER = HERE.parent / "examples/boiler"


def triangles_of(scene):
    with open(scene, "rb") as file:
        _, _, _, length, _ = struct.unpack("<4sIIII", file.read(20))
        return sum(part["triangles"] for part in json.loads(file.read(length))["extras"]["feelem"]["parts"])


def zstd_size(bin_folder, path):
    return int(run_process([bin_folder / "bench_wire", "zstd", path]).out)


def scenes(bin_folder, feelem):
    """Whole files: ids, normals, edges, every result, texture coordinates, pictures."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, options in {"plain": [], "--compress": ["--compress"], "--compress-bound 0.1%": ["--compress-bound", "0.1%"],
                              "--compress-bound 0.01%": ["--compress-bound", "0.01%"]}.items():
            scene = Path(folder) / "scene.glb"
            run_process([feelem, "convert", BOILER / "boiler.frd", "-o", scene, *options])
            size, sent, triangles = scene.stat().st_size, zstd_size(bin_folder, scene), triangles_of(scene)
            rows.append({"scene": name, "bytes": size, "with_zstd": sent, "triangles": triangles,
                         "bytes_a_triangle": round(size / triangles, 2), "sent_a_triangle": round(sent / triangles, 2)})
    return rows


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--side", type=int, default=1000, help="quads along each edge of the sheet")
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options = options.parse_args()
    models = {"irregular sheet": ["sheet", str(options.side)], "boiler, von Mises stress": [BOILER / "boiler.frd"]}
    rows, peers = [], []
    for name, arguments in models.items():
        for line in run_process([options.bin / "bench_wire", *arguments]).out.splitlines():
            rows.append({"model": name, **json.loads(line)})
        if (options.bin / "bench_codecs").exists():
            peers += [{"model": name, **json.loads(line)}
                      for line in run_process([options.bin / "bench_codecs", *arguments]).out.splitlines()]
    report = write_report("wire", {"what": "arrays of compressed scenes: positions, triangles and one result; least of 25, one core",
                                   "rows": rows, "peers": peers, "scenes": scenes(options.bin, options.bin / "feelem")})
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
