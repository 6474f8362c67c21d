//! Short programs as formulas that a person can read.

use crate::program::{Instruction, Operand, Program};
use crate::robot::{Robot, Symbol};

/// A formula longer than this is no help.
const LONGEST: usize = 150;

/// The outputs as formulas, or `None` where one of them is too long to read.
pub(super) fn formulas(robot: &Robot, program: &Program, constants: &[f64]) -> Option<Vec<String>> {
    let mut texts: Vec<Text> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let (a, b) = instruction.operands();
        let read = |operand| read(robot, program, constants, &texts, operand);
        let (a, b) = (read(a), read(b));
        let text = match instruction {
            Instruction::Add(..) => Text {
                text: format!("{} + {}", a.text, b.text),
                precedence: 1,
            },
            Instruction::Sub(..) => Text {
                text: format!("{} - {}", a.text, b.above(1)),
                precedence: 1,
            },
            Instruction::Mul(..) => Text {
                text: format!("{} {}", a.above(1), b.above(1)),
                precedence: 2,
            },
            Instruction::Div(..) => Text {
                text: format!("{} / {}", a.above(1), b.above(2)),
                precedence: 2,
            },
        };
        if text.text.len() > LONGEST {
            return None;
        }
        texts.push(text);
    }
    let output = |output: &crate::program::Output| {
        let text = read(robot, program, constants, &texts, output.operand);
        if output.negative {
            format!("-{}", text.above(1))
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
            precedence: 3,
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
        Operand::Constant(id) => {
            let x = constants[id.index()];
            Text {
                text: format!("{x}"),
                precedence: if x < 0.0 { 1 } else { 3 },
            }
        }
        Operand::Input(index) => Text::atom(symbol(robot, &program.inputs[index as usize])),
        Operand::Result(index) => texts[index as usize].clone(),
    }
}

fn symbol(robot: &Robot, symbol: &Symbol) -> String {
    let joint = |name: &str, i: &usize| format!("{name}{}", i + 1);
    match symbol {
        Symbol::Pi => "pi".to_owned(),
        Symbol::Field(i) => super::signature::plain(&robot.fields[*i]).to_owned(),
        Symbol::AngleSine(_) => "sin(angle)".to_owned(),
        Symbol::AngleCosine(_) => "cos(angle)".to_owned(),
        Symbol::Sine(i) => joint("s", i),
        Symbol::Cosine(i) => joint("c", i),
        Symbol::Position(i) => joint("q", i),
        Symbol::Velocity(i) => joint("qd", i),
        Symbol::Acceleration(i) => joint("qdd", i),
        Symbol::Force(i) => joint("tau", i),
        Symbol::VelocitySign(i) => format!("sign(qd{})", i + 1),
    }
}
