#!/usr/bin/env bash
# Builds timing programs around CasADi's C code and around Pinocchio, and checks their values. Takes
# a compiler of C++17, Python 3, and the wheels `casadi`, `pin` and `cmeel-eigen` of PyPI, which it
# installs into a folder of its own. benches/report.sh then runs the programs with its own.
set -euo pipefail
cd "$(dirname "$0")"
target=$(realpath -m "${CARGO_TARGET_DIR:-../target}")/elsewhere
mkdir -p "$target"
rm -f "$target"/measure-*

python3 -m venv "$target/venv"
"$target/venv/bin/pip" install --quiet casadi==3.8.2 pin==4.1.0 cmeel-eigen==3.4.1
python=$target/venv/bin/python
prefix=$("$python" -c 'import cmeel, sys; print(sys.prefix)')/lib/python3*/site-packages/cmeel.prefix
prefix=$(echo $prefix)

# CasADi tests each argument for null; without the tests gcc evaluates sine and cosine at once.
"$python" casadi_code.py "$target" 2>"$target/casadi-counts.txt"
sed -E -i 's/arg\[([0-9]+)\]\? (arg\[[0-9]+\]\[[0-9]+\]) : 0/\2/; s/if \(res\[0\]!=0\) //' "$target/arms.c"
for level in O3 Ofast; do
  gcc -$level -march=native -c "$target/arms.c" -o "$target/arms-$level.o"
  g++ -std=c++17 -O2 -DCANDIDATE="\"CasADi,-$level\"" casadi.cpp "$target/arms-$level.o" -o "$target/measure-casadi-$level"
done

# Pinocchio: its library as the wheel has it, and compiled for this machine with the loop.
"$python" pinocchio_arms.py >"$target/arms.txt"
pinocchio() { # name, flags
  g++ -std=c++17 -DNDEBUG -O3 "${@:2}" -DCANDIDATE="\"$1\"" -DARMS_FILE="\"$target/arms.txt\"" \
    -DBOOST_FUSION_INVOKE_MAX_ARITY=10 -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 \
    -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -isystem "$prefix/include" -isystem "$prefix/include/eigen3" \
    pinocchio.cpp -L"$prefix/lib" -Wl,-rpath,"$prefix/lib" -lpinocchio_default -o "$target/measure-$1"
}
pinocchio Pinocchio -DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION
pinocchio Pinocchio,native -march=native

remarks=$target/remarks.txt
echo "# Outside Rust, on $(date -u +%Y-%m-%d): $(gcc --version | head -1); CasADi 3.8.2 (recursive Newton-Euler and composite" >"$remarks"
echo "# bodies on its SX symbols, \`cse\`, \`gcc -march=native\`), Pinocchio 4.1.0. Command: \`benches/rivals/elsewhere/build.sh\`." >>"$remarks"
for program in "$target"/measure-*; do
  candidate=$(basename "$program" | sed 's/^measure-//; s/^casadi-/CasADi,-/')
  "$python" check.py "$program" "$candidate" >>"$remarks"
done
