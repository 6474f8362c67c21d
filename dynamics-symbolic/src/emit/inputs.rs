//! The inputs that a method reads before its first operation: arguments, fields, sines and cosines.

use super::names::{field, ident, punct, variable};
use crate::function::{Argument, Request, plain};
use crate::program::Program;
use crate::robot::{Robot, Symbol, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// Whether a field of the struct, or a function of a cell, is an input.
pub(super) fn reads_cells(robot: &Robot, program: &Program) -> bool {
    program.inputs.iter().any(|symbol| match symbol {
        Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_) | Symbol::Stribeck(_) => {
            true
        }
        // The factor of a follower.
        symbol => robot.follower_of(symbol).is_some(),
    })
}

/// A number of the arguments, if there is any: a robot without joints has no positions.
fn number_of(robot: &Robot, request: &Request) -> Option<TokenStream> {
    let has_joints = robot.freedoms().joints > 0;
    let mut arguments = request.arguments().into_iter();
    let argument = arguments.find(|argument| has_joints || *argument != Argument::Position)?;
    Some(element(argument, 0))
}

/// `real`, which makes a constant of a double in the arithmetic of the arguments, if there are any: lanes of a vector
/// know from each other alone how many they are.
pub(super) fn constants_of(robot: &Robot, request: &Request, path: &TokenStream) -> TokenStream {
    match number_of(robot, request) {
        Some(number) => constants_like(&number, path),
        None => {
            let real = ident("real");
            quote!(let #real = <T as #path::Scalar>::from_f64;)
        }
    }
}

/// `real`, which makes a constant of a double in the arithmetic of a number.
pub(super) fn constants_like(number: &TokenStream, path: &TokenStream) -> TokenStream {
    let (real, x) = (ident("real"), ident("x"));
    quote!(let #real = |#x: f64| #path::Scalar::constant(#number, #x);)
}

/// One element of an argument.
fn element(vector: Argument, i: usize) -> TokenStream {
    let (vector, i) = (ident(vector.name()), Literal::usize_unsuffixed(i));
    quote!(#vector.data.0[0][#i])
}

/// The element of an argument that belongs to a degree of freedom.
fn of_freedom(robot: &Robot, argument: Argument, freedom: usize) -> TokenStream {
    element(argument, robot.entry_of(argument, freedom))
}

/// The position or velocity behind a symbol's index; a follower's is that of the joint it follows times the factor.
fn of_joint(cells: &Cells, argument: Argument, i: usize) -> TokenStream {
    match cells.robot.followed(i) {
        None => of_freedom(cells.robot, argument, i),
        Some((leader, factor)) => {
            let x = of_freedom(cells.robot, argument, leader);
            let factor = cells.value(factor);
            quote!((#factor * #x))
        }
    }
}

/// The literal of a double, its sign apart.
pub(super) fn literal(x: f64) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed(x.abs());
    let sign = (x.is_sign_negative() && x != 0.0).then(|| quote!(-));
    quote!(#sign #magnitude)
}

/// The constant of a double, made by [`constants_of`].
pub(super) fn real(x: f64) -> TokenStream {
    let (real, x) = (ident("real"), literal(x));
    quote!(#real(#x))
}

/// The name of an input.
pub(super) fn input_name(robot: &Robot, symbol: &Symbol, angles: &[&Symbol]) -> String {
    let angle_number = |value: &Value| {
        let mut constant = angles.iter().filter_map(|symbol| match symbol {
            Symbol::AngleSine(angle) | Symbol::AngleCosine(angle) => Some(angle),
            _ => None,
        });
        1 + constant.position(|angle| angle == value).unwrap_or(0)
    };
    if let Some((argument, i)) = symbol.entry() {
        return format!("{}_{}", argument.name(), robot.entry_of(argument, i) + 1);
    }
    let angle = |i: usize| robot.entry_of(Argument::Position, i) + 1;
    match symbol {
        Symbol::Pi => "pi".to_owned(),
        Symbol::Field(i) => format!("p_{}", plain(&robot.fields[*i])),
        Symbol::AngleSine(angle) => format!("sa_{}", angle_number(angle)),
        Symbol::AngleCosine(angle) => format!("ca_{}", angle_number(angle)),
        Symbol::Sine(i) => format!("s_{}", angle(*i)),
        Symbol::Cosine(i) => format!("c_{}", angle(*i)),
        Symbol::VelocitySign(i) => format!("sign_{}", i + 1),
        Symbol::Stribeck(i) => format!("stribeck_{}", i + 1),
        _ => unreachable!("an entry of an argument"),
    }
}

/// The variables of a program's inputs.
pub fn input_names(robot: &Robot, program: &Program) -> Vec<String> {
    let angles = program.angles();
    let inputs = program.inputs.iter();
    inputs
        .map(|symbol| input_name(robot, symbol, &angles))
        .collect()
}

/// The inputs in the order in which they are read, each with its index.
pub fn in_order(program: &Program) -> Vec<(usize, &Symbol)> {
    let mut inputs: Vec<_> = program.inputs.iter().enumerate().collect();
    inputs.sort_by_key(|(_, symbol)| place(symbol));
    inputs
}

/// Reads what the program needs from the arguments and the fields, and nothing else.
pub(super) fn inputs(
    robot: &Robot,
    request: &Request,
    program: &Program,
    path: &TokenStream,
) -> TokenStream {
    let names = input_names(robot, program);
    let like = number_of(robot, request);
    let cells = Cells { robot, path, like };
    let mut lines = sines(&cells, true, &program.angles(), program);
    for (index, symbol) in in_order(program) {
        let value = match symbol {
            Symbol::VelocitySign(i) => {
                let velocity = of_joint(&cells, Argument::Velocity, *i);
                quote!(#path::Scalar::sign(#velocity))
            }
            Symbol::Stribeck(i) => stribeck(&cells, *i),
            Symbol::Field(i) => cells.value(&Value::Field(*i)),
            symbol => match symbol.entry() {
                Some((argument, i)) => of_freedom(robot, argument, i),
                None => continue,
            },
        };
        let name = variable(&names[index]);
        lines.extend(quote!(let #name = #value;));
    }
    lines
}

/// The inputs that no motion changes, where `real` is defined: fields, and sines and cosines of angles made of them.
pub(super) fn constant_inputs(robot: &Robot, program: &Program, path: &TokenStream) -> TokenStream {
    let mut angles = program.angles();
    angles.retain(|angle| angle.argument().is_none());
    let cells = Cells::constant(robot, path);
    let sines = sines(&cells, false, &angles, program);
    let fields = program.inputs.iter().filter_map(|symbol| match symbol {
        Symbol::Field(i) => Some((
            variable(&input_name(robot, symbol, &angles)),
            cells.field(*i),
        )),
        _ => None,
    });
    let (names, values): (Vec<_>, Vec<_>) = fields.unzip();
    quote!(#sines #(let #names = #values;)*)
}

/// A cell that no motion changes, where `real` is defined.
pub(super) fn constant_cell(robot: &Robot, value: &Value, path: &TokenStream) -> TokenStream {
    Cells::constant(robot, path).value(value)
}

/// The sines and cosines, all angles of a kind in one call, which evaluates them in the lanes of a
/// vector register. Where the runtime may know those of the joints, they are requested and come from `sines`.
fn sines(cells: &Cells, are_asked_for: bool, angles: &[&Symbol], program: &Program) -> TokenStream {
    let Cells { robot, path, .. } = cells;
    let pair = |sine: Symbol, cosine: Symbol| {
        let [s, c] = [sine, cosine].map(|symbol| {
            let is_read = program.inputs.contains(&symbol);
            is_read.then(|| variable(&input_name(robot, &symbol, angles)))
        });
        Pair(s, c)
    };
    let (mut joints, mut known, mut positions) = (Vec::new(), Vec::new(), Vec::new());
    let (mut pairs, mut arguments) = (Vec::new(), Vec::new());
    // In the order of the joints: angles that lie side by side are loaded together.
    let mut in_order = angles.to_vec();
    in_order.sort_by_key(|angle| place(angle));
    for angle in in_order {
        match angle {
            Symbol::Sine(i) | Symbol::Cosine(i) if are_asked_for && *i < robot.dof() => {
                let joint = robot.entry_of(Argument::Position, *i);
                joints.push(Literal::usize_unsuffixed(joint));
                known.push(pair(Symbol::Sine(*i), Symbol::Cosine(*i)));
                positions.push(of_freedom(robot, Argument::Position, *i));
            }
            Symbol::Sine(i) | Symbol::Cosine(i) => {
                pairs.push(pair(Symbol::Sine(*i), Symbol::Cosine(*i)));
                arguments.push(of_joint(cells, Argument::Position, *i));
            }
            Symbol::AngleSine(value) | Symbol::AngleCosine(value) => {
                let [sine, cosine] = [Symbol::AngleSine, Symbol::AngleCosine];
                pairs.push(pair(sine(value.clone()), cosine(value.clone())));
                arguments.push(cells.value(value));
            }
            _ => {}
        }
    }
    let (sines, patterns) = (ident("sines"), known.iter().map(Pair::pattern));
    let asked_for = match Pair::parts(&known, path) {
        _ if known.is_empty() => TokenStream::new(),
        None => quote! {
            let [#(#patterns),*] =
                #path::Inputs::sin_cos(#sines, [#(#joints),*], [#(#positions),*]);
        },
        Some(parts) => quote! {
            let [#(#patterns),*] =
                #path::Inputs::sin_cos_parts(#sines, [#(#joints),*], #parts, [#(#positions),*]);
        },
    };
    let patterns: Vec<_> = pairs.iter().map(Pair::pattern).collect();
    let evaluated = match (&patterns[..], &arguments[..], Pair::parts(&pairs, path)) {
        ([], ..) => TokenStream::new(),
        (_, _, Some(parts)) => quote! {
            let [#(#patterns),*] = #path::Scalar::sin_cos_parts([#(#arguments),*], #parts);
        },
        ([pair], [argument], _) => quote!(let #pair = #path::Scalar::sin_cos(#argument);),
        _ => quote!(let [#(#patterns),*] = #path::Scalar::sin_cos_array([#(#arguments),*]);),
    };
    quote!(#asked_for #evaluated)
}

/// The variables of the sine and of the cosine of an angle, where they are read.
struct Pair(Option<Ident>, Option<Ident>);

impl Pair {
    fn pattern(&self) -> TokenStream {
        let [sine, cosine] =
            [&self.0, &self.1].map(|name| name.as_ref().map_or(quote!(_), |name| quote!(#name)));
        quote!((#sine, #cosine))
    }

    /// The parts of each pair that are read, unless both are read of every pair.
    fn parts(pairs: &[Pair], path: &TokenStream) -> Option<TokenStream> {
        let parts = pairs.iter().map(|Pair(sine, cosine)| match (sine, cosine) {
            (Some(_), None) => quote!(#path::Part::Sine),
            (None, Some(_)) => quote!(#path::Part::Cosine),
            _ => quote!(#path::Part::Both),
        });
        let is_both = |pair: &Pair| pair.0.is_some() && pair.1.is_some();
        (!pairs.iter().all(is_both)).then(|| quote!([#(#parts),*]))
    }
}

/// The place of an input: fields first, then the arguments in their order.
fn place(symbol: &Symbol) -> (u8, usize) {
    match symbol {
        Symbol::Pi | Symbol::AngleSine(_) | Symbol::AngleCosine(_) => (0, 0),
        Symbol::Field(i) => (1, *i),
        Symbol::Sine(i) | Symbol::Cosine(i) => (2, *i),
        Symbol::Position(i) => (3, *i),
        Symbol::Velocity(i) => (4, *i),
        Symbol::VelocitySign(i) => (5, *i),
        Symbol::Stribeck(i) => (6, *i),
        Symbol::Acceleration(i) => (7, *i),
        Symbol::Force(i) => (8, *i),
        Symbol::Entry(argument, i) => (9 + *argument as u8, *i),
    }
}

/// exp(-(qd/v)^2) of the joint behind a symbol's index.
fn stribeck(cells: &Cells, joint: usize) -> TokenStream {
    let row = cells.robot.row_of(joint);
    let stribeck = row.and_then(|row| row.stribeck.as_ref());
    let v = stribeck.map(|stribeck| cells.value(&stribeck.velocity));
    let (qd, x) = (of_joint(cells, Argument::Velocity, joint), ident("x"));
    let path = cells.path;
    quote! {{
        let #x = #qd / #v;
        #path::Scalar::exp(-(#x * #x))
    }}
}

/// Parametric cells as expressions over the fields.
struct Cells<'a> {
    robot: &'a Robot,
    path: &'a TokenStream,
    /// A number of the method's arguments, where the runtime is asked for fields by `sines`: in lanes each may
    /// have its own.
    like: Option<TokenStream>,
}

impl<'a> Cells<'a> {
    fn constant(robot: &'a Robot, path: &'a TokenStream) -> Self {
        let like = None;
        Cells { robot, path, like }
    }

    fn value(&self, value: &Value) -> TokenStream {
        let (a, operator, b) = match value {
            Value::Rational(_) | Value::Pi => return real(value.to_f64(&[])),
            Value::Field(i) => return self.field(*i),
            Value::Neg(a) => {
                let a = self.value(a);
                return quote!((-#a));
            }
            Value::Add(a, b) => (a, '+', b),
            Value::Mul(a, b) => (a, '*', b),
            Value::Div(a, b) => (a, '/', b),
        };
        let (a, operator, b) = (self.value(a), punct(operator), self.value(b));
        quote!((#a #operator #b))
    }

    fn field(&self, index: usize) -> TokenStream {
        let name = field(&self.robot.fields[index]);
        match &self.like {
            Some(like) => {
                let (path, sines) = (self.path, ident("sines"));
                let index = Literal::usize_unsuffixed(index);
                quote!(#path::Inputs::field(#sines, #index, self.#name, #like))
            }
            None => {
                let real = ident("real");
                quote!(#real(self.#name))
            }
        }
    }
}
