#!/usr/bin/env bash
# Measures C code that generators write, CppADCodeGen's beside that of `robot-dynamics generate`: one compiler, the same
# flags, in turn on one core. Writes the table into docs/performance/generators.md.
#
# ROUNDS says how often each program runs (9), GENERATORS_TARGET where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${GENERATORS_TARGET:-target/generators}")
theirs=$(benches/rivals/elsewhere/cppadcg.sh native "$target")
ours=$(benches/rivals/elsewhere/generated_c.sh native "$target/generated-c" | grep -- '-gcc$')
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }
lines=$target/lines.txt
cat "$ours.errors" "$theirs.errors" >"$lines"
for round in $(seq "${ROUNDS:-9}"); do
  echo "round $round" >&2
  for program in "$ours" "$theirs"; do pin "$program" >>"$lines"; done
done
table=$target/table.md
{
  printf '%s; %s; %s.\n\n' "$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)" \
    "$(cat "$theirs.compiler")" "$(date -u +%Y-%m-%d)"
  python3 benches/rivals/elsewhere/generators.py "$lines" "$target/generated-c" "$theirs.c"
} >"$table"
cat "$table"
benches/insert.sh generators "$table" docs/performance/generators.md
