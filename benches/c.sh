#!/usr/bin/env bash
# Measures the C code of `robot-dynamics generate`, one state at a time and in batches of 64 by columns, beside Rust's native
# build and beside CasADi's C code, in turn on one core. Writes the table into docs/performance/c.md.
#
# ROUNDS says how often each program runs (9), C_TARGET where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${C_TARGET:-target/c}")
host=$(rustc -vV | sed -n 's/^host: //p')
RUSTFLAGS="-C target-cpu=native" cargo build --quiet --release -p goals --target "$host" --target-dir "$target"
rust=$target/$host/release/goals
mapfile -t of_c < <(benches/rivals/elsewhere/generated_c.sh native "$target/generated-c")
[ -x "$target/venv/bin/python" ] || python3 -m venv "$target/venv"
"$target/venv/bin/pip" install --quiet casadi==3.8.2
benches/rivals/elsewhere/casadi.sh "$target" "$target/venv/bin/python"
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }
lanes() { grep -q -m 1 avx512f /proc/cpuinfo && echo 'AVX-512, eight lanes' || echo 'AVX2, four lanes'; }
lines=$target/c-lines.txt
: >"$lines"
for round in $(seq "${ROUNDS:-9}"); do
  echo "round $round" >&2
  pin "$rust" one-core | grep '^time' >>"$lines"
  for program in "${of_c[@]}"; do
    pin "$program" >>"$lines"
    pin "$program" batches >>"$lines"
  done
  for level in O3 Ofast; do pin "$target/measure-casadi-$level" >>"$lines"; done
done
table=$target/c-table.md
{
  printf '%s, %s; %s; %s; %s.\n\n' "$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)" "$(lanes)" \
    "$(rustc --version)" "$(cat "${of_c[@]/%/.compiler}" | paste -sd ',' | sed 's/,/, /g')" "$(date -u +%Y-%m-%d)"
  python3 benches/rivals/elsewhere/c_table.py "$lines"
} >"$table"
cat "$table"
benches/insert.sh c "$table" docs/performance/c.md
