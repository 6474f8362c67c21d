//! The times that the project has set itself, and which of them are missed.

use std::fmt::Write;

use super::records::Records;
use super::tables::three_digits;
use crate::measure::GENERATED;

/// Arm, then for tau, M, V, G and qdd the strongest trial known and the goal, ns.
type Goals = (&'static str, [[f64; 2]; 5]);

const UNKNOWN: f64 = f64::NAN;

const SINGLE: [Goals; 5] = [
    (
        "two_link_saha",
        [
            [14.8, 10.0],
            [UNKNOWN, 6.0],
            [UNKNOWN, 6.0],
            [13.2, 9.0],
            [16.0, 12.0],
        ],
    ),
    (
        "stanford",
        [
            [35.0, 28.0],
            [27.0, 22.0],
            [31.0, 25.0],
            [16.0, 13.0],
            [60.0, 48.0],
        ],
    ),
    (
        "puma560",
        [
            [38.0, 30.0],
            [30.0, 24.0],
            [35.0, 28.0],
            [15.0, 12.0],
            [63.0, 50.0],
        ],
    ),
    (
        "ur5",
        [
            [UNKNOWN, 30.0],
            [UNKNOWN, 24.0],
            [UNKNOWN, 28.0],
            [UNKNOWN, 11.0],
            [UNKNOWN, 50.0],
        ],
    ),
    (
        "panda",
        [
            [58.0, 46.0],
            [43.0, 34.0],
            [56.0, 45.0],
            [33.0, 24.0],
            [105.0, 84.0],
        ],
    ),
];

const BATCHES: [Goals; 2] = [
    (
        "puma560",
        [[9.8, 7.8], [6.2, 5.0], [7.8, 6.2], [4.7, 3.8], [13.6, 10.9]],
    ),
    (
        "panda",
        [
            [15.9, 12.7],
            [12.8, 10.2],
            [12.7, 10.2],
            [7.2, 5.8],
            [23.8, 19.0],
        ],
    ),
];

/// Derivatives: the function, the goal, ns, and what Pinocchio takes.
const DERIVATIVES: [(&str, f64, f64); 2] = [
    ("inverse_dynamics_derivatives", 150.0, 1000.0),
    ("forward_dynamics_derivatives", 350.0, 1500.0),
];

/// The section, from the lines of the native build.
pub(super) fn section(native: &Records) -> String {
    let mut text = format!("{INTRODUCTION}\n");
    table(&mut text, native, &SINGLE, "");
    writeln!(text, "\nBatches, a state:\n").unwrap();
    table(&mut text, native, &BATCHES, "_batch");
    writeln!(
        text,
        "\nDerivatives of the PUMA 560 (time / Pinocchio / goal):\n"
    )
    .unwrap();
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

fn table(text: &mut String, native: &Records, goals: &[Goals], suffix: &str) {
    writeln!(
        text,
        "| arm | tau | M | V | G | qdd |\n|---|---|---|---|---|---|"
    )
    .unwrap();
    for (arm, goals) in goals {
        write!(text, "| {arm} |").unwrap();
        for (function, [trial, goal]) in crate::measure::FUNCTIONS.iter().zip(goals) {
            let function = format!("{function}{suffix}");
            let time = native.time(arm, &function, GENERATED).expect("measured");
            let trial = if trial.is_nan() {
                "–".into()
            } else {
                three_digits(*trial)
            };
            let (time, goal) = (marked(time, *goal), three_digits(*goal));
            write!(text, " {time} / {trial} / {goal} |").unwrap();
        }
        text.push('\n');
    }
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

Native build, ns: the time / the strongest trial that is known / the goal, a fifth below it. A trial is
minimal parameters, CasADi, a vectorised sine with a larger error and `clang -Ofast`, measured on a
machine of the same kind; no tool offers it. Missed goals are bold.
";

const TRIED: &str = "
What bounds the times. Six sines take 13 ns in the lanes of one register, most of it waiting; the rest is
bound by the multipliers, of which the processor has two: the PUMA's tau has 183 multiplications and
fused operations with its friction, the Panda's 292. In a batch each of the PUMA's four angles adds 26
to these; at one multiplication of eight doubles in a cycle tau takes at least 36 cycles a state, some 10 ns
of those measured. A goal below that asks for a sine with fewer multiplications. What was tried and did
not help:

- other weights of multiplications and additions in the search for short programs than 3 to 2;
- the compiler's own vectorisation of the straight-line programs, on or off;
- two vectors of four doubles instead of one of eight for five to eight sines: 35 % longer;
- a scalar type that carries its sine, in place of `Configuration`;
- two vectors for each number of a batch: it saves as much waiting as it costs in registers;
- sines with fewer operations: those of other libraries that take less time err by more than one unit in
  the last place.

What did help, in the order of its worth: sines in lanes without a detour through memory (69 to 13.5 ns
for six), a reduction of the angle in 14 operations instead of 25, base parameters and frames behind
their joints (docs/ARCHITECTURE.md), sums added in the order in which their terms are ready (7 % of a
Panda's M), a sign without a branch, and columns of a batch that are not copied.
";
