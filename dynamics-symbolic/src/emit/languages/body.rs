//! The lines of a function, which all languages write alike.

use super::{Language, in_order, input_names, line_names, pivots, plain};
use crate::function::{Argument, Request, spans};
use crate::program::{Instruction, Line, Operand, Output, Program, Proven, Rest};
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

/// A double that reads back as the same one.
pub(super) fn number(x: f64) -> String {
    format!("{x:?}")
}

impl<'a> Body<'a> {
    pub(super) fn new(robot: &'a Robot, proven: &'a Proven, language: &'a Language) -> Self {
        let program = &proven.program;
        let lines = program.lines();
        Body {
            robot,
            program,
            constants: &proven.constants,
            language,
            names: line_names(&lines),
            inputs: input_names(robot, program),
            lines,
        }
    }

    /// One line of text for each input, each result and each pivot that is tested.
    pub(super) fn statements(&self, request: &Request) -> Vec<String> {
        let declare = |name: &String, value: String| (self.language.declare)(name, &value);
        let symbols = in_order(self.program).into_iter();
        let inputs =
            symbols.map(|(index, symbol)| declare(&self.inputs[index], self.input(symbol)));
        let lines = self.lines.iter().zip(&self.names);
        let results = lines
            .filter_map(|(line, name)| Some(declare(name.as_ref()?, self.line(line.as_ref()?))));
        let pivots = pivots(self.robot.freedoms(), request, self.program).into_iter();
        let tests = pivots.map(|(joint, outputs)| {
            let [pivot, diagonal] = outputs.map(|output| self.output(output));
            (self.language.test_pivot)(joint, &pivot, &diagonal)
        });
        inputs.chain(results).chain(tests).collect()
    }

    /// The outputs of each part that are values, one part after the other.
    pub(super) fn values(&self, request: &Request) -> Vec<Vec<String>> {
        let freedoms = self.robot.freedoms();
        let spans = spans(request.parts(), freedoms, self.program.outputs.len());
        let parts = request.parts().iter().zip(spans);
        let values = parts.map(|(part, span)| {
            let entries = part.function.entries(freedoms, span.len());
            let outputs = &self.program.outputs[span.start..][..entries];
            outputs.iter().map(|output| self.output(*output)).collect()
        });
        values.collect()
    }

    fn output(&self, output: Output) -> String {
        let value = self.operand(output.operand);
        match (output.negative, value.strip_prefix('-')) {
            (false, _) => value,
            (true, Some(opposite)) => opposite.to_owned(),
            (true, None) => format!("-{value}"),
        }
    }

    fn line(&self, line: &Line) -> String {
        let text = |operand: Operand| self.operand(operand);
        match *line {
            Line::Single(instruction) => {
                let [a, b] = instruction.operands().map(text);
                match instruction {
                    Instruction::Mul(..) => self.product(&a, &b),
                    Instruction::Div(..) => format!("{a}{}{b}", self.language.over),
                    Instruction::Add(..) | Instruction::Sub(..) => {
                        format!("{a} {} {b}", instruction.operator())
                    }
                }
            }
            Line::Fused {
                product: (x, y),
                is_subtracted,
                rest,
            } => {
                let product = self.product(&text(x), &text(y));
                match (rest, is_subtracted) {
                    (Rest::Plus(a), false) => format!("{product} + {}", text(a)),
                    (Rest::Plus(a), true) => format!("{} - {product}", text(a)),
                    (Rest::Minus(a), _) => format!("{product} - {}", text(a)),
                    (Rest::Product(a, b), _) => {
                        let sign = if is_subtracted { '-' } else { '+' };
                        format!("{} {sign} {product}", self.product(&text(a), &text(b)))
                    }
                }
            }
        }
    }

    fn product(&self, a: &str, b: &str) -> String {
        format!("{a}{}{b}", self.language.times)
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
        let language = self.language;
        if let Some((argument, i)) = symbol.entry() {
            let entry = self.robot.entry_of(argument, i);
            return (language.entry)(argument.name(), entry);
        }
        match symbol {
            Symbol::Pi => number(core::f64::consts::PI),
            Symbol::Field(i) => self.cell(&Value::Field(*i)),
            Symbol::AngleSine(angle) => call(language.sine, self.cell(angle)),
            Symbol::AngleCosine(angle) => call(language.cosine, self.cell(angle)),
            Symbol::Sine(i) => call(language.sine, self.of_joint(Argument::Position, *i)),
            Symbol::Cosine(i) => call(language.cosine, self.of_joint(Argument::Position, *i)),
            Symbol::VelocitySign(i) => call(language.sign, self.of_joint(Argument::Velocity, *i)),
            Symbol::Stribeck(i) => {
                let row = self.robot.row_of(*i);
                let stribeck = row.and_then(|row| row.stribeck.as_ref());
                let v = stribeck.map_or(String::new(), |stribeck| self.cell(&stribeck.velocity));
                let velocity = self.of_joint(Argument::Velocity, *i);
                let x = format!("({velocity}{}{v})", language.over);
                call(language.exponential, format!("-({})", self.product(&x, &x)))
            }
            _ => unreachable!("an entry of an argument"),
        }
    }

    /// The position or velocity behind a symbol's index; a follower's is that of the joint it follows times the factor.
    fn of_joint(&self, argument: Argument, i: usize) -> String {
        let entry =
            |i: usize| (self.language.entry)(argument.name(), self.robot.entry_of(argument, i));
        match self.robot.followed(i) {
            None => entry(i),
            Some((leader, factor)) => {
                format!("({})", self.product(&self.cell(factor), &entry(leader)))
            }
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
            Value::Mul(a, b) => format!("({})", self.product(&cell(a), &cell(b))),
            Value::Div(a, b) => format!("({}{}{})", cell(a), self.language.over, cell(b)),
        }
    }
}
