#!/usr/bin/env bash
# Runs each harness from the shipped examples: fuzz/run.sh BIN WORK [SECONDS]. Crashing inputs stay in WORK.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=$1 work=$2 seconds=${3:-60} status=0
mkdir -p "$work/seeds"
# Seeds are the heads of our own files: long inputs only slow the fuzzer down.
for file in examples/boiler/*/*.lis examples/boiler/*/*.frd examples/boiler/*.frd; do
    head -c 6000 "$file" >"$work/seeds/$(tr / - <<<"$file")"
done
cp examples/boiler/boiler.presentation.json "$work/seeds/"
for harness in fuzz_read fuzz_presentation; do
    mkdir -p "$work/$harness"
    "$bin/$harness" -max_total_time="$seconds" -timeout=5 -rss_limit_mb=1024 -max_len=16384 -print_final_stats=1 \
        -artifact_prefix="$work/$harness-" "$work/$harness" "$work/seeds" 2>&1 | tail -n 12 || status=1
done
exit $status
