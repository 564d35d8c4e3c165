#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures `feelem convert` on a generated .frd: time and peak memory of the program and of each stage, and the bound
on its memory. Writes bench/results/NAME.json and prints the same; exits 1 when the bound is broken.

    bench/run.py [--side 100] [--bin build/release/bin] [--work build/bench] [--name frd-hex8-1m]"""
import argparse
import json
import os
import struct
import subprocess
import sys
import time
from pathlib import Path

from measure import HERE, MIB, commit, machine


def measured(command):
    """Runs a command: (seconds, CPU seconds, peak bytes, its standard output)."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.PIPE)
    out = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"bench: {command[0]} failed with {process.returncode}")
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, out


def scene_parts(path):
    """The parts that a scene lists: how many vertices and triangles its skin has."""
    with open(path, "rb") as file:
        _, _, _, length, _ = struct.unpack("<4sIIII", file.read(20))
        return json.loads(file.read(length))["extras"]["feelem"]["parts"]


def skin_bytes(parts):
    """The arrays of feelem::Surface: a vertex has a position, a normal, a node; a triangle its corners and its element;
    every quad has a centre with four weights and brings two edges."""
    vertices, triangles = (sum(part[key] for part in parts) for key in ("vertices", "triangles"))
    quads = triangles // 4
    return vertices * (24 + 12 + 4) + triangles * (12 + 4) + quads * (12 + 4 * (4 + 8) + 2 * 8)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--side", type=int, default=100, help="nodes along each edge of the block")
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--work", type=Path, default=HERE.parent / "build/bench")
    options.add_argument("--name", default="frd-hex8-1m")
    options = options.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    source, scene = options.work / f"block{options.side}.frd", options.work / f"block{options.side}.glb"

    if not source.exists():
        part = source.with_suffix(".part")
        subprocess.run([options.bin / "bench_make_frd", str(options.side), part], check=True)
        part.rename(source)
    command = [str(options.bin / "feelem"), "convert", str(source), "-o", str(scene)]
    seconds, cpu, peak, _ = measured(command)
    stages = json.loads(measured([str(options.bin / "bench_stages"), str(source), str(scene)])[3])

    nodes, elements = options.side**3, (options.side - 1) ** 3
    content = {"nodes": 24 * nodes, "connectivity": 4 * 8 * elements, "results": 4 * (3 + 1 + 6) * nodes,
               "skin": skin_bytes(scene_parts(scene))}
    bound = 64 * MIB + 2.5 * sum(content.values())
    report = {
        "what": f"feelem convert of an ASCII .frd: {nodes} hex8 nodes, {elements} elements, DISP NDTEMP STRESS",
        "machine": machine(), "commit": commit(), "input_bytes": source.stat().st_size, "scene_bytes": scene.stat().st_size,
        "seconds": round(seconds, 2), "cpu_seconds": round(cpu, 2),
        "peak_mib": round(peak / MIB, 1), "bound_mib": round(bound / MIB, 1), "within_bound": peak <= bound,
        "content_bytes": content,
        "stages": [{"stage": s["stage"], "seconds": s["seconds"], "peak_mib": round(s["peak_kib"] / 1024, 1)} for s in stages],
    }
    result = HERE / "results" / f"{options.name}.json"
    result.parent.mkdir(exist_ok=True)
    result.write_text(json.dumps(report, indent=1) + "\n")

    print(f"{report['what']}\n{report['machine']}, commit {report['commit']}")
    for stage in report["stages"]:
        print(f"  {stage['stage']:<24} {stage['seconds']:8.2f} s   peak {stage['peak_mib']:8.1f} MiB")
    print(f"  {'feelem convert':<24} {seconds:8.2f} s   peak {report['peak_mib']:8.1f} MiB, bound {report['bound_mib']} MiB: "
          f"{'within' if report['within_bound'] else 'BROKEN'}")
    sys.exit(0 if report["within_bound"] else 1)


if __name__ == "__main__":
    main()
