#!/usr/bin/env bash
# Builds programs that time CasADi's C code for this processor, at -O3 and at -Ofast: FOLDER/measure-casadi-O3 and so on.
#
# Usage: casadi.sh FOLDER PYTHON, an interpreter that has `casadi`
set -euo pipefail
target=$(realpath "$1") python=$2
cd "$(dirname "$0")"
# CasADi tests each argument for null; without the tests gcc evaluates sine and cosine at once.
"$python" casadi_code.py "$target" 2>"$target/casadi-counts.txt"
sed -E -i 's/arg\[([0-9]+)\]\? (arg\[[0-9]+\]\[[0-9]+\]) : 0/\2/; s/if \(res\[0\]!=0\) //' "$target/arms.c"
for level in O3 Ofast; do
  gcc -$level -march=native -c "$target/arms.c" -o "$target/arms-$level.o"
  g++ -std=c++17 -O2 -DCANDIDATE="\"CasADi,-$level\"" casadi.cpp "$target/arms-$level.o" -o "$target/measure-casadi-$level"
done
