#!/usr/bin/env bash
# Measures what docs/PERFORMANCE.md shows, and writes it. The arms are measured here, for docs/performance/arms.md: a plain
# and a native build of benches/rivals, run in turn on one core. Programs that benches/rivals/elsewhere/build.sh has built
# run with them; otherwise their lines are those of benches/rivals/elsewhere/measured.txt.
set -euo pipefail
cd "$(dirname "$0")/rivals"
rounds=${ROUNDS:-9}
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
host=$(rustc -vV | sed -n 's/^host: //p')
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }

build() { # name, RUSTFLAGS
  # With --target the flags are not those of build scripts: symplex is compiled once.
  RUSTFLAGS=$2 cargo build --release --target "$host"
  cp "$target/$host/release/rivals" "$target/rivals-$1"
}
build plain ""
build native "-C target-cpu=native"

elsewhere=("$target"/elsewhere/measure-*)
[ -x "${elsewhere[0]}" ] || elsewhere=()
rm -f "$target"/{plain,native,elsewhere}.txt
for round in $(seq "$rounds"); do
  echo "round $round of $rounds" >&2
  for name in plain native; do pin "$target/rivals-$name" measure >>"$target/$name.txt"; done
  for program in "${elsewhere[@]}"; do pin "$program" >>"$target/elsewhere.txt"; done
done
medians() { # of the fifth words of lines that are alike before
  sort -s -k1,4 -k5,5g | awk '
    function flush() { if (n) print key, value[int((n + 1) / 2)]; n = 0 }
    { now = $1 " " $2 " " $3 " " $4; if (now != key) { flush(); key = now } value[++n] = $5 }
    END { flush() }'
}
if [ ${#elsewhere[@]} -gt 0 ]; then
  {
    cat "$target/elsewhere/remarks.txt"
    echo "# Timed on $(date -u +%Y-%m-%d), in turn with the two builds of that day."
    medians <"$target/elsewhere.txt"
  } >elsewhere/measured.txt
fi
"$target/rivals-plain" report "$target/plain.txt" "$target/native.txt" elsewhere/measured.txt \
  >"$target/arms.md"
../insert.sh arms "$target/arms.md" docs/performance/arms.md
# The table of goals, met or missed, for the widest lanes that there are, and for those of AVX2.
../goals.sh
if grep -qw avx512f /proc/cpuinfo; then ../goals.sh avx2; fi
# The table of this project's C code.
../c.sh
# The table of C code that generators write.
../generators.sh
# The tables of robots with branches, and on bases that move.
../trees.sh
# The tables of inverse kinematics.
../inverse.sh
# The table of an optimal control problem.
../optimal_control.sh
