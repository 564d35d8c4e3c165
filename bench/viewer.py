#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The native viewer's loading and drawing of a model of five million triangles, without a window: a wavy tube of one layer of
hex8, made, converted, loaded and drawn by whatever OpenGL this machine has. Writes bench/results/viewer-5m.json.

    bench/viewer.py [--around 1000] [--along 625] [--runs 3] [--bin build/release/bin] [--work build/bench]"""
import argparse
import json
import statistics
from pathlib import Path

from measure import HERE, run_process, write_report


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--around", type=int, default=1000)
    options.add_argument("--along", type=int, default=625)
    options.add_argument("--runs", type=int, default=3)
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--work", type=Path, default=HERE.parent / "build/bench")
    options.add_argument("--name", default="viewer-5m")
    options = options.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    name = f"tank{options.around}x{options.along}"
    source, scene = options.work / f"{name}.frd", options.work / f"{name}.glb"
    if not scene.exists():
        run_process([options.bin / "bench_make_tank", options.around, options.along, source])
        run_process([options.bin / "feelem", "convert", source, "-o", scene, "--length-unit", "mm"])
        source.unlink()
    picture = options.work / f"{name}.png"
    runs = [json.loads(run_process([options.bin / "bench_viewer", scene, picture]).out) for _ in range(options.runs)]
    steps = []
    for same in zip(*(run["steps"] for run in runs)):
        step = {**same[0]}
        for key in ("wall", "cpu", "peak_mib"):
            step[key] = round(statistics.median(row[key] for row in same), 4)
        steps.append(step)
    first = {key: runs[0][key] for key in ("renderer", "vertices", "triangles", "edges")}
    times = "one run" if options.runs == 1 else f"median of {options.runs} runs"
    report = write_report(options.name, {
        "what": f"feelem-xr without a window: {first['triangles']:,} triangles loaded and drawn in software; {times}",
        "scene_bytes": scene.stat().st_size, **first, "steps": steps})
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
