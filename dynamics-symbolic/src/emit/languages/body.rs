//! The lines of a function, which all languages write alike.

use super::{Language, in_order, input_names, line_names, pivots, plain};
use crate::function::{Argument, Request, spans};
use crate::program::{Instruction, Line, Operand, Output, Program, Proven, Rest};
use crate::robot::{Robot, Symbol, Value};

/// A function that is being written.
pub(super) struct Body<'a> {
    robot: &'a Robot,
    program: &'a Program,
    constants: Vec<f64>,
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
        let mut constants = proven.constants.clone();
        if language.is_single {
            // Rounded once, as in Rust.
            let singles = program.constants.singles(&constants).into_iter();
            for (constant, single) in constants.iter_mut().zip(singles) {
                *constant = single.map_or(*constant, f64::from);
            }
        }
        Body {
            robot,
            program,
            constants,
            language,
            names: line_names(&lines),
            inputs: input_names(robot, program),
            lines,
        }
    }

    /// One line of text for each input, each result and each pivot that is tested.
    pub(super) fn statements(&self, request: &Request) -> Vec<String> {
        let declare = |name: &String, value: String| (self.language.declare)(name, &value);
        let lines = self.lines.iter().zip(&self.names);
        let results = lines
            .filter_map(|(line, name)| Some(declare(name.as_ref()?, self.line(line.as_ref()?))));
        let pivots = pivots(self.robot.freedoms(), request, self.program).into_iter();
        let tests = pivots.map(|(joint, outputs)| {
            let [pivot, diagonal] = outputs.map(|output| self.output(output));
            (self.language.test_pivot)(joint, &pivot, &diagonal)
        });
        let inputs = self.input_statements().into_iter();
        inputs.chain(results).chain(tests).collect()
    }

    /// One line for each input, or for the sine and the cosine of an angle together.
    fn input_statements(&self) -> Vec<String> {
        let symbols = in_order(self.program);
        let partner = |of: &Symbol, is_pair: fn(&Symbol, &Symbol) -> bool| {
            let mut others = symbols.iter();
            others
                .find(|(_, other)| is_pair(of, other))
                .map(|(index, _)| *index)
        };
        let mut statements = Vec::new();
        for (index, symbol) in &symbols {
            let name = &self.inputs[*index];
            if let Some(both) = self.language.sine_and_cosine {
                if let Some(cosine) = partner(symbol, is_sine_beside) {
                    statements.push(both(name, &self.inputs[cosine], &self.angle(symbol)));
                    continue;
                }
                if partner(symbol, |cosine, sine| is_sine_beside(sine, cosine)).is_some() {
                    continue;
                }
            }
            statements.push((self.language.declare)(name, &self.input(symbol)));
        }
        statements
    }

    /// The outputs of each part that are values, one part after the other.
    pub(super) fn values(&self, request: &Request) -> Vec<Vec<String>> {
        let parts = self.outputs(request).into_iter();
        let values = parts.map(|outputs| outputs.iter().map(|output| self.output(*output)));
        values.map(Iterator::collect).collect()
    }

    /// The same of all parts together, without a text where an output is zero always.
    pub(super) fn entries(&self, request: &Request) -> Vec<Option<String>> {
        let entry = |output: &Output| (!self.is_zero(*output)).then(|| self.output(*output));
        let outputs = self.outputs(request).into_iter();
        outputs.flatten().map(entry).collect()
    }

    /// The outputs of each part that are values.
    fn outputs(&self, request: &Request) -> Vec<&[Output]> {
        let freedoms = self.robot.freedoms();
        let spans = spans(request.parts(), freedoms, self.program.outputs.len());
        let parts = request.parts().iter().zip(spans);
        let outputs = parts.map(|(part, span)| {
            let entries = part.function.entries(freedoms, span.len());
            &self.program.outputs[span.start..][..entries]
        });
        outputs.collect()
    }

    fn is_zero(&self, output: Output) -> bool {
        matches!(output.operand, Operand::Constant(id) if self.constants[id.index()] == 0.0)
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
            Operand::Constant(id) => (self.language.number)(self.constants[id.index()]),
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
            Symbol::Pi => (language.number)(core::f64::consts::PI),
            Symbol::Field(i) => self.cell(&Value::Field(*i)),
            Symbol::Sine(_) | Symbol::AngleSine(_) => call(language.sine, self.angle(symbol)),
            Symbol::Cosine(_) | Symbol::AngleCosine(_) => call(language.cosine, self.angle(symbol)),
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

    /// The angle of a sine or a cosine.
    fn angle(&self, symbol: &Symbol) -> String {
        match symbol {
            Symbol::AngleSine(angle) | Symbol::AngleCosine(angle) => self.cell(angle),
            Symbol::Sine(i) | Symbol::Cosine(i) => self.of_joint(Argument::Position, *i),
            _ => unreachable!("a sine or a cosine"),
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
            Value::Rational(_) | Value::Pi => (self.language.number)(value.to_f64(&[])),
            Value::Field(i) => (self.language.field)(plain(&self.robot.fields[*i])),
            Value::Neg(a) => format!("(-{})", cell(a)),
            Value::Add(a, b) => format!("({} + {})", cell(a), cell(b)),
            Value::Mul(a, b) => format!("({})", self.product(&cell(a), &cell(b))),
            Value::Div(a, b) => format!("({}{}{})", cell(a), self.language.over, cell(b)),
        }
    }
}

/// Whether the first is the sine and the second the cosine of one angle.
fn is_sine_beside(sine: &Symbol, cosine: &Symbol) -> bool {
    match (sine, cosine) {
        (Symbol::Sine(i), Symbol::Cosine(j)) => i == j,
        (Symbol::AngleSine(angle), Symbol::AngleCosine(other)) => angle == other,
        _ => false,
    }
}
