#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A free mesh of tetrahedra from gmsh, numbered as gmsh numbers it: a block with a bore and a ball on it.
Writes counts, coordinates and corners for bench_skin's mesh free=PATH.

    bench/free_tets.py PATH SIZE    (SIZE 0.011: about a million tetrahedra)"""
import struct
import sys

import gmsh
import numpy


def main():
    path, size = sys.argv[1], float(sys.argv[2])
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    occ = gmsh.model.occ
    block = occ.addBox(0, 0, 0, 1, 0.6, 0.4)
    bore = occ.addCylinder(0.3, 0.3, -0.1, 0, 0, 0.6, 0.12)
    ball = occ.addSphere(0.8, 0.3, 0.4, 0.15)
    cut, _ = occ.cut([(3, block)], [(3, bore)])
    occ.fuse(cut, [(3, ball)])
    occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.model.mesh.generate(3)
    tags, places, _ = gmsh.model.mesh.getNodes()
    index = numpy.zeros(int(tags.max()) + 1, dtype=numpy.uint32)
    index[tags] = numpy.arange(len(tags), dtype=numpy.uint32)
    _, corners = gmsh.model.mesh.getElementsByType(4)
    with open(path, "wb") as file:
        file.write(struct.pack("<QQ", len(tags), len(corners) // 4))
        file.write(numpy.asarray(places, dtype="<f8").tobytes())
        file.write(index[corners].astype("<u4").tobytes())
    print(f"{len(corners) // 4} tetrahedra, {len(tags)} nodes")


if __name__ == "__main__":
    main()
