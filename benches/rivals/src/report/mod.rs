//! `docs/PERFORMANCE.md` from the lines that the builds printed.

mod goals;
mod machine;
mod tables;

use measuring::records::Records;

/// Prints the document. `files` are the lines of the plain build, those of the native build, and
/// those of the programs that are not Rust.
pub(crate) fn print(files: &[String]) {
    let [plain, native, elsewhere] = files else {
        panic!("three files: plain, native, elsewhere");
    };
    let [plain, native, elsewhere] = [plain, native, elsewhere].map(|file| Records::read(file));
    println!("{INTRODUCTION}");
    println!("{}", machine::description());
    println!("{CANDIDATES}");
    println!("{}", elsewhere.remarks());
    println!("{OVERVIEW}");
    print!("{}", tables::overview(&native, &elsewhere));
    println!("{}", goals::section(&native));
    println!("{GENERATORS}");
    println!("{DETAILS}");
    print!("{}", tables::details(&plain, &native, &elsewhere));
    print!("{}", tables::groups(&plain, &native));
}

const GENERATORS: &str = "\
## Trees

`benches/trees.sh` measures this table alone: the legs of HyQ and of ANYmal on a trunk that stands, and a Panda with two
fingers, from `tests/data/urdf/trees`, beside Pinocchio 4.1.0 compiled whole by clang with `-O3 -march=native`, in turn on
one core. Errors are against 31 digits, relative to the largest entry of each value; viscous friction is in both.

<!-- trees -->
<!-- end -->

## Other generators, and a GPU

`benches/generators.sh` measures this table alone. CppADCodeGen 2.4.3 records what Pinocchio's `rnea`, `crba`,
`computeGeneralizedGravity` and `aba` compute, lets CppAD optimise it, and writes C code; beside it the C code of
`robot-dynamics generate`. The same compiler with `-O3 -march=native`, in turn on one core. Operations are the
multiplications, additions and divisions in the code. CppADCodeGen's constants have the 15 digits that it writes
where it is told nothing else.

<!-- generators -->
<!-- end -->

What could not be measured: Thunder, which is not on PyPI, npm or in Debian, and robcogen2 0.1.0, whose wheel on PyPI
does not start without the Lua module `template-text` of LuaRocks, and whose code needs the headers `iit/rbd` from
their repository.

GRiD (CUDA) as it was published, not measured here: iiwa14, 1,024 states, RTX 5090, `fp32`; ns a state with the
data on the GPU, and with copies there and back.

| function | on the GPU | with copies |
|---|--:|--:|
| gradient of inverse dynamics | 30 | 58 |
| gradient of forward dynamics | 57 | 79 |
";

const INTRODUCTION: &str = "\
# Performance

This file is written by one command, which takes about ten minutes the first time:

```text
benches/report.sh
```

It builds one program twice, *plain* (no flags, as a user gets it who sets none) and *native*
(`RUSTFLAGS=\"-C target-cpu=native\"`), runs the builds in turn on one core, and takes medians. Each
function is evaluated at 64 states in turn, its inputs and results hidden from the optimiser. Before
anything is timed, every candidate's values are compared with the generated functions' (relative
difference below 1e-9).

Times are nanoseconds for one state, `f64`, one core. Errors are relative to the natural magnitude of
the quantity (`scale` in `tests/data/reference`), against references of 25 digits at 24 states, angles
of 1e6 rad among them: the largest, and the root of the mean square. Those of `forward_dynamics` are
the torques that its accelerations need beyond those that were applied. Functions that only the
generated code has are compared with themselves in arithmetic of 31 digits at the states that are
timed, relative to the largest entry of the matrix.
";

const CANDIDATES: &str = "\
## Candidates

| name | what it is |
|---|---|
| generated | the functions of `robot_dynamics!` |
| numeric | `NewtonEuler` of the runtime: recursive Newton-Euler, M by composite bodies, G by composite first moments, forward dynamics by both and one factorisation |
| dynibo | the crate dynibo 0.5 on a URDF of the same arm: RNEA, CRBA, articulated bodies. It knows neither reflected inertias nor friction, and checks its inputs; its values are completed for the comparison, not for the timing |
| symplex | Rust code written by the crate symplex 0.57 from T and U; its forward dynamics is its M and bias with nalgebra's Cholesky factorisation. Fused multiply-add in the native build only |
";

const OVERVIEW: &str = "\
## Overview

Native builds: the time of the generated function, ns, and how many times as long the others take.
";

const DETAILS: &str = "\
## Times and errors
";
