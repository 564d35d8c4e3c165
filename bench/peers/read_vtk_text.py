#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a legacy text file with VTK's own reader (C++; Python only starts it) and says as bench_read_model does what was
found and how much processor time reading took."""
import json
import sys
import time

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader


def main():
    reader = vtkUnstructuredGridReader()
    reader.SetFileName(sys.argv[1])
    start, wall = time.process_time(), time.monotonic()
    reader.Update()
    cpu, wall = time.process_time() - start, time.monotonic() - wall
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData()).sum(axis=0)
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    json.dump({"open_cpu": cpu, "open_wall": wall, "load_cpu": 0, "nodes": grid.GetNumberOfPoints(),
               "elements": grid.GetNumberOfCells(), "corners": int(corners.sum() + corners.size), "x": float(points[0]),
               "y": float(points[1]), "z": float(points[2]), "version": vtkVersion.GetVTKVersion()}, sys.stdout)


if __name__ == "__main__":
    main()
