//! Forces at the joints themselves: friction, and springs.
//!
//!   F_i = viscous_i qd_i + sign(qd_i) (C + (S - C) exp(-(qd_i/v)^2))
//!   K_i = stiffness_i (q_i - rest_i), of the energy 1/2 stiffness_i (q_i - rest_i)^2
//!
//! with C the Coulomb friction of the direction, and S and v of Stribeck's curve, where the joint has one.
//!
//! Motors have to overcome both, M qdd + V + G + K + F = tau. No other file of the derivations knows them.

use super::derivatives::ForceDerivatives;
use super::joints::Joints;
use super::second_derivatives::SecondDerivatives;
use super::symbols::{JointSymbols, Symbols};
use crate::exact::Rational;
use crate::expr::Expr;
use crate::mechanism::{Forces, Joint};
use crate::robot::{Interpretation, Row};
use core::ops::Add;

// Each cell of a row that acts at the joint has its term here.
const _: () = assert!(Row::CELLS == 11);

/// K + F, for every joint.
pub(super) fn both<'g>(symbols: &mut Symbols<'g>) -> Vec<Expr<'g>> {
    let springs = springs(symbols).into_iter();
    let friction = friction(symbols);
    springs.zip(friction).map(|(k, f)| k + f).collect()
}

/// F, for every joint.
pub(super) fn friction<'g>(symbols: &mut Symbols<'g>) -> Vec<Expr<'g>> {
    let joints = symbols.arm().joints.iter().enumerate();
    let force = |(i, joint): (usize, &Joint)| {
        let (own, joint) = (&joint.forces, *symbols.joint(i));
        symbols.value(&own.viscous) * joint.qd + dry_friction(symbols, own, &joint)
    };
    joints.map(force).collect()
}

/// sign(qd) (C + (S - C) exp(-(qd/v)^2))
fn dry_friction<'g>(symbols: &mut Symbols<'g>, own: &Forces, joint: &JointSymbols<'g>) -> Expr<'g> {
    let coulomb = coulomb(symbols, own, joint);
    match beyond_coulomb(symbols, own, joint) {
        Some(beyond) => (coulomb + beyond) * joint.sign,
        None => coulomb * joint.sign,
    }
}

/// C of the direction. With the sign s it is (C+ + C-)/2 + s (C+ - C-)/2, and anything at rest, where s
/// C is zero.
fn coulomb<'g>(symbols: &mut Symbols<'g>, own: &Forces, joint: &JointSymbols<'g>) -> Expr<'g> {
    let [positive, negative] = &own.coulomb;
    if positive == negative {
        return symbols.value(positive);
    }
    let half = symbols.graph().half();
    let (positive, negative) = (symbols.value(positive), symbols.value(negative));
    half * (positive + negative) + half * (positive - negative) * joint.sign
}

/// (S - C) exp(-(qd/v)^2), where friction falls with the velocity.
fn beyond_coulomb<'g>(
    symbols: &mut Symbols<'g>,
    own: &Forces,
    joint: &JointSymbols<'g>,
) -> Option<Expr<'g>> {
    let (stribeck, left) = (own.stribeck.as_ref()?, joint.stribeck?);
    let coulomb = coulomb(symbols, own, joint);
    Some((symbols.value(&stribeck.friction) - coulomb) * left)
}

/// dF/dqd = viscous - 2 qd/v^2 sign(qd) (S - C) exp(-(qd/v)^2). Coulomb friction is constant.
fn slope_of_friction<'g>(
    symbols: &mut Symbols<'g>,
    own: &Forces,
    joint: &JointSymbols<'g>,
) -> Expr<'g> {
    let viscous = symbols.value(&own.viscous);
    let beyond = beyond_coulomb(symbols, own, joint);
    let (Some(stribeck), Some(beyond)) = (&own.stribeck, beyond) else {
        return viscous;
    };
    let v = symbols.value(&stribeck.velocity);
    let falls = symbols.rational(&Rational::from(2)) / (v * v);
    viscous - beyond * joint.sign * (falls * joint.qd)
}

/// d2F/dqd2 = -2/v^2 sign(qd) (S - C) exp(-(qd/v)^2) (1 - 2 qd^2/v^2); `None` where there is none.
fn curvature_of_friction<'g>(
    symbols: &mut Symbols<'g>,
    own: &Forces,
    joint: &JointSymbols<'g>,
) -> Option<Expr<'g>> {
    let beyond = beyond_coulomb(symbols, own, joint)?;
    let v = symbols.value(&own.stribeck.as_ref()?.velocity);
    let one = symbols.graph().one();
    let falls = symbols.rational(&Rational::from(2)) / (v * v);
    Some(beyond * joint.sign * falls * (falls * joint.qd * joint.qd - one))
}

/// K, for every joint.
pub(super) fn springs<'g>(symbols: &mut Symbols<'g>) -> Vec<Expr<'g>> {
    let springs = all_springs(symbols).into_iter();
    springs
        .map(|(stiffness, stretch)| stiffness * stretch)
        .collect()
}

/// The energy in all springs.
pub(super) fn energy_of_springs<'g>(symbols: &mut Symbols<'g>) -> Expr<'g> {
    let graph = symbols.graph();
    let half = graph.half();
    let springs = all_springs(symbols).into_iter();
    let square = |(stiffness, stretch): (Expr<'g>, Expr<'g>)| stiffness * (stretch * stretch);
    half * springs.map(square).fold(graph.zero(), Expr::add)
}

/// Adds dK/dq and dF/dqd to the derivatives of M qdd + V + G, of the joints that move by themselves.
pub(super) fn add_slopes<'g>(
    symbols: &mut Symbols<'g>,
    derivatives: &mut ForceDerivatives<Expr<'g>>,
) {
    let joints = symbols.arm().joints.iter().enumerate();
    let slopes = joints.map(|(i, joint)| {
        let (stiffness, _) = spring(symbols, i);
        let variables = *symbols.joint(i);
        (
            stiffness,
            slope_of_friction(symbols, &joint.forces, &variables),
        )
    });
    let (stiffnesses, slopes): (Vec<_>, Vec<_>) = slopes.unzip();
    let joints = Joints::of(symbols);
    let diagonals = [joints.diagonal(&stiffnesses), joints.diagonal(&slopes)];
    for (i, (stiffness, slope)) in diagonals[0].iter().zip(&diagonals[1]).enumerate() {
        let [by_position, by_velocity] = [
            &mut derivatives.by_position[i][i],
            &mut derivatives.by_velocity[i][i],
        ];
        *by_position = *by_position + *stiffness;
        *by_velocity = *by_velocity + *slope;
    }
}

/// Adds d2F/dqd2 to the second derivatives of M qdd + V + G, of the joints that move by themselves; springs
/// have none.
pub(super) fn add_curvatures<'g>(
    symbols: &mut Symbols<'g>,
    derivatives: &mut SecondDerivatives<Expr<'g>>,
) {
    let zero = symbols.graph().zero();
    let joints = symbols.arm().joints.iter().enumerate();
    let curvatures = joints.map(|(i, joint)| {
        let variables = *symbols.joint(i);
        let curvature = curvature_of_friction(symbols, &joint.forces, &variables);
        // A follower's counts by the cube of its factor, two of which the diagonal has.
        variables.factor * curvature.unwrap_or(zero)
    });
    let curvatures: Vec<_> = curvatures.collect();
    let curvatures = Joints::of(symbols).diagonal(&curvatures);
    for (i, curvature) in curvatures.into_iter().enumerate() {
        let entry = &mut derivatives.by_velocity[i][i][i];
        *entry = *entry + curvature;
    }
}

fn all_springs<'g>(symbols: &mut Symbols<'g>) -> Vec<(Expr<'g>, Expr<'g>)> {
    let joints = 0..symbols.arm().joints.len();
    joints.map(|i| spring(symbols, i)).collect()
}

/// The stiffness of the spring at joint i, and how far it is stretched; zero and zero if there is none.
fn spring<'g>(symbols: &mut Symbols<'g>, i: usize) -> (Expr<'g>, Expr<'g>) {
    let zero = symbols.graph().zero();
    match &symbols.arm().joints[i].forces.spring {
        Some(spring) => {
            let rest = symbols.value(&spring.rest);
            let stretch = symbols.joint(i).q - rest;
            (symbols.value(&spring.stiffness), stretch)
        }
        None => (zero, zero),
    }
}
