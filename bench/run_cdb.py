#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how fast one core reads a generated archive of commands (.cdb): finding its blocks, the rows of NBLOCK and
of EBLOCK, and the whole way to a mesh. Writes bench/results/NAME.json and prints the same.

    bench/run_cdb.py [--side 100] [--bin build/release/bin] [--work build/bench] [--rounds 9] [--name cdb-hex8-1m]"""
import argparse
import json
import subprocess
from pathlib import Path

from measure import HERE, commit, machine


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--side", type=int, default=100, help="nodes along each edge of the block")
    options.add_argument("--bin", type=Path, default=HERE.parent / "build/release/bin")
    options.add_argument("--work", type=Path, default=HERE.parent / "build/bench")
    options.add_argument("--rounds", type=int, default=9)
    options.add_argument("--name", default="cdb-hex8-1m")
    options = options.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    source = options.work / f"block{options.side}.cdb"
    if not source.exists():
        part = source.with_suffix(".part")
        subprocess.run([options.bin / "bench_make_cdb", str(options.side), part], check=True)
        part.rename(source)
    out = subprocess.run([options.bin / "bench_read_cdb", source, str(options.rounds)], check=True, stdout=subprocess.PIPE)
    report = {
        "what": f"one core reads a .cdb: {options.side**3} hex8 nodes (3i9,6e21.13e3), {(options.side - 1) ** 3} elements "
                f"(19i10); processor time of the best of {options.rounds} rounds, pages in memory",
        "machine": machine(), "commit": commit(), "input_bytes": source.stat().st_size, "parts": json.loads(out.stdout),
    }
    result = HERE / "results" / f"{options.name}.json"
    result.write_text(json.dumps(report, indent=1) + "\n")
    print(f"{report['what']}\n{report['machine']}, commit {report['commit']}")
    for part in report["parts"]:
        print(f"  {part['part']:<14} {part['bytes'] / 1e6:8.1f} MB {part['cpu_seconds']:8.3f} s {part['gb_per_second']:6.2f} GB/s")


if __name__ == "__main__":
    main()
