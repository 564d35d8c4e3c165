#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The figures of docs/performance.md that a change of readers or skin moves, measured again in a quarter of an hour on a quiet
# machine: readers beside VTK and meshio, whole conversions, skins of 8 M cells. Rows of the skins that are not measured here
# stay, with the commit that they are of. Then the tables. bench/record.sh [FOLDER OF THE PROGRAMS] [SKIN ROWS]
set -euo pipefail
cd "$(dirname "$0")/.."
bin=${1:-build/release/bin}
skins=${2:-degenerate:natural:3,plate:natural:2,hex8:natural:3,tet4:natural:3,mixed:natural:1,hex20:natural:1}
bench/parse.py --bin "$bin" --runs 5
bench/parse_decks.py --bin "$bin" --rounds 3
bench/end_to_end.py --bin "$bin" --runs 9
[[ -z $skins ]] || bench/compare.py --bin "$bin" --keep --only "$skins"
scripts/update_docs.py "$bin/feelem"
