#!/usr/bin/env bash
# Builds timing programs around CasADi's C code and around Pinocchio, and checks their values. Takes
# gcc, Python 3, and wheels of PyPI (`casadi`, `pin`, `cmeel-eigen`, and `ziglang` for its clang),
# which it installs into a folder of its own. benches/report.sh then runs the programs with its own.
set -euo pipefail
cd "$(dirname "$0")"
target=$(realpath -m "${CARGO_TARGET_DIR:-../target}")/elsewhere
mkdir -p "$target"
rm -f "$target"/measure-*

python3 -m venv "$target/venv"
"$target/venv/bin/pip" install --quiet casadi==3.8.2 pin==4.1.0 cmeel-eigen==3.4.1 ziglang==0.17.0
python=$target/venv/bin/python
prefix=$("$python" -c 'import cmeel, sys; print(sys.prefix)')/lib/python3*/site-packages/cmeel.prefix
prefix=$(echo $prefix)

./casadi.sh "$target" "$python"

# Pinocchio: its library as the wheel has it behind gcc, and compiled for this machine by clang, which
# inlines more of it and is up to 1.7 times as fast as gcc here.
"$python" pinocchio_arms.py >"$target/arms.txt"
pinocchio() { # name, compiler and flags
  "${@:2}" -std=c++17 -DNDEBUG -O3 -DCANDIDATE="\"$1\"" -DARMS_FILE="\"$target/arms.txt\"" -w \
    -DBOOST_FUSION_INVOKE_MAX_ARITY=10 -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 \
    -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -isystem "$prefix/include" -isystem "$prefix/include/eigen3" \
    pinocchio.cpp -o "$target/measure-$1" "${library[@]}"
}
library=(-L"$prefix/lib" -Wl,-rpath,"$prefix/lib" -lpinocchio_default)
pinocchio Pinocchio,gcc g++ -DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION &
library=()
# clang's C++ library has dropped what this Boost still asks of it, unless told to keep it.
ZIG_GLOBAL_CACHE_DIR=$target/zig pinocchio Pinocchio,clang "$python" -m ziglang c++ -march=native \
  -fno-sanitize=undefined -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES -DBOOST_NO_CXX98_FUNCTION_BASE
wait $!

remarks=$target/remarks.txt
cat >"$remarks" <<END
# Outside Rust, built by \`benches/rivals/elsewhere/build.sh\` on $(date -u +%Y-%m-%d):
#
# | name | what it is |
# |---|---|
# | CasADi | 3.8.2: recursive Newton-Euler, composite bodies and an unrolled factorisation on SX symbols, \`cse\`, C code compiled by gcc $(gcc -dumpfullversion) with \`-march=native\` and the level given |
# | Pinocchio,gcc | 4.1.0: \`rnea\`, \`crba\`, \`computeGeneralizedGravity\`, \`aba\` of its wheel's library, called from code compiled with \`-O3\` |
# | Pinocchio,clang | the same, all compiled with \`-O3 -march=native\` by clang (of ziglang 0.17.0) |
#
# V is Pinocchio's \`rnea\` without gravity. Friction is added to its torques.
END
for program in "$target"/measure-*; do
  candidate=$(basename "$program" | sed 's/^measure-//; s/^casadi-/CasADi,-/')
  "$python" check.py "$program" "$candidate" >>"$remarks"
done
