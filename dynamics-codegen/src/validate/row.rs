//! The rows of the table.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Body, JointType, Row, Spring, Stribeck, Value};

use super::body::body;
use super::known::{all, number};
use super::scope::Scope;
use super::{limits, link};
use crate::description::{self, Coulomb, Given, Part, Table};
use crate::mistake::joint as mistake;
use crate::place::Place;

/// The meaning of each row; `None` where it is in error.
pub(super) fn rows(table: &Table, scope: &mut Scope) -> Vec<Option<Row>> {
    report_duplicates(table.rows(), scope);
    let row = |index: usize| {
        let allow = &table.rows()[index].body.allow;
        scope.within(allow, "row", |scope| cells(index, table, scope))
    };
    (0..table.rows().len()).map(row).collect()
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

fn cells(index: usize, table: &Table, scope: &mut Scope) -> Option<Row> {
    let row = &table.rows()[index];
    let on = link::of_row(index, table, scope);
    let at = link::beginning(row, table, scope);
    let (d, theta) = offsets(row, scope);
    let a = scope.given(&row.a);
    let alpha = scope.angle(&row.alpha);
    let body = body(&row.body, scope);
    let motor = motor(&row.motor, scope);
    let zero = (Value::zero(), [0; 2].map(Value::integer), None);
    let friction = row.friction.read(zero, |friction| {
        let viscous = scope.not_negative(&friction.viscous, "a friction coefficient");
        let coulomb = coulomb(&friction.coulomb, scope);
        let stribeck = stribeck(&friction.stribeck, coulomb.as_ref(), scope);
        Some((viscous?, coulomb?, stribeck?))
    });
    let spring = spring(row, scope);
    let limits = limits::limits(row, scope);
    let torque_limit = limits::greatest(&row.torque_limit, scope);
    let velocity_limit = limits::greatest(&row.velocity_limit, scope);
    let Body { mass, com, inertia } = body?;
    let [motor_inertia, gear_ratio] = motor?;
    let (viscous, coulomb, stribeck) = friction?;
    Some(Row {
        name: row.name.as_ref()?.plain().to_owned(),
        joint_type: row.joint_type?,
        on: on?,
        at: at?,
        a: a?,
        alpha: alpha?,
        d: d?,
        theta: theta?,
        mass,
        com,
        inertia,
        motor_inertia,
        gear_ratio,
        viscous,
        coulomb,
        stribeck,
        spring: spring?,
        limits: limits?,
        torque_limit: torque_limit?,
        velocity_limit: velocity_limit?,
        locked: None,
        mount: row.mount.clone(),
        follows: None,
    })
}

/// `d` and `theta`: the joint's variable is added to one of them.
fn offsets(row: &description::Row, scope: &mut Scope) -> (Option<Value>, Option<Value>) {
    let [d, theta] = match row.joint_type {
        Some(JointType::Prismatic) => [Some("d"), None],
        Some(JointType::Revolute) => [None, Some("theta")],
        None => [None, None],
    };
    (
        scope.beside_variable(d, |scope| scope.given(&row.d)),
        scope.beside_variable(theta, |scope| scope.angle(&row.theta)),
    )
}

/// Outer `None`: in error; inner `None`: no spring.
fn spring(row: &description::Row, scope: &mut Scope) -> Option<Option<Spring>> {
    row.spring.read(None, |spring| {
        let [stiffness, slack] = &spring.values;
        if stiffness.is_absent() {
            scope.error(spring.place, mistake::stiffness_missing());
        }
        let stiffness = scope.not_negative(stiffness, "a spring's stiffness");
        let rest = scope.given(slack);
        if let (Given::As(written), Some(rest)) = (slack, &rest)
            && let Some(size) = limits::many_turns(rest, row)
        {
            scope.error(written.place, mistake::position_of_many_turns(size));
        }
        Some(Some(Spring {
            stiffness: stiffness?,
            rest: rest?,
        }))
    })
}

/// The motor's inertia and its gear ratio.
fn motor(cell: &Given<Part<2>>, scope: &mut Scope) -> Option<[Value; 2]> {
    cell.read([0; 2].map(Value::integer), |motor| {
        let [inertia, written] = &motor.values;
        let inertia = scope.not_negative(inertia, "a motor's inertia");
        let gear_ratio = scope.given(written);
        let stands_still = gear_ratio.as_ref().is_some_and(Value::is_zero);
        if stands_still && inertia.as_ref().is_some_and(|value| !value.is_zero()) {
            match written.value() {
                Some(expr) => scope.error(expr.place, mistake::gear_ratio_zero()),
                None => scope.error(motor.place, mistake::gear_ratio_missing()),
            }
        } else if let (Some(ratio), Some(expr)) = (&gear_ratio, written.value()) {
            report_slow_motor(ratio, expr.place, scope);
        }
        Some([inertia?, gear_ratio?])
    })
}

/// Reports a motor that turns more slowly than its joint. Such gears exist, but joint speed over motor speed is written
/// far more often by mistake. A direct drive has a ratio of 1, and the sign is free.
fn report_slow_motor(ratio: &Value, place: Place, scope: &Scope) {
    let ratio = number(ratio).filter(|ratio| *ratio != 0.0 && ratio.abs() < 1.0);
    if let (Some(ratio), false) = (ratio, scope.allowed().odd_gear_ratio) {
        let mistake = mistake::slow_motor(ratio, 1.0 / ratio, scope.place_of_allow());
        scope.error(place, mistake);
    }
}

/// How a message names Coulomb friction and static friction.
const DRY: &str = "a friction torque or force";

/// Coulomb friction by the direction of motion.
fn coulomb(cell: &Given<Coulomb>, scope: &mut Scope) -> Option<[Value; 2]> {
    cell.read([0; 2].map(Value::integer), |coulomb| match coulomb {
        Coulomb::Both(value) => {
            let value = scope.not_negative(value, DRY)?;
            Some([value.clone(), value])
        }
        Coulomb::ByDirection(part) => {
            let [positive, negative] = &part.values;
            all(
                [("positive", positive), ("negative", negative)].map(|(word, cell)| {
                    if cell.is_absent() {
                        scope.error(part.place, mistake::direction_missing(word));
                    }
                    scope.not_negative(cell, DRY)
                }),
            )
        }
    })
}

/// Outer `None`: in error; inner `None`: friction does not fall with the velocity.
fn stribeck(
    cell: &Given<Part<2>>,
    coulomb: Option<&[Value; 2]>,
    scope: &mut Scope,
) -> Option<Option<Stribeck>> {
    cell.read(None, |part| {
        let [at_rest, falling] = &part.values;
        if at_rest.is_absent() {
            scope.error(part.place, mistake::static_missing());
        }
        if falling.is_absent() {
            scope.error(part.place, mistake::stribeck_velocity_missing());
        }
        let friction = scope.not_negative(at_rest, DRY);
        let velocity = scope.given(falling);
        if let (Some(value), Some(expr)) = (&velocity, falling.value())
            && number(value).is_some_and(|v| v <= 0.0)
        {
            scope.error(expr.place, mistake::stribeck_velocity_not_positive());
        }
        if let (Some(value), Some(expr)) = (&friction, at_rest.value()) {
            let coulomb = coulomb.into_iter().flatten().filter_map(number);
            let greatest = coulomb.fold(0.0, f64::max);
            if number(value).is_some_and(|s| s < greatest) {
                scope.error(expr.place, mistake::static_below_coulomb(greatest));
            }
        }
        Some(Some(Stribeck {
            friction: friction?,
            velocity: velocity?,
        }))
    })
}
