//! What a call asks of a file.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use crate::description::Name;

/// What is asked of a URDF file.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The first and the last link of the arm.
    pub chain: Option<[Name; 2]>,
    /// Joints that are left out, with all that hangs on them. `rest`, where no joint has that name, is all joints
    /// beside the chain that are not named, here and in `lock`.
    pub ignore: Vec<Name>,
    /// Joints that stand still, and where, or `rest`; no position is one that is not known here.
    pub lock: Vec<(Name, Option<Value>)>,
    /// How near an angle is to a multiple of a quarter turn that it is taken for, rad, and which share of an axis is zero.
    pub round_angles: Option<Rational>,
    /// Whether tensors that no body can have are accepted.
    pub unphysical_inertia: bool,
    /// Whether movable links without `<inertial>` are taken as massless.
    pub no_inertia: bool,
    /// Whether angles of many turns are accepted, which are meant in degrees elsewhere.
    pub odd_angle: bool,
}
