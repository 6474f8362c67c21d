//! The sines of the runtime, with the same digits (`dynamics-runtime/src/sine`): no operation of theirs is fused.
//!
//! The texts are those of C, with words in the place of what differs: REAL and WORD are a number and its bits, and @ is
//! how many of them are in the lanes of a vector.

use super::super::body::Angle;
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
    finite: &'static str,
    /// The lanes that hold 1, 2, 3 and 4 angles.
    widths: [usize; 4],
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
    finite: "1.7976931348623157e308",
    widths: [1, 2, 4, 4],
    kernel: include_str!("double.c"),
    large: include_str!("large_double.c"),
};

pub(super) static SINGLE: Sines = Sines {
    real: "float",
    word: "uint32_t",
    sign: "31",
    zero: "0.0f",
    largest: "1e4f",
    finite: "3.4028235e38f",
    widths: [1, 4, 4, 4],
    kernel: include_str!("single.c"),
    large: include_str!("large_single.c"),
};

const HEAD: &str = include_str!("head.c");

impl Sines {
    /// The statements that give sines and cosines their names: up to four angles are evaluated at once.
    pub(super) fn statements(&self, angles: &[Angle]) -> Vec<String> {
        let real = self.real;
        if let [angle] = angles {
            return vec![self.of_one(angle)];
        }
        let mut statements = Vec::new();
        for (group, angles) in (1..).zip(angles.chunks(4)) {
            let (count, width) = (angles.len(), self.widths[angles.len() - 1]);
            if let [angle] = angles {
                statements.push(self.of_one(angle));
                continue;
            }
            let values: Vec<_> = angles.iter().map(|angle| angle.value.as_str()).collect();
            let values = values.join(", ");
            statements.push(format!(
                "robot_dynamics_{width} sines_{group}, cosines_{group};"
            ));
            statements.push(format!(
                "robot_dynamics_sin_cos_{count}({values}, &sines_{group}, &cosines_{group});"
            ));
            for (lane, angle) in angles.iter().enumerate() {
                let named = [("sines", &angle.sine), ("cosines", &angle.cosine)];
                let named = named
                    .into_iter()
                    .filter_map(|(of, name)| Some((of, name.as_ref()?)));
                statements.extend(
                    named.map(|(of, name)| format!("const {real} {name} = {of}_{group}[{lane}];")),
                );
            }
        }
        statements
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
        let groups: Vec<_> = (1..=4)
            .filter(|n| is_called(&format!("sin_cos_{n}")))
            .collect();
        let parts: Vec<_> = PARTS.iter().filter(|part| is_called(part.name)).collect();
        let has_columns = is_called("sin_cos_column");
        if groups.is_empty() && parts.is_empty() && !has_columns {
            return String::new();
        }
        let mut text = HEAD.to_owned();
        text.push_str(self.large);
        text.push_str(&self.kernel_of(1));
        text.push_str(include_str!("any.c"));
        for part in parts {
            text.push_str(&part.text());
        }
        if has_columns {
            text.push_str(include_str!("column.c"));
        }
        let mut last = 1;
        for &count in &groups {
            let width = self.widths[count - 1];
            if width > last {
                text.push_str(&self.lanes(width));
            }
            last = width;
            text.push_str(&self.group(count, width));
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

    /// The vectors of so many lanes, which are arrays where the compiler has none, and their kernel.
    fn lanes(&self, lanes: usize) -> String {
        let bytes = lanes * if self.sign == "63" { 8 } else { 4 };
        let kernel = self.kernel_of(lanes);
        format!(
            "\n#ifdef ROBOT_DYNAMICS_VECTORS\n\
             typedef REAL robot_dynamics_{lanes} __attribute__((vector_size({bytes})));\n\
             typedef WORD robot_dynamics_bits_{lanes} __attribute__((vector_size({bytes})));\n{kernel}\
             #else\ntypedef REAL robot_dynamics_{lanes}[{lanes}];\n#endif\n"
        )
    }

    /// The function of so many angles in lanes.
    fn group(&self, count: usize, width: usize) -> String {
        if count == 1 {
            return include_str!("one.c").to_owned();
        }
        let names = &["a", "b", "c", "d"][..count];
        let each = |write: fn(&&str) -> String| names.iter().map(write).collect::<Vec<_>>();
        let parameters = each(|x| format!("REAL {x}")).join(", ");
        let usual = each(|x| format!("ROBOT_DYNAMICS_IS_USUAL({x})")).join(" && ");
        let zeros = vec!["ZERO"; width - count];
        let lanes = [names, &zeros].concat().join(", ");
        let mut text = format!(
            "\n/** Sines and cosines of {count} angles. */\n\
             ROBOT_DYNAMICS_INLINE void robot_dynamics_sin_cos_{count}({parameters}, \
             robot_dynamics_{width} *sines, robot_dynamics_{width} *cosines)\n{{\n    REAL sine, cosine;\n\
             #ifdef ROBOT_DYNAMICS_VECTORS\n    if ({usual}) {{\n        \
             const robot_dynamics_{width} x = {{{lanes}}};\n        \
             robot_dynamics_sin_cos_of_{width}(&x, sines, cosines);\n        return;\n    }}\n#endif\n"
        );
        for (lane, name) in names.iter().enumerate() {
            let _ = write!(
                text,
                "    robot_dynamics_sin_cos({name}, &sine, &cosine);\n    \
                 (*sines)[{lane}] = sine, (*cosines)[{lane}] = cosine;\n"
            );
        }
        text + "}\n"
    }

    fn in_words_of(&self, text: &str) -> String {
        let words = [
            ("REAL", self.real),
            ("WORD", self.word),
            ("SIGN", self.sign),
            ("ZERO", self.zero),
            ("LARGEST", self.largest),
            ("FINITE", self.finite),
        ];
        words
            .iter()
            .fold(text.to_owned(), |text, (word, own)| text.replace(word, own))
    }
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
        turn: "(turns >> 1)",
    },
    Part {
        name: "cos",
        value: "cosine",
        parity: "1u",
        turn: "(turns ^ turns >> 1)",
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
