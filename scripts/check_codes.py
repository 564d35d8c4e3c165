#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when an error or diagnostic code is used by nothing, or provoked by no test."""
import pathlib
import re
import sys


def text_of(root: pathlib.Path, folders: list[str], skip: str = "") -> str:
    files = (p for folder in folders for p in sorted((root / folder).rglob("*")))
    return "\n".join(p.read_text(errors="replace") for p in files if p.suffix in (".cpp", ".hpp") and p.name != skip)


def main(root: pathlib.Path) -> int:
    header = (root / "include/feelem/diagnostics.hpp").read_text()
    codes = re.findall(r"^    ([A-Z]\w+),", header[: header.index("enum class Severity")], re.M)
    used = text_of(root, ["src", "apps"], skip="diagnostics.cpp")
    tested = text_of(root, ["tests"])
    found = [f"{code}: nothing uses it" for code in codes if not re.search(rf"Code::{code}\b", used)]
    found += [f"{code}: no test provokes it" for code in codes if not re.search(rf"Code::{code}\b", tested)]
    print("\n".join(found) or f"codes: all {len(codes)} are used and tested")
    return 1 if found or not codes else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
