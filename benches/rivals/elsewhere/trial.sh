#!/usr/bin/env bash
# Builds the trial, checks its values, and prints the path of the program, beside which its errors and the
# compiler's name lie. Takes g++ or clang++, glibc's libmvec, and CasADi of PyPI, which it installs into a folder
# of its own.
#
# Usage: trial.sh MARCH PROGRAM
set -euo pipefail
march=$1 program=$2
cd "$(dirname "$0")"
folder=$(dirname "$program")
mkdir -p "$folder"
if [ ! -x "$folder/venv/bin/python" ]; then
  python3 -m venv "$folder/venv"
  "$folder/venv/bin/pip" install --quiet casadi==3.8.2
fi
python=$folder/venv/bin/python
"$python" trial_code.py "$folder/trial.h" 2>"$folder/trial-counts.txt"
# The compiler whose program is faster here, by all functions' times, each the least of three runs.
best=
for compiler in clang++ g++; do
  command -v "$compiler" >/dev/null || continue
  "$compiler" -std=c++17 -Ofast -march="$march" -w -I"$folder" -DCANDIDATE='"trial"' trial.cpp \
    -o "$program-$compiler" -lmvec -lm
  time=$(for run in 1 2 3; do "$program-$compiler"; done | awk '
    { name = $2 " " $3; if (!(name in least) || $5 < least[name]) least[name] = $5 }
    END { for (name in least) sum += log(least[name]); print sum }')
  if [ -z "$best" ] || awk "BEGIN { exit !($time < $best) }"; then
    best=$time
    cp "$program-$compiler" "$program"
    "$compiler" --version | head -n 1 >"$program.compiler"
  fi
done
"$python" check.py "$program" trial >"$program.errors"
echo "$program"
