#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ansys' archives and lists read to a mesh with ids, types, materials, and all values, by one core, beside VTK's reader of text
.vtu and (a smaller block) meshio, in one run: first proves that all found the same nodes, elements and places, then runs them in
turn. Processor seconds of reading alone, files in memory. Writes bench/results/NAME.json. A wrong answer fails; a slow one
does not.

    bench/parse.py [--side 101] [--peer-side 40] [--runs 5] [--bin build/release/bin] [--work build/bench] [--name parse-ansys]"""
import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

from measure import HERE, run_alternating, spread, write_report

PYTHON = "/usr/bin/python3"  # What Debian's python3-meshio belongs to.


def made(path, command):
    """Written by command + [path], once."""
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_name("part-" + path.name)
        subprocess.run([str(c) if c is not None else str(part) for c in command], check=True)
        part.rename(path)
    return path


def lists(options, side):
    folder = options.work / f"lists{side}"
    if not (folder / "ETLIST.lis").exists():
        folder.mkdir(exist_ok=True)
        subprocess.run([str(options.bin / "bench_make_lists"), str(side), str(folder)], check=True)
    return folder


def size_of(path):
    return sum(file.stat().st_size for file in path.iterdir()) if path.is_dir() else path.stat().st_size


def findings(run):
    """A list of values alone knows no places: C++ says nan."""
    return json.loads(re.sub(r"-?\bnan\b", "NaN", run.out))


def seconds(run):
    found = findings(run)
    return found["open_cpu"] + found["load_cpu"]


def prove_equal(name, ours, theirs, digits):
    faults = [key for key in ("nodes", "elements", "corners") if ours[key] != theirs[key]]
    faults += [key for key in ("x", "y", "z") if abs(ours[key] - theirs[key]) > 10.0 ** -digits * abs(theirs[key])]
    if faults:
        sys.exit(f"bench: {name}: readers differ in {', '.join(faults)}:\n{ours}\n{theirs}")


def compare(options, files, peer, peer_command, side):
    """`files`: what of ours to read. Each is compared with the peer's findings of the same block."""
    commands = {peer: peer_command}
    commands |= {name: [options.bin / "bench_read_model", path, 1, 1] for name, path in files.items()}
    runs = run_alternating(commands, options.runs, cores={0}, alone=True)
    theirs = findings(runs[peer][0])
    rows = [{"reader": f"{peer} {theirs['version']}", "file": Path(peer_command[-1]).name, "bytes": size_of(Path(peer_command[-1])),
             "cpu": spread(map(seconds, runs[peer])),
             "gb_per_second": spread((1e-9 * size_of(Path(peer_command[-1])) / seconds(r) for r in runs[peer]), 3)}]
    for name, path in files.items():
        if name.startswith("mesh"):  # Lists of one kind hold a part of the mesh.
            prove_equal(path.name, findings(runs[name][0]), theirs, 9)
        size = size_of(path)
        rows.append({"reader": "Feelem", "file": path.name, "bytes": size, "cpu": spread(map(seconds, runs[name])),
                     "gb_per_second": spread((1e-9 * size / seconds(r) for r in runs[name]), 3),
                     "times_faster": spread((seconds(a) / seconds(b) for a, b in zip(runs[peer], runs[name])), 1)})
    for row in rows:
        print(f"  {row['reader']:<14}{row['file']:<22}{side:>4}^3 {row['bytes'] / 1e6:8.1f} MB {row['cpu']['median']:8.3f} s "
              f"{row['gb_per_second']['median']:7.3f} GB/s" + (f"  {row['times_faster']['median']} times" if "times_faster" in row else ""), flush=True)
    return rows


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--side", type=int, default=101, help="nodes along each edge of the block")
    options.add_argument("--peer-side", type=int, default=40, help="of the block that meshio reads")
    options.add_argument("--runs", type=int, default=5)
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--work", type=Path, default=HERE.parent / "build/bench")
    options.add_argument("--name", default="parse-ansys")
    options = options.parse_args()
    if not (options.bin / "bench_vtk_block").exists():
        print("bench: VTK is not installed (./dev setup exchange): nothing to compare with")
        return
    options.work.mkdir(parents=True, exist_ok=True)
    rows = []
    for side, peer in ((options.side, "VTK"), (options.peer_side, "meshio")):
        text = made(options.work / f"block{side}-ascii.vtu", [options.bin / "bench_vtk_block", "make", side, None, "ascii"])
        folder = lists(options, side)
        mesh_alone = options.work / f"mesh-lists{side}"
        mesh_alone.mkdir(exist_ok=True)
        for name in ("NLIST.lis", "ELIST.lis", "ETLIST.lis"):
            if not (mesh_alone / name).exists():
                (mesh_alone / name).hardlink_to(folder / name)
        files = {"mesh of archive": made(options.work / f"block{side}.cdb", [options.bin / "bench_make_cdb", side, None]),
                 "mesh of lists": mesh_alone, "mesh and values": folder, "nodes": folder / "NLIST.lis"}
        command = [options.bin / "bench_vtk_block", "read", text] if peer == "VTK" else [PYTHON, HERE / "peers/read_meshio.py", text]
        rows += compare(options, files, peer, command, side)
    write_report(options.name, {
        "what": "Ansys archives and lists to mesh and values by one core, VTK's and meshio's readers of the same mesh as text .vtu in "
                "turn; processor seconds of reading, files in memory", "runs": options.runs, "rows": rows})


if __name__ == "__main__":
    main()
