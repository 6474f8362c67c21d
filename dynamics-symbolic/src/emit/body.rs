//! The body of a method: straight-line assignments behind its inputs, and its outputs.
//!
//! Up to 500 results are declared by a `let` each. Beyond that, each group of 200 has one pattern, because rustc
//! crashes on about 2,900 nested debug scopes (rust-lang/rust#93908). More than 5,000 results are computed in
//! functions of 500 results inside the method, each of which returns what later ones read: memory and time of the
//! borrow checker grow with the square of a function's length. Closures in place of functions make it worse, because
//! each borrow of a captured variable is a region of its own.

use super::inputs::{constants_of, input_names, inputs, literal, reads_cells, real};
use super::names::{ident, in_tuple, line_names, punct, variable};
use super::pivots::pivots;
use crate::function::{Request, Shape, Sizes, sizes_of, spans};
use crate::program::{ConstantId, Line, Operand, Output, Program, Proven, Rest};
use crate::robot::Robot;
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// Up to so many results are declared by a `let` each, more by one pattern for each group: rustc crashes on about 2,900
/// nested scopes, which `let`s are to debug information (rust-lang/rust#93908).
pub(super) const MOST_LETS: usize = 500;
const GROUP: usize = 200;

/// A program of more results is written in [parts](super::parts).
const MOST_IN_ONE_FUNCTION: usize = 5_000;

pub(super) struct Writer<'p> {
    pub(super) program: &'p Program,
    lines: Vec<Option<Line>>,
    constants: &'p [f64],
    /// The nearest single of each constant whose double rounds to another one.
    singles: Vec<Option<f32>>,
    /// The variable of each input.
    pub(super) inputs: Vec<Ident>,
    /// The variable of each result that has a line.
    pub(super) names: Vec<Option<Ident>>,
}

pub(super) fn body(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    path: &TokenStream,
) -> TokenStream {
    let (writer, program) = (Writer::new(robot, proven), &proven.program);
    let reads_constants = proven.constants.iter().any(|x| !x.is_nan());
    let number = (reads_constants || reads_cells(robot, program))
        .then(|| constants_of(robot, request, path));
    let inputs = inputs(robot, request, program, path);
    let assignments = writer.assignments(path);
    let outputs = writer.outputs(robot, request, path);
    quote!(#number #inputs #assignments #outputs)
}

/// Declarations of variables that are assigned later, by one pattern for each group.
pub(super) fn declared_in_groups(names: &[impl ToTokens]) -> TokenStream {
    let groups = names.chunks(GROUP).map(|group| {
        let types = group.iter().map(|_| quote!(T));
        quote!(let (#(#group,)*): (#(#types,)*);)
    });
    groups.collect()
}

impl<'p> Writer<'p> {
    pub(super) fn new(robot: &Robot, proven: &'p Proven) -> Self {
        let Proven { program, constants } = proven;
        let lines = program.lines();
        let names = line_names(&lines).into_iter();
        let inputs = input_names(robot, program).into_iter();
        Writer {
            program,
            lines,
            constants,
            singles: program.constants.singles(constants),
            inputs: inputs.map(|name| variable(&name)).collect(),
            names: names.map(|name| Some(variable(&name?))).collect(),
        }
    }

    fn assignments(&self, path: &TokenStream) -> TokenStream {
        let results = 0..self.names.len();
        let named: Vec<usize> = results.filter(|i| self.names[*i].is_some()).collect();
        if named.len() <= MOST_LETS {
            self.lets(&named)
        } else if named.len() <= MOST_IN_ONE_FUNCTION {
            self.groups(&named)
        } else {
            self.parts(&named, path)
        }
    }

    /// The results, each declared where it is computed.
    pub(super) fn lets(&self, results: &[usize]) -> TokenStream {
        let mut tokens = Vec::new();
        for index in results {
            tokens.push(TokenTree::from(ident("let")));
            self.assign(*index, &mut tokens);
        }
        tokens.into_iter().collect()
    }

    /// The results, declared in groups.
    fn groups(&self, results: &[usize]) -> TokenStream {
        let names = results.iter().map(|index| &self.names[*index]);
        let mut declarations = declared_in_groups(&names.collect::<Vec<_>>());
        let mut tokens = Vec::new();
        for index in results {
            self.assign(*index, &mut tokens);
        }
        declarations.extend(tokens);
        declarations
    }

    fn assign(&self, index: usize, tokens: &mut Vec<TokenTree>) {
        tokens.extend(self.names[index].clone().map(TokenTree::from));
        tokens.push(punct('='));
        if let Some(line) = &self.lines[index] {
            self.write(line, tokens);
        }
        tokens.push(punct(';'));
    }

    /// The text of an operand.
    pub(super) fn operand(&self, operand: Operand) -> TokenStream {
        let mut tokens = Vec::new();
        self.write_operand(operand, &mut tokens);
        tokens.into_iter().collect()
    }

    fn write(&self, line: &Line, tokens: &mut Vec<TokenTree>) {
        match *line {
            Line::Single(instruction) => {
                let [a, b] = instruction.operands();
                self.write_operation(a, instruction.operator(), b, tokens);
            }
            Line::Fused {
                product,
                is_subtracted,
                rest,
            } => tokens.extend(self.fused(product, is_subtracted, rest)),
        }
    }

    fn write_operation(&self, a: Operand, operator: char, b: Operand, tokens: &mut Vec<TokenTree>) {
        self.write_operand(a, tokens);
        tokens.push(punct(operator));
        self.write_operand(b, tokens);
    }

    /// A sum with a product in it: a b + c as `a.mul_add(b, c)`, which the
    /// runtime makes one operation where the target has it, and two elsewhere.
    fn fused(&self, (x, y): (Operand, Operand), is_subtracted: bool, rest: Rest) -> TokenStream {
        let (factor, y) = (self.operand(x), self.operand(y));
        let factor = match x {
            Operand::Constant(id) if is_subtracted => self.constant(id, -1.0),
            _ if is_subtracted => quote!((-#factor)),
            _ => factor,
        };
        let (a, b) = match rest {
            Rest::Plus(a) | Rest::Minus(a) => (self.operand(a), None),
            Rest::Product(a, b) => (self.operand(a), Some(self.operand(b))),
        };
        let minus = matches!(rest, Rest::Minus(_)).then(|| punct('-'));
        let times = b.is_some().then(|| punct('*'));
        quote!(#factor.mul_add(#y, #minus #a #times #b))
    }

    fn write_operand(&self, operand: Operand, tokens: &mut Vec<TokenTree>) {
        match operand {
            Operand::Constant(id) => tokens.extend(self.constant(id, 1.0)),
            Operand::Input(index) => tokens.push(self.inputs[index as usize].clone().into()),
            // Products without a name are read by the line that they are written into alone.
            Operand::Result(index) => {
                tokens.extend(self.names[index as usize].clone().map(TokenTree::from));
            }
        }
    }

    /// A constant times 1 or -1, as `real(0.1)`.
    fn constant(&self, id: ConstantId, sign: f64) -> TokenStream {
        let double = real(sign * self.constants[id.index()]);
        match self.singles[id.index()] {
            None => double,
            Some(single) => {
                let single = literal(sign * f64::from(single));
                quote!(#double.rounded_once(#single))
            }
        }
    }

    pub(super) fn output(&self, output: Output) -> TokenStream {
        let mut tokens = Vec::new();
        if output.negative {
            tokens.push(punct('-'));
        }
        self.write_operand(output.operand, &mut tokens);
        tokens.into_iter().collect()
    }

    /// A matrix from outputs by rows; nalgebra takes columns.
    fn matrix(&self, first: usize, rows: usize, columns: usize, path: &TokenStream) -> TokenStream {
        let columns = (0..columns).map(|column| {
            let places = (0..rows).map(|row| first + row * columns + column);
            let entries = places.map(|place| self.output(self.program.outputs[place]));
            quote!([#(#entries),*])
        });
        quote!(#path::nalgebra::SMatrix::from_data(#path::nalgebra::ArrayStorage([#(#columns),*])))
    }

    fn outputs(&self, robot: &Robot, request: &Request, path: &TokenStream) -> TokenStream {
        let (freedoms, count) = (robot.freedoms(), self.program.outputs.len());
        let sizes = sizes_of(request.parts(), freedoms, count);
        let spans = spans(request.parts(), freedoms, count);
        let parts = request.parts().iter().zip(spans);
        let values = parts.map(|(part, mut span)| {
            self.values(part.function.shape(), sizes, &mut span.start, path)
        });
        let values = in_tuple(request, values.collect());
        let tests = self.pivot_tests(robot, request, path);
        if tests.is_empty() {
            return values;
        }
        quote!(#tests ::core::result::Result::Ok(#values))
    }

    /// The tests by which a method refuses a singular M.
    fn pivot_tests(&self, robot: &Robot, request: &Request, path: &TokenStream) -> TokenStream {
        let of_base = core::iter::repeat_n("base", robot.freedoms().base);
        let joints = robot.joints().map(|row| row.name.as_str());
        let names: Vec<_> = of_base.chain(joints).collect();
        let pivots = pivots(robot.freedoms(), request, self.program).into_iter();
        let test = |(joint, outputs): (usize, [Output; 2])| {
            let [pivot, diagonal] = outputs.map(|output| self.output(output));
            let (name, joint) = (names[joint], Literal::usize_unsuffixed(joint));
            quote!(#path::SingularMassMatrix::test_joint(#joint, #name, #pivot, #diagonal)?;)
        };
        pivots.map(test).collect()
    }

    /// Values in their arrangement, from output `next` on, which is moved behind them.
    fn values(
        &self,
        shape: &Shape,
        sizes: Sizes,
        next: &mut usize,
        path: &TokenStream,
    ) -> TokenStream {
        let first = *next;
        match shape {
            Shape::Number => {
                *next += 1;
                self.output(self.program.outputs[first])
            }
            Shape::Matrix(rows, columns) => {
                *next += shape.entries(sizes);
                self.matrix(first, rows.of(sizes), columns.of(sizes), path)
            }
            Shape::Each(count, one) => {
                let all = 0..count.of(sizes);
                let values = all.map(|_| self.values(one, sizes, next, path));
                quote!([#(#values),*])
            }
            Shape::Tuple(parts) => {
                let values = parts
                    .iter()
                    .map(|(_, part)| self.values(part, sizes, next, path));
                quote!((#(#values),*))
            }
            // Written over series, in another file.
            Shape::Series => TokenStream::new(),
        }
    }
}
