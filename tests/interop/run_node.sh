#!/usr/bin/env bash
# run_node.sh SCRIPT ARGUMENT...: a Node script of the tests with the project's own Node; 77 (skipped) without it.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
case $(uname -m) in x86_64) arch=x64 ;; aarch64) arch=arm64 ;; *) arch=none ;; esac
node=$root/scripts/node/node_modules/node-linux-$arch/bin/node
[[ -x $node && -d $root/web/node_modules ]] || { echo "skipped: run ./dev setup web first"; exit 77; }
script=$1; shift
exec "$node" "$root/tests/interop/$script" "$@"
