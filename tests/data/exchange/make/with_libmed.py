# SPDX-License-Identifier: Apache-2.0
"""MED, by the MED library itself (libmedc11). Solids are in MED's own order, the mirror of everybody else's."""
import ctypes

import models

TYPES = {"hex8": 308, "wedge6": 306, "pyramid5": 305, "tet4": 304, "quad4": 204, "hex20": 320, "wedge15": 315,
         "pyramid13": 313, "tet10": 310, "quad8": 208, "tri6": 206}
MIRROR = {
    "tet4": [0, 2, 1, 3], "tet10": [0, 2, 1, 3, 6, 5, 4, 7, 9, 8], "pyramid5": [0, 3, 2, 1, 4],
    "pyramid13": [0, 3, 2, 1, 4, 8, 7, 6, 5, 9, 12, 11, 10], "wedge6": [0, 2, 1, 3, 5, 4],
    "wedge15": [0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13], "hex8": [0, 3, 2, 1, 4, 7, 6, 5],
    "hex20": [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]}
CREATE, UNSTRUCTURED, CARTESIAN, CELL, NODE, NODAL, FULL, COMPACT, FLOAT64 = 3, 0, 0, 0, 3, 0, 0, 2, 6
NO = -1


def text(words, width):
    return "".join(w.ljust(width) for w in words).encode()


def integers(values):
    return (ctypes.c_int * len(values))(*values)


def reals(values):
    return (ctypes.c_double * len(values))(*values)


class File:
    def __init__(self, path):
        self.library = ctypes.CDLL("libmedC.so.11")
        self.library.MEDfileOpen.restype = ctypes.c_int64
        self.id = ctypes.c_int64(self.library.MEDfileOpen(path.encode(), CREATE))

    def call(self, name, *arguments):
        words = [ctypes.c_double(a) if isinstance(a, float) else a for a in arguments]
        if getattr(self.library, name)(self.id, *words) < 0:
            raise RuntimeError(name)


def add_field(file, name, components, steps, values_of):
    """`values_of(step)`: (entity, type, profile or b"", rows)."""
    file.call("MEDfieldCr", name, FLOAT64, len(components), text(components, 16), text([""] * len(components), 16),
              b"s".ljust(16), b"mesh")
    for s in range(steps):
        for entity, type_, profile, rows in values_of(s):
            flat = [float(v) for row in rows for v in (row if isinstance(row, list) else [row])]
            file.call("MEDfieldValueWithProfileWr", name, s + 1, NO, models.STEPS[s], entity, type_, COMPACT, profile,
                      b"", FULL, 0, len(rows), ctypes.cast(reals(flat), ctypes.c_char_p))


def write_one(path, model, steps):
    file = File(path)
    file.call("MEDmeshCr", b"mesh", 3, 3, UNSTRUCTURED, b"Feelem's example", b"s", 0, CARTESIAN,
              text("xyz", 16), text(["m"] * 3, 16))
    count = len(model.nodes)
    file.call("MEDmeshNodeCoordinateWr", b"mesh", NO, NO, 0.0, FULL, count,
              reals([float(x) for p in model.nodes for x in p]))
    file.call("MEDmeshEntityNumberWr", b"mesh", NO, NO, NODE, 0, count, integers(model.node_ids))
    file.call("MEDfamilyCr", b"mesh", b"FAMILLE_ZERO", 0, 0, b"")
    file.call("MEDfamilyCr", b"mesh", b"clamped nodes", 1, 1, text(["clamped"], 80))
    for number, part in enumerate(model.parts(), 1):
        groups = [part, "all"]
        file.call("MEDfamilyCr", b"mesh", part.encode(), -number, len(groups), text(groups, 80))
    file.call("MEDmeshEntityFamilyNumberWr", b"mesh", NO, NO, NODE, 0, count,
              integers([1 if i < 4 else 0 for i in range(count)]))
    # MED keeps one array a type: in both models each type is in one part.
    for (part, type_), block in model.blocks().items():
        order = MIRROR.get(type_, range(len(block[0].nodes)))
        nodes = integers([e.nodes[i] + 1 for e in block for i in order])
        file.call("MEDmeshElementConnectivityWr", b"mesh", NO, NO, 0.0, CELL, TYPES[type_], NODAL, FULL,
                  len(block), nodes)
        file.call("MEDmeshEntityNumberWr", b"mesh", NO, NO, CELL, TYPES[type_], len(block),
                  integers([e.id for e in block]))
        family = -1 - model.parts().index(part)
        file.call("MEDmeshEntityFamilyNumberWr", b"mesh", NO, NO, CELL, TYPES[type_], len(block),
                  integers([family] * len(block)))
    add_results(file, model, steps)
    file.call("MEDfileClose")


def add_results(file, model, steps):
    others = [i for i in range(len(model.nodes)) if i != models.MISSING_NODE]
    file.call("MEDprofileWr", b"all but one", len(others), integers([i + 1 for i in others]))

    def heat(s):
        if s == 0:
            return [(NODE, 0, b"", [models.temperature(i, s) for i in model.node_ids])]
        return [(NODE, 0, b"all but one", [models.temperature(model.node_ids[i], s) for i in others])]

    def on_elements(value, only=None):
        return lambda s: [
            (CELL, TYPES[type_], b"", [value(e.id, s) for e in block])
            for (part, type_), block in model.blocks().items() if only in (None, part)]

    def med_stress(element, s):  # xx yy zz xy xz yz
        v = models.stress(element, s)
        return [v[0], v[1], v[2], v[3], v[5], v[4]]

    add_field(file, b"TEMP", ["TEMP"], steps, heat)
    add_field(file, b"DEPL", ["DX", "DY", "DZ"], steps,
              lambda s: [(NODE, 0, b"", [models.displacement(i, s) for i in model.node_ids])])
    add_field(file, b"density", ["rho"], steps, on_elements(models.density))
    add_field(file, b"damage", ["d"], steps, on_elements(models.damage, models.HAS_DAMAGE))
    add_field(file, b"SIEF", ["SIXX", "SIYY", "SIZZ", "SIXY", "SIXZ", "SIYZ"], steps, on_elements(med_stress))


def write(folder, stack, curved):
    write_one(f"{folder}/stack.med", stack, 2)
    write_one(f"{folder}/curved.med", curved, 1)
