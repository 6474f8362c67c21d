//! Joints that follow others.

mod law;

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Coupling, JointType, Row};

use super::lock::report_out_of_limits;
use super::scope::Scope;
use crate::description::{self, Given, Name, Positioned};
use crate::limits::{MOST_FOLLOWERS, MOST_JOINTS_OF_COUPLED};
use crate::mistake::{couple as mistake, entry};
use crate::place::Place;
use crate::words;
use law::{Law, law};

/// A joint that follows another one.
pub(super) struct Couple {
    name: Name,
    /// `None` where it is in error.
    law: Option<Law>,
}

/// The index of the row that leads a row, and the law by which it does; `None` of a row that follows none.
type Lead<'c> = Option<(usize, &'c Law)>;

/// The couplings, in the scope of the place where they are written; `joints` are the names of all joints.
pub(super) fn couplings(
    coupled: Option<&[Positioned]>,
    joints: &[String],
    scope: &mut Scope,
) -> Vec<Couple> {
    let coupled = coupled.unwrap_or_default();
    let couple = |coupled: &Positioned| Couple {
        name: coupled.name.clone(),
        law: coupled
            .position
            .as_ref()
            .and_then(|position| law(position, &coupled.name, joints, scope)),
    };
    coupled.iter().map(couple).collect()
}

/// Couples the rows' joints. A row that is in error (`None`) is known by its name alone. What follows a
/// joint that is locked is locked, and what follows a follower follows the joint that leads that one.
pub(super) fn couple(
    rows: &mut [Option<Row>],
    couples: &[Couple],
    written: &[description::Row],
    scope: &Scope,
) {
    let names: Vec<String> = written.iter().map(name_of).collect();
    if report_too_many(couples, names.len(), scope) {
        return;
    }
    let laws = laws_of_rows(rows, couples, written, &names, scope);
    if report_circles(&laws, couples, &names, scope) {
        return;
    }
    for (row, name) in names.iter().enumerate() {
        let couple = couples.iter().find(|couple| couple.name.plain() == name);
        let Some(place) = couple.map(|couple| Place::from(&couple.name)) else {
            continue;
        };
        if let Some(coupling) = resolved(&laws, row, scope, place) {
            follow(rows, row, coupling, place, scope);
        }
    }
}

/// Reports more followers, or more rows beside followers, than there may be; whether it did.
fn report_too_many(couples: &[Couple], rows: usize, scope: &Scope) -> bool {
    if let Some(first_too_many) = couples.get(MOST_FOLLOWERS) {
        scope.error(&first_too_many.name, mistake::too_many());
        return true;
    }
    if let Some(couple) = couples.first()
        && rows > MOST_JOINTS_OF_COUPLED
    {
        let mistake = mistake::too_many_rows(MOST_JOINTS_OF_COUPLED);
        scope.error(&couple.name, mistake);
        return true;
    }
    false
}

/// How each row is led. Reports names that are no
/// joints, joints that follow twice, and what their rows say that a follower's cannot.
fn laws_of_rows<'c>(
    rows: &[Option<Row>],
    couples: &'c [Couple],
    written: &[description::Row],
    names: &[String],
    scope: &Scope,
) -> Vec<Lead<'c>> {
    let position = |word: &str| names.iter().position(|name| name == word);
    let mut laws: Vec<Lead> = names.iter().map(|_| None).collect();
    let mut seen = BTreeSet::new();
    for couple in couples {
        let word = couple.name.plain();
        let Some(row) = position(word) else {
            let known: Vec<&str> = names.iter().map(String::as_str).collect();
            let mistake = entry::unknown_joint(word, words::nearest(word, &known), &known);
            scope.error(&couple.name, mistake);
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
        // A URDF file has limits at each joint, and angles that are rounded where it is asked for.
        if written[row].mount.is_none() {
            report_limits(&written[row], &law.leader, scope);
            report_offset(rows[row].as_ref(), law, scope);
        }
        laws[row] = position(&law.leader).map(|leader| (leader, law));
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
}

fn name_of(row: &description::Row) -> String {
    row.name
        .as_ref()
        .map_or(String::new(), |name| name.plain().to_owned())
}

fn report_limits(row: &description::Row, leader: &str, scope: &Scope) {
    let Given::As([Some(lower), Some(upper)]) = &row.limits else {
        return;
    };
    let mistake = mistake::limits(&name_of(row), leader);
    scope.error(lower.place.to(upper.place), mistake);
}

/// Reports an offset that was hardly meant as an angle.
fn report_offset(row: Option<&Row>, law: &Law, scope: &Scope) {
    let is_angle = row.is_some_and(|row| row.joint_type == JointType::Revolute);
    if let Some((odd, place)) = &law.odd
        && is_angle
        && !scope.allowed().odd_angle
    {
        scope.error(*place, odd.mistake(scope.place_of_allow()));
    }
}

/// Reports every circle of followers, once; whether there is one.
fn report_circles(laws: &[Lead], couples: &[Couple], names: &[String], scope: &Scope) -> bool {
    let mut in_circles: BTreeSet<usize> = BTreeSet::new();
    for couple in couples {
        let start = names.iter().position(|name| name == couple.name.plain());
        let Some(start) = start.filter(|start| !in_circles.contains(start)) else {
            continue;
        };
        let mut chain = vec![start];
        while let Some((leader, _)) = chain.last().and_then(|&row| laws[row]) {
            chain.push(leader);
            if leader == start {
                let names: Vec<&str> = chain.iter().map(|&row| names[row].as_str()).collect();
                scope.error(&couple.name, mistake::circle(&names));
                in_circles.extend(&chain);
                break;
            }
            if chain.len() > laws.len() {
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
