//! The robots and reference values of `tests/data`, as they are written there.

use serde::Deserialize;

use crate::decimal::Decimal;

/// A robot's table.
#[derive(Deserialize)]
pub(crate) struct RobotFile {
    pub(crate) convention: String,
    pub(crate) gravity: [f64; 3],
    pub(crate) joints: Vec<JointRow>,
}

/// A row of a robot's table.
#[derive(Deserialize)]
pub(crate) struct JointRow {
    #[serde(rename = "type")]
    pub(crate) joint_type: String,
    pub(crate) a: f64,
    pub(crate) alpha: f64,
    pub(crate) d: f64,
    pub(crate) theta: f64,
    pub(crate) mass: f64,
    pub(crate) com: [f64; 3],
    pub(crate) inertia: [f64; 6],
    pub(crate) motor_inertia: f64,
    pub(crate) gear_ratio: f64,
    pub(crate) viscous: f64,
    pub(crate) coulomb: f64,
}

/// The reference values of a robot.
#[derive(Deserialize)]
pub(crate) struct ReferenceFile {
    pub(crate) states: Vec<ReferenceState>,
}

/// Every quantity at one state.
#[derive(Deserialize)]
pub(crate) struct ReferenceState {
    pub(crate) label: String,
    pub(crate) q: Vec<f64>,
    pub(crate) qd: Vec<f64>,
    pub(crate) qdd: Vec<f64>,
    #[serde(rename = "M")]
    pub(crate) mass_matrix: Vec<Vec<Decimal>>,
    #[serde(rename = "V")]
    pub(crate) coriolis_vector: Vec<Decimal>,
    #[serde(rename = "G")]
    pub(crate) gravity_vector: Vec<Decimal>,
    /// M qdd + V + G, without friction.
    pub(crate) tau: Vec<Decimal>,
    pub(crate) friction: Vec<Decimal>,
    #[serde(rename = "C")]
    pub(crate) coriolis_matrix: Vec<Vec<Decimal>>,
    pub(crate) kinetic_energy: Decimal,
    pub(crate) potential_energy: Decimal,
    pub(crate) ee_pose: Vec<Vec<Decimal>>,
    pub(crate) jacobian: Vec<Vec<Decimal>>,
    pub(crate) scale: Scale,
}

/// The natural magnitude of each quantity, the denominator of relative errors.
#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names in the files")]
pub(crate) struct Scale {
    pub(crate) M: f64,
    pub(crate) V: f64,
    pub(crate) G: f64,
    pub(crate) C: f64,
    pub(crate) tau: f64,
    pub(crate) T: f64,
    pub(crate) U: f64,
}
