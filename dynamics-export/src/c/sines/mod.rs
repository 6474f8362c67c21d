//! The sines of the runtime, with the same digits (`dynamics-runtime/src/sine`): no operation of theirs is fused.
//!
//! The texts are those of C, with words in the place of what differs: REAL and WORD are a number and its bits, and @ is
//! how many of them are in the lanes of a vector.

use crate::syntax::Angle;
use core::fmt::Write as _;

/// The sines of one precision.
pub(super) struct Sines {
    pub(super) real: &'static str,
    pub(super) word: &'static str,
    /// The place of the bit of the sign.
    sign: &'static str,
    zero: &'static str,
    /// The largest magnitude that is not reduced in integers, and the largest of all.
    largest: &'static str,
    /// The square of the largest.
    square: &'static str,
    finite: &'static str,
    /// The lanes that hold 1, 2, 3 and 4 angles.
    widths: [usize; 4],
    /// The processors, as a condition of the preprocessor, that have eight lanes and gain by them.
    eight: &'static str,
    /// The reduction of an angle, and the polynomials.
    kernel: &'static str,
    large: &'static str,
}

pub(super) static DOUBLE: Sines = Sines {
    real: "double",
    word: "uint64_t",
    sign: "63",
    zero: "0.0",
    largest: "1e5",
    square: "1e10",
    finite: "1.7976931348623157e308",
    widths: [1, 2, 4, 4],
    // On Intel's processors, which have no SSE4a, an instruction of 512 bits takes both units that multiply.
    eight: "defined(__AVX512F__) && defined(__SSE4A__)",
    kernel: include_str!("double.c"),
    large: include_str!("large_double.c"),
};

pub(super) static SINGLE: Sines = Sines {
    real: "float",
    word: "uint32_t",
    sign: "31",
    zero: "0.0f",
    largest: "1e4f",
    square: "1e8f",
    finite: "3.4028235e38f",
    widths: [1, 4, 4, 4],
    eight: "defined(__AVX__)",
    kernel: include_str!("single.c"),
    large: include_str!("large_single.c"),
};

const HEAD: &str = include_str!("head.c");

impl Sines {
    /// The statements that give sines and cosines their names: up to eight angles are evaluated at once.
    pub(super) fn statements(&self, angles: &[Angle]) -> Vec<String> {
        let groups = angles.chunks(8).enumerate();
        groups
            .flat_map(|(group, angles)| self.of_group(2 * group + 1, angles))
            .collect()
    }

    /// The statements of up to eight angles: sines and cosines of the first four are in vectors of one number, those of
    /// the others in vectors of the next one.
    fn of_group(&self, number: usize, angles: &[Angle]) -> Vec<String> {
        if let [angle] = angles {
            return vec![self.of_one(angle)];
        }
        let halves = || (number..).zip(angles.chunks(4));
        let vectors = halves().map(|(number, half)| {
            let width = self.width_of(half.len().max(2));
            format!("robot_dynamics_{width} sines_{number}, cosines_{number};")
        });
        let values = angles.iter().map(|angle| angle.value.clone());
        let results = halves().map(|(number, _)| format!("&sines_{number}, &cosines_{number}"));
        let arguments: Vec<_> = values.chain(results).collect();
        let (count, arguments) = (angles.len(), arguments.join(", "));
        let call = format!("robot_dynamics_sin_cos_{count}({arguments});");
        let names = halves().flat_map(|(number, half)| self.names_of_lanes(number, half));
        vectors.chain([call]).chain(names).collect()
    }

    /// The statements that give the lanes of the vectors of one number their names.
    fn names_of_lanes(&self, number: usize, angles: &[Angle]) -> Vec<String> {
        let real = self.real;
        let of_lane = |(lane, angle): (usize, &Angle)| {
            let named = [
                ("sines", angle.sine.clone()),
                ("cosines", angle.cosine.clone()),
            ];
            named.map(|(vector, name)| {
                Some(format!(
                    "const {real} {} = {vector}_{number}[{lane}];",
                    name?
                ))
            })
        };
        let statements = angles.iter().enumerate().flat_map(of_lane);
        statements.flatten().collect()
    }

    fn of_one(
        &self,
        Angle {
            value,
            sine,
            cosine,
        }: &Angle,
    ) -> String {
        let real = self.real;
        match (sine, cosine) {
            (Some(sine), Some(cosine)) => format!(
                "{real} {sine}, {cosine}; robot_dynamics_sin_cos_1({value}, &{sine}, &{cosine});"
            ),
            (Some(name), None) => format!("const {real} {name} = robot_dynamics_sin({value});"),
            (_, name) => {
                let name = name.as_deref().unwrap_or_default();
                format!("const {real} {name} = robot_dynamics_cos({value});")
            }
        }
    }

    /// The functions that the bodies call, and those that these need.
    pub(super) fn functions(&self, bodies: &str) -> String {
        let is_called = |name: &str| bodies.contains(&format!("robot_dynamics_{name}("));
        let groups = self.groups_of(|count| is_called(&format!("sin_cos_{count}")));
        let parts: Vec<_> = PARTS.iter().filter(|part| is_called(part.name)).collect();
        let has_columns = is_called("sin_cos_column");
        if groups.is_empty() && parts.is_empty() && !has_columns {
            return String::new();
        }
        let mut text = HEAD.to_owned();
        if !groups.is_empty() {
            text.push_str(include_str!("vectors.c"));
        }
        text.push_str(&self.kernel_of(1));
        text.push_str(self.large);
        text.push_str(include_str!("any.c"));
        for part in parts {
            text.push_str(&part.text());
        }
        if has_columns {
            text.push_str(include_str!("column.c"));
        }
        let mut last = 1;
        for count in groups {
            let width = self.width_of(count);
            if width > last {
                text.push_str(&self.lanes(width));
            }
            last = width;
            text.push_str(&self.group(count));
        }
        self.in_words_of(&text)
    }

    /// The kernel in so many lanes.
    fn kernel_of(&self, lanes: usize) -> String {
        let text = self.kernel.to_owned() + include_str!("both.c");
        let text = text.replace('@', &lanes.to_string());
        if lanes == 1 {
            return text;
        }
        let [real, word] = [
            format!("robot_dynamics_{lanes}"),
            format!("robot_dynamics_bits_{lanes}"),
        ];
        text.replace("REAL", &real).replace("WORD", &word)
    }

    /// The numbers of angles that are evaluated at once, those of both halves of more than four among them.
    fn groups_of(&self, is_called: impl Fn(usize) -> bool) -> Vec<usize> {
        let is_half = |count: usize| {
            let mut wholes = (5..=8).filter(|whole| count == 4 || count == in_second_half(*whole));
            wholes.any(&is_called)
        };
        (1..=8)
            .filter(|count| is_called(*count) || (*count <= 4 && is_half(*count)))
            .collect()
    }

    /// The lanes that so many angles are in.
    fn width_of(&self, count: usize) -> usize {
        self.widths.get(count - 1).copied().unwrap_or(8)
    }

    /// The vectors of so many lanes and their kernel. Four lanes and less are arrays where the compiler has no vectors.
    fn lanes(&self, lanes: usize) -> String {
        let bytes = lanes * if self.sign == "63" { 8 } else { 4 };
        let kernel = self.kernel_of(lanes);
        let types = format!(
            "typedef REAL robot_dynamics_{lanes} __attribute__((vector_size({bytes})));\n\
             typedef WORD robot_dynamics_bits_{lanes} __attribute__((vector_size({bytes})));\n"
        );
        if lanes == 8 {
            let eight = self.eight;
            return format!(
                "\n#if defined(ROBOT_DYNAMICS_VECTORS) && {eight}\n#define ROBOT_DYNAMICS_EIGHT\n\
                 {types}{kernel}#endif\n"
            );
        }
        format!(
            "\n#ifdef ROBOT_DYNAMICS_VECTORS\n{types}{kernel}\
             #else\ntypedef REAL robot_dynamics_{lanes}[{lanes}];\n#endif\n"
        )
    }

    /// The function of so many angles in lanes.
    fn group(&self, count: usize) -> String {
        match count {
            1 => include_str!("one.c").to_owned(),
            2..=4 => self.of_up_to_four(count),
            _ => self.of_up_to_eight(count),
        }
    }

    fn of_up_to_four(&self, count: usize) -> String {
        let (names, width) = (&NAMES[..count], self.width_of(count));
        let mut text = self.head_of_group(
            count,
            &format!("robot_dynamics_{width} *sines, robot_dynamics_{width} *cosines"),
        );
        let _ = write!(
            text,
            "    REAL sine, cosine;\n#ifdef ROBOT_DYNAMICS_VECTORS\n    if ({}) {{\n        \
             const robot_dynamics_{width} x = {{{}}};\n        \
             robot_dynamics_sin_cos_of_{width}(&x, sines, cosines);\n        return;\n    }}\n#endif\n",
            are_usual(names),
            in_lanes(names, width),
        );
        for (lane, name) in names.iter().enumerate() {
            let _ = write!(
                text,
                "    robot_dynamics_sin_cos({name}, &sine, &cosine);\n    \
                 (*sines)[{lane}] = sine;\n    (*cosines)[{lane}] = cosine;\n"
            );
        }
        text + "}\n"
    }

    /// Two halves: the first four angles, and the others.
    fn of_up_to_eight(&self, count: usize) -> String {
        let names = &NAMES[..count];
        let others = in_second_half(count);
        let width = self.width_of(others);
        let results = format!(
            "robot_dynamics_4 *sines, robot_dynamics_4 *cosines, \
             robot_dynamics_{width} *other_sines, robot_dynamics_{width} *other_cosines"
        );
        let half = |vector: &str, from: usize, lanes: usize| {
            let lanes: Vec<_> = (from..from + lanes)
                .map(|lane| format!("{vector}[{lane}]"))
                .collect();
            format!("(robot_dynamics_{}){{{}}}", lanes.len(), lanes.join(", "))
        };
        let (first, last) = (names[..4].join(", "), in_lanes(&names[4..], others));
        self.head_of_group(count, &results)
            + &format!(
                "#ifdef ROBOT_DYNAMICS_EIGHT\n    if ({}) {{\n        \
                 const robot_dynamics_8 x = {{{}}};\n        robot_dynamics_8 s, c;\n        \
                 robot_dynamics_sin_cos_of_8(&x, &s, &c);\n        \
                 *sines = {};\n        *cosines = {};\n        *other_sines = {};\n        *other_cosines = {};\n        \
                 return;\n    }}\n#endif\n    robot_dynamics_sin_cos_4({first}, sines, cosines);\n    \
                 robot_dynamics_sin_cos_{others}({last}, other_sines, other_cosines);\n}}\n",
                are_usual(names),
                in_lanes(names, 8),
                half("s", 0, 4),
                half("c", 0, 4),
                half("s", 4, width),
                half("c", 4, width),
            )
    }

    fn head_of_group(&self, count: usize, results: &str) -> String {
        let parameters: Vec<_> = NAMES[..count].iter().map(|x| format!("REAL {x}")).collect();
        format!(
            "\n/** Sines and cosines of {count} angles. */\n\
             ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_{count}({}, {results})\n{{\n",
            parameters.join(", ")
        )
    }

    fn in_words_of(&self, text: &str) -> String {
        let words = [
            ("REAL", self.real),
            ("WORD", self.word),
            ("SIGN", self.sign),
            ("ZERO", self.zero),
            ("LARGEST", self.largest),
            ("SQUARE", self.square),
            ("FINITE", self.finite),
        ];
        words
            .iter()
            .fold(text.to_owned(), |text, (word, own)| text.replace(word, own))
    }
}

/// The names of the angles of a function of several.
const NAMES: [&str; 8] = ["a", "b", "c", "d", "e", "f", "g", "h"];

/// How many of more than four angles the second half has: one that is alone has a partner that is zero.
fn in_second_half(count: usize) -> usize {
    (count - 4).max(2)
}

/// Whether the sum of their squares says that no angle is larger than the largest: it says so of no infinite one, nor of
/// what is no number. Large angles that are usual all the same have the digits of one by one.
fn are_usual(names: &[&str]) -> String {
    let (last, others) = names.split_last().expect("an angle");
    let add = |sum: String, x: &&str| format!("ROBOT_DYNAMICS_FMA({x}, {x}, {sum})");
    let sum = others.iter().rev().fold(format!("{last} * {last}"), add);
    format!("{sum} < SQUARE")
}

/// The angles in so many lanes.
fn in_lanes(names: &[&str], width: usize) -> String {
    let zeros = vec!["ZERO"; width - names.len()];
    [names, &zeros].concat().join(", ")
}

/// The sine alone, or the cosine alone.
struct Part {
    name: &'static str,
    value: &'static str,
    /// Whether n is odd where what is left of the angle has this part as its sine.
    parity: &'static str,
    turn: &'static str,
}

const PARTS: [Part; 2] = [
    Part {
        name: "sin",
        value: "sine",
        parity: "0u",
        turn: "(turns.bits >> 1)",
    },
    Part {
        name: "cos",
        value: "cosine",
        parity: "1u",
        turn: "(turns.bits ^ turns.bits >> 1)",
    },
];

impl Part {
    fn text(&self) -> String {
        let words = [
            ("PARITY", self.parity),
            ("TURN", self.turn),
            ("NAME", self.name),
            ("PART", self.value),
        ];
        let part = include_str!("part.c").to_owned();
        words
            .iter()
            .fold(part, |text, (word, own)| text.replace(word, own))
    }
}
