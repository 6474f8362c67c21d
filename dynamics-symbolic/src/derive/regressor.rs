//! The regressor: joint forces by the motion and a unit base parameter, one column for each.
//!
//! The joint forces are linear in the inertial parameters (Khosla and Kanade 1985), so the column
//! of a parameter is what the equations of motion give where that one is 1 and all others are 0.

use super::base;
use super::chain::Chain;
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::robot::{Grouping, Parameter, Robot};
use crate::spatial::{Acceleration, Body, Force, accelerations, felt_inwards};

/// A column in the making: its link, and the force of its body on the link. A motor has none.
type Column<'g> = (usize, Option<Force<Expr<'g>>>);

/// Each body's force handed on from link to link, to the base. By rows.
pub(super) fn by_recursion<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<Expr<'g>>,
) -> Vec<Expr<'g>> {
    by_rows(symbols, robot, chain, |i, force| {
        felt_inwards(force, chain.joints().take(i + 1))
    })
}

/// The power of each body's force in a unit velocity of each joint (Kane's partial velocities). By
/// rows.
pub(super) fn by_partial_velocities<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let axes = chain.axes();
    by_rows(symbols, robot, chain, |i, force| {
        axes[i].iter().map(|axis| axis.dot(force)).collect()
    })
}

/// The regressor by rows. `felt` says what the joints up to link i feel of a force on it.
fn by_rows<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<Expr<'g>>,
    felt: impl Fn(usize, Force<Expr<'g>>) -> Vec<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let qdd = symbols.all(|joint| joint.qdd);
    let column = |(i, force): Column<'g>| {
        let mut column = vec![chain.zero; qdd.len()];
        match force {
            Some(force) => column[..=i].copy_from_slice(&felt(i, force)),
            None => column[i] = qdd[i],
        }
        column
    };
    let columns = columns(symbols, robot, chain).into_iter().map(column);
    let columns: Vec<_> = columns.collect();
    let row = |i: usize| columns.iter().map(move |column| column[i]);
    (0..qdd.len()).flat_map(row).collect()
}

/// The force of every unit base parameter.
fn columns<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<Expr<'g>>,
) -> Vec<Column<'g>> {
    let grouping = Grouping::of(robot);
    let geometry = base::geometry(symbols, robot);
    let (qd, qdd) = (
        symbols.all(|joint| joint.qd),
        symbols.all(|joint| joint.qdd),
    );
    let at_base = Acceleration::of_base(chain.zero, chain.gravity);
    let accelerations = accelerations(at_base, chain.joints(), &qd, &qdd);
    let column = |(i, parameter): (usize, Parameter)| {
        let body = base::unit(&grouping, &geometry, i, parameter, (chain.zero, chain.one));
        let placed = |body: Body<_>| chain.links[i].place(body, chain.zero);
        (i, body.map(|body| accelerations[i].force(&placed(body))))
    };
    base::columns(&grouping).into_iter().map(column).collect()
}
