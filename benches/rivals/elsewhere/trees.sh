#!/usr/bin/env bash
# Builds a program that times Pinocchio on the trees of tests/data/urdf/trees, compiled whole by clang, and prints its path;
# beside it stand the numbers of the trees. Takes Python 3 and wheels of PyPI, which it installs into a folder of its own.
#
# Usage: trees.sh FOLDER
set -euo pipefail
mkdir -p "$1"
folder=$(realpath "$1")
cd "$(dirname "$0")"
if [ ! -x "$folder/venv/bin/python" ]; then
  python3 -m venv "$folder/venv"
  "$folder/venv/bin/pip" install --quiet pin==4.1.0 cmeel-eigen==3.4.1 ziglang==0.17.0
fi
python=$folder/venv/bin/python
prefix=$(echo "$folder"/venv/lib/python3*/site-packages/cmeel.prefix)
data=../../../tests/data/urdf/trees
"$python" trees.py "$data"/{hyq_no_sensors,anymal_erd,panda_free}.urdf >"$folder/trees.txt"
"$python" trees.py --floating "$data"/{hyq_no_sensors,anymal_erd}.urdf >"$folder/legged.txt"
program=$folder/measure-trees
if [ trees.cpp -nt "$program" ]; then
  ZIG_GLOBAL_CACHE_DIR=$folder/zig "$python" -m ziglang c++ -std=c++17 -O3 -march=native -DNDEBUG -w -fno-sanitize=undefined \
    -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES -DBOOST_NO_CXX98_FUNCTION_BASE -DBOOST_FUSION_INVOKE_MAX_ARITY=10 \
    -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS \
    -isystem "$prefix/include" -isystem "$prefix/include/eigen3" trees.cpp -o "$program"
fi
echo "$program"
