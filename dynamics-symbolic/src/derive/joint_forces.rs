//! What acts at the joints themselves: friction, and springs.
//!
//!   F_i = viscous_i qd_i + sign(qd_i) (C + (S - C) exp(-(qd_i/v)^2))
//!   K_i = stiffness_i (q_i - rest_i), of the energy 1/2 stiffness_i (q_i - rest_i)^2
//!
//! with C the Coulomb friction of the direction, and S and v of Stribeck's curve, where the joint has one.
//!
//! Motors have to overcome both, M qdd + V + G + K + F = tau. What is said of them in the equations of
//! motion is said here alone. A joint that is locked has neither.

use super::derivatives::ForceDerivatives;
use super::joints::Joints;
use super::second_derivatives::SecondDerivatives;
use super::symbols::{JointSymbols, Symbols};
use crate::exact::Rational;
use crate::expr::Expr;
use crate::robot::{Interpretation, Robot, Row};

/// K + F, for the joint of every row.
pub(super) fn both<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let springs = springs(symbols, robot).into_iter();
    let friction = friction(symbols, robot);
    springs.zip(friction).map(|(k, f)| k + f).collect()
}

/// F, for the joint of every row.
pub(super) fn friction<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let force = |(i, row): (usize, &Row)| {
        let joint = *symbols.joint(i);
        symbols.value(&row.viscous) * joint.qd + dry_friction(symbols, row, &joint)
    };
    robot.rows.iter().enumerate().map(force).collect()
}

/// sign(qd) (C + (S - C) exp(-(qd/v)^2))
fn dry_friction<'g>(symbols: &mut Symbols<'g>, row: &Row, joint: &JointSymbols<'g>) -> Expr<'g> {
    let coulomb = coulomb(symbols, row, joint);
    match beyond_coulomb(symbols, row, joint) {
        Some(beyond) => (coulomb + beyond) * joint.sign,
        None => coulomb * joint.sign,
    }
}

/// C of the direction. With the sign s it is (C+ + C-)/2 + s (C+ - C-)/2, and anything at rest, where s
/// C is zero.
fn coulomb<'g>(symbols: &mut Symbols<'g>, row: &Row, joint: &JointSymbols<'g>) -> Expr<'g> {
    let [positive, negative] = &row.coulomb;
    if positive == negative {
        return symbols.value(positive);
    }
    let half = symbols.rational(&(Rational::ONE / Rational::from(2)));
    let (positive, negative) = (symbols.value(positive), symbols.value(negative));
    half * (positive + negative) + half * (positive - negative) * joint.sign
}

/// (S - C) exp(-(qd/v)^2), where friction falls with the velocity.
fn beyond_coulomb<'g>(
    symbols: &mut Symbols<'g>,
    row: &Row,
    joint: &JointSymbols<'g>,
) -> Option<Expr<'g>> {
    let (stribeck, left) = (row.stribeck.as_ref()?, joint.stribeck?);
    let coulomb = coulomb(symbols, row, joint);
    Some((symbols.value(&stribeck.friction) - coulomb) * left)
}

/// dF/dqd = viscous - 2 qd/v^2 sign(qd) (S - C) exp(-(qd/v)^2). Coulomb friction is constant.
fn slope_of_friction<'g>(
    symbols: &mut Symbols<'g>,
    row: &Row,
    joint: &JointSymbols<'g>,
) -> Expr<'g> {
    let viscous = symbols.value(&row.viscous);
    let beyond = beyond_coulomb(symbols, row, joint);
    let (Some(stribeck), Some(beyond)) = (&row.stribeck, beyond) else {
        return viscous;
    };
    let v = symbols.value(&stribeck.velocity);
    let falls = symbols.rational(&Rational::from(2)) / (v * v);
    viscous - beyond * joint.sign * (falls * joint.qd)
}

/// d2F/dqd2 = -2/v^2 sign(qd) (S - C) exp(-(qd/v)^2) (1 - 2 qd^2/v^2); `None` where there is none.
fn curvature_of_friction<'g>(
    symbols: &mut Symbols<'g>,
    row: &Row,
    joint: &JointSymbols<'g>,
) -> Option<Expr<'g>> {
    let beyond = beyond_coulomb(symbols, row, joint)?;
    let v = symbols.value(&row.stribeck.as_ref()?.velocity);
    let one = symbols.graph().one();
    let falls = symbols.rational(&Rational::from(2)) / (v * v);
    Some(beyond * joint.sign * falls * (falls * joint.qd * joint.qd - one))
}

/// K, for the joint of every row.
pub(super) fn springs<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let force = |i: usize| {
        let (stiffness, stretch) = spring(symbols, robot, i);
        stiffness * stretch
    };
    (0..robot.rows.len()).map(force).collect()
}

/// The energy in all springs.
pub(super) fn energy_of_springs<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Expr<'g> {
    let graph = symbols.graph();
    let half = graph.rational(&(Rational::ONE / Rational::from(2)));
    let twice = (0..robot.rows.len()).fold(graph.zero(), |sum, i| {
        let (stiffness, stretch) = spring(symbols, robot, i);
        sum + stiffness * (stretch * stretch)
    });
    half * twice
}

/// Adds dK/dq and dF/dqd to the derivatives of M qdd + V + G, of the joints that move by themselves.
pub(super) fn add_slopes<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    derivatives: &mut ForceDerivatives<Expr<'g>>,
) {
    let slopes = robot.rows.iter().enumerate().map(|(i, row)| {
        let (stiffness, _) = spring(symbols, robot, i);
        let joint = *symbols.joint(i);
        (stiffness, slope_of_friction(symbols, row, &joint))
    });
    let (stiffnesses, slopes): (Vec<_>, Vec<_>) = slopes.unzip();
    let joints = Joints::of(symbols, robot);
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
    robot: &Robot,
    derivatives: &mut SecondDerivatives<Expr<'g>>,
) {
    let zero = symbols.graph().zero();
    let rows = robot.rows.iter().enumerate().map(|(i, row)| {
        let joint = *symbols.joint(i);
        let curvature = curvature_of_friction(symbols, row, &joint).unwrap_or(zero);
        // A follower's counts by the cube of its factor, two of which the diagonal has.
        match symbols.followed(i) {
            Some((_, factor)) => factor * curvature,
            None => curvature,
        }
    });
    let rows: Vec<_> = rows.collect();
    let curvatures = Joints::of(symbols, robot).diagonal(&rows);
    for (i, curvature) in curvatures.into_iter().enumerate() {
        let entry = &mut derivatives.by_velocity[i][i][i];
        *entry = *entry + curvature;
    }
}

/// The stiffness of the spring at the joint of row i, and how far it is stretched; zero and zero where
/// there is none.
fn spring<'g>(symbols: &mut Symbols<'g>, robot: &Robot, i: usize) -> (Expr<'g>, Expr<'g>) {
    let zero = symbols.graph().zero();
    let row = &robot.rows[i];
    match &row.spring {
        Some(spring) if row.locked.is_none() => {
            let rest = symbols.value(&spring.rest);
            let stretch = symbols.joint(i).q - rest;
            (symbols.value(&spring.stiffness), stretch)
        }
        _ => (zero, zero),
    }
}
