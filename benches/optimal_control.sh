#!/usr/bin/env bash
# Measures an optimal control problem that IPOPT solves, with functions of `generate --lang casadi` beside graphs of CasADi.
# Writes the table into docs/performance/optimal_control.md.
#
# OPTIMAL_TARGET says where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${OPTIMAL_TARGET:-target/optimal_control}")
for language in casadi python; do
  cargo run --quiet --release -p dynamics-cli --target-dir "$target" -- \
    generate tests/data/urdf/panda.urdf --gravity 0,0,-9.81 --lock panda_finger_joint1=0 \
    --lang "$language" --functions inverse_dynamics,forward_dynamics --out "$target"
done
[ -x "$target/venv/bin/python" ] || python3 -m venv "$target/venv"
"$target/venv/bin/pip" install --quiet casadi==3.8.2 numpy
of_processor() { sed -n "s/^$1\s*: //p" /proc/cpuinfo | head -n 1; }
lanes() { grep -q -m 1 avx512f /proc/cpuinfo && echo AVX-512 || echo AVX2; }
for form in inverse forward; do
  table=$target/$form.md
  {
    printf '%s, family %s, model %s, %s; CasADi 3.8.2; gcc %s with `-O3 -march=native`; %s.\n\n' "$(of_processor 'model name')" \
      "$(of_processor 'cpu family')" "$(of_processor model)" "$(lanes)" "$(gcc -dumpfullversion)" "$(date -u +%Y-%m-%d)"
    "$target/venv/bin/python" benches/rivals/elsewhere/swing_up.py "$target" $form
  } >"$table"
  cat "$table"
done
benches/insert.sh optimal_control "$target/inverse.md" docs/performance/optimal_control.md
benches/insert.sh optimal_control_forward "$target/forward.md" docs/performance/optimal_control.md
