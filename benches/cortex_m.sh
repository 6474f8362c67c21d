#!/usr/bin/env bash
# Counts instructions, and measures stack and code, of the C code of `robot-dynamics generate --scalar float` on a
# Cortex-M4 that QEMU executes. Writes the table into docs/performance/cortex_m.md.
#
# It needs arm-none-eabi-gcc with its C library, and qemu-system-arm. In Debian: apt install gcc-arm-none-eabi
# libnewlib-arm-none-eabi qemu-system-arm. CORTEX_M_TARGET says where everything is built.
set -euo pipefail
cd "$(dirname "$0")/.."
target=$(realpath -m "${CORTEX_M_TARGET:-target/cortex_m}")
functions=inverse_dynamics,mass_matrix,coriolis_vector,gravity_vector,forward_dynamics
arms=(two_link_saha puma560 ur5 panda)
for arm in "${arms[@]}"; do
  cargo run --quiet -p dynamics-cli -- generate "tests/data/robots/$arm.json" --lang c --scalar float \
    --functions "$functions" --out "$target" >/dev/null
done
table=$target/table.md
{
  printf '%s; %s; %s.\n\n' "$(arm-none-eabi-gcc --version | head -n 1)" "$(qemu-system-arm --version | head -n 1)" \
    "$(date -u +%Y-%m-%d)"
  python3 benches/cortex_m/measure.py "$target" "${arms[@]}"
} >"$table"
cat "$table"
benches/insert.sh cortex_m "$table" docs/performance/cortex_m.md
