//! The table in numbers, which the runtime's checks read.

use core::fmt::Debug;

use dynamics_symbolic::program::rounded_angle;
use dynamics_symbolic::robot::{
    Angle, Base, Body, Carrier, Coupling, Frame, Placement, Quantity, Robot, Row, Spring, Stribeck,
    Tool, Value,
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use crate::call::Structure;

/// The expression that builds the table.
pub(super) fn table(structure: &Structure, robot: &Robot, path: &TokenStream) -> TokenStream {
    let fields: Vec<&Ident> = structure
        .fields
        .iter()
        .filter_map(|f| f.name.as_ref())
        .collect();
    let convention = variant(robot.convention);
    let gravity = robot.gravity.iter().map(|value| number(value, &fields));
    let mut cell = |value: &Value, quantity| match quantity {
        Quantity::Angle => angle(value, &fields, path),
        Quantity::Number => number(value, &fields),
    };
    let cells: Vec<_> = robot.rows.iter().map(|row| row.map(&mut cell)).collect();
    let mut place = |places: &[Placement]| {
        let places = places.iter().map(|place| place.map(&mut cell));
        placement(&places.collect::<Vec<_>>(), path)
    };
    let mut placements = Vec::with_capacity(cells.len());
    for (i, row) in robot.rows.iter().enumerate() {
        let [mount, link_frame] = robot.mounted(i);
        let tip = row
            .tip()
            .map(|tip| place(tip).unwrap_or_else(|| quote!(#path::Placement::IDENTITY)));
        placements.push([place(&mount), place(&link_frame), tip]);
    }
    let rows = cells.iter().zip(placements);
    let rows = rows.map(|(cells, placements)| row(cells, placements, path));
    let frames = robot.frames.iter();
    let frames: Vec<_> = frames
        .map(|frame| fixed_frame(&frame.map(&mut cell), path))
        .collect();
    let base = robot.base.as_ref().map(|base| base.map(&mut cell));
    let (made, motions): (_, Vec<_>) = if robot.floating().is_some() {
        let motions = cells.iter().map(|row| motion(row, path)).collect();
        (quote!(with_floating_base), motions)
    } else if robot.is_coupled() || !frames.is_empty() {
        let made = if frames.is_empty() {
            quote!(couple)
        } else {
            quote!(with_frames)
        };
        (made, cells.iter().map(|row| motion(row, path)).collect())
    } else if robot.rows.iter().any(|row| row.locked.is_some()) {
        (
            quote!(lock),
            cells
                .iter()
                .map(|row| option(row.locked.as_ref()))
                .collect(),
        )
    } else {
        (quote!(new), Vec::new())
    };
    let (base, floating) = match &base {
        Some(Base::Standing(placement)) => {
            let frame = frame(placement, path);
            (Some(quote!(base: #frame,)), None)
        }
        Some(Base::Floating(body)) => {
            let body = floating(body, path);
            (None, Some(quote!(#body,)))
        }
        None => (None, None),
    };
    let has = |list: &[TokenStream]| floating.is_some() || !list.is_empty();
    let motions = has(&motions).then(|| quote!([#(#motions),*],));
    let frames = has(&frames).then(|| quote!([#(#frames),*],));
    let arm = quote! {
        #path::Table::#made(
            #floating #path::Convention::#convention, [#(#gravity),*], [#(#rows),*], #motions #frames
        )
    };
    let tool = robot.tool.as_ref().map(|tool| {
        let tool = self::tool(&tool.map(&mut cell), path);
        quote!(tool: #tool,)
    });
    if base.is_none() && tool.is_none() {
        arm
    } else {
        quote!(#path::Table { #base #tool ..#arm })
    }
}

/// The name of a variant.
fn variant(value: impl Debug) -> Ident {
    Ident::new(&format!("{value:?}"), Span::call_site())
}

fn option(value: Option<impl ToTokens>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}

/// How the joint of a row moves.
fn motion(row: &Row<TokenStream>, path: &TokenStream) -> TokenStream {
    match (&row.locked, &row.follows) {
        (Some(position), _) => quote!(#path::JointMotion::Locked(#position)),
        (None, Some(coupling)) => {
            let Coupling {
                leader,
                factor,
                offset,
            } = coupling;
            let leader = Literal::usize_unsuffixed(*leader);
            quote! {
                #path::JointMotion::Follows { leader: #leader, factor: #factor, offset: #offset }
            }
        }
        (None, None) => quote!(#path::JointMotion::Free),
    }
}

fn frame(Placement { xyz, rpy }: &Placement<TokenStream>, path: &TokenStream) -> TokenStream {
    quote!(#path::Frame { xyz: [#(#xyz),*], rpy: [#(#rpy),*] })
}

/// The body of a base that moves.
fn floating(body: &Body<TokenStream>, path: &TokenStream) -> TokenStream {
    let Body { mass, com, inertia } = body;
    quote!(#path::FloatingBase { mass: #mass, com: [#(#com),*], inertia: [#(#inertia),*] })
}

fn tool(tool: &Tool<TokenStream>, path: &TokenStream) -> TokenStream {
    let frame = frame(&tool.placement, path);
    let Body { mass, com, inertia } = &tool.body;
    quote! {
        #path::Tool {
            frame: #frame,
            mass: #mass,
            com: [#(#com),*],
            inertia: [#(#inertia),*],
        }
    }
}

/// A frame on a link or on the base, and its body.
fn fixed_frame(frame: &Frame<TokenStream>, path: &TokenStream) -> TokenStream {
    let on = option(frame.on.map(Literal::usize_unsuffixed));
    let place = placement(&frame.places, path);
    let place = place.unwrap_or_else(|| quote!(#path::Placement::IDENTITY));
    let body = frame.body.as_ref().map(|Body { mass, com, inertia }| {
        quote!(mass: #mass, com: [#(#com),*], inertia: [#(#inertia),*],)
    });
    quote!(#path::FixedFrame { #body ..#path::FixedFrame::new(#on, #place) })
}

/// The last of some frames, each placed in the one before it; `None` where there are none.
fn placement(placements: &[Placement<TokenStream>], path: &TokenStream) -> Option<TokenStream> {
    let frames = placements.iter().map(|placement| frame(placement, path));
    let frames: Vec<_> = frames.collect();
    (!frames.is_empty()).then(|| quote!(#path::Placement::of_frames(&[#(#frames),*])))
}

/// The row of the runtime; how its joint moves is said apart from it.
fn row(
    row: &Row<TokenStream>,
    placements: [Option<TokenStream>; 3],
    path: &TokenStream,
) -> TokenStream {
    let joint_type = variant(row.joint_type);
    let on = match row.on {
        Carrier::Above => None,
        Carrier::Base => Some(quote!(on: #path::Carrier::Base,)),
        Carrier::Row(carrier) => {
            let carrier = Literal::usize_unsuffixed(carrier);
            Some(quote!(on: #path::Carrier::Row(#carrier),))
        }
    };
    let cells = row.cells().map(|(name, values)| {
        let name = Ident::new(name, Span::call_site());
        match values {
            [value] => quote!(#name: #value,),
            values => quote!(#name: [#(#values),*],),
        }
    });
    let stribeck = row.stribeck.as_ref();
    let stribeck = stribeck.map(|Stribeck { friction, velocity }| {
        quote! {
            stribeck: ::core::option::Option::Some(#path::Stribeck {
                friction: #friction,
                velocity: #velocity,
            }),
        }
    });
    let spring = row.spring.as_ref();
    let spring = spring.map(|Spring { stiffness, rest }| {
        quote!(spring: #path::Spring { stiffness: #stiffness, rest: #rest },)
    });
    let limits = range(row.limits.as_ref());
    let greatest = [
        ("torque_limit", &row.torque_limit),
        ("velocity_limit", &row.velocity_limit),
    ];
    let greatest = greatest.into_iter().filter_map(|(name, value)| {
        let (name, value) = (
            Ident::new(name, Span::call_site()),
            option(Some(value.as_ref()?)),
        );
        Some(quote!(#name: #value,))
    });
    let [mount, link_frame, tip] = placements;
    let mount = mount.map(|placement| quote!(mount: #placement,));
    let link_frame = link_frame.map(|placement| quote!(link_frame: #placement,));
    let tip = tip.map(|placement| quote!(tip: ::core::option::Option::Some(#placement),));
    quote! {
        #path::Row {
            #on
            #(#cells)*
            #stribeck
            #spring
            limits: #limits,
            #(#greatest)*
            #mount
            #link_frame
            #tip
            ..#path::Row::new(#path::JointType::#joint_type)
        }
    }
}

/// The range of a joint: numbers, for no field may stand there.
pub(super) fn limits(row: &Row) -> TokenStream {
    let numbers = |limits: &[Value; 2]| limits.each_ref().map(|value| number(value, &[]));
    range(row.limits.as_ref().map(numbers).as_ref())
}

/// The greatest torques of the joints, and their greatest velocities.
pub(super) fn greatest(robot: &Robot) -> [Vec<TokenStream>; 2] {
    let of = |cell: fn(&Row) -> &Option<Value>| {
        let cells = robot.joints().map(cell);
        cells
            .map(|cell| option(cell.as_ref().map(|value| number(value, &[]))))
            .collect()
    };
    [of(|row| &row.torque_limit), of(|row| &row.velocity_limit)]
}

fn range(limits: Option<&[TokenStream; 2]>) -> TokenStream {
    option(limits.map(|[lower, upper]| quote!([#lower, #upper])))
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
    let binary = |a, operator, b| {
        let (a, b): (TokenStream, TokenStream) = (number(a), number(b));
        quote!((#a #operator #b))
    };
    match value {
        Value::Field(index) => {
            let field = fields[*index];
            quote!(self.#field)
        }
        Value::Neg(a) => {
            let a = number(a);
            quote!((-#a))
        }
        Value::Add(a, b) => binary(a, quote!(+), b),
        Value::Mul(a, b) => binary(a, quote!(*), b),
        Value::Div(a, b) => binary(a, quote!(/), b),
        Value::Rational(_) | Value::Pi => literal(value.to_f64(&[])),
    }
}

/// The number as a literal that reads back as the same double, its sign apart: a
/// literal token holds none.
fn literal(number: f64) -> TokenStream {
    let magnitude = Literal::f64_suffixed(number.abs());
    if number < 0.0 {
        quote!((-#magnitude))
    } else {
        quote!(#magnitude)
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
