#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a file with meshio and says as bench_read_model does what was found and how much processor time reading took."""
import json
import sys
import time

import meshio


def main():
    path = sys.argv[1]
    start, wall = time.process_time(), time.monotonic()
    mesh = meshio.read(path)
    cpu, wall = time.process_time() - start, time.monotonic() - wall
    points = mesh.points.sum(axis=0)
    cells = [block.data for block in mesh.cells]
    # meshio counts nodes from 0; the generated decks from 1 without gaps.
    json.dump({"open_cpu": cpu, "open_wall": wall, "load_cpu": 0, "nodes": len(mesh.points),
               "elements": sum(len(data) for data in cells), "corners": int(sum(data.sum() + data.size for data in cells)),
               "x": float(points[0]), "y": float(points[1]), "z": float(points[2]), "version": meshio.__version__}, sys.stdout)


if __name__ == "__main__":
    main()
