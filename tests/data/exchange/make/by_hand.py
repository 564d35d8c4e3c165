# SPDX-License-Identifier: Apache-2.0
"""EnSight Gold, as text."""
import models

NAMES = {"hex8": "hexa8", "wedge6": "penta6", "pyramid5": "pyramid5", "tet4": "tetra4", "quad4": "quad4",
         "hex20": "hexa20", "wedge15": "penta15", "pyramid13": "pyramid13", "tet10": "tetra10", "quad8": "quad8",
         "tri6": "tria6"}
UNDEFINED = -9.9e9


def real(value):
    return f"{value:12.5e}\n"


def whole(value):
    return f"{value:10d}\n"


def nodes_of(model, part):
    return sorted({n for block in model.blocks(part).values() for e in block for n in e.nodes})


def geometry(model):
    out = "Feelem's example\n" + model.name + "\nnode id given\nelement id given\n"
    for number, part in enumerate(model.parts(), 1):
        used = nodes_of(model, part)
        out += "part\n" + whole(number) + part + "\ncoordinates\n" + whole(len(used))
        out += "".join(whole(model.node_ids[n]) for n in used)
        out += "".join(real(model.nodes[n][k]) for k in range(3) for n in used)
        for (_, type_), block in model.blocks(part).items():
            out += NAMES[type_] + "\n" + whole(len(block)) + "".join(whole(e.id) for e in block)
            for e in block:
                out += "".join(f"{used.index(n) + 1:10d}" for n in e.nodes) + "\n"
    return out


def at_nodes(model, value, missing=None):
    """`missing`: a node without a value."""
    out = "values\n"
    for number, part in enumerate(model.parts(), 1):
        used = nodes_of(model, part)
        rows = [value(model.node_ids[n]) for n in used]
        rows = [r if isinstance(r, list) else [r] for r in rows]
        if missing in used:
            rows[used.index(missing)] = [UNDEFINED]
        out += "part\n" + whole(number)
        out += "coordinates undef\n" + real(UNDEFINED) if missing in used else "coordinates\n"
        out += "".join(real(r[k]) for k in range(len(rows[0])) for r in rows)
    return out


def on_elements(model, value, only=None):
    out = "values\n"
    for number, part in enumerate(model.parts(), 1):
        if only not in (None, part):
            continue
        out += "part\n" + whole(number)
        for (_, type_), block in model.blocks(part).items():
            rows = [value(e.id) for e in block]
            rows = [r if isinstance(r, list) else [r] for r in rows]
            out += NAMES[type_] + "\n" + "".join(real(r[k]) for k in range(len(rows[0])) for r in rows)
    return out


def ensight_stress(element, step):  # xx yy zz xy xz yz
    v = models.stress(element, step)
    return [v[0], v[1], v[2], v[3], v[5], v[4]]


def write_one(folder, model, steps):
    files = {f"{model.name}.geo": geometry(model)}
    for s in range(steps):
        end = f"{s + 1:02d}"
        missing = models.MISSING_NODE if s == 1 else None
        files[f"{model.name}.heat{end}"] = at_nodes(model, lambda i: models.temperature(i, s), missing)
        files[f"{model.name}.disp{end}"] = at_nodes(model, lambda i: models.displacement(i, s))
        files[f"{model.name}.dens{end}"] = on_elements(model, lambda i: models.density(i, s))
        files[f"{model.name}.dama{end}"] = on_elements(model, lambda i: models.damage(i, s), models.HAS_DAMAGE)
        files[f"{model.name}.stre{end}"] = on_elements(model, lambda i: ensight_stress(i, s))
    files[f"{model.name}.case"] = f"""FORMAT
type: ensight gold

GEOMETRY
model: {model.name}.geo

VARIABLE
scalar per node: 1 Temperature {model.name}.heat**
vector per node: 1 displacement {model.name}.disp**
scalar per element: 1 density {model.name}.dens**
scalar per element: 1 damage {model.name}.dama**
tensor symm per element: 1 stress {model.name}.stre**

TIME
time set: 1
number of steps: {steps}
filename start number: 1
filename increment: 1
time values: {" ".join(str(t) for t in models.STEPS[:steps])}
"""
    for name, text in files.items():
        with open(f"{folder}/{name}", "w") as out:
            out.write(text)


def write(folder, stack, curved):
    write_one(folder, stack, 2)
    write_one(folder, curved, 1)
