#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when a folder includes a folder it must not know. The table below is the architecture."""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": [],
    "model": ["base"],
    "read": ["base", "model"],
    "derive": ["base", "model"],
    "skin": ["base", "model"],
    "inside": ["base", "model", "skin"],
    "lod": ["base", "model"],
    "pick": ["base", "model"],
    "write": ["base", "model"],
    "present": ["base"],
    "scene": ["base", "model", "present"],
    "convert": ["base", "model", "read", "derive", "skin", "inside", "lod", "pick", "present", "scene", "write"],
    "distribute": ["base", "model", "convert"],
}
# Folders of apps/viewer among themselves; main.cpp and the files beside it may include all.
VIEWER_MAY_INCLUDE = {
    "core": [],
    "scene": ["core"],
    "render": ["core", "scene"],
    "audio": ["core"],
    "haptics": ["core"],
    "xr": ["core", "haptics"],
    "desktop": ["core", "haptics"],
    "ui": ["core", "scene"],
    "record": ["core", "haptics"],
    "doctor": ["xr"],
}
PUBLIC_HEADER_OWNER = {
    "error": "base", "diagnostics": "base",
    "ids": "model", "element_type": "model", "mesh": "model", "result": "model", "model": "model", "surface": "model",
    "read": "read", "derive": "derive", "skin": "skin", "inside": "inside", "lod": "lod", "pick": "pick", "write": "write",
    "present": "present", "presented_view": "present", "scene": "scene", "convert": "convert", "probe": "convert", "interior": "convert",
}
ONLY_IN = {"SDL": ("apps/viewer/desktop", "apps/viewer/audio", "tests/viewer"), "AL/": ("apps/viewer/audio", "tests/viewer"),
           "epoxy/": ("apps/viewer/render", "apps/viewer/xr", "apps/viewer/desktop", "apps/viewer/ui", "tests/viewer",
                     "tests/monado", "tests/xr_runtime"),
           "imgui": ("apps/viewer/ui", "apps/viewer/desktop"),
           "mpi.h": "src/distribute", "openxr/": ("apps/viewer/xr", "tests/viewer", "tests/monado", "tests/xr_runtime"), "httplib.h": "apps/server", "CLI/": ("apps/cli", "apps/viewer/app/options.cpp"),
           "vtk": ("apps/exchange", "bench/peers"), "hdf5.h": "apps/exchange", "netcdf.h": "apps/exchange"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def owner(include: str) -> str | None:
    """Layer that an include path belongs to, or None when it is not ours."""
    if include.startswith("feelem/"):
        return PUBLIC_HEADER_OWNER[pathlib.PurePath(include).stem]
    first = include.split("/")[0]
    return first if "/" in include and first in MAY_INCLUDE else None


def main(root: pathlib.Path) -> int:
    found = []
    folders = [root / name for name in ("include", "src", "apps", "tests", "bench", "fuzz")]
    for path in sorted(p for folder in folders for p in folder.rglob("*") if p.suffix in (".hpp", ".cpp")):
        where = path.relative_to(root).as_posix()
        for include in INCLUDE.findall(path.read_text()):
            for library, folder in ONLY_IN.items():
                if include.startswith(library) and not where.startswith(folder):
                    found.append(f"{where}: <{include}> belongs to {folder if isinstance(folder, str) else ' and '.join(folder)} only")
            me = where.split("/")[1] if where.startswith("src/") else owner(where.removeprefix("include/"))
            other = owner(include)
            if me in MAY_INCLUDE and other and other != me and other not in MAY_INCLUDE[me]:
                found.append(f"{where}: {me} must not include {other} ({include})")
    print("\n".join(found) or "layers: clean")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
