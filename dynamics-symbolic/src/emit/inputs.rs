//! What a method reads before its first operation: arguments, fields, sines and cosines.

use super::names::{field, ident, plain};
use crate::function::{Argument, Request};
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

/// `real`, which makes a constant of a double in the arithmetic of the arguments, if there are any:
/// lanes of a vector know the processor's instructions, and so how many they are, from each other
/// alone.
pub(super) fn constants_of(arguments: &[Argument], path: &TokenStream) -> TokenStream {
    match arguments.first() {
        Some(argument) => constants_like(&element(*argument, 0), path),
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

/// Position or velocity behind a symbol's index: of a follower, that of the joint it follows times the
/// factor.
fn of_joint(cells: &Cells, argument: Argument, i: usize) -> TokenStream {
    match cells.robot.followed(i) {
        None => element(argument, i),
        Some((leader, factor)) => {
            let (factor, x) = (cells.value(factor), element(argument, leader));
            quote!((#factor * #x))
        }
    }
}

/// The literal of a double, its sign apart.
pub(super) fn literal(x: f64) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed(x.abs());
    if x.is_sign_negative() && x != 0.0 {
        quote!(-#magnitude)
    } else {
        quote!(#magnitude)
    }
}

/// The variable of an input. Names end in `_i`: an identifier pattern that
/// happens to be the name of a user's constant would be that constant.
pub(super) fn input_name(robot: &Robot, symbol: &Symbol, angles: &[&Symbol]) -> String {
    let angle_number = |value: &Value| {
        let same = |symbol: &&Symbol| match symbol {
            Symbol::AngleSine(other) | Symbol::AngleCosine(other) => other == value,
            _ => false,
        };
        angles
            .iter()
            .filter(|s| matches!(s, Symbol::AngleSine(_) | Symbol::AngleCosine(_)))
            .position(same)
            .unwrap_or(0)
            + 1
    };
    match symbol {
        Symbol::Pi => "pi".to_owned(),
        Symbol::Field(i) => format!("p_{}", plain(&robot.fields[*i])),
        Symbol::AngleSine(angle) => format!("sa_{}", angle_number(angle)),
        Symbol::AngleCosine(angle) => format!("ca_{}", angle_number(angle)),
        Symbol::Sine(i) => format!("s_{}", i + 1),
        Symbol::Cosine(i) => format!("c_{}", i + 1),
        Symbol::Position(i) => format!("q_{}", i + 1),
        Symbol::Velocity(i) => format!("qd_{}", i + 1),
        Symbol::Acceleration(i) => format!("qdd_{}", i + 1),
        Symbol::Force(i) => format!("tau_{}", i + 1),
        Symbol::VelocitySign(i) => format!("sign_{}", i + 1),
        Symbol::Stribeck(i) => format!("stribeck_{}", i + 1),
        Symbol::Entry(argument, i) => format!("{}_{}", argument.name(), i + 1),
    }
}

/// Reads what the program needs from the arguments and the fields, and nothing else.
pub(super) fn inputs(
    robot: &Robot,
    request: &Request,
    program: &Program,
    path: &TokenStream,
) -> TokenStream {
    let angles = program.angles();
    let name = |symbol: &Symbol| ident(&input_name(robot, symbol, &angles));
    let like = request.arguments().first().map(|first| element(*first, 0));
    let cells = Cells { robot, path, like };
    let mut lines = sines(&cells, true, &angles, program);
    let mut symbols: Vec<_> = program.inputs.iter().collect();
    symbols.sort_by_key(|symbol| place(symbol));
    for symbol in symbols {
        let value = match symbol {
            Symbol::Position(i) => element(Argument::Position, *i),
            Symbol::Velocity(i) => element(Argument::Velocity, *i),
            Symbol::Acceleration(i) => element(Argument::Acceleration, *i),
            Symbol::Force(i) => element(Argument::Force, *i),
            Symbol::Entry(argument, i) => element(*argument, *i),
            Symbol::VelocitySign(i) => {
                let velocity = of_joint(&cells, Argument::Velocity, *i);
                quote!(#path::Scalar::sign(#velocity))
            }
            Symbol::Stribeck(i) => stribeck(&cells, *i),
            Symbol::Field(i) => cells.value(&Value::Field(*i)),
            _ => continue,
        };
        let name = name(symbol);
        lines.extend(quote!(let #name = #value;));
    }
    lines
}

/// The inputs that no motion changes: fields, and sines and cosines of angles made of them. They
/// expect `real` to be defined.
pub(super) fn constant_inputs(robot: &Robot, program: &Program, path: &TokenStream) -> TokenStream {
    let angles = program.angles();
    let constant = |angle: &&Symbol| !matches!(angle, Symbol::Sine(_) | Symbol::Cosine(_));
    let of_constants: Vec<_> = angles.iter().copied().filter(constant).collect();
    let cells = Cells {
        robot,
        path,
        like: None,
    };
    let mut lines = sines(&cells, false, &of_constants, program);
    for symbol in &program.inputs {
        if let Symbol::Field(i) = symbol {
            let name = ident(&input_name(robot, symbol, &angles));
            let value = cells.value(&Value::Field(*i));
            lines.extend(quote!(let #name = #value;));
        }
    }
    lines
}

/// A cell that no motion changes, where `real` is defined.
pub(super) fn constant_cell(robot: &Robot, value: &Value, path: &TokenStream) -> TokenStream {
    let cells = Cells {
        robot,
        path,
        like: None,
    };
    cells.value(value)
}

/// The sines and cosines, all angles of a kind in one call, which evaluates them in the lanes of a
/// vector register. Where the runtime may know those of the joints, they are asked for and come from `sines`.
fn sines(cells: &Cells, are_asked_for: bool, angles: &[&Symbol], program: &Program) -> TokenStream {
    let Cells { robot, path, .. } = cells;
    let pair = |sine: Symbol, cosine: Symbol| {
        let [s, c] = [sine, cosine].map(|symbol| {
            let is_read = program.inputs.contains(&symbol);
            is_read.then(|| ident(&input_name(robot, &symbol, angles)))
        });
        Pair(s, c)
    };
    let (mut joints, mut known, mut positions) = (Vec::new(), Vec::new(), Vec::new());
    let (mut pairs, mut arguments) = (Vec::new(), Vec::new());
    // In the order of the joints: angles that lie side by side are loaded together.
    let mut angles = angles.to_vec();
    angles.sort_by_key(|angle| place(angle));
    for angle in &angles {
        match angle {
            Symbol::Sine(i) | Symbol::Cosine(i) if are_asked_for && *i < robot.dof() => {
                joints.push(Literal::usize_unsuffixed(*i));
                known.push(pair(Symbol::Sine(*i), Symbol::Cosine(*i)));
                positions.push(element(Argument::Position, *i));
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

/// The variables of the sine and the cosine of an angle, of those that are read.
struct Pair(Option<Ident>, Option<Ident>);

impl Pair {
    /// What they are bound by.
    fn pattern(&self) -> TokenStream {
        let [sine, cosine] = [&self.0, &self.1].map(|name| match name {
            Some(name) => quote!(#name),
            None => quote!(_),
        });
        quote!((#sine, #cosine))
    }

    /// Which of them are read, where that is not both of every angle.
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

/// Where an input is read: fields first, then the arguments in their order.
pub(super) fn place(symbol: &Symbol) -> (u8, usize) {
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

impl Cells<'_> {
    fn value(&self, value: &Value) -> TokenStream {
        let real = ident("real");
        match value {
            Value::Rational(_) | Value::Pi => {
                let x = literal(value.to_f64(&[]));
                quote!(#real(#x))
            }
            Value::Field(i) => self.field(*i),
            Value::Neg(a) => {
                let a = self.value(a);
                quote!((-#a))
            }
            Value::Add(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                quote!((#a + #b))
            }
            Value::Mul(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                quote!((#a * #b))
            }
            Value::Div(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                quote!((#a / #b))
            }
        }
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
