#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the colour tables of C++ and TypeScript from scripts/colour_maps.txt; --check fails when they are stale.

cool_warm is computed: K. Moreland, Diverging Color Maps for Scientific Visualization (2009), Msh interpolation.
"""
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ORDER = ["batlow", "viridis", "cividis", "turbo", "ansys_rainbow", "cool_warm"]
WHITE = (0.95047, 1.0, 1.08883)  # D65
TO_XYZ = ((0.4124564, 0.3575761, 0.1804375), (0.2126729, 0.7151522, 0.0721750), (0.0193339, 0.1191920, 0.9503041))
TO_RGB = ((3.2404542, -1.5371385, -0.4985314), (-0.9692660, 1.8760108, 0.0415560), (0.0556434, -0.2040259, 1.0572252))


def product(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def msh_of(rgb):
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in (v / 255 for v in rgb)]
    x, y, z = (math.cbrt(c / w) if c / w > 0.008856 else 7.787 * c / w + 16 / 116
               for c, w in zip(product(TO_XYZ, linear), WHITE))
    lab = (116 * y - 16, 500 * (x - y), 200 * (y - z))
    m = math.hypot(*lab)
    return m, math.acos(lab[0] / m), math.atan2(lab[2], lab[1])


def rgb_of(msh):
    m, s, h = msh
    lightness, a, b = m * math.cos(s), m * math.sin(s) * math.cos(h), m * math.sin(s) * math.sin(h)
    y = (lightness + 16) / 116
    xyz = [w * (c ** 3 if c ** 3 > 0.008856 else (c - 16 / 116) / 7.787) for c, w in zip((y + a / 500, y, y - b / 200), WHITE)]
    encoded = (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in product(TO_RGB, xyz))
    return [min(255, max(0, math.floor(255 * c + 0.5))) for c in encoded]


def adjusted_hue(msh, unsaturated_m):
    """Hue to leave the unsaturated middle with, so that the path bends away from purple (Moreland, AdjustHue)."""
    m, s, h = msh
    if m >= unsaturated_m:
        return h
    spin = s * math.sqrt(unsaturated_m ** 2 - m ** 2) / (m * math.sin(s))
    return h + spin if h > -math.pi / 3 else h - spin


def cool_warm(count):
    cool, warm, middle_m = msh_of((59, 76, 192)), msh_of((180, 4, 38)), 88.0
    rows = []
    for i in range(count):
        t = i / (count - 1)
        if t < 0.5:
            ends, f = (cool, (middle_m, 0, adjusted_hue(cool, middle_m))), 2 * t
        else:
            ends, f = ((middle_m, 0, adjusted_hue(warm, middle_m)), warm), 2 * t - 1
        rows.append("%02x%02x%02x" % tuple(rgb_of([(1 - f) * a + f * b for a, b in zip(*ends)])))
    return rows


def read_maps():
    maps, name = {}, None
    for line in (ROOT / "scripts/colour_maps.txt").read_text().splitlines():
        words = line.split()
        if line.startswith("#"):
            continue
        if words[0] == "map":
            name = words[1]
            maps[name] = []
        else:
            maps[name] += words
    maps["cool_warm"] = cool_warm(257)
    return [(name, maps[name]) for name in ORDER]


def constant(name):
    return "k" + "".join(word.capitalize() for word in name.split("_"))


def cpp(maps):
    out = ["// SPDX-License-Identifier: Apache-2.0",
           "// Made by scripts/make_colour_tables.py: the colour maps as rows of 0xRRGGBB. Licences: NOTICE.",
           '#include "present/colour_tables.hpp"', "", "#include <array>", "", "namespace feelem {", "namespace {", "",
           "// clang-format off"]
    for name, rows in maps:
        out.append(f"constexpr std::array<std::uint32_t, {len(rows)}> {constant(name)}{{")
        out += ["    " + " ".join(f"0x{row}," for row in rows[i:i + 11]) for i in range(0, len(rows), 11)]
        out.append("};")
    out.append(f"constexpr std::array<ColourTable, {len(maps)}> kTables{{{{")
    out += [f'    {{"{name}", {constant(name)}}},' for name, _ in maps]
    out += ["}};", "// clang-format on", "", "}  // namespace", "",
            "std::span<const ColourTable> colour_tables() {", "    return kTables;", "}", "", "}  // namespace feelem", ""]
    return "\n".join(out)


def typescript(maps):
    out = ["// SPDX-License-Identifier: Apache-2.0",
           "// Made by scripts/make_colour_tables.py: the rows of the colour maps, rrggbb from low to high. Licences: NOTICE.",
           "// biome-ignore-all format: a table.", "export const colourTables: Readonly<Record<string, string>> = {"]
    for name, rows in maps:
        lines = ["".join(rows[i:i + 18]) for i in range(0, len(rows), 18)]
        out.append(f"  {name}:")
        out += [f"    '{line}'{' +' if i + 1 < len(lines) else ','}" for i, line in enumerate(lines)]
    return "\n".join(out + ["};", ""])


def main():
    maps = read_maps()
    stale = []
    for path, text in (("src/present/colour_tables.cpp", cpp(maps)), ("web/src/present/colour-tables.ts", typescript(maps))):
        file = ROOT / path
        if not file.exists() or file.read_text() != text:
            stale.append(path)
            if "--check" not in sys.argv:
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
    if "--check" in sys.argv and stale:
        print("stale, run scripts/make_colour_tables.py:", *stale)
        return 1
    print("colour tables: up to date" if not stale else "written: " + " ".join(stale))
    return 0


if __name__ == "__main__":
    sys.exit(main())
