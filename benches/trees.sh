#!/usr/bin/env bash
# Measures robots with branches, and on bases that move, the generated functions beside Pinocchio's, in turn on one core.
# Writes the tables into docs/performance/trees.md.
#
# ROUNDS says how often each program runs (9), TREES_TARGET where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${TREES_TARGET:-target/trees}")
theirs=$(benches/rivals/elsewhere/trees.sh "$target")
RUSTFLAGS="-C target-cpu=native" cargo bench --quiet -p benches --bench trees --bench legged --no-run --target-dir "$target"
newest() { find "$target/release/deps" -name "$1-*" -executable -type f -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2; }
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }
lanes() { grep -q -m 1 avx512f /proc/cpuinfo && echo 'AVX-512, eight lanes' || echo 'AVX2, four lanes'; }
for kind in trees legged; do
  ours=$(newest "$kind")
  "$ours" states >"$target/$kind-states.txt"
  lines=$target/$kind-lines.txt
  : >"$lines"
  for round in $(seq "${ROUNDS:-9}"); do
    echo "$kind, round $round" >&2
    pin "$ours" >>"$lines"
    pin "$theirs" "$target/$kind.txt" "$target/$kind-states.txt" >>"$lines"
  done
  table=$target/$kind-table.md
  {
    printf '%s, %s; %s; %s.\n\n' "$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)" "$(lanes)" "$(rustc --version)" "$(date -u +%Y-%m-%d)"
    python3 benches/trees_table.py "$lines"
  } >"$table"
  cat "$table"
  benches/insert.sh "$kind" "$table" docs/performance/trees.md
done
