//! The times that the project has set itself, and which of them are missed.

use std::fmt::Write;

use super::records::Records;
use super::tables::three_digits;
use crate::candidates::GENERATED;

/// Derivatives: the function, the goal, ns, and what Pinocchio takes.
const DERIVATIVES: [(&str, f64, f64); 2] = [
    ("inverse_dynamics_derivatives", 150.0, 1000.0),
    ("forward_dynamics_derivatives", 350.0, 1500.0),
];

/// The section, from the lines of the native build.
pub(super) fn section(native: &Records) -> String {
    let mut text = format!("{INTRODUCTION}\n");
    for (function, goal, pinocchio) in DERIVATIVES {
        let time = native
            .time("puma560", function, GENERATED)
            .expect("measured");
        let time = marked(time, goal);
        writeln!(
            text,
            "- `{function}`: {time} / about {pinocchio:.0} / {goal:.0}"
        )
        .unwrap();
    }
    text + TRIED
}

/// A time that misses its goal by more than two hundredths is bold.
fn marked(time: f64, goal: f64) -> String {
    let digits = three_digits(time);
    if time > 1.02 * goal {
        format!("**{digits}**")
    } else {
        digits
    }
}

const INTRODUCTION: &str = "\
## Goals, and those that are missed

`benches/goals.sh` measures this part alone, in some minutes, and writes the tables below. The trial is what no
tool offers: as few inertial parameters as there are, CasADi, sines of libmvec with an error of up to 4 units
in the last place, `-Ofast`; `benches/rivals/elsewhere/trial_code.py` writes it, and it runs in turn with the
generated functions. It is not the strongest that is known: one that was measured elsewhere, on a machine of the
same kind, took 38 / 30 / 35 / 15 / 63 ns for tau, M, V, G and qdd of the PUMA 560 at one state and 9.8 / 6.2 /
7.8 / 4.7 / 13.6 ns a state in AVX-512 batches. Batches have 64 states, those of derivatives 1,024, by columns;
`f32` is timed in turns with `f64`, one core in turns with two.

<!-- goals on AVX-512 -->
<!-- end -->

<!-- goals on AVX2 -->
<!-- end -->

Derivatives of the PUMA 560, one state, native build, ns (time / Pinocchio / goal):
";

const TRIED: &str = "
What bounds the times. Six sines take 13 ns in the lanes of one register, most of it waiting; the rest is
bound by the multipliers, of which the processor has two: the PUMA's tau has 183 multiplications and
fused operations with its friction, the Panda's 292. In a batch each of the PUMA's four angles adds 21
to these, and it misses its goals by those: libmvec's sines take fewer operations for a larger error. What was
tried and did not help:

- other weights of multiplications and additions in the search for short programs than 3 to 2;
- the compiler's own vectorisation of the straight-line programs, on or off;
- two vectors of four doubles instead of one of eight for five to eight sines: 35 % longer;
- a scalar type that carries its sine, in place of `Configuration`;
- two vectors for each number of a batch: it saves as much waiting as it costs in registers;
- sines of one state with fewer operations: those of other libraries that take less time err by more than one
  unit in the last place, and a state waits for its sines, whatever their number of operations;
- lines in an order in which few numbers are kept ([TRIED.md](TRIED.md)).

What did help, in the order of its worth: sines in lanes without a detour through memory (69 to 13.5 ns
for six), sines of batches in 21 multiplications instead of 26, fused (four angles of eight states 4.4 instead of
6.1 ns a state on AVX-512, 7.0 instead of 8.8 on AVX2, errors up to 0.84 instead of 0.77 units in the last
place), a reduction of the angle in 14 operations instead of 25, base parameters and frames behind
their joints (docs/ARCHITECTURE.md), sums added in the order in which their terms are ready (7 % of a
Panda's M), a sign without a branch, and columns of a batch that are not copied.
";
