#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Skins beside VTK's, in one run: first proves that both found the same facets, area, volume and values, then runs peer
and Feelem in turn and prints the ratios of processor time and of extra memory, with their spread. Writes
bench/results/NAME.json. A wrong answer fails; a slow one does not.

    bench/compare.py [--cells 8000000] [--runs 9] [--meshes hex8,tet4,...] [--numberings natural,windowed,random] [--name skin-8m]"""
import argparse
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

from measure import HERE, commit, machine, spread

MESHES = ("hex8", "tet4", "mixed", "plate", "hex20", "tet10")


def run(*command):
    # VTK's own threads are off: one core is compared with one core.
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          env={**os.environ, "VTK_SMP_BACKEND_IN_USE": "Sequential"})
    if done.returncode:
        sys.exit(f"bench: {' '.join(str(part) for part in command)} failed: {done.stderr.strip()}")
    return json.loads(done.stdout)


def close(a, b):
    return abs(a - b) <= 1e-5 * max(abs(a), abs(b))


def prove_equal(kind, facets, skin, vtk):
    """VTK computes in float, so areas and volumes agree to a float's digits; facets and values exactly."""
    faults = [key for key in ("cells", "nodes", "facets", "facet_sum") if facets[key] != vtk[key]]
    faults += [key for key in ("facets", "value_sum") if skin[key] != vtk[key]]
    faults += [key for key in ("area", "volume") if not close(skin[key], vtk[key])]
    if faults:
        sys.exit(f"bench: {kind}: Feelem and VTK differ in {', '.join(faults)}:\n{facets}\n{skin}\n{vtk}")


def compare(bin_folder, kind, cells, numbering, runs):
    ours = {"facets": [], "skin": []}
    peer = []
    for _ in range(runs):
        for stage, found in ours.items():
            found.append(run(bin_folder / "bench_skin", stage, kind, cells, numbering, 1))
        peer.append(run(bin_folder / "bench_vtk_skin", "dss", kind, cells, numbering))
        prove_equal(kind, ours["facets"][-1], ours["skin"][-1], peer[-1])
    row = {"mesh": kind, "numbering": numbering, "cells": peer[0]["cells"], "facets": peer[0]["facets"],
           "vtk_cpu": spread([found["cpu"] for found in peer]),
           "vtk_bytes_a_cell": round(statistics.median(f["extra_bytes"] for f in peer) / peer[0]["cells"], 1)}
    for stage, found in ours.items():
        row[f"{stage}_cpu"] = spread([f["cpu"] for f in found])
        row[f"{stage}_bytes_a_cell"] = round(statistics.median(f["extra_bytes"] for f in found) / peer[0]["cells"], 1)
        row[f"{stage}_times_faster"] = spread([v["cpu"] / f["cpu"] for v, f in zip(peer, found)])
    return row


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--cells", type=int, default=8_000_000)
    options.add_argument("--runs", type=int, default=9)
    options.add_argument("--meshes", default=",".join(MESHES))
    options.add_argument("--numberings", default="natural,windowed,random")
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--name", default="skin-8m")
    options = options.parse_args()
    if not (options.bin / "bench_vtk_skin").exists():
        sys.exit("bench: VTK is not installed: ./dev setup exchange")
    rows = []
    print(f"{'mesh':<8}{'numbering':<11}{'cells':>10}  {'VTK s':>7}{'facets s':>10}{'skin s':>8}{'VTK/facets':>12}{'VTK/skin':>10}"
          f"   bytes a cell: VTK, facets, skin")
    for kind in options.meshes.split(","):
        for numbering in options.numberings.split(","):
            row = compare(options.bin, kind, options.cells, numbering, options.runs)
            rows.append(row)
            print(f"{kind:<8}{numbering:<11}{row['cells']:>10,}  {row['vtk_cpu']['median']:>7.2f}{row['facets_cpu']['median']:>10.2f}"
                  f"{row['skin_cpu']['median']:>8.2f}{row['facets_times_faster']['median']:>12.1f}{row['skin_times_faster']['median']:>10.1f}"
                  f"   {row['vtk_bytes_a_cell']}, {row['facets_bytes_a_cell']}, {row['skin_bytes_a_cell']}", flush=True)
    report = {"what": "skins of one mesh, VTK's vtkDataSetSurfaceFilter and Feelem in turn, one core, processor time",
              "machine": machine(), "commit": commit(), "runs": options.runs, "rows": rows}
    result = HERE / "results" / f"{options.name}.json"
    result.parent.mkdir(exist_ok=True)
    result.write_text(json.dumps(report, indent=1) + "\n")


if __name__ == "__main__":
    main()
