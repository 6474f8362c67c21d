//! Regressors: joint forces by the motion, or the energies, and a unit base parameter, one column for
//! each.
//!
//! The joint forces are linear in the inertial parameters (Khosla and Kanade 1985), so the column
//! of a parameter is what the equations of motion give where that one is 1 and all others are 0.
//!
//! A column is inverse dynamics with one unit parameter. The motion is shared. The wrench of each unit body is either
//! handed on from link to link or multiplied by the partial velocities of all joints, whichever is shorter. The order
//! of columns is part of the contract and does not depend on the gauge. The proof chooses the columns anew, by
//! elimination of the regressor of all standard parameters at random states, and compares every entry.

use super::base::{self, Geometry, Observed};
use super::chain::Chain;
use super::momenta;
use super::passivity::{self, Rates};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::spatial::{Body, Force};

/// A column in the making, with its link: the force of a body on the link, or the acceleration of a motor.
type Column<'g> = (usize, Result<Force<Expr<'g>>, Expr<'g>>);

/// Each body's force handed on from link to link, to the base. By rows.
pub(super) fn by_recursion<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let columns = columns_of_motion(symbols, chain);
    by_rows(chain, columns, |i, force| chain.joint_forces(i, force))
}

/// The power of each body's force in a unit velocity of each joint (Kane's partial velocities). By
/// rows.
pub(super) fn by_partial_velocities<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let axes = chain.axes();
    let columns = columns_of_motion(symbols, chain);
    by_rows(chain, columns, |i, force| {
        let mut forces = vec![chain.zero; axes.len()];
        for (j, axis) in &axes[i] {
            forces[*j] = axis.dot(force);
        }
        forces
    })
}

/// The regressor of M qdd_r + C(q, qd) qd_r + G, by rows.
pub(super) fn of_passivity<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    rates: &[Rates<Expr<'g>>],
) -> Vec<Expr<'g>> {
    let half = symbols.graph().half();
    let units = Units::new(symbols);
    let motions = passivity::motions(chain, rates);
    let columns = units.bodies(chain).map(|(i, body)| {
        let force = body.map(|body| motions[i].force(&body, half));
        (i, force.ok_or(rates[i].qdd_r))
    });
    by_rows(chain, columns.collect(), |i, force| {
        chain.joint_forces(i, force)
    })
}

/// The kinetic energy of a unit of every base parameter, then the potential energy, zero where frame 0
/// has its origin.
pub(super) fn of_energies<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let half = symbols.graph().half();
    let qd = symbols.all(|joint| joint.qd);
    let units = Units::new(symbols);
    let velocities = momenta::velocities(chain, &qd);
    // A base that stands adds a constant to U, which is left out.
    let base = if symbols.arm().freedoms().has_base() {
        chain.datum
    } else {
        chain.zero
    };
    let heights = heights(chain, base);
    let energies = units.bodies(chain).map(|(i, body)| match body {
        Some(body) => {
            let (gravity, above) = heights[i];
            let potential = -(gravity.dot(body.moment) + above * body.mass);
            (body.kinetic_energy(velocities[i], half), potential)
        }
        None => (half * (qd[i] * qd[i]), chain.zero),
    });
    let (kinetic, potential): (Vec<_>, Vec<_>) = energies.unzip();
    [kinetic, potential].concat()
}

/// Gravity in the axes of every frame, and g.p with p the frame's origin, which is `base` for frame 0.
fn heights<'g>(chain: &Chain<Expr<'g>>, base: Expr<'g>) -> Vec<(Vector3<Expr<'g>>, Expr<'g>)> {
    chain
        .tree
        .outward((chain.gravity, base), |i, &(gravity, above)| {
            let joint = chain.joint(i);
            let above = above + gravity.dot(joint.position());
            (joint.enter(gravity), above)
        })
}

/// A regressor by rows. `joint_forces` has the component of a force on link i along each joint.
fn by_rows<'g>(
    chain: &Chain<Expr<'g>>,
    columns: Vec<Column<'g>>,
    joint_forces: impl Fn(usize, Force<Expr<'g>>) -> Vec<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let joints = chain.links.len();
    let column = |(i, column): Column<'g>| {
        column.map_or_else(
            |acceleration| {
                let mut forces = vec![chain.zero; joints];
                forces[i] = acceleration;
                forces
            },
            |force| joint_forces(i, force),
        )
    };
    let columns: Vec<_> = columns.into_iter().map(column).collect();
    let row = |i: usize| columns.iter().map(move |column| column[i]);
    (0..joints).flat_map(row).collect()
}

/// The columns of the equations of motion.
fn columns_of_motion<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Column<'g>> {
    let units = Units::new(symbols);
    let (qd, qdd) = (
        symbols.all(|joint| joint.qd),
        symbols.all(|joint| joint.qdd),
    );
    let accelerations = chain.accelerations(chain.gravity, &qd, &qdd);
    let column = |(i, body): (usize, Option<Body<Expr<'g>>>)| {
        let force = body.map(|body| accelerations[i].force(&body));
        (i, force.ok_or(qdd[i]))
    };
    units.bodies(chain).map(column).collect()
}

/// The base parameters of an arm, a unit of each of them.
struct Units<'g> {
    observed: Observed,
    geometry: Geometry<Expr<'g>>,
}

impl<'g> Units<'g> {
    fn new(symbols: &mut Symbols<'g>) -> Self {
        Units {
            observed: Observed::of(symbols.arm()),
            geometry: base::geometry(symbols, symbols.arm()),
        }
    }

    /// For every base parameter its link, and the body that is a unit of it in the link's frame; none
    /// of a motor.
    fn bodies(
        &self,
        chain: &Chain<Expr<'g>>,
    ) -> impl Iterator<Item = (usize, Option<Body<Expr<'g>>>)> {
        let grouping = &self.observed.grouping;
        let columns = self.observed.columns().into_iter();
        columns.map(move |(i, parameter)| {
            let body = base::unit(grouping, &self.geometry, i, parameter);
            (i, body.map(|body| chain.links[i].place(body, chain.zero)))
        })
    }
}
