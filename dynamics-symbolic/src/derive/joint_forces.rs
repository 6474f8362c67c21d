//! What acts at the joints themselves: friction, and springs.
//!
//!   F_i = viscous_i qd_i + coulomb_i sign(qd_i)
//!   K_i = stiffness_i (q_i - rest_i), of the energy 1/2 stiffness_i (q_i - rest_i)^2
//!
//! Motors have to overcome both, M qdd + V + G + K + F = tau. What is said of them in the equations of
//! motion is said here alone. A joint that is locked has neither.

use super::derivatives::ForceDerivatives;
use super::symbols::Symbols;
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
        symbols.value(&row.viscous) * joint.qd + symbols.value(&row.coulomb) * joint.sign
    };
    robot.rows.iter().enumerate().map(force).collect()
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

/// Adds dK/dq and dF/dqd to the derivatives of M qdd + V + G. Coulomb friction is constant.
pub(super) fn add_slopes<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    derivatives: &mut ForceDerivatives<Expr<'g>>,
) {
    for (i, row) in robot.rows.iter().enumerate() {
        let (stiffness, _) = spring(symbols, robot, i);
        let [by_position, by_velocity] = [
            &mut derivatives.by_position[i][i],
            &mut derivatives.by_velocity[i][i],
        ];
        *by_position = *by_position + stiffness;
        *by_velocity = *by_velocity + symbols.value(&row.viscous);
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
