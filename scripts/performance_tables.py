# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/performance.md and README.md, made of bench/results/*.json alone: no figure is typed by hand.

update_docs.py asks for them by name: `<!-- generated: bench-skin -->`. A new table is a function and a line in TABLES."""
import json
from pathlib import Path

RESULTS = Path(__file__).resolve().parent.parent / "bench/results"


def load(name):
    return json.loads((RESULTS / f"{name}.json").read_text())


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def source(name, data):
    """Where the figures are from."""
    busy = data.get("load", data.get("loadAverage"))
    loads = sorted(row["load"] for row in data.get("rows", []) if isinstance(row, dict) and "load" in row)
    if busy is None and loads:
        busy = f"{loads[0]} to {loads[-1]}" if loads[0] != loads[-1] else loads[0]
    parts = [f"[{name}.json](../bench/results/{name}.json)", f"commit {data['commit']}", data["machine"]]
    if busy is not None:
        parts.append(f"load {busy}")
    command = data.get("command", "").split("/")[-1] if data.get("command", "").startswith("/") else data.get("command", "")
    return "\n\n" + ", ".join(parts) + (f". Again: `{plain(command)}`" if command else "")


def plain(command):
    """Without the folders of whoever ran it."""
    words = command.split()
    kept, skip = [], False
    for word in words:
        if skip:
            skip = False
        elif word in ("--bin", "--work"):
            skip = True
        else:
            kept.append("free.tets" if word.endswith("free.bin") else word)
    return " ".join(kept)


def times(spread, digits=1):
    middle = f"**{spread['median']:.{digits}f}**"
    if spread["least"] == spread["most"]:
        return middle + ", one run"
    return f"{middle} ({spread['least']:.{digits}f} to {spread['most']:.{digits}f})"


def seconds(spread):
    return f"{spread['median']:.3f}"


def skin(_):
    data = load("skin-8m")
    rows = []
    for row in data["rows"]:
        chain = times(row["stage_times_faster"]) if "stage_times_faster" in row else ""
        rows.append([row["mesh"], row["numbering"], f"{row['cells']:,}", f"{row['facets']:,}", row["runs"],
                     seconds(row["vtk_filter_cpu"]), seconds(row["compact_cpu"]), times(row["surface_times_faster"]), chain,
                     f"{row['compact_bytes_a_cell']} / {row['stage_bytes_a_cell']}", row["vtk_filter_bytes_a_cell"], row.get("commit", data["commit"])])
    head = ["mesh", "numbering", "cells", "facets", "runs", "VTK s", "Feelem s", "surface: times faster", "whole stage: times faster",
            "bytes a cell (surface / stage)", "VTK's", "commit"]
    return table(head, rows) + source("skin-8m", data)


def growth(_):
    data = load("skin-8m")
    data = {**data, "commit": data.get("growth_commit", data["commit"]), "command": data.get("growth_command", data["command"]), "rows": []}
    rows = [[row["mesh"], f"{row['from']:,} to {row['to']:,}", row["runs"], times(row["surface_exponent"], 3), times(row["stage_exponent"], 3)]
            for row in data["growth"]]
    return table(["mesh", "cells", "runs", "surface: exponent", "stage: exponent"], rows) + source("skin-8m", data)


def large(_):
    data = load("skin-64m")
    rows = [[row["figure"], f"{row['cells']:,}", f"{row['nodes']:,}", f"{row['cpu']:.2f}", row["bytes_a_cell"]] for row in data["rows"]]
    peak = f"\n\nPeak of resident memory with the mesh: {data['peak_resident_bytes_with_mesh'] / 2**30:.2f} GiB."
    return table(["hex8", "cells", "nodes", "CPU s", "extra bytes a cell"], rows) + peak + source("skin-64m", data)


def parse(name, cpu):
    data = load(name)
    rows = []
    for row in data["rows"]:
        faster = row.get("times_faster") or row.get("times_faster_than_meshio", row.get("times_faster_than_vtk", {})).get("parse")
        if row["file"] == "NLIST.lis":  # Nodes alone, the peer a whole mesh.
            faster = None
        reader = row["reader"] + (f" {row['version']}" if "version" in row else "")
        rows.append([reader, f"`{row['file']}`", f"{row['bytes'] / 1e6:.1f}", seconds(row[cpu]), f"{row['gb_per_second']['median']:.3f}",
                     times(faster) if faster else ""])
    return table(["reader", "file", "MB", "s", "GB/s", "times faster than the peer above"], rows) + source(name, data)


def end_to_end(_):
    data = load("end-to-end")
    rows = [[row["program"], seconds(row["wall"]), seconds(row["cpu"]), row["peak_mib"], row.get("peak_anonymous_mib", "")]
            for row in data["rows"]]
    text = table(["program", "wall s", "CPU s", "peak MiB", "of it anonymous"], rows)
    faster, scans = data["times_faster"], data["times_the_scan"]
    named = [("faster than VTK, wall", faster, "than_vtk_wall"), ("faster than VTK, processor", faster, "than_vtk_cpu"),
             ("faster than VTK, ours without digest, wall", faster, "than_vtk_no_digest_wall"),
             ("faster than VTK, ours without digest, processor", faster, "than_vtk_no_digest_cpu"),
             ("faster than VTK, ours on one core, wall", faster, "than_vtk_one_core_wall"),
             ("two cores against one, wall", faster, "two_cores_than_one_wall"),
             ("of mapping and scanning the file, ours on one core, wall", scans, "one_core_wall"),
             ("of mapping and scanning the file, ours on one core without digest, wall", scans, "no_digest_one_core_wall")]
    facts = [[title, times(ratios[key], 2)] for title, ratios, key in named if key in ratios]
    facts += [["peak of anonymous memory, of the input's size", f"**{data['peak_anonymous_of_input']}**"],
              ["SHA-256 of the input alone, CPU s", data["digest_of_input_cpu"]]]
    return text + "\n\n" + table(["times", ""], facts) + source("end-to-end", data)


def wire(_):
    data = load("wire")
    whole = [[row["model"], row["what"], f"{row['triangles']:,}", row["bytes_a_triangle"], f"**{row['with_zstd']}**", f"{row['decode_mtri_s']:.0f}"]
             for row in data["rows"] if "decode_mtri_s" in row]
    steps = [[row["model"], row.get("bound", "lossless"), row["bytes_a_vertex"], f"**{row['with_zstd']}**", row.get("value_off", 0)]
             for row in data["rows"] if row["what"].startswith("a further step")]
    draco = [[row["model"], row["what"], row["bound"], row["bytes_a_triangle"], row["decode_mtri_s"]]
             for row in data.get("peers", []) if "bytes_a_triangle" in row]
    zfp = [[row["model"], row["what"], row["bound"], row["bytes_a_vertex"]] for row in data.get("peers", []) if "bytes_a_vertex" in row]
    scenes = [[f"`{row['scene']}`", f"{row['bytes']:,}", f"{row['with_zstd']:,}", row["bytes_a_triangle"], row["sent_a_triangle"]]
              for row in data["scenes"]]
    return (table(["model", "positions, triangles, one result", "triangles", "bytes a triangle", "with zstd", "decode, M triangles/s"], whole) + "\n\n" +
            table(["model", "a further step within, of the range", "bytes a vertex", "with zstd", "largest change found"], steps) + "\n\n" +
            table(["model", "peer: the same arrays", "within, of the range", "bytes a triangle", "decode, M triangles/s"], draco) + "\n\n" +
            table(["model", "peer: a further step", "within, of the range", "bytes a vertex"], zfp) + "\n\n" +
            table(["whole scene of the boiler", "bytes", "with zstd", "a triangle", "with zstd, a triangle"], scenes) + source("wire", data))


def levels(_):
    data = load("lod")
    runs = [[row["what"], f"{row['triangles']:,}", f"{row['left']:,}", "yes" if row["centroids"] else "no", row["mtri_per_s"],
             f"{100 * row['strict_max']:.3f} %", row["worst_of_bound"], row["over"], row["bytes_per_triangle"]]
            for row in data["runs"] if "mtri_per_s" in row]
    def of_peer(row):
        if row.get("reached", True):
            return [f"{row['triangles']:,}", row["ratio"]]
        return [f"not reached with {row['triangles']:,}, all", f"more than {row['ratio']}"]
    peers = [[row["what"], f"{100 * row['error']:.3g} %", f"{row['ours']:,}", *of_peer(row)] for row in data["runs"] if "ratio" in row]
    return (table(["model", "triangles", "to", "middles bounded too", "M triangles/s", "largest error of range", "worst of its bound", "vertices over",
                   "bytes a triangle"], runs) + "\n\n" +
            table(["peer", "at a proven error of", "Feelem's triangles", "the peer's", "times"], peers) + source("lod", data))


def viewer(_):
    data = load("viewer-5m")
    def sent(step):
        return ", ".join(f"{step[key + '_bytes'] / 1e6:.1f} MB {word}" for key, word in
                         (("geometry", "geometry"), ("field", "values"), ("displacement", "displacement")) if step.get(key + "_bytes"))
    def culled(step):
        return f"{step['clusters_culled']:,} of {step['clusters']:,}" if "clusters" in step else ""
    rows = [[step["step"], f"{step['wall']:.3f}", f"{step['cpu']:.3f}", f"{step['peak_mib']:,.0f}",
             f"{step['triangles']:,}" if "triangles" in step else "", culled(step), sent(step)] for step in data["steps"]]
    head = ["step", "wall s", "CPU s", "peak MiB so far", "triangles drawn", "clusters left out", "sent to the card"]
    facts = (f"{data['triangles']:,} triangles, {data['vertices']:,} vertices, {data['edges']:,} edges; scene of "
             f"{data['scene_bytes'] / 1e6:.0f} MB; drawn by {data['renderer']}.")
    return facts + "\n\n" + table(head, rows) + source("viewer-5m", data)


def first_picture(_):
    data = load("first-picture")
    rows = []
    for row in data["rows"]:
        for way, word in (("scene_first", "scene first"), ("shape_first", "**shape first**")):
            rows.append([row["model"], f"{row['bytes'] / 1e6:.0f}", row["runs"], word, *(times(row[way][key], 2) for key in ("page_asked", "shape", "results"))])
    return table(["model", "MB", "runs", "way", "page asked for, s", "shape stands, s", "results stand, s"], rows) + source("first-picture", data)


def measured(name, make):
    """A table, or the plain word that there is none."""
    return lambda program: make(program) if (RESULTS / f"{name}.json").exists() else "Not measured yet."


TABLES = {
    "bench-skin": measured("skin-8m", skin),
    "bench-growth": measured("skin-8m", growth),
    "bench-large": measured("skin-64m", large),
    "bench-parse-ansys": measured("parse-ansys", lambda _: parse("parse-ansys", "cpu")),
    "bench-parse-decks": measured("parse-decks", lambda _: parse("parse-decks", "parse_cpu")),
    "bench-end-to-end": measured("end-to-end", end_to_end),
    "bench-wire": measured("wire", wire),
    "bench-levels": measured("lod", levels),
    "bench-first-picture": measured("first-picture", first_picture),
    "bench-viewer": measured("viewer-5m", viewer),
}
