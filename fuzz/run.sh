#!/usr/bin/env bash
# fuzz/run.sh BIN WORK [SECONDS [HARNESS...]]: runs each harness of BIN, from our own examples and what earlier runs
# found. Crashing inputs stay in WORK. FEELEM_FUZZ_KEEP=1 then keeps the smallest set of inputs that reaches the same
# code in tests/data/fuzz_corpus, where the test Hostile replays it.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=$1 work=$2 seconds=${3:-60} status=0
if (( $# > 3 )); then harnesses=("${@:4}"); else mapfile -t harnesses < <(cd "$bin" && ls -d fuzz_*); fi
largest=32768
common=(-timeout=10 -rss_limit_mb=2048 "-max_len=$largest")

mkdir -p "$work/seeds"
# The readers that ask the helper program look for it beside themselves; it is never built with sanitizers.
helper=build/release/bin/feelem-exchange
if [[ -x $helper ]]; then ln -sf "$PWD/$helper" "$bin/"; fi
while read -r file; do
    # Heads only: long inputs slow the fuzzer down, and counts stand in heads.
    head -c $largest "$file" >"$work/seeds/$(tr / - <<<"$file")"
done < <(find examples tests/data -type f ! -name '*.md' ! -name '*.py' ! -path '*/fuzz_corpus/*')

for harness in "${harnesses[@]}"; do
    mkdir -p "$work/$harness" "tests/data/fuzz_corpus/$harness"
    echo "== $harness, $seconds s"
    "$bin/$harness" "${common[@]}" -max_total_time="$seconds" -print_final_stats=1 -artifact_prefix="$work/$harness-" \
        "$work/$harness" "tests/data/fuzz_corpus/$harness" "$work/seeds" 2>&1 | tail -n 12 || status=1
    if [[ -n ${FEELEM_FUZZ_KEEP:-} ]]; then
        rm -rf "$work/least"; mkdir "$work/least"
        "$bin/$harness" "${common[@]}" -merge=1 "$work/least" "$work/$harness" "tests/data/fuzz_corpus/$harness" "$work/seeds" \
            >"$work/$harness-merge.log" 2>&1 || status=1
        rm -rf "tests/data/fuzz_corpus/$harness"; mkdir "tests/data/fuzz_corpus/$harness"
        # The smallest ones: the repository stays small, and large ones are cuts of the examples anyway.
        find "$work/least" -type f -size -2049c -printf '%s %p\n' | sort -n | head -n 200 | cut -d ' ' -f 2- |
            xargs -r cp -t "tests/data/fuzz_corpus/$harness"
    fi
    rmdir --ignore-fail-on-non-empty "tests/data/fuzz_corpus/$harness" tests/data/fuzz_corpus
done
exit $status
