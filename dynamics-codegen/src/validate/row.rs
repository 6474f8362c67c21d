//! The rows of the table.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{JointType, Row, Spring, Value};

use super::body::Body;
use super::scope::Scope;
use super::{body, friction, limits};
use crate::description::{self, Given, Part};
use crate::mistake::joint as mistake;

/// The meaning of each row; `None` where it is in error.
pub(super) fn rows(rows: &[description::Row], scope: &mut Scope) -> Vec<Option<Row>> {
    report_duplicates(rows, scope);
    rows.iter().map(|row| self::row(row, scope)).collect()
}

fn report_duplicates(rows: &[description::Row], scope: &Scope) {
    let mut seen = BTreeSet::new();
    for name in rows.iter().filter_map(|row| row.name.as_ref()) {
        let word = name.plain();
        if !seen.insert(word) {
            scope.error(name, mistake::twice(word));
        }
    }
}

fn row(row: &description::Row, scope: &mut Scope) -> Option<Row> {
    scope.within(&row.allow, "row", |scope| cells(row, scope))
}

fn cells(row: &description::Row, scope: &mut Scope) -> Option<Row> {
    let (d, theta) = offsets(row, scope);
    let a = scope.given(&row.a);
    let alpha = scope.angle(&row.alpha, None);
    let body = body::body(
        &Body {
            mass: &row.mass,
            com: &row.com,
            inertia: &row.inertia,
            inertia_at_origin: &row.inertia_at_origin,
            place: "row",
        },
        scope,
    );
    let (motor_inertia, gear_ratio) = motor(&row.motor, scope);
    let friction = friction::friction(&row.friction, scope);
    let spring = spring(row, scope);
    let limits = limits::limits(row, scope);
    let (mass, com, inertia) = body?;
    Some(Row {
        name: row.name.as_ref()?.plain().to_owned(),
        joint_type: row.joint_type?,
        a: a?,
        alpha: alpha?,
        d: d?,
        theta: theta?,
        mass,
        com,
        inertia,
        motor_inertia: motor_inertia?,
        gear_ratio: gear_ratio?,
        viscous: friction.viscous?,
        coulomb: friction.coulomb?,
        stribeck: friction.stribeck?,
        spring: spring?,
        limits: limits?,
        locked: None,
        mount: row.mount.clone(),
        follows: None,
    })
}

/// `d` and `theta`: the joint's variable is added to one of them.
fn offsets(row: &description::Row, scope: &mut Scope) -> (Option<Value>, Option<Value>) {
    match row.joint_type {
        Some(JointType::Prismatic) => (
            scope.given_beside_variable(&row.d, "d"),
            scope.angle(&row.theta, None),
        ),
        Some(JointType::Revolute) => (scope.given(&row.d), scope.angle(&row.theta, Some("theta"))),
        None => (scope.given(&row.d), scope.angle(&row.theta, None)),
    }
}

/// Outer `None`: in error; inner `None`: no spring.
fn spring(row: &description::Row, scope: &mut Scope) -> Option<Option<Spring>> {
    let spring = match &row.spring {
        Given::Absent => return Some(None),
        Given::Unreadable => return None,
        Given::As(spring) => spring,
    };
    let [stiffness, slack] = &spring.values;
    if stiffness.is_absent() {
        scope.error(spring.place, mistake::stiffness_missing());
    }
    let stiffness = scope.not_negative(stiffness, "a spring's stiffness");
    let rest = scope.given(slack);
    if let (Given::As(written), Some(rest)) = (slack, &rest)
        && let Some(mistake) = limits::many_turns(rest, row)
    {
        scope.error(written.place, mistake);
    }
    Some(Some(Spring {
        stiffness: stiffness?,
        rest: rest?,
    }))
}

/// The motor's inertia and its gear ratio.
fn motor(cell: &Given<Part<2>>, scope: &mut Scope) -> (Option<Value>, Option<Value>) {
    let motor = match cell {
        Given::Absent => return (Some(Value::zero()), Some(Value::zero())),
        Given::Unreadable => return (None, None),
        Given::As(motor) => motor,
    };
    let [inertia, written] = &motor.values;
    let inertia = scope.not_negative(inertia, "a motor's inertia");
    let gear_ratio = scope.given(written);
    let stands_still = gear_ratio.as_ref().is_some_and(Value::is_zero);
    if stands_still && inertia.as_ref().is_some_and(|value| !value.is_zero()) {
        match written.value() {
            Some(expr) => scope.error(expr.place, mistake::gear_ratio_zero()),
            None => scope.error(motor.place, mistake::gear_ratio_missing()),
        }
    }
    (inertia, gear_ratio)
}
