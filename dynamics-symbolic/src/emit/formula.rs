//! Short programs as formulas that a person can read.

use super::names::plain;
use crate::program::{Instruction, Operand, Program};
use crate::robot::{Robot, Symbol, Value};

/// A formula longer than this is no help.
const LONGEST: usize = 200;

/// How tightly operations bind.
const SUM: u8 = 1;
const QUOTIENT: u8 = 2;
const PRODUCT: u8 = 3;
const ATOM: u8 = 4;

/// The outputs as formulas, or `None` where one of them is too long to read.
pub(super) fn formulas(robot: &Robot, program: &Program, constants: &[f64]) -> Option<Vec<String>> {
    let mut texts: Vec<Text> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let (a, b) = instruction.operands();
        let read = |operand| read(robot, program, constants, &texts, operand);
        let (a, b) = (read(a), read(b));
        let text = match instruction {
            Instruction::Add(..) => sum(&a, '+', &b),
            Instruction::Sub(..) => sum(&a, '-', &b),
            Instruction::Mul(..) => product(&a, &b),
            Instruction::Div(..) => quotient(&a, &b),
        };
        if text.text.len() > LONGEST {
            return None;
        }
        texts.push(text);
    }
    let output = |output: &crate::program::Output| {
        let text = read(robot, program, constants, &texts, output.operand);
        if output.negative {
            format!("-{}", text.above(SUM))
        } else {
            text.text
        }
    };
    Some(program.outputs.iter().map(output).collect())
}

/// A formula and how tightly its outermost operation binds.
#[derive(Clone)]
struct Text {
    text: String,
    precedence: u8,
}

impl Text {
    fn atom(text: String) -> Self {
        Text {
            text,
            precedence: ATOM,
        }
    }

    /// In parentheses, unless it binds more tightly than `precedence`.
    fn above(&self, precedence: u8) -> String {
        if self.precedence > precedence {
            self.text.clone()
        } else {
            format!("({})", self.text)
        }
    }
}

fn read(
    robot: &Robot,
    program: &Program,
    constants: &[f64],
    texts: &[Text],
    operand: Operand,
) -> Text {
    match operand {
        Operand::Constant(id) => number(constants[id.index()]),
        Operand::Input(index) => Text::atom(symbol(robot, &program.inputs[index as usize])),
        Operand::Result(index) => texts[index as usize].clone(),
    }
}

fn symbol(robot: &Robot, symbol: &Symbol) -> String {
    let joint = |name: &str, i: &usize| format!("{name}{}", i + 1);
    match symbol {
        Symbol::Pi => "pi".to_owned(),
        Symbol::Field(i) => plain(&robot.fields[*i]).to_owned(),
        Symbol::AngleSine(angle) => format!("sin({})", cell(robot, angle).text),
        Symbol::AngleCosine(angle) => format!("cos({})", cell(robot, angle).text),
        Symbol::Sine(i) => format!("sin(q{})", i + 1),
        Symbol::Cosine(i) => format!("cos(q{})", i + 1),
        Symbol::Position(i) => joint("q", i),
        Symbol::Velocity(i) => joint("qd", i),
        Symbol::Acceleration(i) => joint("qdd", i),
        Symbol::Force(i) => joint("tau", i),
        Symbol::VelocitySign(i) => format!("sign(qd{})", i + 1),
        Symbol::Stribeck(i) => {
            let row = robot.joints().nth(*i);
            let stribeck = row.and_then(|row| row.stribeck.as_ref());
            let v = stribeck.map(|stribeck| cell(robot, &stribeck.velocity).above(PRODUCT));
            format!("exp(-(qd{} / {})^2)", i + 1, v.unwrap_or_default())
        }
        Symbol::Entry(argument, i) => joint(argument.name(), i),
    }
}

/// A cell of the table.
fn cell(robot: &Robot, value: &Value) -> Text {
    match value {
        Value::Rational(_) => number(value.to_f64(&[])),
        Value::Pi => Text::atom("pi".to_owned()),
        Value::Field(i) => Text::atom(plain(&robot.fields[*i]).to_owned()),
        Value::Neg(a) => Text {
            text: format!("-{}", cell(robot, a).above(SUM)),
            precedence: SUM,
        },
        Value::Add(a, b) => sum(&cell(robot, a), '+', &cell(robot, b)),
        Value::Mul(a, b) => product(&cell(robot, a), &cell(robot, b)),
        Value::Div(a, b) => quotient(&cell(robot, a), &cell(robot, b)),
    }
}

fn number(x: f64) -> Text {
    Text {
        text: format!("{x}"),
        precedence: if x < 0.0 { SUM } else { ATOM },
    }
}

fn sum(a: &Text, sign: char, b: &Text) -> Text {
    let b = if sign == '-' {
        b.above(SUM)
    } else {
        b.text.clone()
    };
    Text {
        text: format!("{} {sign} {b}", a.text),
        precedence: SUM,
    }
}

/// A product by juxtaposition; a quotient in it is put in parentheses.
fn product(a: &Text, b: &Text) -> Text {
    Text {
        text: format!("{} {}", a.above(QUOTIENT), b.above(QUOTIENT)),
        precedence: PRODUCT,
    }
}

fn quotient(a: &Text, b: &Text) -> Text {
    Text {
        text: format!("{} / {}", a.above(QUOTIENT), b.above(PRODUCT)),
        precedence: QUOTIENT,
    }
}
