//! Base inertial parameters: the smallest set that determines the forces of every motion.
//!
//! The Lagrangian is linear in the standard inertial parameters of the links (Maes, Samson and
//! Bastin 1989). Let F_i(c) be the part of it that parameters c of link i contribute. Where F_i(c)
//! does not depend on joint i, it is what it is at q_i = 0, qd_i = 0: there link i is a part of
//! link i-1, so that F_i(c) = F_{i-1}(X c) with the constant change of frame X, and c may move to
//! link i-1 without a division. Those c are a space A_i. What is left when they have moved, for
//! each link from the tip inwards, is minimal: if sum F_i(b_i) is constant and b_n is not 0, F_n(b_n)
//! does not depend on joint n, so b_n is in A_n. The rules of Gautier and Khalil (1990) give
//! the part of A_i that every chain has; here all of A_i is found ([`Grouping`]), from the motions
//! that link i-1 can make.
//!
//! Which parameters are kept does not depend on the way of writing the equations: the links from
//! the base outwards, the parameters of a link in the order of [`Parameter::ALL`], each kept unless
//! it is a combination of those before it.
//!
//! Where joints follow others the forces tell fewer parameters apart: see `couple`.
//!
//! Constants other than multiples of a quarter turn count as independent of one another: a
//! coincidence such as sin 30 deg = 1/2 groups nothing.

mod axes;
mod couple;
mod geometry;
mod group;
mod observe;

pub(crate) use couple::dependent;
pub(crate) use geometry::{Geometry, LinkGeometry, geometry};
pub(crate) use group::{group, unit};

use super::rows::{body, screws};
use super::symbols::Symbols;
use crate::expr::{Expr, Graph};
use crate::robot::{Grouping, Interpretation, Parameter, Robot};
use crate::spatial::Body;

/// The standard inertial parameters of every link; those of the tool count to the last one's.
pub(super) fn bodies<I: Interpretation>(
    cells: &mut I,
    robot: &Robot,
) -> Vec<(Body<I::Number>, I::Number)> {
    let screws = screws(cells, robot);
    let rows = robot.rows.iter().zip(&screws[1..]).enumerate();
    rows.map(|(i, (row, next))| {
        let ratio = cells.value(&row.gear_ratio);
        let reflected = ratio * ratio * cells.value(&row.motor_inertia);
        (body(cells, robot, i, next), reflected)
    })
    .collect()
}

/// The base parameters of a robot without its couplings, in the order of [`columns`].
pub(crate) fn base_parameters<I: Interpretation>(
    cells: &mut I,
    robot: &Robot,
    grouping: &Grouping,
) -> Vec<I::Number> {
    let geometry = geometry(cells, robot);
    let bodies = bodies(cells, robot);
    let mut columns = vec![Vec::new(); bodies.len()];
    let none = Body::splat(geometry.zero);
    geometry.tree.inward(none, Body::joined, |i, outer| {
        let (body, reflected) = bodies[i];
        let moved = group(grouping, &geometry, i, (body.joined(outer), reflected));
        columns[i] = moved.kept;
        moved.inward
    });
    columns.concat()
}

/// What is taken off each link's body and its motor's reflected inertia, for the base parameters
/// that are neglected: their values, where the parameters are written.
pub(super) fn neglected<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
) -> Vec<(Body<Expr<'g>>, Expr<'g>)> {
    let zero = symbols.graph().zero();
    let mut parts = vec![(Body::splat(zero), zero); robot.rows.len()];
    let Some(neglected) = &robot.neglected else {
        return parts;
    };
    let grouping = &neglected.grouping;
    let links = geometry(symbols, robot);
    let values = base_parameters(symbols, robot, grouping);
    for (column, value) in columns(grouping).into_iter().zip(values) {
        if !neglected.columns.contains(&column) {
            continue;
        }
        let (i, parameter) = column;
        let (body, motor) = parts[i];
        parts[i] = match unit(grouping, &links, i, parameter) {
            Some(unit) => (body.joined(unit.times(value)), motor),
            None => (body, motor + value),
        };
    }
    parts
}

/// The base parameters of an arm: those of the arm without its couplings, or fewer, of which some are
/// combinations of these.
pub(crate) struct Observed {
    /// Those without couplings.
    pub(crate) grouping: Grouping,
    /// Which of their columns are kept, in order.
    pub(crate) kept: Vec<usize>,
}

impl Observed {
    /// Those of a robot.
    pub(crate) fn of(robot: &Robot) -> Self {
        let grouping = Grouping::of(robot);
        let kept = match robot.is_coupled() {
            true => {
                let graph = Graph::new();
                couple::independent(&mut Symbols::new(&graph, robot), robot, &grouping)
            }
            false => (0..grouping.count()).collect(),
        };
        Observed { grouping, kept }
    }

    /// Link and parameter of every column of the regressor.
    pub(crate) fn columns(&self) -> Vec<(usize, Parameter)> {
        let all = columns(&self.grouping);
        self.kept.iter().map(|&column| all[column]).collect()
    }
}

/// Link and parameter of every column of a robot's regressor.
pub fn observed(robot: &Robot) -> Vec<(usize, Parameter)> {
    Observed::of(robot).columns()
}

/// The base parameters of a robot, in the order of the regressor's columns.
pub(super) fn observed_parameters<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let Observed { grouping, kept } = Observed::of(robot);
    let mut values = base_parameters(symbols, robot, &grouping);
    if robot.is_coupled() {
        for dependent in dependent(symbols, robot, &grouping) {
            let value = values[dependent.column];
            for (column, coefficient) in dependent.terms {
                values[column] = values[column] + coefficient * value;
            }
        }
    }
    kept.iter().map(|&column| values[column]).collect()
}

/// Link and parameter of every base parameter of the arm without its couplings.
pub fn columns(grouping: &Grouping) -> Vec<(usize, Parameter)> {
    let links = grouping.links.iter().enumerate();
    links
        .flat_map(|(i, link)| link.kept.iter().map(move |&kept| (i, kept)))
        .collect()
}
