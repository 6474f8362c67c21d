#!/usr/bin/env bash
# Measures robots with branches, the generated functions beside Pinocchio's, in turn on one core. Writes the table into
# docs/PERFORMANCE.md.
#
# ROUNDS says how often each program runs (9), TREES_TARGET where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${TREES_TARGET:-target/trees}")
theirs=$(benches/rivals/elsewhere/trees.sh "$target")
RUSTFLAGS="-C target-cpu=native" cargo bench --quiet -p benches --bench trees --no-run --target-dir "$target"
ours=$(find "$target/release/deps" -name 'trees-*' -executable -type f -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2)
"$ours" states >"$target/states.txt"
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }
lines=$target/lines.txt
: >"$lines"
for round in $(seq "${ROUNDS:-9}"); do
  echo "round $round" >&2
  pin "$ours" >>"$lines"
  pin "$theirs" "$target/trees.txt" "$target/states.txt" >>"$lines"
done
table=$target/table.md
{
  printf '%s; %s; %s.\n\n' "$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)" "$(rustc --version)" "$(date -u +%Y-%m-%d)"
  python3 benches/trees_table.py "$lines"
} >"$table"
cat "$table"
sed -i -e "/^<!-- trees -->/,/^<!-- end -->/{//!d}" -e "/^<!-- trees -->/r $table" docs/PERFORMANCE.md
