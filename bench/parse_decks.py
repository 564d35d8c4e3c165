#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decks and results as text, read to mesh, sets and values, beside meshio and VTK's own text reader, in one run: first proves
that all found the same mesh, then runs peer and Feelem in turn, one core each, and prints gigabytes a second and ratios of
processor time: of reading alone, and of whole processes. Writes bench/results/NAME.json. A wrong answer fails; a slow one does not.

    bench/parse_decks.py [--side 100] [--peer-side 100] [--only inp,msh41] [--rounds 3] [--bin build/release/bin] [--work build/bench] [--name parse-decks]"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

from measure import HERE, ratios, run_alternating, spread, write_report

DECKS = {"inp": "inp", "bdf-free": "bdf", "bdf-small": "bdf", "bdf-large": "bdf",
         "msh22": "msh", "msh41": "msh", "msh41-binary": "msh", "unv": "unv"}
# meshio finds no elements in large fields; neither it nor VTK reads universal files.
WITHOUT_PEER = ("bdf-large", "unv")
# What Debian's python3-meshio and python3-vtk9 belong to.
PYTHON = "/usr/bin/python3"


def made(options, form, side):
    """The generated file; written once."""
    suffix = DECKS.get(form, form)
    path = options.work / f"block{side}-{form}.{suffix}"
    if not path.exists():
        part = path.with_suffix(".part")
        maker = [options.bin / "bench_make_frd", str(side)] if form == "frd" else [options.bin / "bench_make_deck", form, str(side)]
        subprocess.run([*maker, part], check=True)
        part.rename(path)
    return path


def close(a, b):
    return abs(a - b) <= 1e-12 * max(abs(a), abs(b), 1)


def prove_equal(what, ours, theirs):
    """Sums are taken in another order, so that they agree but for their last digits; everything else exactly."""
    faults = [key for key in ("nodes", "elements", "corners") if ours[key] != theirs[key]]
    faults += [key for key in ("x", "y", "z") if not close(ours[key], theirs[key])]
    if faults:
        sys.exit(f"bench: {what}: readers differ in {', '.join(faults)}:\n{ours}\n{theirs}")


def parsing(runs):
    """Processor seconds of reading alone, as each program measured it."""
    return [json.loads(run.out)["open_cpu"] + json.loads(run.out)["load_cpu"] for run in runs]


def row_of(name, path, runs):
    size, seconds = path.stat().st_size, parsing(runs)
    found = json.loads(runs[0].out)
    row = {"reader": name, "file": path.name, "bytes": size, "nodes": found["nodes"], "elements": found["elements"],
           "parse_cpu": spread(seconds), "gb_per_second": spread((1e-9 * size / s for s in seconds), 3),
           "process_cpu": spread(run.cpu for run in runs), "process_wall": spread(run.wall for run in runs),
           "peak_mib": round(max(run.peak_rss for run in runs) / (1 << 20), 1)}
    if "version" in found:
        row["version"] = found["version"]
    if found["load_cpu"]:
        row["values"] = found["values"]
    return row


def say(row, times=""):
    print(f"{row['reader']:<16}{row['file']:<26}{row['bytes'] / 1e6:9.1f} MB{row['parse_cpu']['median']:9.3f} s"
          f"{row['gb_per_second']['median']:9.3f} GB/s  {times}", flush=True)


def times_faster(peer, ours):
    slow, fast = parsing(peer), parsing(ours)
    return {"parse": spread((a / b for a, b in zip(slow, fast)), 1), "process": ratios(peer, ours)}


def beside_meshio(options, form):
    """The same file through both."""
    path = made(options, form, options.peer_side)
    runs = run_alternating({"meshio": [PYTHON, HERE / "peers/read_meshio.py", path],
                            "feelem": [options.bin / "bench_read_model", path, 1, 1]}, options.rounds, cores={0}, alone=True)
    prove_equal(path.name, json.loads(runs["feelem"][0].out), json.loads(runs["meshio"][0].out))
    faster = times_faster(runs["meshio"], runs["feelem"])
    rows = [row_of("meshio", path, runs["meshio"]),
            {**row_of("Feelem", path, runs["feelem"]), "times_faster_than_meshio": faster}]
    say(rows[0])
    say(rows[1], f"{faster['parse']['median']} times")
    return rows


def beside_vtk(options, forms):
    """The same block through each: VTK reads it from its own text, the others hold the same mesh."""
    vtk = made(options, "vtk", options.side)
    files = {form: made(options, form, options.side) for form in [*forms, "frd"]}
    commands = {"VTK": [PYTHON, HERE / "peers/read_vtk_text.py", vtk]}
    commands |= {form: [options.bin / "bench_read_model", path, 1, 1] for form, path in files.items()}
    runs = run_alternating(commands, options.rounds, cores={0}, alone=True)
    theirs = json.loads(runs["VTK"][0].out)
    if "inp" in forms:
        prove_equal("inp", json.loads(runs["inp"][0].out), theirs)
    for form in files:
        ours = json.loads(runs[form][0].out)
        if any(ours[key] != theirs[key] for key in ("nodes", "elements", "corners")):
            sys.exit(f"bench: {form}: {ours}\n{theirs}")
    rows = [row_of("VTK", vtk, runs["VTK"])]
    say(rows[0])
    for form, path in files.items():
        faster = times_faster(runs["VTK"], runs[form])
        rows.append({**row_of("Feelem", path, runs[form]), "times_faster_than_vtk": faster})
        say(rows[-1], f"{faster['parse']['median']} times")
    return rows


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--side", type=int, default=100, help="nodes along each edge of the block")
    options.add_argument("--peer-side", type=int, default=100, help="of the block that meshio reads: ten seconds a file at 100")
    options.add_argument("--only", help="some of " + ", ".join(DECKS))
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--work", type=Path, default=HERE.parent / "build/bench")
    options.add_argument("--name", default="parse-decks")
    options = options.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    forms = [form for form in DECKS if options.only is None or form in options.only.split(",")]
    rows = [row for form in forms if form not in WITHOUT_PEER for row in beside_meshio(options, form)]
    rows += beside_vtk(options, forms)
    write_report(options.name, {
        "what": "text read to mesh, sets and (frd) all values by one core: meshio, VTK's legacy text reader and Feelem in turn; "
                "processor seconds, files in memory", "rounds": options.rounds, "rows": rows})


if __name__ == "__main__":
    main()
