//! The tool meets its surroundings: impedance control against a spring wall, and a push that a momentum
//! observer finds without a force sensor.
//!
//! ```text
//! cargo run --release --example contact
//! ```

use robot_dynamics::nalgebra::{Matrix4, Vector3, Vector6};
use robot_dynamics::{Simulation, SimulationError, robot_dynamics, simulation::Dop853};

robot_dynamics! {
    /// An elbow arm with a tool of 0.5 kg.
    struct Arm;

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist:    revolute { d: 0.4, mass: 8, com: [0, 0.02, -0.1], inertia: cylinder(0.1, 0.4) },
        shoulder: revolute { alpha: PI/2, mass: 5, com: [0.22, 0, 0.05], inertia: rod(0.45) },
        elbow:    revolute { a: 0.45, mass: 2, com: [0.18, 0, 0], inertia: rod(0.4) },
    ],
    tool: { xyz: [0.4, 0, 0], mass: 0.5, com: [0.02, 0, 0], inertia: sphere(0.03) },
    functions: [
        default, forward_kinematics, jacobian,
        impedance_terms = (forward_kinematics, jacobian, gravity_vector),
        observer_terms = (generalized_momentum, momentum_bias),
    ],
}

type Vector = Vector3<f64>;
type Outcome<T> = Result<T, Box<SimulationError<3>>>;

const START: Vector = Vector3::new(0.0, 0.7, -1.2);

fn place(pose: &Matrix4<f64>) -> Vector {
    Vector3::new(pose[(0, 3)], pose[(1, 3)], pose[(2, 3)])
}

/// A force without a moment.
fn force(f: Vector) -> Vector6<f64> {
    Vector6::new(f[0], f[1], f[2], 0.0, 0.0, 0.0)
}

/// Stiffness of the wall and of the hand, N/m, and the hand's damping, N s/m.
const WALL: f64 = 5_000.0;
const STIFFNESS: f64 = 400.0;
const DAMPING: f64 = 80.0;

/// The wall is `NEAR` before the tool, and the tool has to go `FAR` ahead, m.
const NEAR: f64 = 0.05;
const FAR: f64 = 0.15;

/// Impedance control (Hogan 1985): the hand is a spring and a damper, tau = J' (K (x_d - x) - D x') + G,
/// and pushes as hard as the spring is bent. The force on the wall after 6 s.
fn pushing() -> Outcome<f64> {
    let start = place(&Arm.forward_kinematics(&START));
    let (wall, goal) = (start[0] + NEAR, start + Vector3::new(FAR, 0.0, 0.0));
    let pushed_back = |pose: &Matrix4<f64>| WALL * f64::max(pose[(0, 3)] - wall, 0.0);
    let motion = Simulation::new(&Arm)
        .initial(START, Vector::zeros())
        .torque(|_, q, qd| {
            let (pose, jacobian, gravity) = Arm.impedance_terms(q);
            let velocity = (jacobian * qd).fixed_rows::<3>(0).into_owned();
            let hand = (goal - place(&pose)) * STIFFNESS - velocity * DAMPING;
            jacobian.tr_mul(&force(hand)) + gravity
        })
        .tool_wrench(|_, pose, _| force(Vector3::new(-pushed_back(pose), 0.0, 0.0)))
        .duration(6.0)
        .run()?;
    let last = motion.q.len() - 1;
    let pose = Arm.forward_kinematics(&motion.q[last]);
    let aside = (place(&pose) - goal).fixed_rows::<2>(1).amax();
    assert!(aside < 1e-6, "the tool is {aside:e} m beside its line");
    Ok(pushed_back(&pose))
}

/// Where the two springs balance: f = K (FAR - x) = WALL (x - NEAR).
fn balance() -> f64 {
    WALL * STIFFNESS / (WALL + STIFFNESS) * (FAR - NEAR)
}

/// From 1 s on something pushes the tool, N.
const PUSH: Vector = Vector3::new(0.0, 12.0, -20.0);

/// The observer's rate, 1/s, and its period, s.
const RATE: f64 = 50.0;
const PERIOD: f64 = 1e-3;

/// The residual of the generalized momentum p = M qd (De Luca and Mattone 2003):
///
///   r = RATE (p - p(0) - integral of tau + C' qd - G + r),   r' = RATE (J' w - r),
///
/// where C' qd - G is the momentum's bias.
///
/// It is compared with J' w, which the observer does not know: the time when it finds half of the push,
/// after it began, and the largest part of it that is missing at the end.
fn observed() -> Outcome<[f64; 2]> {
    let torque = |q: &Vector, qd: &Vector| Arm.gravity_vector(q) + (START - q) * 300.0 - qd * 40.0;
    let motion = Simulation::new(&Arm)
        .method(Dop853::with_tolerance(1e-9))
        .initial(START, Vector::zeros())
        .torque(|_, q, qd| torque(q, qd))
        .tool_wrench(|t, _, _| force(if t > 1.0 { PUSH } else { Vector::zeros() }))
        .duration(2.0)
        .samples(2001)
        .run()?;
    let mut integral = Vector::zeros();
    let mut residual = Vector::zeros();
    let mut found = f64::INFINITY;
    let mut missing = f64::INFINITY;
    for ((&t, q), qd) in motion.t.iter().zip(&motion.q).zip(&motion.qd) {
        let (momentum, bias) = Arm.observer_terms(q, qd);
        integral += (torque(q, qd) + bias + residual) * PERIOD;
        residual = (momentum - integral) * RATE;
        let pushed = Arm.jacobian(q).tr_mul(&force(PUSH));
        missing = (residual - pushed).amax() / pushed.amax();
        if t <= 1.0 {
            assert!(residual.amax() < 1e-6, "nothing pushes at {t} s");
        } else if missing < 0.5 {
            found = f64::min(found, t - 1.0);
        }
    }
    Ok([found, missing])
}

fn main() -> Outcome<()> {
    let (pushed, expected) = (pushing()?, balance());
    println!(
        "impedance: the wall is pushed with {pushed:.4} N, the springs balance at {expected:.4} N"
    );
    assert!((pushed - expected).abs() < 1e-4 * expected);

    let [found, missing] = observed()?;
    println!(
        "momentum observer: half of the push after {:.0} ms, {:.1} % of it missing after 1 s",
        1e3 * found,
        1e2 * missing
    );
    assert!(found < 0.03 && missing < 0.02);
    Ok(())
}
