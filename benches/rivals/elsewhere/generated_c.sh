#!/usr/bin/env bash
# Builds programs that time the C code of `robot-dynamics generate`, by gcc and by clang where it is installed,
# checks their values, and prints the programs' paths, beside which their errors and the compilers' names lie.
#
# Usage: generated_c.sh MARCH FOLDER
set -euo pipefail
march=$1
mkdir -p "$2"
folder=$(realpath "$2")
cd "$(dirname "$0")"
functions=inverse_dynamics,mass_matrix,coriolis_vector,gravity_vector,forward_dynamics
# Named by its manifest: this folder lies in a workspace of its own.
root=../../..
for arm in two_link_saha elbow_3r stanford puma560 ur5 panda; do
  cargo run --quiet --manifest-path "$root/Cargo.toml" -p dynamics-cli -- \
    generate "$root/tests/data/robots/$arm.json" --functions "$functions" --lang c --out "$folder" >/dev/null
done
for pair in gcc:g++ clang:clang++; do
  c=${pair%:*} cpp=${pair#*:}
  command -v "$cpp" >/dev/null || continue
  objects=()
  for source in "$folder"/*.c; do
    objects+=("${source%.c}-$c.o")
    "$c" -std=c99 -O3 -march="$march" -c "$source" -o "${source%.c}-$c.o"
  done
  program=$folder/generated_c-$c
  "$cpp" -std=c++17 -O3 -march="$march" -I"$folder" -DCANDIDATE="\"C,$c\"" generated_c.cpp "${objects[@]}" \
    -o "$program" -lm
  "$c" --version | head -n 1 >"$program.compiler"
  python3 check.py "$program" "C,$c" >"$program.errors"
  echo "$program"
done
