#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the examples of exchange formats: tests/data/exchange/make/make.py [FOLDER]

Needs python3-vtk9 python3-netcdf4 libmedc11 libcgns3.4 of Debian 12; the tests need none of them.
"""
import importlib
import pathlib
import sys

import models

FORMATS = {"with_vtk": "vtk", "with_netcdf": "exodus", "with_libmed": "med", "with_libcgns": "cgns", "by_hand": "ensight"}

if __name__ == "__main__":
    top = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    for module, folder in FORMATS.items():
        (top / folder).mkdir(parents=True, exist_ok=True)
        importlib.import_module(module).write(str(top / folder), models.stack(), models.curved())
