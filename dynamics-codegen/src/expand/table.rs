//! The table in numbers, which the runtime's checks read.

use dynamics_symbolic::program::rounded_angle;
use dynamics_symbolic::robot::{Angle, Convention, JointType, Placement, Robot, Row, Tool, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::call::Structure;

/// The expression that builds the table.
pub(super) fn table(structure: &Structure, robot: &Robot, path: &TokenStream) -> TokenStream {
    let fields: Vec<&Ident> = structure
        .fields
        .iter()
        .filter_map(|f| f.name.as_ref())
        .collect();
    let convention = match robot.convention {
        Convention::Standard => quote!(#path::Convention::Standard),
        Convention::Modified => quote!(#path::Convention::Modified),
    };
    let gravity = robot.gravity.iter().map(|value| number(value, &fields));
    let rows = robot.rows.iter().map(|row| self::row(row, &fields, path));
    let is_locked = |row: &Row| row.locked.is_some();
    let arm = match robot.rows.iter().any(is_locked) {
        _ if robot.is_coupled() => {
            let motions = motions(robot, &fields, path);
            quote! {
                #path::Table::couple(
                    #convention,
                    [#(#gravity),*],
                    [#(#rows),*],
                    [#(#motions),*],
                )
            }
        }
        true => {
            let positions = positions(robot, &fields, path);
            quote! {
                #path::Table::lock(
                    #convention,
                    [#(#gravity),*],
                    [#(#rows),*],
                    [#(#positions),*],
                )
            }
        }
        false => quote!(#path::Table::new(#convention, [#(#gravity),*], [#(#rows),*])),
    };
    let base = robot.base.as_ref().map(|base| {
        let frame = frame(base, &fields, path);
        quote!(base: #frame,)
    });
    let tool = robot.tool.as_ref().map(|tool| {
        let tool = self::tool(tool, &fields, path);
        quote!(tool: #tool,)
    });
    match base.is_none() && tool.is_none() {
        true => arm,
        false => quote!(#path::Table { #base #tool ..#arm }),
    }
}

/// Where the joints of all rows are locked.
fn positions(robot: &Robot, fields: &[&Ident], path: &TokenStream) -> Vec<TokenStream> {
    let position = |row: &Row| match (&row.locked, row.joint_type) {
        (Some(position), JointType::Revolute) => {
            let position = angle(position, fields, path);
            quote!(::core::option::Option::Some(#position))
        }
        (Some(position), JointType::Prismatic) => {
            let position = number(position, fields);
            quote!(::core::option::Option::Some(#position))
        }
        (None, _) => quote!(::core::option::Option::None),
    };
    robot.rows.iter().map(position).collect()
}

/// How the joints of all rows move.
fn motions(robot: &Robot, fields: &[&Ident], path: &TokenStream) -> Vec<TokenStream> {
    let position = |value: &Value, joint_type| match joint_type {
        JointType::Revolute => angle(value, fields, path),
        JointType::Prismatic => number(value, fields),
    };
    let motion = |row: &Row| match (&row.locked, &row.follows) {
        (Some(locked), _) => {
            let position = position(locked, row.joint_type);
            quote!(#path::JointMotion::Locked(#position))
        }
        (None, Some(coupling)) => {
            let leader = Literal::usize_unsuffixed(coupling.leader);
            let factor = number(&coupling.factor, fields);
            let offset = position(&coupling.offset, row.joint_type);
            quote! {
                #path::JointMotion::Follows { leader: #leader, factor: #factor, offset: #offset }
            }
        }
        (None, None) => quote!(#path::JointMotion::Free),
    };
    robot.rows.iter().map(motion).collect()
}

fn frame(placement: &Placement, fields: &[&Ident], path: &TokenStream) -> TokenStream {
    let xyz = placement.xyz.iter().map(|value| number(value, fields));
    let rpy = placement.rpy.iter().map(|value| angle(value, fields, path));
    quote!(#path::Frame { xyz: [#(#xyz),*], rpy: [#(#rpy),*] })
}

fn tool(tool: &Tool, fields: &[&Ident], path: &TokenStream) -> TokenStream {
    let frame = frame(&tool.placement, fields, path);
    let mass = number(&tool.mass, fields);
    let com = tool.com.iter().map(|value| number(value, fields));
    let inertia = tool.inertia.iter().map(|value| number(value, fields));
    quote! {
        #path::Tool {
            frame: #frame,
            mass: #mass,
            com: [#(#com),*],
            inertia: [#(#inertia),*],
        }
    }
}

fn row(row: &Row, fields: &[&Ident], path: &TokenStream) -> TokenStream {
    let joint_type = match row.joint_type {
        JointType::Revolute => quote!(#path::JointType::Revolute),
        JointType::Prismatic => quote!(#path::JointType::Prismatic),
    };
    let [a, d] = [&row.a, &row.d].map(|value| number(value, fields));
    let [alpha, theta] = [&row.alpha, &row.theta].map(|value| angle(value, fields, path));
    let mass = number(&row.mass, fields);
    let com = row.com.iter().map(|value| number(value, fields));
    let inertia = row.inertia.iter().map(|value| number(value, fields));
    let [motor_inertia, gear_ratio] =
        [&row.motor_inertia, &row.gear_ratio].map(|value| number(value, fields));
    let viscous = number(&row.viscous, fields);
    let coulomb = row.coulomb.iter().map(|value| number(value, fields));
    let stribeck = row.stribeck.as_ref().map(|stribeck| {
        let [friction, velocity] =
            [&stribeck.friction, &stribeck.velocity].map(|value| number(value, fields));
        quote! {
            stribeck: ::core::option::Option::Some(#path::Stribeck {
                friction: #friction,
                velocity: #velocity,
            }),
        }
    });
    let spring = row.spring.as_ref().map(|spring| {
        let [stiffness, rest] =
            [&spring.stiffness, &spring.rest].map(|value| number(value, fields));
        quote!(spring: #path::Spring { stiffness: #stiffness, rest: #rest },)
    });
    let limits = self::limits(row);
    let places = row.mount.iter().flat_map(|mount| &mount.frame);
    let places: Vec<_> = places.map(|place| frame(place, fields, path)).collect();
    let link_frame = (!places.is_empty())
        .then(|| quote!(link_frame: #path::Placement::of_frames(&[#(#places),*]),));
    quote! {
        #path::Row {
            a: #a,
            alpha: #alpha,
            d: #d,
            theta: #theta,
            mass: #mass,
            com: [#(#com),*],
            inertia: [#(#inertia),*],
            motor_inertia: #motor_inertia,
            gear_ratio: #gear_ratio,
            viscous: #viscous,
            coulomb: [#(#coulomb),*],
            #stribeck
            #spring
            limits: #limits,
            #link_frame
            ..#path::Row::new(#joint_type)
        }
    }
}

/// The range of a joint: numbers, for no field may stand there.
pub(super) fn limits(row: &Row) -> TokenStream {
    match &row.limits {
        Some(limits) => {
            let limits = limits.iter().map(|value| number(value, &[]));
            quote!(::core::option::Option::Some([#(#limits),*]))
        }
        None => quote!(::core::option::Option::None),
    }
}

/// An angle, from the same parts as the engine's sine and cosine of it: a constant as the double that
/// means it, any other as what is left beside its quarter turns, and these.
fn angle(value: &Value, fields: &[&Ident], path: &TokenStream) -> TokenStream {
    if value.is_number() {
        return literal(rounded_angle(value));
    }
    let parts = Angle::new(value);
    let quarter_turns = parts.signed_quarter_turns();
    let rest = number(&parts.rest.unwrap_or_else(Value::zero), fields);
    match quarter_turns {
        0 => rest,
        quarter_turns => {
            let quarter_turns = literal(f64::from(quarter_turns));
            quote!(#path::turned(#rest, #quarter_turns))
        }
    }
}

/// The value as an `f64` expression: one literal where it is known, rounded once where
/// it is rational.
fn number(value: &Value, fields: &[&Ident]) -> TokenStream {
    if value.is_number() {
        return literal(value.to_f64(&[]));
    }
    let number = |value: &Value| number(value, fields);
    match value {
        Value::Field(index) => {
            let field = fields[*index];
            quote!(self.#field)
        }
        Value::Neg(a) => {
            let a = number(a);
            quote!((-#a))
        }
        Value::Add(a, b) => {
            let (a, b) = (number(a), number(b));
            quote!((#a + #b))
        }
        Value::Mul(a, b) => {
            let (a, b) = (number(a), number(b));
            quote!((#a * #b))
        }
        Value::Div(a, b) => {
            let (a, b) = (number(a), number(b));
            quote!((#a / #b))
        }
        Value::Rational(_) | Value::Pi => literal(value.to_f64(&[])),
    }
}

/// The number as a literal that reads back as the same double, its sign apart: a
/// literal token holds none.
fn literal(number: f64) -> TokenStream {
    let magnitude = Literal::f64_suffixed(number.abs());
    match number < 0.0 {
        true => quote!((-#magnitude)),
        false => quote!(#magnitude),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_are_single_literals() {
        let pi_half = Value::Pi.checked_div(Value::integer(2)).unwrap();
        assert_eq!(number(&pi_half, &[]).to_string(), "1.5707963267948966f64");
        let tenth = Value::integer(1).checked_div(Value::integer(10)).unwrap();
        assert_eq!(number(&-tenth, &[]).to_string(), "(- 0.1f64)");
    }

    #[test]
    fn right_angles_are_right_however_they_are_written() {
        let ten_digits = Value::integer(1_570_796_327).checked_div(Value::integer(1_000_000_000));
        let ten_digits = ten_digits.unwrap();
        assert_eq!(
            angle(&-ten_digits, &[], &quote!(path)).to_string(),
            "(- 1.5707963267948966f64)"
        );
        let eight_digits = Value::integer(15_707_963).checked_div(Value::integer(10_000_000));
        assert_eq!(
            angle(&eight_digits.unwrap(), &[], &quote!(path)).to_string(),
            "1.5707963f64"
        );
    }

    #[test]
    fn quarter_turns_are_kept_apart_from_fields() {
        let field = Ident::new("off", proc_macro2::Span::call_site());
        let ten_digits = Value::integer(15_707_963_268).checked_div(Value::integer(10_000_000_000));
        let sum = Value::field(0) - ten_digits.unwrap();
        let tokens = angle(&sum, &[&field], &quote!(path)).to_string();
        assert_eq!(tokens, "path :: turned (self . off , (- 1f64))");
    }

    #[test]
    fn fields_are_read_from_the_struct() {
        let field = Ident::new("l1", proc_macro2::Span::call_site());
        let value = Value::field(0) * Value::integer(2) - Value::integer(1);
        let tokens = number(&value, &[&field]).to_string();
        assert_eq!(tokens, "((self . l1 * 2f64) + (- 1f64))");
    }
}
