//! The numbers of C: what differs between double and single precision.

use super::super::{Language, free_name};
use super::WORDS;

/// The numbers of C, and their sines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CNumbers {
    /// `double`, with the sines of the C library.
    #[default]
    Double,
    /// `float`, with the sines of the runtime: the digits of Rust's `f32`, and no function of the C library but `expf`, where
    /// a joint has Stribeck's friction.
    Float,
    /// `float`, with `sinf` and `cosf` of the C library.
    FloatWithLibrary,
}

/// How functions of one kind of numbers are written.
pub(in super::super) struct Precision {
    pub(in super::super) language: Language,
    /// The type.
    pub(super) word: &'static str,
    /// The lines that stand at the top of a source.
    pub(in super::super) functions: &'static str,
    /// The last line of the title of a header.
    pub(super) convention: &'static str,
}

impl CNumbers {
    pub(in super::super) fn precision(self) -> &'static Precision {
        match self {
            CNumbers::Double => &DOUBLE,
            CNumbers::Float => &FLOAT,
            CNumbers::FloatWithLibrary => &FLOAT_WITH_LIBRARY,
        }
    }
}

const NOT_FINITE: &str = "Nothing is allocated, no state is kept. What depends on an input that is not finite is not finite.";

static DOUBLE: Precision = Precision {
    language: Language {
        sign: "robot_dynamics_sign",
        own_functions: &[
            ("robot_dynamics_sign(", SIGN),
            ("robot_dynamics_is_pivot(", IS_PIVOT),
        ],
        ..OF_C
    },
    word: "double",
    functions: FUNCTIONS,
    convention: NOT_FINITE,
};

static FLOAT: Precision = Precision {
    language: Language {
        sine: "robot_dynamics_sinf",
        cosine: "robot_dynamics_cosf",
        sine_and_cosine: Some(|sine, cosine, angle| {
            format!("float {sine}, {cosine}; robot_dynamics_sin_cosf({angle}, &{sine}, &{cosine});")
        }),
        own_functions: &[
            ("robot_dynamics_sinf(", SINES),
            ("robot_dynamics_cosf(", SINES),
            ("robot_dynamics_sin_cosf(", SINES),
            ("robot_dynamics_sinf(", SINE),
            ("robot_dynamics_cosf(", COSINE),
            ("ROBOT_DYNAMICS_EXPF(", EXPONENTIAL),
            ("robot_dynamics_signf(", FLOAT_SIGN),
            ("robot_dynamics_is_pivotf(", FLOAT_IS_PIVOT),
        ],
        ..OF_FLOAT
    },
    word: "float",
    functions: "",
    convention: "Nothing is allocated, no state is kept. Numbers are of single precision, sines are in the source.",
};

static FLOAT_WITH_LIBRARY: Precision = Precision {
    language: OF_FLOAT,
    word: "float",
    functions: FLOAT_FUNCTIONS,
    convention: "Nothing is allocated, no state is kept. Numbers are of single precision.",
};

const OF_C: Language = Language {
    declare: |name, value| format!("const double {name} = {value};"),
    entry: |argument, i| format!("{argument}[{i}]"),
    number: |x| format!("{x:?}"),
    is_single: false,
    times: " * ",
    over: " / ",
    field: |field| format!("arm->{}", free_name(field, WORDS)),
    sine: "ROBOT_DYNAMICS_SIN",
    cosine: "ROBOT_DYNAMICS_COS",
    sine_and_cosine: None,
    exponential: "ROBOT_DYNAMICS_EXP",
    sign: "",
    test_pivot: |joint, pivot, diagonal| {
        let number = joint + 1;
        format!("if (!robot_dynamics_is_pivot({pivot}, {diagonal})) return {number};")
    },
    own_functions: &[],
};

const OF_FLOAT: Language = Language {
    declare: |name, value| format!("const float {name} = {value};"),
    number: single,
    is_single: true,
    sine: "ROBOT_DYNAMICS_SINF",
    cosine: "ROBOT_DYNAMICS_COSF",
    exponential: "ROBOT_DYNAMICS_EXPF",
    sign: "robot_dynamics_signf",
    test_pivot: |joint, pivot, diagonal| {
        let number = joint + 1;
        format!("if (!robot_dynamics_is_pivotf({pivot}, {diagonal})) return {number};")
    },
    own_functions: &[
        ("robot_dynamics_signf(", FLOAT_SIGN),
        ("robot_dynamics_is_pivotf(", FLOAT_IS_PIVOT),
    ],
    ..OF_C
};

/// A literal of the nearest single. Beyond the largest one it is infinite, as in Rust.
fn single(x: f64) -> String {
    let single = x as f32;
    if single.is_finite() {
        format!("{single:?}f")
    } else {
        let sign = if single < 0.0 { "-" } else { "" };
        format!("({sign}1.0f / 0.0f)")
    }
}

/// Sine, cosine and exponential may be others than those of the C library.
const FUNCTIONS: &str = "\
#include <math.h>

#ifndef ROBOT_DYNAMICS_SIN
#define ROBOT_DYNAMICS_SIN sin
#endif
#ifndef ROBOT_DYNAMICS_COS
#define ROBOT_DYNAMICS_COS cos
#endif
#ifndef ROBOT_DYNAMICS_EXP
#define ROBOT_DYNAMICS_EXP exp
#endif
";

const FLOAT_FUNCTIONS: &str = "\
#include <math.h>

#ifndef ROBOT_DYNAMICS_SINF
#define ROBOT_DYNAMICS_SINF sinf
#endif
#ifndef ROBOT_DYNAMICS_COSF
#define ROBOT_DYNAMICS_COSF cosf
#endif
#ifndef ROBOT_DYNAMICS_EXPF
#define ROBOT_DYNAMICS_EXPF expf
#endif
";

const EXPONENTIAL: &str = "
#include <math.h>

#ifndef ROBOT_DYNAMICS_EXPF
#define ROBOT_DYNAMICS_EXPF expf
#endif
";

const SINES: &str = include_str!("sines.c");

const SINE: &str = "
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_sinf(float x)
{
    float sine, cosine;
    robot_dynamics_sin_cosf(x, &sine, &cosine);
    return sine;
}
";

const COSINE: &str = "
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_cosf(float x)
{
    float sine, cosine;
    robot_dynamics_sin_cosf(x, &sine, &cosine);
    return cosine;
}
";

const SIGN: &str = "
/** The sign, 0 of zero; NaN of NaN. */
ROBOT_DYNAMICS_DEVICE static double robot_dynamics_sign(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x == 0.0 ? 0.0 : x;
}
";

const FLOAT_SIGN: &str = "
/** The sign, 0 of zero; NaN of NaN. */
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_signf(float x)
{
    return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : x == 0.0f ? 0.0f : x;
}
";

const IS_PIVOT: &str = "
/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
ROBOT_DYNAMICS_DEVICE static int robot_dynamics_is_pivot(double pivot, double diagonal)
{
    const double rounding = diagonal * 2.220446049250313e-16 * 8.0;
    return pivot - rounding > 0.0 && pivot + rounding > 0.0;
}
";

const FLOAT_IS_PIVOT: &str = "
/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
ROBOT_DYNAMICS_DEVICE static int robot_dynamics_is_pivotf(float pivot, float diagonal)
{
    const float rounding = diagonal * 1.1920929e-7f * 8.0f;
    return pivot - rounding > 0.0f && pivot + rounding > 0.0f;
}
";
