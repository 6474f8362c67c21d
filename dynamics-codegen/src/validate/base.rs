//! The base: where it stands, or the body with which it moves, and what there is not on one that moves.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::prove::{Assignment, Number};
use dynamics_symbolic::robot::{Base, Body, Robot, Value};

use super::body::body;
use super::named::{named, read_masses};
use super::scope::{BASE, Scope};
use super::{Parts, link};
use crate::description::{self, Asked, Entry, Place, Table};
use crate::diagnose::Diagnostics;
use crate::mistake::base as mistake;

/// The base; `None` where it is in error.
pub(super) fn base(base: &description::Base, scope: &mut Scope) -> Option<Base> {
    match base {
        description::Base::Standing(placement) => {
            link::placement(placement, scope).map(Base::Standing)
        }
        description::Base::Floating(_, written) => scope.within(&written.allow, BASE, |scope| {
            body(written, scope).map(Base::Floating)
        }),
    }
}

/// Whether a table may do without joints: its base moves, or it is not known what it does.
pub(super) fn may_be_alone(table: &Table) -> bool {
    let is_unread = |entry: &Entry| matches!(entry, Entry::Base(None));
    table.floating().is_some() || table.entries.iter().any(is_unread)
}

/// Whether a table is that of a base that moves, and of no joint.
pub(super) fn is_alone(table: &Table) -> bool {
    // The joints of an entry that could not be read are not known.
    let is_unknown = |entry: &Entry| {
        matches!(
            entry,
            Entry::Joints(_, None) | Entry::Beside(..) | Entry::File(_)
        )
    };
    let is_complete = table.joints().is_none_or(|joints| joints.complete);
    let has_none = is_complete && table.rows().is_empty();
    table.floating().is_some() && has_none && !table.entries.iter().any(is_unknown)
}

/// Reports what a robot on a base that moves does not have: functions that are arranged by joints alone, a share that is
/// neglected, and a tip where there are no joints.
pub(super) fn report(asked: &[Asked], parts: &Parts, table: &Table, scope: &Scope) {
    if table.floating().is_none() {
        return;
    }
    if let Some((_, place)) = &parts.neglect {
        scope.error(*place, mistake::neglect());
    }
    let has_tip = !is_alone(table);
    let (inverses, asked): (Vec<_>, Vec<_>) = named(asked).partition(|wanted| wanted.is_inverse);
    for wanted in inverses {
        scope.error(wanted.place, mistake::inverse(wanted.name()));
    }
    let asked = asked.into_iter();
    let asked = asked.map(|wanted| (wanted.function, wanted.frame.is_some(), wanted.place));
    let needed = table.name.iter().zip(&table.needed);
    let needed = needed.map(|(name, function)| (*function, false, Place::from(name)));
    for (function, has_frame, place) in asked.chain(needed) {
        let name = function.name();
        let mistake = match function {
            Function::CoriolisCoefficients | Function::CentrifugalCoefficients => {
                mistake::coefficients(name)
            }
            Function::TaylorSeries => mistake::series(name),
            _ if function.row().of_tip && !has_frame && !has_tip => {
                mistake::tip_without_joints(name)
            }
            _ => continue,
        };
        scope.error(place, mistake);
    }
    for entry in &table.entries {
        if let (Entry::Tool(place, _), false) = (entry, has_tip) {
            scope.error(*place, mistake::tool_without_joints());
        }
    }
}

/// Whether something resists every motion of a base that moves, where a function depends on it; reports that nothing does.
/// `odd_mass` and `no_inertia` accept it.
///
/// A velocity v of the robot costs no energy where M v = 0. Such velocities without motion of the base
/// are joints that move no mass, as arms may have them too. If there are more, at a point of the prime
/// field that stands for all positions and fields, then some motion of the base costs nothing, at every
/// position.
pub(super) fn resists(robot: &Robot, table: &Table, diagnostics: &Diagnostics) -> bool {
    let (Some(body), Some((place, written))) = (robot.floating(), table.floating()) else {
        return true;
    };
    let allow = written.allow.value().copied().unwrap_or_default();
    let allow = table.allow().or(allow);
    let is_allowed = allow.no_inertia || allow.odd_mass || !read_masses(table);
    if is_allowed || is_definite(body) || !moves_nothing(robot) {
        return true;
    }
    let mistake = if body.mass.is_zero() {
        mistake::without_mass
    } else {
        mistake::without_inertia
    };
    diagnostics.error(place, mistake(table.place_of_base()));
    false
}

/// Whether a body has a mass and a positive definite tensor, all in numbers (Sylvester's criterion).
fn is_definite(body: &Body) -> bool {
    let is_known = [&body.mass]
        .into_iter()
        .chain(&body.inertia)
        .all(Value::is_number);
    if !is_known {
        return false;
    }
    let [xx, yy, zz, xy, yz, xz] = body.inertia.each_ref().map(|entry| entry.to_f64(&[]));
    let scale = 1e-9 * xx.max(yy).max(zz);
    let second = xx * yy - xy * xy;
    let third = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    body.mass.to_f64(&[]) > 0.0
        && xx > scale
        && second > scale * scale
        && third > scale * scale * scale
}

/// Whether a motion of the base costs no energy, whatever the positions.
fn moves_nothing(robot: &Robot) -> bool {
    let program = derive_plain(robot, Function::MassMatrix);
    let values = program.evaluate(&mut Assignment::new(robot, 0));
    let Some(values) = values.into_iter().collect::<Option<Vec<Number>>>() else {
        return false;
    };
    let (all, base) = (robot.dof(), Base::FREEDOMS);
    let rows: Vec<_> = values.chunks(all).map(<[Number]>::to_vec).collect();
    let of_joints = rows[base..].iter().map(|row| row[base..].to_vec());
    let free_of_joints = all - base - rank(of_joints.collect());
    all - rank(rows) > free_of_joints
}

/// The rank of a matrix, by Gaussian elimination.
fn rank(mut rows: Vec<Vec<Number>>) -> usize {
    let columns = rows.first().map_or(0, Vec::len);
    let mut rank = 0;
    for column in 0..columns {
        let pivot = (rank..rows.len()).find(|&row| !rows[row][column].is_zero());
        let Some((pivot, inverse)) =
            pivot.and_then(|row| Some((row, rows[row][column].inverse()?)))
        else {
            continue;
        };
        rows.swap(rank, pivot);
        let (done, rest) = rows.split_at_mut(rank + 1);
        for row in rest {
            let factor = row[column] * inverse;
            for (x, above) in row.iter_mut().zip(&done[rank]) {
                *x = *x - factor * *above;
            }
        }
        rank += 1;
    }
    rank
}
