# SPDX-License-Identifier: Apache-2.0
"""VTK's own files, by VTK's writers (python3-vtk9), and ParaView's lists of them."""
import math

import vtk

import models

WEDGE = {"wedge6": [0, 2, 1, 3, 5, 4], "wedge15": [0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13]}
TYPES = {
    "tet4": vtk.VTK_TETRA, "pyramid5": vtk.VTK_PYRAMID, "wedge6": vtk.VTK_WEDGE, "hex8": vtk.VTK_HEXAHEDRON,
    "quad4": vtk.VTK_QUAD, "tri6": vtk.VTK_QUADRATIC_TRIANGLE, "quad8": vtk.VTK_QUADRATIC_QUAD,
    "tet10": vtk.VTK_QUADRATIC_TETRA, "pyramid13": vtk.VTK_QUADRATIC_PYRAMID,
    "wedge15": vtk.VTK_QUADRATIC_WEDGE, "hex20": vtk.VTK_QUADRATIC_HEXAHEDRON}


def array(name, rows, kind=vtk.vtkDoubleArray):
    out = kind()
    out.SetName(name)
    rows = [r if isinstance(r, list) else [r] for r in rows]
    out.SetNumberOfComponents(len(rows[0]))
    for r in rows:
        out.InsertNextTuple(r)
    return out


def grid(model, step, part=None, damage=True):
    """`part`: that alone, with its nodes alone."""
    elements = [e for e in model.elements if part in (None, e.part)]
    used = sorted({n for e in elements for n in e.nodes}) if part else range(len(model.nodes))
    place = {n: i for i, n in enumerate(used)}
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for n in used:
        points.InsertNextPoint(model.nodes[n])
    out = vtk.vtkUnstructuredGrid()
    out.SetPoints(points)
    for e in elements:
        order = WEDGE.get(e.type, range(len(e.nodes)))
        out.InsertNextCell(TYPES[e.type], len(e.nodes), [place[e.nodes[i]] for i in order])
    ids = [model.node_ids[n] for n in used]
    heat = [models.temperature(i, step) for i in ids]
    if step == 1 and models.MISSING_NODE in place:
        heat[place[models.MISSING_NODE]] = math.nan
    at_nodes, on_elements = out.GetPointData(), out.GetCellData()
    at_nodes.AddArray(array("GlobalNodeId", ids, vtk.vtkLongLongArray))
    at_nodes.AddArray(array("Temperature", heat))
    at_nodes.AddArray(array("displacement", [models.displacement(i, step) for i in ids]))
    on_elements.AddArray(array("GlobalElementId", [e.id for e in elements], vtk.vtkLongLongArray))
    on_elements.AddArray(array("density", [models.density(e.id, step) for e in elements], vtk.vtkFloatArray))
    on_elements.AddArray(array("stress", [models.stress(e.id, step) for e in elements]))
    if damage:
        on_elements.AddArray(array("damage", [
            models.damage(e.id, step) if e.part == models.HAS_DAMAGE else math.nan for e in elements]))
    return out


def write_xml(path, data, text=False):
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    if text:
        writer.SetDataModeToAscii()
    writer.Write()


def write_legacy(path, data):
    writer = vtk.vtkUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.SetFileTypeToBinary()
    writer.Write()


PVTU = """<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt32">
<PUnstructuredGrid GhostLevel="0">
<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>
<PPointData>
<PDataArray type="Int64" Name="GlobalNodeId"/>
<PDataArray type="Float64" Name="Temperature"/>
<PDataArray type="Float64" Name="displacement" NumberOfComponents="3"/>
</PPointData>
<PCellData>
<PDataArray type="Int64" Name="GlobalElementId"/>
<PDataArray type="Float32" Name="density"/>
<PDataArray type="Float64" Name="stress" NumberOfComponents="6"/>
</PCellData>
<Piece Source="stack_lower_1.vtu"/>
<Piece Source="stack_upper_1.vtu"/>
</PUnstructuredGrid>
</VTKFile>
"""


def write(folder, stack, curved):
    write_xml(f"{folder}/curved.vtu", grid(curved, 0))
    write_legacy(f"{folder}/curved.vtk", grid(curved, 1))
    write_legacy(f"{folder}/stack.vtk", grid(stack, 1))
    lines = []
    for step, time in enumerate(models.STEPS):
        for number, part in enumerate(stack.parts()):
            name = f"stack_{part}_{step + 1}.vtu"
            write_xml(f"{folder}/{name}", grid(stack, step, part, part == models.HAS_DAMAGE), step == 0)
            lines.append(f'<DataSet timestep="{time}" part="{number}" name="{part}" file="{name}"/>\n')
    with open(f"{folder}/stack.pvd", "w") as out:
        out.write('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n')
        out.write("".join(lines) + "</Collection>\n</VTKFile>\n")
    with open(f"{folder}/stack.pvtu", "w") as out:
        out.write(PVTU)
