#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A whole conversion beside VTK's, in one run: an archive of commands (.cdb, text) to .glb by `feelem convert`, with the digests
of its input and its arrays, and the same mesh as appended raw .vtu to glTF by vtkXMLUnstructuredGridReader,
vtkDataSetSurfaceFilter and vtkGLTFWriter. First proves that both found the same skin (facets, area, nodes), then runs them in
turn with feelem on one core, with feelem without the digest of its input (which VTK does not make either) and with the least
that any reader of the text does, a mapped scan for line ends. Anonymous memory is looked at in runs of its own. Writes bench/results/NAME.json. A wrong answer fails; a slow one does not.

    bench/end_to_end.py [--side 101] [--runs 9] [--bin build/release/bin] [--work build/bench] [--name end-to-end]"""
import argparse
import array
import json
import re
import struct
import subprocess
import sys
from pathlib import Path

from measure import HERE, MIB, ratios, run_alternating, run_process, spread, write_report


def made(path, *command):
    if not path.exists():
        part = path.with_suffix(".part" + path.suffix)
        subprocess.run([str(c) for c in command[:command.index(None)]] + [str(part)] +
                       [str(c) for c in command[command.index(None) + 1:]], check=True)
        part.rename(path)
    return path


def skin_of_scene(path):
    """Facets, area and node ids of a scene: of the certificate and of the arrays."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    skin = document["extras"]["feelem"]["certificate"]["skin"]
    ids = set()
    for accessor in document["accessors"]:
        if not re.fullmatch(r"p\d+/_NODE_ID", accessor["name"]):
            continue
        view = document["bufferViews"][accessor["bufferView"]]
        start = 28 + length + view.get("byteOffset", 0)
        ids.update(array.array("f", data[start:start + 4 * accessor["count"]]))
    ids.discard(0.0)  # Centres of facets.
    return {"facets": skin["facets"]["kept"], "nodes": len(ids), "sum_of_node_ids": int(sum(ids)), "area": skin["area"]}


def prove_equal(ours, vtk):
    faults = [key for key in ("facets", "nodes", "sum_of_node_ids") if ours[key] != vtk[key]]
    if abs(ours["area"] - vtk["area"]) > 1e-9 * vtk["area"]:
        faults.append("area")
    if faults:
        sys.exit(f"bench: Feelem and VTK differ in {', '.join(faults)}:\n{ours}\n{vtk}")


def stages_of(run):
    """What --verbose says of each stage."""
    found = re.findall(r"^(\w+) +([\d.]+) s +peak +([\d.]+) MiB +anonymous +([\d.]+) MiB", run.err, re.M)
    return [{"stage": s, "seconds": float(t), "peak_mib": float(p), "anonymous_mib": float(a)} for s, t, p, a in found]


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--side", type=int, default=101, help="nodes along each edge of the block")
    options.add_argument("--runs", type=int, default=9)
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--work", type=Path, default=HERE.parent / "build/bench")
    options.add_argument("--name", default="end-to-end")
    options = options.parse_args()
    if not (options.bin / "bench_vtk_block").exists():
        print("bench: VTK is not installed (./dev setup exchange): nothing to compare with")
        return
    options.work.mkdir(parents=True, exist_ok=True)
    work, side = options.work, options.side
    cdb = made(work / f"block{side}.cdb", options.bin / "bench_make_cdb", side, None)
    vtu = made(work / f"block{side}.vtu", options.bin / "bench_vtk_block", "make", side, None, "raw")
    glb, gltf = work / f"block{side}-cdb.glb", work / f"block{side}.gltf"
    convert = [options.bin / "feelem", "convert", cdb, "-o", glb]
    one = ["taskset", "-c", "0"]
    bare = convert + ["--no-input-digest"]
    commands = {"feelem": convert, "feelem, one core": one + convert,
                "feelem, no digest of the input": bare, "feelem, no digest, one core": one + bare,
                "VTK": [options.bin / "bench_vtk_block", "gltf", vtu, gltf],
                "scan": one + [options.bin / "bench_scan_lines", cdb]}

    run_process(convert)
    ours = skin_of_scene(glb)
    vtk = json.loads(run_process([options.bin / "bench_vtk_block", "skin", vtu]).out)
    prove_equal(ours, vtk)

    runs = run_alternating(commands, options.runs, alone=True)
    watched = {name: [run_process(commands[name] + (["--verbose"] if name != "VTK" else []), watch_memory=True) for _ in range(3)]
               for name in ("feelem", "VTK")}
    rows = [{"program": name, "wall": spread(r.wall for r in found), "cpu": spread(r.cpu for r in found),
             "peak_mib": round(max(r.peak_rss for r in found) / MIB, 1),
             **({"peak_anonymous_mib": round(max(r.peak_anon for r in watched[name]) / MIB, 1)} if name in watched else {})}
            for name, found in runs.items()]
    faster = {"than_vtk_wall": ratios(runs["VTK"], runs["feelem"], "wall"), "than_vtk_cpu": ratios(runs["VTK"], runs["feelem"]),
              "than_vtk_one_core_wall": ratios(runs["VTK"], runs["feelem, one core"], "wall"),
              "than_vtk_no_digest_wall": ratios(runs["VTK"], runs["feelem, no digest of the input"], "wall"),
              "than_vtk_no_digest_cpu": ratios(runs["VTK"], runs["feelem, no digest of the input"]),
              "two_cores_than_one_wall": ratios(runs["feelem, one core"], runs["feelem"], "wall")}
    scans = {"wall": ratios(runs["feelem"], runs["scan"], "wall"), "one_core_wall": ratios(runs["feelem, one core"], runs["scan"], "wall"),
             "no_digest_one_core_wall": ratios(runs["feelem, no digest, one core"], runs["scan"], "wall")}
    anonymous = max(r.peak_anon for r in watched["feelem"])
    digest = run_process(one + ["openssl", "dgst", "-sha256", cdb], alone=True)
    report = write_report(options.name, {
        "what": f"hex8 block of {side ** 3} nodes: .cdb text to .glb by feelem, the same as appended raw .vtu to glTF by VTK, whole processes in turn",
        "input_bytes": cdb.stat().st_size, "vtu_bytes": vtu.stat().st_size, "answer": ours, "runs": options.runs, "rows": rows,
        "times_faster": faster, "times_the_scan": scans, "digest_of_input_cpu": round(digest.cpu, 3),
        "peak_anonymous_of_input": round(anonymous / cdb.stat().st_size, 3), "stages": stages_of(watched["feelem"][-1])})
    print(f"{report['what']}\n{report['machine']}, commit {report['commit']}, load {report['load']}")
    for row in rows:
        print(f"  {row['program']:<30} wall {row['wall']['median']:7.3f} s   CPU {row['cpu']['median']:7.3f} s   peak {row['peak_mib']:7.1f} MiB"
              + (f", anonymous {row['peak_anonymous_mib']:7.1f} MiB" if "peak_anonymous_mib" in row else ""))
    for name, ratio in {**faster, **{f"scans_{key}": value for key, value in scans.items()}}.items():
        print(f"  {name:<26} {ratio['median']:6.2f}  ({ratio['least']} to {ratio['most']})")
    print(f"  anonymous memory {anonymous / cdb.stat().st_size:.2f} of the input's size; its SHA-256 alone {digest.cpu:.3f} s of one core")


if __name__ == "__main__":
    main()
