#!/usr/bin/env bash
# Measures what the project has set itself goals for, and writes the table of goals, met or missed, into a file of this
# processor in docs/contributing/goals, and those of all processors into README.md there: the generated functions beside a trial
# that benches/rivals/elsewhere/trial.sh builds, in turn on one core, and the C code that `robot-dynamics generate`
# writes; then two cores beside one. With `avx2` the same without AVX-512, where a processor has it.
#
# ROUNDS says how often each program runs (5), GOALS_TARGET where cargo builds. With fewer than five rounds the table
# is printed alone: `ROUNDS=1 benches/goals.sh` tries whether all of it runs.
set -euo pipefail
cd "$(dirname "$0")/.."
host=$(rustc -vV | sed -n 's/^host: //p')
target=$(realpath -m "${GOALS_TARGET:-target/goals}")
if [ "${1:-}" = avx2 ] || ! grep -qw avx512f /proc/cpuinfo; then
  lanes=4 name=AVX2 march=x86-64-v3 flags="-C target-cpu=x86-64-v3 --cfg disable_dispatch_avx512"
else
  lanes=8 name=AVX-512 march=native flags="-C target-cpu=native"
fi
# Names of functions with their types, for what is said of registers.
flags="$flags -C symbol-mangling-version=v0"
RUSTFLAGS=$flags cargo build --quiet --release -p goals --target "$host" --target-dir "$target/$lanes"
goals=$target/$lanes/$host/release/goals
trial=$(benches/rivals/elsewhere/trial.sh "$march" "$target/trial-$lanes")
of_c=$(benches/rivals/elsewhere/generated_c.sh "$march" "$target/generated-c-$lanes")
mapfile -t c_programs <<<"$of_c"
pin() { if command -v taskset >/dev/null; then taskset -c $(($(nproc) - 1)) "$@"; else "$@"; fi; }
lines=$target/lines-$lanes.txt
cat "$trial.errors" "${c_programs[@]/%/.errors}" >"$lines"
for round in $(seq "${ROUNDS:-5}"); do
  echo "round $round" >&2
  pin "$goals" one-core >>"$lines"
  for program in "$trial" "${c_programs[@]}"; do pin "$program" >>"$lines"; done
  "$goals" all-cores >>"$lines"
done
table=$target/table-$lanes.md
of_processor() { sed -n "s/^$1\s*: //p" /proc/cpuinfo | head -n 1; }
family="family $(of_processor 'cpu family'), model $(of_processor model)"
{
  printf '# Goals on %s: %s, %s\n\n' "$name" "$(of_processor 'model name')" "$family"
  printf '%s lanes of doubles; %s; trial compiled by %s; %s.\n\n' \
    "$lanes" "$(rustc --version)" "$(cat "$trial.compiler")" "$(date -u +%Y-%m-%d)"
  "$goals" table "$lanes" "$lines"
  python3 benches/spills.py "$goals"
} >"$table"
sed '/^Each function/,$d' "$table"
[ "${ROUNDS:-5}" -ge 5 ] || exit 0
case $(of_processor vendor_id) in
  AuthenticAMD) vendor=amd ;;
  GenuineIntel) vendor=intel ;;
  *) vendor=other ;;
esac
width=$(tr -d - <<<"${name,,}")
cp "$table" "docs/contributing/goals/$vendor-$(of_processor 'cpu family')-$(of_processor model)-$width.md"
summary=$target/summary.md
python3 benches/goals_summary.py docs/contributing/goals/*-*-*.md >"$summary"
benches/insert.sh goals "$summary" docs/contributing/goals/README.md
