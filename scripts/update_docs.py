#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Rewrites the generated parts of the documents from the program and the tables: ./dev docs.

    scripts/update_docs.py FEELEM            writes what is stale
    scripts/update_docs.py --check FEELEM    names what is stale and exits 1: the test `docs`

A part stands between `<!-- generated: NAME -->` and `<!-- end -->`; nothing else of a page is touched."""
import json
import re
import subprocess
import sys
from pathlib import Path

import performance_tables

ROOT = Path(__file__).resolve().parent.parent
PART = re.compile(r"(<!-- generated: (\S+) -->\n).*?(<!-- end -->)", re.S)
SEVERITIES = {"Error": "error", "Warning": "warning", "Note": "note"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, env={"LC_ALL": "C.UTF-8", "COLUMNS": "100"}).stdout


def formats(feelem):
    listed = json.loads(output(feelem, "formats", "--json"))
    rows = ["| | format | suffixes | mesh | results |", "|---|---|---|---|---|"]
    for row in listed["read"]:
        yes = {True: "yes", False: ""}
        rows.append(f"| reads | {row['title']} | {row['suffixes']} | {yes[row['mesh']]} | {yes[row['results']]} |")
    for row in listed["write"]:
        rows.append(f"| writes | {row['title']} | {row['suffix']} | | |")
    return "\n".join(rows)


def commands(feelem):
    names = re.findall(r"^  (\w+)   ", output(feelem, "--help"), re.M)
    return "\n\n".join(f"### {name}\n```\n{output(feelem, name, '--help').strip()}\n```" for name in names)


def codes(_):
    source = (ROOT / "src/base/diagnostics.cpp").read_text()
    row = re.compile(r'CodeInfo\{\s*Code::\w+,\s*"(\w+)",\s*Severity::(\w+),\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\}')
    found = row.findall(source)
    if len(found) != len(re.findall(r"CodeInfo\{", source)):
        sys.exit("update_docs: a row of the table in src/base/diagnostics.cpp has a new shape")
    rows = ["| code | severity | meaning |", "|---|---|---|"]
    for word, severity, strings in found:
        meaning = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', strings))
        rows.append(f"| `{word}` | {SEVERITIES[severity]} | {meaning} |")
    return "\n".join(rows)


MAKERS = {"formats": formats, "commands": commands, "codes": codes, **performance_tables.TABLES}


def main():
    check = "--check" in sys.argv
    feelem = next((argument for argument in sys.argv[1:] if not argument.startswith("-")), None)
    if feelem is None:
        sys.exit(__doc__)
    stale = []
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        old = page.read_text()
        new = PART.sub(lambda part: part[1] + MAKERS[part[2]](feelem) + "\n" + part[3], old)
        if new != old:
            stale.append(str(page.relative_to(ROOT)))
            if not check:
                page.write_text(new)
    print("docs: " + (("stale, run ./dev docs: " if check else "written: ") + " ".join(stale) if stale else "up to date"))
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
