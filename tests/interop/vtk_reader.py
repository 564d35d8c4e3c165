#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""VTK's vtkGLTFReader gives results, masks and ids of our scenes back bit for bit, side files and all.

The reference is a reader of this file's own, over the plain bytes. Argument: the folder of the tests' scenes.
"""
import json
import os
import pathlib
import struct
import sys

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkGLTFReader
    import numpy
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

KINDS = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}
checked, failures = 0, []


def check(holds, text):
    global checked
    checked += 1
    if not holds:
        failures.append(text)


def plain(path):
    data = path.read_bytes()
    if path.suffix == ".glb":
        size = struct.unpack("<I", data[12:16])[0]
        head, chunk = json.loads(data[20:20 + size]), data[28 + size:]
    else:
        head, chunk = json.loads(data), b""
    buffers = [(path.parent / b["uri"]).read_bytes() if "uri" in b else chunk for b in head["buffers"]]
    return head, buffers


def numbers(head, buffers, index):
    accessor = head["accessors"][index]
    view = head["bufferViews"][accessor["bufferView"]]
    width = WIDTHS[accessor["type"]]
    flat = numpy.frombuffer(buffers[view["buffer"]], KINDS[accessor["componentType"]], accessor["count"] * width, view["byteOffset"])
    return flat.reshape(-1, width) if width > 1 else flat


def meshes(block, found):
    """All polygonal data of a tree of blocks, in order."""
    if block is None:
        return found
    if block.IsA("vtkPolyData"):
        found.append(block)
    elif block.IsA("vtkMultiBlockDataSet"):
        for i in range(block.GetNumberOfBlocks()):
            meshes(block.GetBlock(i), found)
    return found


def check_scene(path):
    try:
        head, buffers = plain(path)
    except (struct.error, ValueError):
        return  # a test of another folder wrote what is no scene
    if "certificate" not in head.get("extras", {}).get("feelem", {}):
        return
    if head.get("extensionsRequired"):
        return  # compressed: for Feelem's viewers and those who know the extension; VTK 9.1 ends on it
    reader = vtkGLTFReader()
    reader.SetFileName(str(path))
    reader.Update()
    found = meshes(reader.GetOutput(), [])
    for node in head["nodes"]:
        if node["extras"]["feelem"]["role"] != "part":
            continue
        primitive = head["meshes"][node["mesh"]]["primitives"][0]
        attributes = primitive["attributes"]
        count = head["accessors"][attributes["POSITION"]]["count"]
        triangles = head["accessors"][primitive["indices"]]["count"] // 3
        fits = [m for m in found if m.GetNumberOfPoints() == count and m.GetNumberOfPolys() == triangles]
        check(bool(fits), f"{path}: VTK has no mesh of {count} points for {node['name']}")
        for semantic, accessor in attributes.items():
            if not semantic.startswith("_"):
                continue
            wanted = numbers(head, buffers, accessor)

            def same(mesh):
                array = mesh.GetPointData().GetArray(semantic)
                return array is not None and vtk_to_numpy(array).astype("<f4").tobytes() == wanted.tobytes()
            check(any(same(mesh) for mesh in fits), f"{path}: VTK changes {semantic} of {node['name']}")


def is_ours(folder):
    """As in files.mjs: neither what only looks like scenes, nor what the native viewer's tests write at the same time."""
    return folder not in ("broken", "stand_ins") and not folder.startswith("viewer_")


# os.walk passes over a folder that goes meanwhile.
for folder, below, names in os.walk(sys.argv[1]):
    below[:] = sorted(filter(is_ours, below))
    for name in sorted(names):
        if name.endswith((".glb", ".gltf")):
            check_scene(pathlib.Path(folder, name))
for failure in failures:
    print(failure)
print(f"{checked} checked, {len(failures)} failed")
sys.exit(1 if failures or checked == 0 else 0)
