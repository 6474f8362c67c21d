//! The lines of a function, which all languages write alike.
//!
//! Every language writes the lines of `Program::lines`, as the Rust method does. `arrangement` has the shapes of
//! values, and a module for each language what differs. `c::batch` writes the lines into a loop over
//! states, behind loops over the columns of their angles: gcc and clang make lanes of loops without branches. Python
//! and MATLAB add -0 to each value, which changes no number and gives it the axes of all arguments. The test, in
//! `dynamics-evaluation`, gives C, JavaScript and Python the sines and exponentials of Rust and demands equal bits.
//! With their own sines errors stay below 1e-10 of the largest entry.

use crate::syntax::{Angle, Syntax};
use dynamics_symbolic::emit::{in_order, input_names, line_names, pivots};
use dynamics_symbolic::function::{Argument, Request, plain, spans};
use dynamics_symbolic::program::{Instruction, Line, Operand, Output, Program, Proven, Rest};
use dynamics_symbolic::robot::{Robot, Symbol, Value};

/// A function that is being written.
pub(crate) struct Body<'a> {
    robot: &'a Robot,
    program: &'a Program,
    constants: Vec<f64>,
    syntax: &'a Syntax,
    lines: Vec<Option<Line>>,
    /// The variable of each result that has a line.
    names: Vec<Option<String>>,
    inputs: Vec<String>,
}

/// A value with its sign turned.
pub(crate) fn opposite(value: &str) -> String {
    match value.strip_prefix('-') {
        Some(opposite) => opposite.to_owned(),
        None => format!("-{value}"),
    }
}

/// A double that reads back as the same one.
pub(crate) fn number(x: f64) -> String {
    format!("{x:?}")
}

impl<'a> Body<'a> {
    pub(crate) fn new(robot: &'a Robot, proven: &'a Proven, syntax: &'a Syntax) -> Self {
        let program = &proven.program;
        let lines = program.lines();
        let mut constants = proven.constants.clone();
        if syntax.is_single {
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
            syntax,
            names: line_names(&lines),
            inputs: input_names(robot, program),
            lines,
        }
    }

    /// One line of text for each input, each result and each pivot that is tested.
    pub(crate) fn statements(&self, request: &Request) -> Vec<String> {
        let declare = |name: &String, value: String| (self.syntax.declare)(name, &value);
        let lines = self.lines.iter().zip(&self.names);
        let results = lines
            .filter_map(|(line, name)| Some(declare(name.as_ref()?, self.line(line.as_ref()?))));
        let pivots = pivots(self.robot.freedoms(), request, self.program).into_iter();
        let tests = pivots.map(|(joint, outputs)| {
            let [pivot, diagonal] = outputs.map(|output| self.output(output));
            (self.syntax.test_pivot)(joint, &pivot, &diagonal)
        });
        let inputs = self.inputs_that(|_| true).into_iter();
        inputs.chain(results).chain(tests).collect()
    }

    /// One line for each input whose symbol is one of those, behind those of angles where the language evaluates these together.
    pub(crate) fn inputs_that(&self, is_one: impl Fn(&Symbol) -> bool) -> Vec<String> {
        let is_apart = |symbol: &Symbol| self.syntax.of_angles.is_some() && is_of_angle(symbol);
        let symbols = in_order(self.program).into_iter();
        let others = symbols.filter(|(_, symbol)| is_one(symbol) && !is_apart(symbol));
        let others = others
            .map(|(index, symbol)| (self.syntax.declare)(&self.inputs[index], &self.input(symbol)));
        let of_angles = self.syntax.of_angles;
        let of_angles = of_angles.map(|write| write(&self.angles_that(&is_one)));
        of_angles.into_iter().flatten().chain(others).collect()
    }

    /// The variable of an input.
    pub(crate) fn input_name(&self, index: usize) -> &str {
        &self.inputs[index]
    }

    /// One line for each result whose index is one of those.
    pub(crate) fn lines_that(&self, is_one: impl Fn(usize) -> bool) -> Vec<String> {
        let lines = self.lines.iter().zip(&self.names).enumerate();
        let ones = lines.filter(|(index, _)| is_one(*index));
        ones.filter_map(|(_, (line, name))| {
            Some((self.syntax.declare)(
                name.as_ref()?,
                &self.line(line.as_ref()?),
            ))
        })
        .collect()
    }

    /// The output of that index.
    pub(crate) fn output_of(&self, index: usize) -> String {
        self.output(self.program.outputs[index])
    }

    /// The angles whose sines or cosines are read, each once.
    pub(crate) fn angles(&self) -> Vec<Angle> {
        self.angles_that(&|_| true)
    }

    /// The same of the symbols that are some of those.
    fn angles_that(&self, is_one: &dyn Fn(&Symbol) -> bool) -> Vec<Angle> {
        let mut angles: Vec<Angle> = Vec::new();
        for (index, symbol) in in_order(self.program) {
            if !(is_of_angle(symbol) && is_one(symbol)) {
                continue;
            }
            let value = self.angle(symbol);
            let known = angles.iter().position(|angle| angle.value == value);
            let at = known.unwrap_or(angles.len());
            if known.is_none() {
                angles.push(Angle {
                    value,
                    sine: None,
                    cosine: None,
                });
            }
            let name = Some(self.inputs[index].clone());
            match symbol {
                Symbol::Sine(_) | Symbol::AngleSine(_) => angles[at].sine = name,
                _ => angles[at].cosine = name,
            }
        }
        angles
    }

    /// The outputs of each part that are values, one part after the other.
    pub(crate) fn values(&self, request: &Request) -> Vec<Vec<String>> {
        let parts = self.outputs(request).into_iter();
        let values = parts.map(|outputs| outputs.iter().map(|output| self.output(*output)));
        values.map(Iterator::collect).collect()
    }

    /// The same of all parts together, without a text where an output is zero always.
    pub(crate) fn entries(&self, request: &Request) -> Vec<Option<String>> {
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
        if output.negative {
            opposite(&value)
        } else {
            value
        }
    }

    fn line(&self, line: &Line) -> String {
        let text = |operand: Operand| self.operand(operand);
        match *line {
            Line::Single(instruction) => {
                let [a, b] = instruction.operands().map(text);
                match instruction {
                    Instruction::Mul(..) => self.product(&a, &b),
                    Instruction::Div(..) => format!("{a}{}{b}", self.syntax.over),
                    Instruction::Add(..) | Instruction::Sub(..) => {
                        format!("{a} {} {b}", instruction.operator())
                    }
                }
            }
            Line::Fused {
                product,
                is_subtracted,
                rest,
            } => match self.syntax.fused {
                Some(function) => self.fused(function, product, is_subtracted, rest),
                None => self.product_and_rest(product, is_subtracted, rest),
            },
        }
    }

    /// A sum with a product in it, as two operations.
    fn product_and_rest(
        &self,
        (x, y): (Operand, Operand),
        is_subtracted: bool,
        rest: Rest,
    ) -> String {
        let text = |operand: Operand| self.operand(operand);
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

    /// The same as a call, with the signs that the Rust method has.
    fn fused(
        &self,
        function: &str,
        (x, y): (Operand, Operand),
        is_subtracted: bool,
        rest: Rest,
    ) -> String {
        let text = |operand: Operand| self.operand(operand);
        let factor = if is_subtracted {
            opposite(&text(x))
        } else {
            text(x)
        };
        let rest = match rest {
            Rest::Plus(a) => text(a),
            Rest::Minus(a) => opposite(&text(a)),
            Rest::Product(a, b) => self.product(&text(a), &text(b)),
        };
        format!("{function}({factor}, {}, {rest})", text(y))
    }

    fn product(&self, a: &str, b: &str) -> String {
        format!("{a}{}{b}", self.syntax.times)
    }

    fn operand(&self, operand: Operand) -> String {
        match operand {
            Operand::Constant(id) => (self.syntax.number)(self.constants[id.index()]),
            Operand::Input(index) => self.inputs[index as usize].clone(),
            Operand::Result(index) => self.names[index as usize].clone().unwrap_or_default(),
        }
    }

    fn input(&self, symbol: &Symbol) -> String {
        let call = |function: &str, argument: String| format!("{function}({argument})");
        let syntax = self.syntax;
        if let Some((argument, i)) = symbol.entry() {
            let entry = self.robot.entry_of(argument, i);
            return (syntax.entry)(argument.name(), entry);
        }
        match symbol {
            Symbol::Pi => (syntax.number)(core::f64::consts::PI),
            Symbol::Field(i) => self.cell(&Value::Field(*i)),
            Symbol::Sine(_) | Symbol::AngleSine(_) => call(syntax.sine, self.angle(symbol)),
            Symbol::Cosine(_) | Symbol::AngleCosine(_) => call(syntax.cosine, self.angle(symbol)),
            Symbol::VelocitySign(i) => call(syntax.sign, self.of_joint(Argument::Velocity, *i)),
            Symbol::Stribeck(i) => {
                let row = self.robot.row_of(*i);
                let stribeck = row.and_then(|row| row.stribeck.as_ref());
                let v = stribeck.map_or(String::new(), |stribeck| self.cell(&stribeck.velocity));
                let velocity = self.of_joint(Argument::Velocity, *i);
                let x = format!("({velocity}{}{v})", syntax.over);
                call(syntax.exponential, format!("-({})", self.product(&x, &x)))
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
            |i: usize| (self.syntax.entry)(argument.name(), self.robot.entry_of(argument, i));
        match self.robot.followed(i) {
            None => entry(i),
            Some((leader, factor)) => {
                format!("({})", self.product(&self.cell(factor), &entry(leader)))
            }
        }
    }

    /// A cell as an expression over the fields, rounded after each operation.
    pub(crate) fn cell(&self, value: &Value) -> String {
        let cell = |value: &Value| self.cell(value);
        match value {
            Value::Rational(_) | Value::Pi => (self.syntax.number)(value.to_f64(&[])),
            Value::Field(i) => (self.syntax.field)(plain(&self.robot.fields[*i])),
            Value::Neg(a) => format!("(-{})", cell(a)),
            Value::Add(a, b) => format!("({} + {})", cell(a), cell(b)),
            Value::Mul(a, b) => format!("({})", self.product(&cell(a), &cell(b))),
            Value::Div(a, b) => format!("({}{}{})", cell(a), self.syntax.over, cell(b)),
        }
    }
}

/// Whether a symbol is the sine or the cosine of an angle.
fn is_of_angle(symbol: &Symbol) -> bool {
    use Symbol::{AngleCosine, AngleSine, Cosine, Sine};
    matches!(symbol, Sine(_) | Cosine(_) | AngleSine(_) | AngleCosine(_))
}
