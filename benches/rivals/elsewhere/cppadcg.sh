#!/usr/bin/env bash
# Builds a program that times the C code which CppADCodeGen writes of Pinocchio's algorithms, checks its values, and
# prints the program's path, beside which its errors, the compiler's name and the code lie. Takes gcc, Python 3 and
# wheels of PyPI, which it installs into a folder of its own. The program that writes the code takes g++ some minutes.
#
# Usage: cppadcg.sh MARCH FOLDER
set -euo pipefail
march=$1
mkdir -p "$2"
folder=$(realpath "$2")
cd "$(dirname "$0")"
if [ ! -x "$folder/venv/bin/python" ]; then
  python3 -m venv "$folder/venv"
  "$folder/venv/bin/pip" install --quiet pin==4.1.0 cmeel-eigen==3.4.1 cmeel-cppadcodegen==2.4.3
fi
python=$folder/venv/bin/python
prefix=$(echo "$folder"/venv/lib/python3*/site-packages/cmeel.prefix)
"$python" pinocchio_arms.py >"$folder/arms.txt"
writer=$folder/cppadcg_code
if [ cppadcg_code.cpp -nt "$writer" ] || [ pinocchio_model.h -nt "$writer" ]; then
  g++ -std=c++17 -O0 -DNDEBUG -DARMS_FILE="\"$folder/arms.txt\"" -w -DBOOST_FUSION_INVOKE_MAX_ARITY=10 \
    -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS \
    -isystem "$prefix/include" -isystem "$prefix/include/eigen3" cppadcg_code.cpp -o "$writer" \
    -L"$prefix/lib" -Wl,-rpath,"$prefix/lib" -lpinocchio_default
fi
program=$folder/measure-CppADCodeGen
"$writer" "$program.c"
gcc -O3 -march="$march" -c "$program.c" -o "$folder/cppadcg.o"
g++ -std=c++17 -O3 -march="$march" -DCANDIDATE='"CppADCodeGen"' cppadcg.cpp "$folder/cppadcg.o" -o "$program" -lm
gcc --version | head -n 1 >"$program.compiler"
"$python" check.py "$program" CppADCodeGen >"$program.errors"
echo "$program"
