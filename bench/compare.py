#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Skins beside VTK's, in one run: first proves that both found the same facets, area, volume and values, then runs peer
and Feelem in turn and prints the ratios of processor time and of extra memory, with their spread. Writes
bench/results/NAME.json. A wrong answer fails; a slow one does not. Three figures:

    surface   the search for outer facets and output as vtkDataSetSurfaceFilter gives it (points used, with value and
              node; triangles with their element): equal work. The filter makes no triangles of quads and no nodes.
    stage     our whole stage as `feelem convert` runs it (triangles round centres, creases, normals, all element edges,
              a result carried) beside VTK's filter, vtkTriangleFilter and vtkPolyDataNormals split at 30 degrees, which
              make no edges.
    search    the search alone, which has no peer.

    bench/compare.py [--cells 8000000] [--runs 9] [--meshes hex8,tet4,...] [--numberings natural,windowed,random]
                     [--chain-runs 1] [--growth hex8,tet4] [--free FILE] [--name skin-8m]"""
import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

from measure import HERE, commit, machine, spread

MESHES = ("hex8", "tet4", "mixed", "plate", "degenerate", "hex20", "tet10")
STAGES = ("search", "compact", "stage")


def run(*command):
    """The lines that a program says, each a JSON object."""
    # VTK's own threads are off: one core is compared with one core.
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          env={**os.environ, "VTK_SMP_BACKEND_IN_USE": "Sequential"})
    if done.returncode:
        sys.exit(f"bench: {' '.join(str(part) for part in command)} failed: {done.stderr.strip()}")
    return [json.loads(line) for line in done.stdout.splitlines()]


def ours(options, mesh, cells, numbering, stages=STAGES):
    return {found["stage"]: found for found in run(options.bin / "bench_skin", ",".join(stages), mesh, cells, numbering, 1)}


def vtk(options, what, mesh, cells, numbering, *prove):
    return run(options.bin / "bench_vtk_skin", what, mesh, cells, numbering, *prove)[0]


def close(a, b):
    return abs(a - b) <= 1e-5 * max(abs(a), abs(b))


def prove_equal(mesh, mine, peer):
    """VTK computes in float, so areas and volumes agree to a float's digits; facets and values exactly."""
    faults = [f"search: {key}" for key in ("cells", "nodes", "facets", "facet_sum") if mine["search"][key] != peer[key]]
    faults += ["stage: facets"] if mine["stage"]["facets"] != peer["facets"] else []
    for stage in ("compact", "stage"):
        # VTK keeps sides that repeated nodes have made lines, and with them nodes from the inside.
        if mesh != "degenerate" and mine[stage]["value_sum"] != peer["value_sum"]:
            faults.append(f"{stage}: value_sum")
        faults += [f"{stage}: {key}" for key in ("area", "volume") if not close(mine[stage][key], peer[key])]
    if faults:
        sys.exit(f"bench: {mesh}: Feelem and VTK differ in {', '.join(faults)}:\n{mine}\n{peer}")


def column(found, key):
    return [one[key] for one in found]


def compare(options, mesh, cells, numbering, runs):
    mine, filters, chains = [], [], []
    for turn in range(runs):
        mine.append(ours(options, mesh, cells, numbering))
        # VTK's clock has stopped before it proves anything.
        filters.append(vtk(options, "dss", mesh, cells, numbering, *(["prove"] if turn == 0 else [])))
        if turn == 0:
            prove_equal(mesh, mine[0], filters[0])
        if turn < options.chain_runs:
            chains.append(vtk(options, "chain", mesh, cells, numbering))
    peer = filters[0]
    row = {"mesh": mesh.split("=")[0], "numbering": numbering, "cells": peer["cells"], "facets": peer["facets"],
           "runs": runs, "load": round(os.getloadavg()[0], 1), "commit": commit()}
    for name, found in (("vtk_filter", filters), ("vtk_chain", chains),
                        *((stage, [one[stage] for one in mine]) for stage in STAGES)):
        if found:
            row[f"{name}_cpu"] = spread(column(found, "cpu"))
            row[f"{name}_bytes_a_cell"] = round(statistics.median(column(found, "extra_bytes")) / peer["cells"], 1)
    row["surface_times_faster"] = spread([v["cpu"] / m["compact"]["cpu"] for v, m in zip(filters, mine)])
    if chains:
        row["stage_times_faster"] = spread([v["cpu"] / m["stage"]["cpu"] for v, m in zip(chains, mine)])
    return row


def growth(options, mesh):
    """How the time grows from an eighth of the cells to all: 1 is as the cells do. The two sizes take turns."""
    exponents = {"compact": [], "stage": []}
    for _ in range(options.runs if options.growth_runs is None else options.growth_runs):
        small = ours(options, mesh, options.cells // 8, "natural", tuple(exponents))
        big = ours(options, mesh, options.cells, "natural", tuple(exponents))
        for stage, found in exponents.items():
            cells = math.log(big[stage]["cells"] / small[stage]["cells"])
            found.append(math.log(big[stage]["cpu"] / small[stage]["cpu"]) / cells)
    return {"mesh": mesh, "from": options.cells // 8, "to": options.cells, "runs": len(exponents["compact"]),
            "surface_exponent": spread(exponents["compact"]), "stage_exponent": spread(exponents["stage"])}


def say(row):
    def median(key):
        return f"{row[key]['median']:.2f}" if key in row else "-"
    print(f"{row['mesh']:<11}{row['numbering']:<10}{row['cells']:>10,}"
          f"  surface: VTK {median('vtk_filter_cpu')} s, ours {median('compact_cpu')}: {median('surface_times_faster')} times"
          f"  stage: VTK {median('vtk_chain_cpu')}, ours {median('stage_cpu')}: {median('stage_times_faster')} times"
          f"  search {median('search_cpu')} s  bytes a cell: VTK {row['vtk_filter_bytes_a_cell']},"
          f" surface {row['compact_bytes_a_cell']}, stage {row['stage_bytes_a_cell']}  load {row['load']}", flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--cells", type=int, default=8_000_000)
    options.add_argument("--runs", type=int, default=9)
    options.add_argument("--chain-runs", type=int, default=1)
    options.add_argument("--growth-runs", type=int)
    options.add_argument("--meshes", default=",".join(MESHES))
    options.add_argument("--numberings", default="natural,windowed,random")
    options.add_argument("--only", help="instead of meshes and numberings, runs too if you like: hex8:natural:9,tet4:random")
    options.add_argument("--growth", default="", help="meshes whose growth from an eighth of the cells is measured")
    options.add_argument("--free", type=Path, help="a mesh of free_tets.py, as it is numbered")
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--keep", action="store_true", help="what the report holds already and this run does not measure stays in it, each with its commit")
    options.add_argument("--name", default="skin-8m")
    options = options.parse_args()
    if not (options.bin / "bench_vtk_skin").exists():
        sys.exit("bench: VTK is not installed: ./dev setup exchange")
    pairs = [(mesh, numbering) for mesh in options.meshes.split(",") for numbering in options.numberings.split(",")]
    if options.only is not None:
        pairs = [pair.split(":") for pair in options.only.split(",") if pair]
    pairs += [(f"free={options.free}", "natural")] if options.free else []
    report = {"what": "skins of one mesh, VTK and Feelem in turn, one core, processor seconds; see bench/compare.py",
              "machine": machine(), "commit": commit(), "chain_runs": options.chain_runs,
              "command": " ".join(sys.argv), "started": time.strftime("%Y-%m-%d %H:%M"), "rows": [], "growth": []}
    result = HERE / "results" / f"{options.name}.json"
    result.parent.mkdir(exist_ok=True)

    before = json.loads(result.read_text()) if options.keep and result.exists() else None

    def keep():
        if before:
            rows = {(row["mesh"], row["numbering"]): {"commit": before["commit"], **row} for row in before["rows"]}
            rows |= {(row["mesh"], row["numbering"]): row for row in report["rows"]}
            full = {**report, "rows": list(rows.values())}
            if not report["growth"]:
                full |= {key: before[key] for key in ("growth", "growth_commit", "growth_command") if key in before}
            result.write_text(json.dumps(full, indent=1) + "\n")
            return
        result.write_text(json.dumps(report, indent=1) + "\n")

    for mesh, numbering, *runs in pairs:
        report["rows"].append(compare(options, mesh, options.cells, numbering, int(runs[0]) if runs else options.runs))
        say(report["rows"][-1])
        keep()
    for mesh in [mesh for mesh in options.growth.split(",") if mesh]:
        report["growth"].append(growth(options, mesh))
        print(json.dumps(report["growth"][-1]), flush=True)
        keep()


if __name__ == "__main__":
    main()
