//! The forces that act at a joint.

use crate::robot::{Row, Spring, Stribeck, Value};

/// Friction, motor and spring of a joint.
#[derive(Clone, Debug)]
pub(crate) struct Forces {
    pub(crate) motor_inertia: Value,
    /// The number zero where there is no motor.
    pub(crate) gear_ratio: Value,
    pub(crate) viscous: Value,
    /// The values for positive velocities and for negative ones.
    pub(crate) coulomb: [Value; 2],
    pub(crate) stribeck: Option<Stribeck>,
    pub(crate) spring: Option<Spring>,
}

impl Forces {
    /// The forces of a joint at which nothing acts.
    pub(super) fn none() -> Self {
        let zero = Value::zero;
        Forces {
            motor_inertia: zero(),
            gear_ratio: zero(),
            viscous: zero(),
            coulomb: [zero(), zero()],
            stribeck: None,
            spring: None,
        }
    }

    /// The forces of a row.
    pub(super) fn of(row: &Row) -> Self {
        Forces {
            motor_inertia: row.motor_inertia.clone(),
            gear_ratio: row.gear_ratio.clone(),
            viscous: row.viscous.clone(),
            coulomb: row.coulomb.clone(),
            stribeck: row.stribeck.clone(),
            spring: row.spring.clone(),
        }
    }
}
