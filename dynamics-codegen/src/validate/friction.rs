//! Friction of a joint.

use dynamics_symbolic::robot::{Stribeck, Value};

use super::all;
use super::scope::{Scope, number};
use crate::description::{self, Coulomb, Given, Part};
use crate::mistake::joint as mistake;

/// What a cell says of friction; outer `None`s: in error.
pub(super) struct Friction {
    pub(super) viscous: Option<Value>,
    /// By the direction of motion.
    pub(super) coulomb: Option<[Value; 2]>,
    /// Inner `None`: friction does not fall with the velocity.
    pub(super) stribeck: Option<Option<Stribeck>>,
}

/// How a message names Coulomb friction and static friction.
const DRY: &str = "a friction torque or force";

pub(super) fn friction(cell: &Given<description::Friction>, scope: &mut Scope) -> Friction {
    let friction = match cell {
        Given::Absent => &description::Friction::default(),
        Given::Unreadable => {
            return Friction {
                viscous: None,
                coulomb: None,
                stribeck: None,
            };
        }
        Given::As(friction) => friction,
    };
    let viscous = scope.not_negative(&friction.viscous, "a friction coefficient");
    let coulomb = coulomb(&friction.coulomb, scope);
    let stribeck = stribeck(&friction.stribeck, coulomb.as_ref(), scope);
    Friction {
        viscous,
        coulomb,
        stribeck,
    }
}

fn coulomb(cell: &Given<Coulomb>, scope: &mut Scope) -> Option<[Value; 2]> {
    match cell {
        Given::Absent => Some([Value::zero(), Value::zero()]),
        Given::Unreadable => None,
        Given::As(Coulomb::Both(value)) => {
            let value = scope.not_negative(value, DRY)?;
            Some([value.clone(), value])
        }
        Given::As(Coulomb::ByDirection(part)) => {
            let [positive, negative] = &part.values;
            let directions = [("positive", positive), ("negative", negative)];
            all(directions.map(|(word, cell)| {
                if cell.is_absent() {
                    scope.error(part.place, mistake::direction_missing(word));
                }
                scope.not_negative(cell, DRY)
            }))
        }
    }
}

fn stribeck(
    cell: &Given<Part<2>>,
    coulomb: Option<&[Value; 2]>,
    scope: &mut Scope,
) -> Option<Option<Stribeck>> {
    let part = match cell {
        Given::Absent => return Some(None),
        Given::Unreadable => return None,
        Given::As(part) => part,
    };
    let [of_rest, falling] = &part.values;
    if of_rest.is_absent() {
        scope.error(part.place, mistake::static_missing());
    }
    if falling.is_absent() {
        scope.error(part.place, mistake::stribeck_velocity_missing());
    }
    let friction = scope.not_negative(of_rest, DRY);
    let velocity = scope.given(falling);
    if let (Some(value), Some(expr)) = (&velocity, falling.value())
        && number(value).is_some_and(|v| v <= 0.0)
    {
        scope.error(expr.place, mistake::stribeck_velocity_not_positive());
    }
    if let (Some(value), Some(expr)) = (&friction, of_rest.value()) {
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
}
