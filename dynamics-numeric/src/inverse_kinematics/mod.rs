//! Inverse kinematics, numerically: joint positions at which frames are where they are to be.
//!
//! It takes any robot whose base stands: arms of any number of joints, trees, joints that follow others, several frames at
//! once. [`InverseKinematics`] says how.

mod descent;
mod ending;
mod joints;
mod normal;
mod places;
mod posture;
mod problem;
mod search;
mod settle;
#[cfg(feature = "std")]
mod solutions;
mod step;
mod target;
mod tolerance;

use dynamics_runtime::{Size, SizedKinematics};

pub use dynamics_runtime::SizedTable;
pub use ending::{NotReached, Reached, Reason, Residual};
pub use places::{Placed, Places, Tip};
pub use target::Target;

use joints::Joints;
use tolerance::Tolerance;

/// A search for joint positions at which one or more frames of a robot reach their targets, within the limits of the joints.
///
/// Levenberg and Marquardt's method goes down from a start, with the robot's own poses and Jacobians; joints that would pass a
/// limit stay on it. Where a descent ends before the targets, others begin at random positions, the same in each run; joints
/// that move no frame stay where they are. Every second of these ignores limits at first.
/// A result was looked at again: the poses at the very positions that are returned are within the tolerance of the
/// targets, and these positions within the limits. Otherwise the error says why, and what came nearest.
///
/// ```
/// use robot_dynamics::inverse_kinematics::{InverseKinematics, Reason, Target};
/// use robot_dynamics::nalgebra::{SVector, Vector3};
/// use robot_dynamics::robot_dynamics;
///
/// robot_dynamics! {
///     /// Two links of 0.5 m in a plane.
///     struct Planar;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [
///         shoulder: revolute { limits: [-PI/2, PI/2] },
///         elbow: revolute { a: 0.5, limits: [-2.5, 2.5] },
///     ],
///     tool: { xyz: [0.5, 0, 0] },
///     functions: [forward_kinematics, jacobian],
/// }
///
/// let solver = InverseKinematics::new(&Planar);
/// let found = solver.solve(Target::position(Vector3::new(0.5, 0.5, 0.0)), &SVector::from([0.1, 0.1]))?;
/// assert!((found.q - SVector::from([0.0, std::f64::consts::FRAC_PI_2])).amax() < 1e-8);
///
/// let too_far = solver.solve(Target::position(Vector3::new(1.1, 0.0, 0.0)), &found.q);
/// assert!(matches!(too_far.unwrap_err().reason, Reason::OutOfReach { .. }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Frames are given by their poses and Jacobians. A tuple of both is one program, which evaluates each sine once:
///
/// ```
/// use robot_dynamics::inverse_kinematics::{InverseKinematics, Target};
/// use robot_dynamics::nalgebra::{SVector, Vector3};
/// use robot_dynamics::robot_dynamics;
///
/// robot_dynamics! {
///     /// Two arms of one link on a waist.
///     struct Torso;
///     convention: modified,
///     gravity: [0, 0, -9.81],
///     joints: [
///         waist: revolute {},
///         left: revolute { on: waist, b: 0.4, gamma: PI/2, alpha: PI/2 },
///         right: revolute { on: waist, b: 0.4, gamma: -PI/2, alpha: PI/2 },
///     ],
///     frames: { left_hand: { on: left, xyz: [0.5, 0, 0] }, right_hand: { on: right, xyz: [0.5, 0, 0] } },
///     functions: [
///         left_hand = (forward_kinematics(left_hand), jacobian(left_hand)),
///         right_hand = (forward_kinematics(right_hand), jacobian(right_hand)),
///     ],
/// }
///
/// let hands = [|q: &_| Torso.left_hand(q), |q: &_| Torso.right_hand(q)];
/// let solver = InverseKinematics::of_frames(&Torso, hands);
/// let reached = SVector::from([0.3, 0.5, -0.4]);
/// let [left, right] = [Torso.left_hand(&reached).0, Torso.right_hand(&reached).0];
/// let found = solver.solve_all(&[(&left).into(), (&right).into()], &SVector::from([0.0, 0.0, 0.0]))?;
/// assert!((found.q - reached).amax() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// All is computed in doubles. Where the compiler knows the number of joints, [`solve`](InverseKinematics::solve) allocates
/// nothing.
#[derive(Clone, Debug)]
pub struct InverseKinematics<D: Size, P> {
    places: P,
    joints: Joints<D>,
    posture: Option<D::Vector>,
    tolerance: Tolerance,
    attempts: usize,
    iterations: usize,
    seed: u64,
}

impl<'a, D: Size, R: SizedKinematics<D> + SizedTable<D>> InverseKinematics<D, Tip<'a, R>> {
    /// A search for the tip of a robot, with the limits of its table.
    pub fn new(robot: &'a R) -> Self {
        Self::with(Tip(robot), Joints::new(&robot.sized_numbers()))
    }
}

impl<D: Size, P: Places<D>> InverseKinematics<D, P> {
    /// A search for frames of a robot, each of which is to have a target. The frames are functions that return the
    /// pose and the Jacobian of a place that the robot's joints move. Limits are those of its table.
    pub fn of_frames(robot: &impl SizedTable<D>, frames: P) -> Self {
        // A frame may stand away from those of the table.
        Self::with(frames, Joints::new(&robot.sized_numbers()).of_any_reach())
    }

    fn with(places: P, joints: Joints<D>) -> Self {
        InverseKinematics {
            places,
            joints,
            posture: None,
            tolerance: Tolerance::new(1e-9, 1e-9),
            attempts: 100,
            iterations: 60,
            seed: 1,
        }
    }

    /// Other limits than those of the table, lower ends first, rad or m.
    pub fn limits(mut self, limits: D::Each<Option<[f64; 2]>>) -> Self {
        self.joints.limits = limits;
        self
    }

    /// How far a frame may be from its target, m and rad: 1e-9 each, unless this says otherwise.
    pub fn tolerance(mut self, position: f64, rotation: f64) -> Self {
        self.tolerance = Tolerance::new(position, rotation);
        self
    }

    /// The secondary aim: where the targets leave the joints a freedom, they move towards this posture from where the targets
    /// were reached first, as long as they come nearer.
    pub fn posture(mut self, posture: D::Vector) -> Self {
        self.posture = Some(posture);
        self
    }

    /// How many descents there may be, the one from the start with them: 100, unless this says otherwise.
    pub fn attempts(mut self, attempts: usize) -> Self {
        self.attempts = attempts.max(1);
        self
    }

    /// How many iterations a descent may take: 60, unless this says otherwise.
    pub fn iterations(mut self, iterations: usize) -> Self {
        self.iterations = iterations;
        self
    }

    /// The seed of the random positions: equal seeds, equal results.
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }
}
