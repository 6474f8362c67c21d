//! The numbers of C: what differs between double and single precision.

use super::WORDS;
use super::sines::{self, Sines};
use crate::names::free_name;
use crate::syntax::Syntax;

/// The numbers of C, and their sines: those of the runtime, which are in the source and have the digits of Rust, or those
/// of the C library.
///
/// Nothing else of the C library is called but the exponential, where a joint has Stribeck's friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CNumbers {
    /// `double`, with the sines of the runtime.
    #[default]
    Double,
    /// `double`, with `sin` and `cos` of the C library.
    DoubleWithLibrary,
    /// `float`, with the sines of the runtime, and no operation in double precision.
    Float,
    /// `float`, with `sinf` and `cosf` of the C library.
    FloatWithLibrary,
}

/// How functions of one kind of numbers are written.
pub(crate) struct Precision {
    pub(crate) syntax: Syntax,
    /// The type.
    pub(crate) word: &'static str,
    /// The unsigned integer of as many bytes.
    pub(super) unsigned: &'static str,
    /// The function that multiplies and adds.
    fused: &'static str,
    /// The sines that stand in the source.
    pub(super) sines: Option<&'static Sines>,
    /// The functions of the C library: by which call, and what stands at the top of a source.
    library: &'static [(&'static str, &'static str)],
    /// The lines about digits in the title of a header.
    pub(super) digits: &'static [&'static str],
}

impl CNumbers {
    /// The numbers of a precision, with the sines of the C library or with those of the runtime.
    pub fn new(is_single: bool, has_library: bool) -> Self {
        match (is_single, has_library) {
            (false, false) => CNumbers::Double,
            (false, true) => CNumbers::DoubleWithLibrary,
            (true, false) => CNumbers::Float,
            (true, true) => CNumbers::FloatWithLibrary,
        }
    }

    pub(crate) fn precision(self) -> &'static Precision {
        match self {
            CNumbers::Double => &DOUBLE,
            CNumbers::DoubleWithLibrary => &DOUBLE_WITH_LIBRARY,
            CNumbers::Float => &FLOAT,
            CNumbers::FloatWithLibrary => &FLOAT_WITH_LIBRARY,
        }
    }
}

impl Precision {
    /// The text above the functions whose texts are given: the functions that they call.
    pub(crate) fn functions(&self, bodies: &str) -> String {
        let library = self.library.iter();
        let library = library.filter(|(call, _)| bodies.contains(call));
        let mut library: Vec<&str> = library.map(|(_, text)| *text).collect();
        if !library.is_empty() {
            library.insert(0, "\n#include <math.h>\n");
        }
        let contraction = CONTRACTION
            .replace("ONE", &(self.syntax.number)(1.0))
            .replace("WORD", self.word);
        let sines = self.sines.map(|sines| sines.functions(bodies));
        let sines = sines.unwrap_or_default();
        let has = |macro_name| bodies.contains(macro_name) || sines.contains(macro_name);
        let fused = has("ROBOT_DYNAMICS_FMA(").then(|| FUSED.replace("BUILTIN", self.fused));
        let lanes = has("ROBOT_DYNAMICS_LANES").then_some(LANES);
        let own = self.syntax.called(bodies);
        library.concat()
            + &contraction
            + &fused.unwrap_or_default()
            + lanes.unwrap_or_default()
            + &sines
            + &own
    }

    /// A text in which numbers are REAL, and literals have a point, in this precision.
    pub(crate) fn text(&self, text: &str) -> String {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
        let (mut written, mut rest) = (String::new(), text);
        while let Some(start) = rest.find(is_part) {
            let (before, word) = rest.split_at(start);
            let (word, behind) = word.split_at(word.find(|c| !is_part(c)).unwrap_or(word.len()));
            let number = word.parse().ok().filter(|_| word.contains('.'));
            let word = if word == "REAL" { self.word } else { word };
            written += before;
            written += &number.map_or(word.to_owned(), self.syntax.number);
            rest = behind;
        }
        written + rest
    }
}

const CONTRACTION: &str = include_str!("contraction.c");

const FUSED: &str = include_str!("fused.c");

const LANES: &str = include_str!("lanes.c");

const DOUBLE: Precision = Precision {
    syntax: Syntax {
        of_angles: Some(|angles| sines::DOUBLE.statements(angles)),
        ..OF_DOUBLE
    },
    sines: Some(&sines::DOUBLE),
    digits: SAME_DIGITS,
    ..DOUBLE_WITH_LIBRARY
};

const DOUBLE_WITH_LIBRARY: Precision = Precision {
    syntax: OF_DOUBLE,
    word: "double",
    unsigned: "uint64_t",
    fused: "__builtin_fma",
    sines: None,
    library: &[
        ("ROBOT_DYNAMICS_SIN(", SIN),
        ("ROBOT_DYNAMICS_COS(", COS),
        ("ROBOT_DYNAMICS_EXP(", EXP),
        ("ROBOT_DYNAMICS_SQRT(", SQRT),
    ],
    digits: OTHER_DIGITS,
};

const FLOAT: Precision = Precision {
    syntax: Syntax {
        of_angles: Some(|angles| sines::SINGLE.statements(angles)),
        ..OF_FLOAT
    },
    sines: Some(&sines::SINGLE),
    digits: SAME_DIGITS,
    ..FLOAT_WITH_LIBRARY
};

const FLOAT_WITH_LIBRARY: Precision = Precision {
    syntax: OF_FLOAT,
    word: "float",
    unsigned: "uint32_t",
    fused: "__builtin_fmaf",
    sines: None,
    library: &[
        ("ROBOT_DYNAMICS_SINF(", SINF),
        ("ROBOT_DYNAMICS_COSF(", COSF),
        ("ROBOT_DYNAMICS_EXPF(", EXPF),
        ("ROBOT_DYNAMICS_SQRTF(", SQRTF),
    ],
    digits: OTHER_DIGITS,
};

const SAME_DIGITS: &[&str] = &[
    "Sines are in the source. Values have the digits of Rust's in a build for the same processor, whatever the compiler",
    "and its level: products are fused with sums where Rust fuses them, if the processor has an instruction for it. That is",
    "so of gcc and clang. -ffast-math, /fp:fast and the registers of an x87 are refused. It is not so of an exponential",
    "(Stribeck's friction), which is the C library's, and of what depends on it.",
];

const OTHER_DIGITS: &[&str] =
    &["Sines are those of the C library: values differ from Rust's in their last places."];

const OF_DOUBLE: Syntax = Syntax {
    declare: |name, value| format!("const double {name} = {value};"),
    entry: |argument, i| format!("{argument}[{i}]"),
    number: |x| format!("{x:?}"),
    is_single: false,
    times: " * ",
    over: " / ",
    field: |field| format!("arm->{}", free_name(field, WORDS)),
    sine: "ROBOT_DYNAMICS_SIN",
    cosine: "ROBOT_DYNAMICS_COS",
    of_angles: None,
    fused: Some("ROBOT_DYNAMICS_FMA"),
    exponential: "ROBOT_DYNAMICS_EXP",
    sign: "robot_dynamics_sign",
    test_pivot: |joint, pivot, diagonal| {
        let number = joint + 1;
        format!("if (!robot_dynamics_is_pivot({pivot}, {diagonal})) return {number};")
    },
    own_functions: &[
        ("robot_dynamics_sign(", SIGN),
        ("robot_dynamics_is_pivot(", IS_PIVOT),
        ("robot_dynamics_nan(", NAN),
    ],
};

const OF_FLOAT: Syntax = Syntax {
    declare: |name, value| format!("const float {name} = {value};"),
    number: single,
    is_single: true,
    sine: "ROBOT_DYNAMICS_SINF",
    cosine: "ROBOT_DYNAMICS_COSF",
    exponential: "ROBOT_DYNAMICS_EXPF",
    own_functions: &[
        ("robot_dynamics_sign(", FLOAT_SIGN),
        ("robot_dynamics_is_pivot(", FLOAT_IS_PIVOT),
        ("robot_dynamics_nan(", FLOAT_NAN),
    ],
    ..OF_DOUBLE
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

// The functions of the C library may be replaced by others.
const SIN: &str = "\n#ifndef ROBOT_DYNAMICS_SIN\n#define ROBOT_DYNAMICS_SIN sin\n#endif\n";
const COS: &str = "\n#ifndef ROBOT_DYNAMICS_COS\n#define ROBOT_DYNAMICS_COS cos\n#endif\n";
const EXP: &str = "\n#ifndef ROBOT_DYNAMICS_EXP\n#define ROBOT_DYNAMICS_EXP exp\n#endif\n";
const SQRT: &str = "\n#ifndef ROBOT_DYNAMICS_SQRT\n#define ROBOT_DYNAMICS_SQRT sqrt\n#endif\n";
const SINF: &str = "\n#ifndef ROBOT_DYNAMICS_SINF\n#define ROBOT_DYNAMICS_SINF sinf\n#endif\n";
const COSF: &str = "\n#ifndef ROBOT_DYNAMICS_COSF\n#define ROBOT_DYNAMICS_COSF cosf\n#endif\n";
const EXPF: &str = "\n#ifndef ROBOT_DYNAMICS_EXPF\n#define ROBOT_DYNAMICS_EXPF expf\n#endif\n";
const SQRTF: &str = "\n#ifndef ROBOT_DYNAMICS_SQRTF\n#define ROBOT_DYNAMICS_SQRTF sqrtf\n#endif\n";

const SIGN: &str = "
/** The sign, 0 of zero; NaN of NaN. */
ROBOT_DYNAMICS_DEVICE static double robot_dynamics_sign(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x >= 0.0 ? 0.0 : x;
}
";

const FLOAT_SIGN: &str = "
/** The sign, 0 of zero; NaN of NaN. */
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_sign(float x)
{
    return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : x >= 0.0f ? 0.0f : x;
}
";

const IS_PIVOT: &str = "
/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
ROBOT_DYNAMICS_DEVICE static int robot_dynamics_is_pivot(double pivot, double diagonal)
{
    const double rounding = diagonal * 1.7763568394002505e-15;
    return (pivot > rounding) & (pivot > -rounding);
}
";

const FLOAT_IS_PIVOT: &str = "
/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
ROBOT_DYNAMICS_DEVICE static int robot_dynamics_is_pivot(float pivot, float diagonal)
{
    const float rounding = diagonal * 9.536743e-7f;
    return (pivot > rounding) & (pivot > -rounding);
}
";

const NAN: &str = "
ROBOT_DYNAMICS_DEVICE static double robot_dynamics_nan(void)
{
    const double zero = 0.0;
    return zero / zero;
}
";

const FLOAT_NAN: &str = "
ROBOT_DYNAMICS_DEVICE static float robot_dynamics_nan(void)
{
    const float zero = 0.0f;
    return zero / zero;
}
";
