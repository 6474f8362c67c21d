//! Joints that follow others.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Coupling, JointType, Row, Value};

use super::angle::Odd;
use super::known::is_identically_zero;
use super::lock::report_out_of_limits;
use super::measured::Measured;
use super::scope::Scope;
use crate::description::{self, Given, Name, Positioned};
use crate::mistake::couple as mistake;
use crate::place::Place;

/// A joint that follows another one.
pub(super) struct Couple {
    name: Name,
    /// `None` where it is in error.
    law: Option<Law>,
}

/// factor * leader + offset
struct Law {
    leader: String,
    factor: Value,
    offset: Value,
    /// The oddity of the offset, where it is an angle.
    odd: Option<(Odd, Place)>,
}

/// The index of the row that leads a row, and the law by which it does; `None` of a row that follows none.
type Lead<'c> = Option<(usize, &'c Law)>;

/// The couplings, in the scope of the place where they are written.
pub(super) fn couplings(coupled: Option<&[Positioned]>, scope: &mut Scope) -> Vec<Couple> {
    let couple = |coupled: &Positioned| Couple {
        name: coupled.name.clone(),
        law: law(coupled, scope),
    };
    coupled.unwrap_or_default().iter().map(couple).collect()
}

/// Reads the law of a follower.
fn law(coupled: &Positioned, scope: &mut Scope) -> Option<Law> {
    let (name, position) = (coupled.name.plain(), coupled.position.as_ref()?);
    let Measured { value, leader, .. } = scope.position_of(&coupled.name, position)?;
    let (place, mistake) = match leader {
        None => (position.place, mistake::no_leader(name)),
        Some(leader) if leader.name == name => (leader.place, mistake::itself(name)),
        Some(leader) if is_identically_zero(&leader.factor) => {
            (position.place, mistake::factor_zero(name, &leader.name))
        }
        Some(leader) => {
            return Some(Law {
                leader: leader.name,
                factor: leader.factor,
                offset: value,
                odd: leader.odd,
            });
        }
    };
    scope.error(place, mistake);
    None
}

/// Couples the rows' joints. A row that is in error (`None`) is known by its name alone. A joint that
/// follows a locked one is locked, and one that follows a follower follows the joint that leads that one.
pub(super) fn couple(
    rows: &mut [Option<Row>],
    couples: &[Couple],
    written: &[description::Row],
    scope: &Scope,
) {
    let laws = laws_of_rows(rows, couples, written, scope);
    if report_circles(&laws, couples, written, scope) {
        return;
    }
    for (row, name) in written.iter().map(description::Row::word).enumerate() {
        let couple = couples.iter().find(|couple| couple.name.plain() == name);
        let Some(place) = couple.map(|couple| Place::from(&couple.name)) else {
            continue;
        };
        if let Some(coupling) = resolved(&laws, row, scope, place) {
            follow(rows, row, coupling, place, scope);
        }
    }
}

/// How each row is led. Reports names that are no joints, joints that follow twice, and what their rows say that a
/// follower's cannot.
fn laws_of_rows<'c>(
    rows: &[Option<Row>],
    couples: &'c [Couple],
    written: &[description::Row],
    scope: &Scope,
) -> Vec<Lead<'c>> {
    let mut laws: Vec<Lead> = written.iter().map(|_| None).collect();
    let mut seen = BTreeSet::new();
    for couple in couples {
        let word = couple.name.plain();
        let Some(row) = scope.row_of(&couple.name, written) else {
            continue;
        };
        if !seen.insert(row) {
            scope.error(&couple.name, mistake::twice(word));
            continue;
        }
        if rows[row].as_ref().is_some_and(|row| row.locked.is_some()) {
            scope.error(&couple.name, mistake::locked(word));
            continue;
        }
        let Some(law) = &couple.law else {
            continue;
        };
        report_limits(&written[row], &law.leader, scope);
        // The angles of a URDF file are rounded where it is asked for.
        if written[row].mount.is_none() {
            report_offset(rows[row].as_ref(), law, scope);
        }
        let leader = written.iter().position(|row| row.word() == law.leader);
        laws[row] = leader.map(|leader| (leader, law));
    }
    laws
}

/// Makes a row a follower, or locks it where its leader is locked, within its own limits.
fn follow(rows: &mut [Option<Row>], row: usize, coupling: Coupling, place: Place, scope: &Scope) {
    let leader = rows[coupling.leader].as_ref();
    let locked = leader.and_then(|row| row.locked.clone());
    let Some(row) = &mut rows[row] else {
        return;
    };
    match locked {
        Some(position) => {
            let position = coupling.factor * position + coupling.offset;
            report_out_of_limits(row, &position, place, scope);
            row.locked = Some(position);
        }
        None => row.follows = Some(coupling),
    }
    // It is where the joint that leads is, within the limits of that one.
    row.limits = None;
    (row.torque_limit, row.velocity_limit) = (None, None);
}

fn report_limits(row: &description::Row, leader: &str, scope: &Scope) {
    let range = match &row.limits {
        Given::As([Some(lower), Some(upper)]) if !row.limits_of_file => {
            Some(lower.place.to(upper.place))
        }
        _ => None,
    };
    // A URDF file has an effort and a velocity at each joint, too.
    let greatest = [&row.torque_limit, &row.velocity_limit].map(|cell| {
        let written = cell.value().filter(|_| row.mount.is_none());
        written.map(|limit| limit.place)
    });
    for place in range.into_iter().chain(greatest.into_iter().flatten()) {
        scope.error(place, mistake::limits(row.word(), leader));
    }
}

/// Reports an offset that was hardly meant as an angle.
fn report_offset(row: Option<&Row>, law: &Law, scope: &Scope) {
    let is_angle = row.is_some_and(|row| row.joint_type == JointType::Revolute);
    if let Some((odd, place)) = law.odd.as_ref().filter(|_| is_angle) {
        scope.report_odd(odd, *place);
    }
}

/// Reports every circle of followers, once; whether there is one.
fn report_circles(
    laws: &[Lead],
    couples: &[Couple],
    written: &[description::Row],
    scope: &Scope,
) -> bool {
    let mut in_circles: BTreeSet<usize> = BTreeSet::new();
    for couple in couples {
        let start = written
            .iter()
            .position(|row| row.word() == couple.name.plain());
        let Some(start) = start.filter(|start| !in_circles.contains(start)) else {
            continue;
        };
        let mut chain = vec![start];
        while chain.len() <= laws.len()
            && let Some((leader, _)) = chain.last().and_then(|&row| laws[row])
        {
            chain.push(leader);
            if leader == start {
                let names: Vec<&str> = chain.iter().map(|&row| written[row].word()).collect();
                scope.error(&couple.name, mistake::circle(&names));
                in_circles.extend(&chain);
                break;
            }
        }
    }
    !in_circles.is_empty()
}

/// How a row follows the joint that leads it in the end, which follows none. Reports a factor that gets too long on
/// the way.
fn resolved(laws: &[Lead], row: usize, scope: &Scope, place: Place) -> Option<Coupling> {
    let (mut leader, law) = laws[row]?;
    let (mut factor, mut offset) = (law.factor.clone(), law.offset.clone());
    while let Some((next, law)) = laws[leader] {
        // k (k' q + c') + c
        offset = scope.limited(factor.clone() * law.offset.clone() + offset, place)?;
        factor = scope.limited(factor * law.factor.clone(), place)?;
        leader = next;
    }
    Some(Coupling {
        leader,
        factor,
        offset,
    })
}
