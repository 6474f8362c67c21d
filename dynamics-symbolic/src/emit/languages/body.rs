//! The lines of a function, which C and JavaScript write alike.

use super::{Language, input_name, place, plain};
use crate::function::{Request, spans};
use crate::program::{Instruction, Line, Operand, Program, Proven, Rest};
use crate::robot::{Robot, Symbol, Value};

/// A function that is being written.
pub(super) struct Body<'a> {
    robot: &'a Robot,
    program: &'a Program,
    constants: &'a [f64],
    language: &'a Language,
    lines: Vec<Option<Line>>,
    /// The variable of each result that has a line.
    names: Vec<Option<String>>,
    inputs: Vec<String>,
}

/// A test of a pivot: the texts of the pivot and of the diagonal entry.
#[derive(Clone, PartialEq)]
pub(super) struct PivotTest {
    /// The joint, counted from 0.
    pub(super) joint: usize,
    pub(super) pivot: String,
    pub(super) diagonal: String,
}

/// A double that reads back as the same one.
pub(super) fn number(x: f64) -> String {
    format!("{x:?}")
}

impl<'a> Body<'a> {
    pub(super) fn new(robot: &'a Robot, proven: &'a Proven, language: &'a Language) -> Self {
        let program = &proven.program;
        let lines = program.lines();
        let mut count = 0;
        let name = |line: &Option<Line>| {
            line.map(|_| {
                count += 1;
                format!("t_{count}")
            })
        };
        let names = lines.iter().map(name).collect();
        let angles = program.angles();
        let inputs = program.inputs.iter();
        let inputs = inputs.map(|symbol| input_name(robot, symbol, &angles));
        Body {
            robot,
            program,
            constants: &proven.constants,
            language,
            names,
            inputs: inputs.collect(),
            lines,
        }
    }

    /// What is read, and then computed: one line of text for each, without indentation.
    pub(super) fn statements(&self) -> Vec<String> {
        let mut statements = Vec::new();
        let mut inputs: Vec<_> = self.program.inputs.iter().zip(&self.inputs).collect();
        inputs.sort_by_key(|(symbol, _)| place(symbol));
        for (symbol, name) in inputs {
            self.declare(name, &self.input(symbol), &mut statements);
        }
        for (line, name) in self.lines.iter().zip(&self.names) {
            if let (Some(line), Some(name)) = (line, name) {
                self.declare(name, &self.line(line), &mut statements);
            }
        }
        statements
    }

    fn declare(&self, name: &str, value: &str, statements: &mut Vec<String>) {
        let declaration = self.language.declaration;
        statements.push(format!("{declaration} {name} = {value};"));
    }

    /// The outputs of each part that are values, one part after the other.
    pub(super) fn values(&self, request: &Request) -> Vec<Vec<String>> {
        let (joints, count) = (self.robot.dof(), self.program.outputs.len());
        let spans = spans(request.parts(), joints, count);
        let of_part = |(part, span): (&crate::Function, core::ops::Range<usize>)| {
            let pivots = if part.has_pivots() { 2 * joints } else { 0 };
            (span.start..span.end - pivots)
                .map(|output| self.output(output))
                .collect()
        };
        request.parts().iter().zip(spans).map(of_part).collect()
    }

    /// The tests by which the function refuses, in the order in which they are made.
    pub(super) fn pivot_tests(&self, request: &Request) -> Vec<PivotTest> {
        let (joints, count) = (self.robot.dof(), self.program.outputs.len());
        let spans = spans(request.parts(), joints, count);
        let mut tests: Vec<PivotTest> = Vec::new();
        for (part, span) in request.parts().iter().zip(spans) {
            if !part.has_pivots() {
                continue;
            }
            for joint in (0..joints).rev() {
                let test = PivotTest {
                    joint,
                    pivot: self.output(span.end - 2 * joints + joint),
                    diagonal: self.output(span.end - joints + joint),
                };
                if !tests.contains(&test) {
                    tests.push(test);
                }
            }
        }
        tests
    }

    fn output(&self, index: usize) -> String {
        let output = self.program.outputs[index];
        let value = self.operand(output.operand);
        match (output.negative, value.strip_prefix('-')) {
            (false, _) => value,
            (true, Some(opposite)) => opposite.to_owned(),
            (true, None) => format!("-{value}"),
        }
    }

    fn line(&self, line: &Line) -> String {
        let of = |operand: Operand| self.operand(operand);
        match *line {
            Line::Single(instruction) => {
                let (a, b) = instruction.operands();
                let operator = match instruction {
                    Instruction::Add(..) => '+',
                    Instruction::Sub(..) => '-',
                    Instruction::Mul(..) => '*',
                    Instruction::Div(..) => '/',
                };
                format!("{} {operator} {}", of(a), of(b))
            }
            Line::Fused {
                product: (x, y),
                is_subtracted,
                rest,
            } => {
                let product = format!("{} * {}", of(x), of(y));
                match (rest, is_subtracted) {
                    (Rest::Plus(a), false) => format!("{product} + {}", of(a)),
                    (Rest::Plus(a), true) => format!("{} - {product}", of(a)),
                    (Rest::Minus(a), _) => format!("{product} - {}", of(a)),
                    (Rest::Product(a, b), false) => format!("{} * {} + {product}", of(a), of(b)),
                    (Rest::Product(a, b), true) => format!("{} * {} - {product}", of(a), of(b)),
                }
            }
        }
    }

    fn operand(&self, operand: Operand) -> String {
        match operand {
            Operand::Constant(id) => number(self.constants[id.index()]),
            Operand::Input(index) => self.inputs[index as usize].clone(),
            Operand::Result(index) => self.names[index as usize].clone().unwrap_or_default(),
        }
    }

    fn input(&self, symbol: &Symbol) -> String {
        let call = |function: &str, argument: String| format!("{function}({argument})");
        let entry = |argument: &str, i: usize| format!("{argument}[{i}]");
        let Language {
            sine,
            cosine,
            exponential,
            sign,
            ..
        } = self.language;
        match symbol {
            Symbol::Pi => number(core::f64::consts::PI),
            Symbol::Field(i) => self.cell(&Value::Field(*i)),
            Symbol::AngleSine(angle) => call(sine, self.cell(angle)),
            Symbol::AngleCosine(angle) => call(cosine, self.cell(angle)),
            Symbol::Sine(i) => call(sine, self.of_joint("q", *i)),
            Symbol::Cosine(i) => call(cosine, self.of_joint("q", *i)),
            Symbol::Position(i) => entry("q", *i),
            Symbol::Velocity(i) => entry("qd", *i),
            Symbol::Acceleration(i) => entry("qdd", *i),
            Symbol::Force(i) => entry("tau", *i),
            Symbol::VelocitySign(i) => call(sign, self.of_joint("qd", *i)),
            Symbol::Stribeck(i) => {
                let row = self.robot.row_of(*i);
                let stribeck = row.and_then(|row| row.stribeck.as_ref());
                let v = stribeck.map_or(String::new(), |stribeck| self.cell(&stribeck.velocity));
                let x = format!("({} / {v})", self.of_joint("qd", *i));
                call(exponential, format!("-({x} * {x})"))
            }
            Symbol::Entry(argument, i) => entry(argument.name(), *i),
        }
    }

    /// Position or velocity behind a symbol's index: of a follower, that of the joint it follows times
    /// the factor.
    fn of_joint(&self, argument: &str, i: usize) -> String {
        match self.robot.followed(i) {
            None => format!("{argument}[{i}]"),
            Some((leader, factor)) => format!("({} * {argument}[{leader}])", self.cell(factor)),
        }
    }

    /// A cell as an expression over the fields, rounded after each operation.
    fn cell(&self, value: &Value) -> String {
        let cell = |value: &Value| self.cell(value);
        match value {
            Value::Rational(_) | Value::Pi => number(value.to_f64(&[])),
            Value::Field(i) => (self.language.field)(plain(&self.robot.fields[*i])),
            Value::Neg(a) => format!("(-{})", cell(a)),
            Value::Add(a, b) => format!("({} + {})", cell(a), cell(b)),
            Value::Mul(a, b) => format!("({} * {})", cell(a), cell(b)),
            Value::Div(a, b) => format!("({} / {})", cell(a), cell(b)),
        }
    }
}
