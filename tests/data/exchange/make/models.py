# SPDX-License-Identifier: Apache-2.0
"""The two example models, with values that tests can compute again: see ../README.md."""
from dataclasses import dataclass

# Edges of each type in Feelem's order (VTK's: bottom, top, vertical).
EDGES = {
    "tri6": [(0, 1), (1, 2), (2, 0)],
    "quad8": [(0, 1), (1, 2), (2, 3), (3, 0)],
    "tet10": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
    "pyramid13": [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)],
    "wedge15": [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)],
    "hex20": [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)],
}


@dataclass
class Element:
    type: str
    part: str
    id: int
    nodes: list  # Indexes of nodes, in Feelem's order.


@dataclass
class Model:
    name: str
    nodes: list  # Points.
    node_ids: list
    elements: list

    def parts(self):
        return list(dict.fromkeys(e.part for e in self.elements))

    def blocks(self, part=None):
        """(part, type) -> elements, in order of first appearance."""
        out = {}
        for e in self.elements:
            if part in (None, e.part):
                out.setdefault((e.part, e.type), []).append(e)
        return out


STEPS = [0.5, 2.0]  # Their times.
MISSING_NODE = 4  # Its temperature is missing at the second step, where the format can say so.
HAS_DAMAGE = "lower"  # The other part has none.


def temperature(node_id, step):
    return node_id * 0.25 * (step + 1)


def displacement(node_id, step):
    return [node_id * (step + 1) / 8, -node_id / 2, step + 0.125]


def density(element_id, step):
    return element_id * (step + 1) / 8


def damage(element_id, step):
    return step - element_id / 16


def stress(element_id, step):
    """xx yy zz xy yz zx."""
    return [element_id * (step + 1) + k / 4 for k in range(6)]


def stack():
    """A brick, a wedge beside it, a pyramid and a tetrahedron on top, a plate at the side."""
    points = [
        (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1),
        (2, 0, 0), (2, 0, 1), (0, 0, 2), (1, 0, 2), (3, 0, 0), (3, 0, 1)]
    ids = [100 + 7 * i for i in range(len(points))]
    elements = [
        Element("hex8", "lower", 1009, [0, 1, 2, 3, 4, 5, 6, 7]),
        Element("wedge6", "lower", 1006, [1, 8, 2, 5, 9, 6]),
        Element("pyramid5", "upper", 2003, [4, 5, 6, 7, 10]),
        Element("tet4", "upper", 2000, [5, 9, 6, 11]),
        Element("quad4", "upper", 3000, [8, 12, 13, 9]),
    ]
    return Model("stack", points, ids, elements)


def curved():
    """One element of each second-order type, side by side and not joined."""
    corners = {
        "hex20": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
        "wedge15": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 2), (1, 0, 2), (0, 1, 2)],
        "pyramid13": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1.5)],
        "tet10": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
        "quad8": [(0, 0, 0), (1, 0, 0), (1, 2, 0), (0, 2, 0)],
        "tri6": [(0, 0, 0), (1, 0, 0), (0, 2, 0)],
    }
    points, elements = [], []
    for place, (type_, own) in enumerate(corners.items()):
        own = own + [tuple((a + b) / 2 for a, b in zip(own[i], own[j])) for i, j in EDGES[type_]]
        first = len(points)
        points += [(x + 3 * place, y, z) for x, y, z in own]
        part = "lower" if type_ in ("hex20", "wedge15") else "upper"
        elements.append(Element(type_, part, 50 - 3 * place, list(range(first, len(points)))))
    return Model("curved", points, [3 * i + 2 for i in range(len(points))], elements)
