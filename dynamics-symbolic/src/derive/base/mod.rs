//! Base inertial parameters: the smallest set that determines the forces of every motion.
//!
//! The Lagrangian is linear in the standard inertial parameters of the links (Maes, Samson and
//! Bastin 1989). Let F_i(c) be the part of it that parameters c of link i contribute. Where F_i(c)
//! does not depend on joint i, it is what it is at q_i = 0, qd_i = 0: there link i is a part of
//! link i-1, so that F_i(c) = F_{i-1}(X c) with the constant change of frame X, and c may move to
//! link i-1 without a division. These c are a space A_i. The set that is left when they have moved,
//! for each link from the tip inwards, is minimal: if sum F_i(b_i) is constant and b_n is not 0,
//! F_n(b_n) does not depend on joint n, so b_n is in A_n. The rules of Gautier and Khalil (1990) give
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

use super::rows::Places;
use super::symbols::Symbols;
use crate::expr::{Expr, Graph};
use crate::mechanism::{Joint, Mechanism};
use crate::robot::{Grouping, Interpretation, Parameter, Robot};
use crate::spatial::Body;

/// gear_ratio^2 * motor_inertia
pub(super) fn reflected<I: Interpretation>(cells: &mut I, joint: &Joint) -> I::Number {
    let ratio = cells.value(&joint.forces.gear_ratio);
    ratio * ratio * cells.value(&joint.forces.motor_inertia)
}

/// The standard inertial parameters of every link; those of the tool count to its link.
pub(super) fn bodies<I: Interpretation>(
    cells: &mut I,
    arm: &Mechanism,
) -> Vec<(Body<I::Number>, I::Number)> {
    let places = Places::new(cells, arm);
    let joints = arm.joints.iter().enumerate();
    let body = |(i, joint): (usize, &Joint)| {
        let reflected = reflected(cells, joint);
        (places.body(cells, arm, i), reflected)
    };
    joints.map(body).collect()
}

/// The base parameters of an arm without its couplings, in the order of [`columns`].
pub(crate) fn base_parameters<I: Interpretation>(
    cells: &mut I,
    arm: &Mechanism,
    grouping: &Grouping,
) -> Vec<I::Number> {
    let geometry = geometry(cells, arm);
    let bodies = bodies(cells, arm);
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

/// The parts taken off each link's body and its motor's reflected inertia for the base parameters
/// that are neglected: their values, where the parameters are written.
pub(super) fn neglected<'g>(symbols: &mut Symbols<'g>) -> Vec<(Body<Expr<'g>>, Expr<'g>)> {
    let (zero, arm) = (symbols.graph().zero(), symbols.arm());
    let mut parts = vec![(Body::splat(zero), zero); arm.joints.len()];
    let Some(neglected) = &arm.neglected else {
        return parts;
    };
    let grouping = &neglected.grouping;
    let links = geometry(symbols, arm);
    let values = base_parameters(symbols, arm, grouping);
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
    /// The base parameters without couplings.
    pub(crate) grouping: Grouping,
    /// Which of their columns are kept, in order.
    pub(crate) kept: Vec<usize>,
}

impl Observed {
    /// The base parameters of an arm.
    pub(crate) fn of(arm: &Mechanism) -> Self {
        let grouping = Grouping::of_mechanism(arm);
        let kept = if arm.is_coupled() {
            couple::independent(&mut Symbols::new(&Graph::new(), arm), &grouping)
        } else {
            (0..grouping.count()).collect()
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
    Observed::of(&Mechanism::from(robot)).columns()
}

/// The base parameters of an arm, in the order of the regressor's columns.
pub(super) fn observed_parameters<'g>(symbols: &mut Symbols<'g>) -> Vec<Expr<'g>> {
    let arm = symbols.arm();
    let Observed { grouping, kept } = Observed::of(arm);
    let mut values = base_parameters(symbols, arm, &grouping);
    if arm.is_coupled() {
        for dependent in dependent(symbols, &grouping) {
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
