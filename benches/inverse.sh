#!/usr/bin/env bash
# Measures inverse kinematics, in closed form and numeric, on one core; plain build. Writes the tables into
# docs/performance/inverse_kinematics.md.
#
# INVERSE_TARGET says where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${INVERSE_TARGET:-target/inverse}")
cargo bench --quiet -p benches --bench closed_forms --bench reach --no-run --target-dir "$target"
newest() { find "$target/release/deps" -name "$1-*" -executable -type f -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2; }
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }
of_processor() { sed -n "s/^$1\s*: //p" /proc/cpuinfo | head -n 1; }
lanes() { grep -q -m 1 avx512f /proc/cpuinfo && echo AVX-512 || echo AVX2; }
for kind in closed_forms reach; do
  table=$target/$kind-table.md
  {
    printf '%s, family %s, model %s, %s; %s; %s.\n\n' "$(of_processor 'model name')" "$(of_processor 'cpu family')" \
      "$(of_processor model)" "$(lanes)" "$(rustc --version)" "$(date -u +%Y-%m-%d)"
    pin "$(newest "$kind")"
  } >"$table"
  cat "$table"
  benches/insert.sh "$kind" "$table" docs/performance/inverse_kinematics.md
done
