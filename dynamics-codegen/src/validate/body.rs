//! The body of a row or of the tool, and whether one can have its inertia.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{self, Value};

use super::known::all;
use super::scope::Scope;
use super::solid;
use crate::description::{Body, Expr, Given, Inertia, Solid, Tensor};
use crate::mistake::joint as mistake;
use crate::place::Place;

/// The body; `None` where one of its cells is in error.
pub(super) fn body(body: &Body, scope: &mut Scope) -> Option<robot::Body> {
    let mass = scope.not_negative(&body.mass, "a mass");
    let com = scope.given_vector(&body.com);
    report_massless(body, com.as_ref(), scope);
    let inertia = match (&body.inertia, &body.inertia_at_origin) {
        (inertia, Given::Absent) => inertia_about_com(inertia, body, mass.as_ref(), scope),
        (Given::Absent, Given::Unreadable) => None,
        (Given::Absent, Given::As(tensor)) => {
            moved(tensor, body, mass.as_ref().zip(com.as_ref()), scope)
        }
        (_, tensor) => {
            if let Given::As(tensor) = tensor {
                scope.error(tensor.place, mistake::two_inertias());
            }
            None
        }
    };
    Some(robot::Body {
        mass: mass?,
        com: com?,
        inertia: inertia?,
    })
}

/// Reports a centre of mass, or more than the moment about one axis, where no mass is written.
///
/// That moment is all that matters of a body that turns about this axis alone, and tables are published with
/// it and without a mass: the PUMA's first link has `inertia: { yy: 0.35 }`. A mass of zero is written
/// where none is meant.
fn report_massless(body: &Body, com: Option<&[Value; 3]>, scope: &Scope) {
    if !body.mass.is_absent() || scope.allowed().odd_mass {
        return;
    }
    let is_elsewhere = com.is_some_and(|com| com.iter().any(|component| !component.is_zero()));
    if let Some([Some(first), _, Some(last)]) = body.com.value().filter(|_| is_elsewhere) {
        let place = first.place.to(last.place);
        scope.error(place, mistake::com_without_mass(scope.place()));
        return;
    }
    if let Given::As(Inertia::Tensor(tensor)) = &body.inertia
        && tensor.values.iter().filter_map(Given::value).count() > 1
    {
        scope.error(tensor.place, mistake::tensor_without_mass(scope.place()));
    }
}

/// The tensor about the centre of mass: entries xx, yy, zz, xy, yz, xz.
fn inertia_about_com(
    inertia: &Given<Inertia>,
    body: &Body,
    mass: Option<&Value>,
    scope: &mut Scope,
) -> Option<[Value; 6]> {
    inertia.read([0; 6].map(Value::integer), |inertia| match inertia {
        Inertia::Solid(place, solid, sizes) => {
            if body.mass.is_absent() {
                scope.error(*place, mistake::solid_without_mass(scope.place()));
            }
            self::solid(*solid, sizes, mass, scope)
        }
        Inertia::Tensor(tensor) => {
            let entries = &tensor.values;
            let values = all(entries.each_ref().map(|entry| scope.given(entry)))?;
            possible(known(entries, &values, scope), tensor.place, scope)?;
            Some(values)
        }
    })
}

/// The tensor about the centre of mass, from one about the frame's origin.
fn moved(
    tensor: &Tensor,
    body: &Body,
    place: Option<(&Value, &[Value; 3])>,
    scope: &mut Scope,
) -> Option<[Value; 6]> {
    for (word, is_absent) in [
        ("mass", body.mass.is_absent()),
        ("com", body.com.is_absent()),
    ] {
        if is_absent {
            return scope.refused(tensor.place, mistake::cannot_be_moved(word, scope.place()));
        }
    }
    let values = all(tensor.values.each_ref().map(|entry| scope.given(entry)))?;
    let (mass, com) = place?;
    let values = about_center_of_mass(values, mass, com);
    possible(values.each_ref().map(number), tensor.place, scope)?;
    Some(values)
}

/// `J_com = J_origin - m (c.c 1 - c c')`, the parallel-axis theorem (Huygens, Steiner), exactly.
fn about_center_of_mass(tensor: [Value; 6], mass: &Value, com: &[Value; 3]) -> [Value; 6] {
    let moment = |i: usize, j: usize| mass.clone() * (com[i].clone() * com[j].clone());
    let [xx, yy, zz, xy, yz, xz] = tensor;
    [
        xx - moment(1, 1) - moment(2, 2),
        yy - moment(0, 0) - moment(2, 2),
        zz - moment(0, 0) - moment(1, 1),
        xy + moment(0, 1),
        yz + moment(1, 2),
        xz + moment(0, 2),
    ]
}

/// Reports a tensor that no body has, unless that is allowed: then it is `None`.
fn possible(entries: [Option<Rational>; 6], place: Place, scope: &Scope) -> Option<()> {
    match refusal(&entries).filter(|_| !scope.allowed().unphysical_inertia) {
        None => Some(()),
        Some(reason) => scope.refused(place, mistake::no_body(reason, scope.place())),
    }
}

fn solid(
    solid: Solid,
    sizes: &[Option<Expr>],
    mass: Option<&Value>,
    scope: &mut Scope,
) -> Option<[Value; 6]> {
    let mut values = Vec::new();
    for size in sizes.iter().flatten() {
        let value = scope.value(size);
        if value.as_ref().is_some_and(Value::is_negative) {
            scope.error(size.place, mistake::negative("a length"));
        }
        values.extend(value);
    }
    solid::tensor(solid, mass?, &values)
}

/// The entries that are known numbers.
///
/// One diagonal entry alone is the moment about one axis, which is all that matters
/// of a planar arm's link or of the link next to the base: then the other two are
/// taken as not known. Elsewhere, and of a base that moves, what is left out is zero.
fn known(entries: &[Given<Expr>; 6], values: &[Value; 6], scope: &Scope) -> [Option<Rational>; 6] {
    let is_absent = |i: usize| i < 3 && entries[i].is_absent();
    let is_one_moment = !scope.is_in_base() && (0..3).filter(|i| is_absent(*i)).count() == 2;
    core::array::from_fn(|i| number(&values[i]).filter(|_| !(is_one_moment && is_absent(i))))
}

/// The value where it is a number; one with pi in it to double precision.
fn number(value: &Value) -> Option<Rational> {
    match value.as_rational() {
        Some(rational) => Some(rational.clone()),
        None if value.is_number() => Rational::try_from(value.to_f64(&[])).ok(),
        None => None,
    }
}

/// Why no mass distribution has this tensor, as far as its entries are known.
///
/// With a density rho >= 0 the tensor is `J = tr(S) 1 - S`, where `S`, the integral of
/// `rho r r'`, is positive semidefinite, and every such `S` belongs to some density.
/// Since `S = tr(J)/2 1 - J`, a tensor is possible exactly where `tr(J)/2 1 - J` is
/// positive semidefinite, which is the triangle inequality of the principal moments
/// (Wensing, Kim and Slotine 2018, IEEE RA-L 3(1), 60-67). It makes `J` positive
/// semidefinite too; that is decided first, for a clearer message.
pub(crate) fn refusal(entries: &[Option<Rational>; 6]) -> Option<&'static str> {
    let [xx, yy, zz, xy, yz, xz] = entries.clone();
    let half_trace = match (&xx, &yy, &zz) {
        (Some(xx), Some(yy), Some(zz)) => Some((xx + yy + zz) / Rational::from(2)),
        _ => None,
    };
    let scale = entries.iter().flatten().map(magnitude).max()?;
    let second_moment = |j: &Option<Rational>| Some(half_trace.as_ref()? - j.as_ref()?);
    let opposite = |j: &Option<Rational>| Some(-j.as_ref()?.clone());
    let s = [&xx, &yy, &zz].map(second_moment);
    let [s_xy, s_yz, s_xz] = [&xy, &yz, &xz].map(opposite);
    let [s_xx, s_yy, s_zz] = s;
    let least = -slack() * &scale;
    if [&xx, &yy, &zz].into_iter().flatten().any(|j| *j < least) {
        return Some("a moment of inertia is negative");
    }
    if !is_semidefinite(&[xx, yy, zz, xy, yz, xz], &scale) {
        return Some("one of its principal moments is negative");
    }
    if !is_semidefinite(&[s_xx, s_yy, s_zz, s_xy, s_yz, s_xz], &scale) {
        return Some("the largest principal moment exceeds the sum of the other two");
    }
    None
}

/// Whether every principal minor of the symmetric matrix that is known is at least
/// zero (exact arithmetic). Entries that are decimals of limiting cases, such as a
/// slender rod's, may be off by [`slack`], relative to `scale`.
fn is_semidefinite(matrix: &[Option<Rational>; 6], scale: &Rational) -> bool {
    let [a, b, c, f, g, h] = matrix.each_ref().map(Option::as_ref);
    let one = |x: Option<&Rational>| x.cloned();
    let two = |x: Option<&Rational>, y: Option<&Rational>, xy: Option<&Rational>| {
        Some(x? * y? - xy? * xy?)
    };
    // | a f h |
    // | f b g |
    // | h g c |
    let three = || {
        let (a, b, c, f, g, h) = (a?, b?, c?, f?, g?, h?);
        let minors = a * (b * c - g * g) - f * (f * c - g * h) + h * (f * g - b * h);
        Some(minors)
    };
    let first = slack() * scale;
    let second = &first * scale;
    let third = &second * scale;
    [
        (one(a), &first),
        (one(b), &first),
        (one(c), &first),
        (two(a, b, f), &second),
        (two(b, c, g), &second),
        (two(a, c, h), &second),
        (three(), &third),
    ]
    .into_iter()
    .all(|(minor, slack)| minor.is_none_or(|minor| minor >= -slack.clone()))
}

/// A relative error of 1e-11: a slender rod's moments in twelve digits, the last of which may be off by one, or zeros
/// that another program computed.
fn slack() -> Rational {
    Rational::from_parts(1.into(), 100_000_000_000_u64.into())
}

fn magnitude(x: &Rational) -> Rational {
    if *x < Rational::ZERO {
        -x.clone()
    } else {
        x.clone()
    }
}
