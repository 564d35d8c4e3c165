# SPDX-License-Identifier: Apache-2.0
"""CGNS, by the CGNS library itself (libcgns3.4): a zone a part, in HDF5 and in the older ADF."""
import ctypes

import models

TYPES = {"hex8": 17, "wedge6": 14, "pyramid5": 12, "tet4": 10, "quad4": 7, "hex20": 18, "wedge15": 15,
         "pyramid13": 21, "tet10": 11, "quad8": 8, "tri6": 6}
# CGNS has the vertical edges before those of the top.
ORDER = {"hex20": [*range(12), *range(16, 20), *range(12, 16)],
         "wedge15": [*range(9), *range(12, 15), *range(9, 12)]}
WRITE, ADF, HDF5, UNSTRUCTURED, DOUBLE, VERTEX, CELL, TIME_ACCURATE, CHARACTER = 1, 1, 2, 3, 4, 2, 3, 2, 5

STRESS = ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]

library = ctypes.CDLL("libcgns.so.3.4")


def call(name, *arguments):
    """Whole numbers of CGNS are 32 bits in Debian's build."""
    if getattr(library, name)(*arguments) != 0:
        library.cg_get_error.restype = ctypes.c_char_p
        raise RuntimeError(f"{name}: {library.cg_get_error().decode()}")


def integers(values):
    return (ctypes.c_int * len(values))(*values)


def reals(values):
    return (ctypes.c_double * len(values))(*values)


def new(name, *arguments):
    out = ctypes.c_int()
    call(name, *arguments, ctypes.byref(out))
    return out.value


def write_one(path, model, steps, kind):
    call("cg_set_file_type", kind)
    file = new("cg_open", path.encode(), WRITE)
    base = new("cg_base_write", file, b"Base", 3, 3)
    call("cg_biter_write", file, base, b"TimeIterValues", steps)
    call("cg_goto", file, base, b"BaseIterativeData_t", 1, b"end")
    call("cg_array_write", b"TimeValues", DOUBLE, 1, integers([steps]), reals(models.STEPS[:steps]))
    call("cg_simulation_type_write", file, base, TIME_ACCURATE)
    for part in model.parts():
        write_zone(file, base, model, part, steps)
    call("cg_close", file)


def write_zone(file, base, model, part, steps):
    blocks = model.blocks(part)
    used = sorted({n for block in blocks.values() for e in block for n in e.nodes})
    elements = [e for block in blocks.values() for e in block]
    zone = new("cg_zone_write", file, base, part.encode(), integers([len(used), len(elements), 0]), UNSTRUCTURED)
    for k, axis in enumerate("XYZ"):
        new("cg_coord_write", file, base, zone, DOUBLE, f"Coordinate{axis}".encode(),
            reals([float(model.nodes[n][k]) for n in used]))
    first = 1
    for (_, type_), block in blocks.items():
        order = ORDER.get(type_, range(len(block[0].nodes)))
        rows = integers([used.index(e.nodes[i]) + 1 for e in block for i in order])
        new("cg_section_write", file, base, zone, type_.encode(), TYPES[type_], first, first + len(block) - 1, 0, rows)
        first += len(block)
    ids = [model.node_ids[n] for n in used]
    names = {"vertex": [], "cell": []}
    for s in range(steps):
        moved = [models.displacement(i, s) for i in ids]
        at_nodes = {"Temperature": [models.temperature(i, s) for i in ids],
                    **{f"Displacement{axis}": [m[k] for m in moved] for k, axis in enumerate("XYZ")}}
        stresses = [models.stress(e.id, s) for e in elements]
        on_elements = {"Density": [models.density(e.id, s) for e in elements],
                       **{f"Stress{name}": [v[k] for v in stresses] for k, name in enumerate(STRESS)}}
        if part == models.HAS_DAMAGE:
            on_elements["Damage"] = [models.damage(e.id, s) for e in elements]
        for place, where, arrays in (("vertex", VERTEX, at_nodes), ("cell", CELL, on_elements)):
            name = f"{place}{s + 1}"
            names[place].append(name)
            solution = new("cg_sol_write", file, base, zone, name.encode(), where)
            for field, values in arrays.items():
                new("cg_field_write", file, base, zone, solution, DOUBLE, field.encode(), reals(values))
    call("cg_ziter_write", file, base, zone, b"ZoneIterativeData")
    call("cg_goto", file, base, b"Zone_t", zone, b"ZoneIterativeData_t", 1, b"end")
    for pointer, place in ((b"FlowSolutionPointers", "vertex"), (b"FlowSolutionCellPointers", "cell")):
        call("cg_array_write", pointer, CHARACTER, 2, integers([32, steps]),
             "".join(n.ljust(32) for n in names[place]).encode())


def write(folder, stack, curved):
    write_one(f"{folder}/stack.cgns", stack, 2, HDF5)
    write_one(f"{folder}/curved.cgns", curved, 1, ADF)
