# SPDX-License-Identifier: Apache-2.0
"""Exodus II, as its manual describes the netCDF variables (python3-netcdf4)."""
import math

import netCDF4
import numpy

import models

NAMES = {"hex8": "HEX8", "wedge6": "WEDGE6", "pyramid5": "PYRAMID5", "tet4": "TETRA4", "quad4": "SHELL4",
         "hex20": "HEX20", "wedge15": "WEDGE15", "pyramid13": "PYRAMID13", "tet10": "TETRA10",
         "quad8": "SHELL8", "tri6": "TRI6"}
# Exodus has the vertical edges before those of the top.
ORDER = {"hex20": [*range(12), *range(16, 20), *range(12, 16)],
         "wedge15": [*range(9), *range(12, 15), *range(9, 12)]}
STRESS = ["stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"]
# (Element, side), each from 1. Of the stack the bottom of the brick and the top of the wedge; of the curved one a side of
# each element, the plate's front and an edge of the triangle.
SIDES = {"stack": [(1, 5), (2, 5)], "curved": [(1, 1), (2, 3), (3, 5), (4, 2), (5, 1), (6, 4)]}


def words(names, width=33):
    return numpy.array([list(n.encode().ljust(width, b"\0")) for n in names], "u1").view("S1")


def write_one(path, model, steps):
    file = netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET")
    file.set_auto_mask(False)
    file.setncatts({"api_version": numpy.float32(7.05), "version": numpy.float32(7.05),
                    "floating_point_word_size": numpy.int32(8), "file_size": numpy.int32(1),
                    "title": "Feelem's example: " + model.name})
    blocks = model.blocks()
    elements = [e for block in blocks.values() for e in block]
    node_names = ["Temperature", "displacement_x", "displacement_y", "displacement_z"]
    element_names = ["density", "damage", *STRESS]

    def dimension(name, size):
        file.createDimension(name, size)

    def variable(name, kind, dimensions, values):
        file.createVariable(name, kind, dimensions)[:] = values

    for name, size in [("len_string", 33), ("len_name", 33), ("len_line", 81), ("four", 4), ("num_dim", 3),
                       ("num_nodes", len(model.nodes)), ("num_elem", len(elements)),
                       ("num_el_blk", len(blocks)), ("num_nod_var", len(node_names)),
                       ("num_elem_var", len(element_names))]:
        dimension(name, size)
    dimension("time_step", None)
    variable("time_whole", "f8", ("time_step",), models.STEPS[:steps])
    for k, axis in enumerate("xyz"):
        variable(f"coord{axis}", "f8", ("num_nodes",), [p[k] for p in model.nodes])
    variable("coor_names", "S1", ("num_dim", "len_name"), words("xyz"))
    variable("node_num_map", "i4", ("num_nodes",), model.node_ids)
    variable("elem_num_map", "i4", ("num_elem",), [e.id for e in elements])
    variable("eb_status", "i4", ("num_el_blk",), [1] * len(blocks))
    ids = file.createVariable("eb_prop1", "i4", ("num_el_blk",))
    ids.setncattr("name", "ID")
    ids[:] = [10 * (b + 1) for b in range(len(blocks))]
    variable("eb_names", "S1", ("num_el_blk", "len_name"), words([f"{p}_{t}" for p, t in blocks]))
    for b, ((_, type_), block) in enumerate(blocks.items(), 1):
        dimension(f"num_el_in_blk{b}", len(block))
        dimension(f"num_nod_per_el{b}", len(block[0].nodes))
        order = ORDER.get(type_, range(len(block[0].nodes)))
        rows = file.createVariable(f"connect{b}", "i4", (f"num_el_in_blk{b}", f"num_nod_per_el{b}"))
        rows.setncattr("elem_type", NAMES[type_])
        rows[:] = [[e.nodes[i] + 1 for i in order] for e in block]
    add_sets(file, dimension, variable, SIDES[model.name])
    variable("name_nod_var", "S1", ("num_nod_var", "len_name"), words(node_names))
    variable("name_elem_var", "S1", ("num_elem_var", "len_name"), words(element_names))
    # The truth table: which block has which variable.
    variable("elem_var_tab", "i4", ("num_el_blk", "num_elem_var"), [
        [int(name != "damage" or part == models.HAS_DAMAGE) for name in element_names] for part, _ in blocks])
    for s in range(steps):
        heat = [models.temperature(i, s) for i in model.node_ids]
        if s == 1:
            heat[models.MISSING_NODE] = math.nan
        moved = [models.displacement(i, s) for i in model.node_ids]
        for v, values in enumerate([heat] + [[m[k] for m in moved] for k in range(3)], 1):
            put(file, f"vals_nod_var{v}", "num_nodes", s, values)
        for b, ((part, _), block) in enumerate(blocks.items(), 1):
            for v, name in enumerate(element_names, 1):
                if name == "damage" and part != models.HAS_DAMAGE:
                    continue
                values = [{"density": models.density, "damage": models.damage}[name](e.id, s)
                          if name not in STRESS else models.stress(e.id, s)[STRESS.index(name)] for e in block]
                put(file, f"vals_elem_var{v}eb{b}", f"num_el_in_blk{b}", s, values)
    file.close()


def put(file, name, dimension, step, values):
    if name not in file.variables:
        file.createVariable(name, "f8", ("time_step", dimension), fill_value=False)
    file.variables[name][step, :] = values


def add_sets(file, dimension, variable, sides):
    dimension("num_node_sets", 2)
    dimension("num_side_sets", 1)
    variable("ns_status", "i4", ("num_node_sets",), [1, 1])
    for kind, count in (("ns", 2), ("ss", 1)):
        ids = file.createVariable(f"{kind}_prop1", "i4", ("num_node_sets" if kind == "ns" else "num_side_sets",))
        ids.setncattr("name", "ID")
        ids[:] = [7, 3][:count]
    # The second has no name: it is called by its number.
    variable("ns_names", "S1", ("num_node_sets", "len_name"), words(["clamped", ""]))
    for i, nodes in enumerate([[1, 2, 3, 4], [11]], 1):
        dimension(f"num_nod_ns{i}", len(nodes))
        variable(f"node_ns{i}", "i4", (f"num_nod_ns{i}",), nodes)
    variable("ss_status", "i4", ("num_side_sets",), [1])
    variable("ss_names", "S1", ("num_side_sets", "len_name"), words(["some sides"]))
    dimension("num_side_ss1", len(sides))
    variable("elem_ss1", "i4", ("num_side_ss1",), [e for e, _ in sides])
    variable("side_ss1", "i4", ("num_side_ss1",), [s for _, s in sides])


def write(folder, stack, curved):
    write_one(f"{folder}/stack.exo", stack, 2)
    write_one(f"{folder}/curved.exo", curved, 1)
