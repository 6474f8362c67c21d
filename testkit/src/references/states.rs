//! The robots and reference values of `tests/data`, as they are written there.

use serde::Deserialize;

use super::Decimal;

/// A robot's table.
#[derive(Deserialize)]
pub struct RobotFile {
    /// `standard` or `modified`.
    pub convention: String,
    /// Acceleration of gravity in the axes of the world, m/s^2.
    pub gravity: [f64; 3],
    /// Where the arm is mounted in the world, if the file says it.
    pub base: Option<PlacementFile>,
    /// The rows, from the base outwards.
    pub joints: Vec<JointRow>,
    /// The frame and the body at the end, if there is one.
    pub tool: Option<ToolFile>,
}

/// Where a frame is in another one.
#[derive(Deserialize)]
pub struct PlacementFile {
    /// Its origin, m.
    pub xyz: [f64; 3],
    /// Roll, pitch and yaw, rad.
    pub rpy: [f64; 3],
}

/// The tool of a robot.
#[derive(Deserialize)]
pub struct ToolFile {
    /// Where its frame is in the last link frame.
    #[serde(flatten)]
    pub placement: PlacementFile,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the tool frame, m.
    pub com: [f64; 3],
    /// xx, yy, zz, xy, yz, xz about the centre of mass, kg m^2.
    pub inertia: [f64; 6],
}

/// A row of a robot's table.
#[derive(Deserialize)]
pub struct JointRow {
    /// `revolute` or `prismatic`.
    #[serde(rename = "type")]
    pub joint_type: String,
    /// Length along x, m.
    pub a: f64,
    /// Angle about x, rad.
    pub alpha: f64,
    /// Length along z, m.
    pub d: f64,
    /// Angle about z, rad.
    pub theta: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the link frame, m.
    pub com: [f64; 3],
    /// xx, yy, zz, xy, yz, xz about the centre of mass, kg m^2.
    pub inertia: [f64; 6],
    /// Inertia of the rotor, kg m^2.
    pub motor_inertia: f64,
    /// Turns of the rotor for one of the joint.
    pub gear_ratio: f64,
    /// Viscous friction, N m s.
    pub viscous: f64,
    /// Coulomb friction, N m.
    pub coulomb: f64,
}

/// The reference values of a robot.
#[derive(Deserialize)]
pub struct ReferenceFile {
    /// Twenty-four states.
    pub states: Vec<ReferenceState>,
}

/// Every quantity at one state.
#[derive(Deserialize)]
pub struct ReferenceState {
    /// The name of the state.
    pub label: String,
    /// Positions.
    pub q: Vec<f64>,
    /// Velocities.
    pub qd: Vec<f64>,
    /// Accelerations.
    pub qdd: Vec<f64>,
    /// M.
    #[serde(rename = "M")]
    pub mass_matrix: Vec<Vec<Decimal>>,
    /// V.
    #[serde(rename = "V")]
    pub coriolis_vector: Vec<Decimal>,
    /// G.
    #[serde(rename = "G")]
    pub gravity_vector: Vec<Decimal>,
    /// M qdd + V + G, without friction.
    pub tau: Vec<Decimal>,
    /// F.
    pub friction: Vec<Decimal>,
    /// C, from the Christoffel symbols.
    #[serde(rename = "C")]
    pub coriolis_matrix: Vec<Vec<Decimal>>,
    /// T.
    pub kinetic_energy: Decimal,
    /// U.
    pub potential_energy: Decimal,
    /// The last frame in the base, a matrix of four rows.
    pub ee_pose: Vec<Vec<Decimal>>,
    /// The geometric Jacobian, rows vx vy vz wx wy wz.
    pub jacobian: Vec<Vec<Decimal>>,
    /// The denominators of relative errors.
    pub scale: Scale,
}

/// The natural magnitude of each quantity, the denominator of relative errors.
#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names in the files")]
pub struct Scale {
    /// Scale of the mass matrix.
    pub M: f64,
    /// Scale of the Coriolis vector.
    pub V: f64,
    /// Scale of the gravity vector.
    pub G: f64,
    /// Scale of the Coriolis matrix.
    pub C: f64,
    /// Scale of the torques.
    pub tau: f64,
    /// Scale of the kinetic energy.
    pub T: f64,
    /// Scale of the potential energy.
    pub U: f64,
}
