//! Controllers to copy: gravity compensation, computed torque from one fused method, a load that is
//! dropped, and adaptive control that learns a load.
//!
//! ```text
//! cargo run --release --example control
//! ```

use robot_dynamics::nalgebra::{SVector, Vector3};
use robot_dynamics::{
    Method, Simulation, SimulationError, Trajectory, robot_dynamics, simulation::Dop853,
};

robot_dynamics! {
    /// An elbow arm that carries `load` at its tool.
    #[derive(Clone, Copy)]
    struct Arm { load: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist:    revolute { d: 0.4, mass: 8, com: [0, 0.02, -0.1], inertia: cylinder(0.1, 0.4) },
        shoulder: revolute {
            alpha: PI/2, mass: 5, com: [0.22, 0, 0.05], inertia: rod(0.45),
            motor: { inertia: 1e-4, gear_ratio: 100 },
        },
        elbow: revolute {
            a: 0.45, mass: 2, com: [0.18, 0, 0], inertia: rod(0.4),
            motor: { inertia: 1e-4, gear_ratio: 80 },
        },
    ],
    tool: { xyz: [0.4, 0, 0], mass: load },
    // One call gives all terms: sines and kinematics are evaluated once.
    functions: [
        default, passivity_regressor, base_parameters,
        control_terms = (mass_matrix, coriolis_vector, gravity_vector),
    ],
}

type Vector = Vector3<f64>;
type Outcome<T> = Result<T, Box<SimulationError<3>>>;

const START: Vector = Vector3::new(0.0, 0.6, -0.9);

/// The motion to follow: position, velocity and acceleration.
fn desired(t: f64) -> [Vector; 3] {
    let (size, rate) = (Vector3::new(0.8, 0.4, 0.6), Vector3::new(1.5, 2.1, 2.7));
    let of = |f: fn(f64, f64) -> f64| SVector::from_fn(|i, _| size[i] * f(rate[i], t));
    [
        START + of(|w, t| 1.0 - (w * t).cos()),
        of(|w, t| w * (w * t).sin()),
        of(|w, t| w * w * (w * t).cos()),
    ]
}

/// Gravity compensation: tau = G(q) - d qd. The arm stays where it is put.
fn held(arm: Arm, believed: Arm) -> Outcome<f64> {
    let motion = Simulation::new(&arm)
        .initial(START, Vector::zeros())
        .torque(|_, q, qd| believed.gravity_vector(q) - qd * 20.0)
        .duration(2.0)
        .run()?;
    let sag = motion.q.iter().map(|q| (q - START).amax());
    Ok(sag.fold(0.0, f64::max))
}

/// Natural frequency of the error, rad/s, critically damped.
const OMEGA: f64 = 12.0;

/// Computed torque: tau = M (qdd_d + 2 w e' + w^2 e) + V + G, so that e'' + 2 w e' + w^2 e = 0.
fn computed_torque(model: Arm, t: f64, q: &Vector, qd: &Vector) -> Vector {
    let (m, v, g) = model.control_terms(q, qd);
    let [q_d, qd_d, qdd_d] = desired(t);
    m * (qdd_d + (qd_d - qd) * (2.0 * OMEGA) + (q_d - q) * (OMEGA * OMEGA)) + v + g
}

/// The motion from `start` on, where the arm is `q`, `qd`.
fn followed(arm: Arm, model: Arm, start: f64, q: Vector, qd: Vector) -> Outcome<Trajectory<3>> {
    Simulation::new(&arm)
        .method(Dop853::with_tolerance(1e-10))
        .initial(q, qd)
        .torque(|t, q, qd| computed_torque(model, start + t, q, qd))
        .duration(1.0)
        .run()
}

/// The largest error of a motion that began at `start`, in degrees.
fn largest_error(motion: &Trajectory<3>, start: f64) -> f64 {
    let samples = motion.t.iter().zip(&motion.q);
    let errors = samples.map(|(t, q)| (desired(start + t)[0] - q).amax());
    errors.fold(0.0, f64::max).to_degrees()
}

/// The initial error dies away as e0 (1 + w t) exp(-w t).
fn error_dies_away() -> Outcome<f64> {
    let arm = Arm { load: 2.0 };
    let off = Vector3::new(0.1, -0.05, 0.08);
    let motion = followed(arm, arm, 0.0, START - off, Vector::zeros())?;
    let samples = motion.t.iter().zip(&motion.q);
    let differences = samples.map(|(&t, q)| {
        let expected = off * (1.0 + OMEGA * t) * (-OMEGA * t).exp();
        (desired(t)[0] - q - expected).amax()
    });
    Ok(differences.fold(0.0, f64::max))
}

/// 2 kg are dropped at 1 s. The largest error after that, where the controller knows and where it does
/// not.
fn dropped() -> Outcome<[f64; 2]> {
    let (loaded, empty) = (Arm { load: 2.0 }, Arm { load: 0.0 });
    let before = followed(loaded, loaded, 0.0, START, Vector::zeros())?;
    let (q, qd) = (before.q[100], before.qd[100]);
    let told = followed(empty, empty, 1.0, q, qd)?;
    let untold = followed(empty, loaded, 1.0, q, qd)?;
    Ok([told, untold].map(|motion| largest_error(&motion, 1.0)))
}

/// Adaptive control (Slotine and Li 1987): tau = Y_r b - K s with s = qd - qd_r, qd_r = qd_d + L (q_d - q),
/// and b' = -A Y_r' s, where Y_r b = M qdd_r + C qd_r + G. It starts from the parameters of the empty arm; 2 kg are at the tool. The largest
/// errors of each second, in degrees.
fn learned(seconds: usize) -> Outcome<Vec<f64>> {
    /// The controller's period, s.
    const PERIOD: f64 = 2e-3;
    let arm = Arm { load: 2.0 };
    let mut b = Arm { load: 0.0 }.base_parameters::<f64>();
    let (mut q, mut qd) = (START, Vector::zeros());
    let mut errors = vec![0.0_f64; seconds];
    for k in 0..seconds * 500 {
        let t = k as f64 * PERIOD;
        let [q_d, qd_d, qdd_d] = desired(t);
        let (e, ed) = (q_d - q, qd_d - qd);
        let (qd_r, qdd_r) = (qd_d + e * 8.0, qdd_d + ed * 8.0);
        let s = qd - qd_r;
        let y = arm.passivity_regressor(&q, &qd, &qd_r, &qdd_r);
        let tau = y * b - s * 40.0;
        b -= y.tr_mul(&s) * (1.5 * PERIOD);
        let motion = Simulation::new(&arm)
            .initial(q, qd)
            .method(Method::RungeKutta4 { step: PERIOD })
            .torque(|_, _, _| tau)
            .duration(PERIOD)
            .samples(2)
            .run()?;
        (q, qd) = (motion.q[1], motion.qd[1]);
        errors[k / 500] = errors[k / 500].max(e.amax().to_degrees());
    }
    Ok(errors)
}

fn main() -> Outcome<()> {
    let empty = Arm { load: 0.0 };
    let (still, sag) = (held(empty, empty)?, held(Arm { load: 2.0 }, empty)?);
    println!(
        "gravity compensation: {still:.1e} rad in 2 s; {sag:.2} rad with 2 kg that it does not know"
    );
    assert!(still < 1e-9 && sag > 0.05);

    let difference = error_dies_away()?;
    println!("computed torque: the error is e0 (1 + w t) exp(-w t) to {difference:.1e} rad");
    assert!(difference < 1e-7);

    let [told, untold] = dropped()?;
    println!(
        "2 kg dropped at 1 s: {told:.1e} degrees where the controller is told, {untold:.2} where not"
    );
    assert!(told < 1e-5 && untold > 0.5);

    let errors = learned(12)?;
    let (first, last) = (errors[0], errors[11]);
    println!(
        "Slotine and Li, 2 kg unknown: {first:.2} degrees in the first second, {last:.3} in the twelfth"
    );
    assert!(last < 0.2 * first);

    let all: u32 = ["mass_matrix", "coriolis_vector", "gravity_vector"]
        .iter()
        .map(|name| operations(name))
        .sum();
    println!(
        "control_terms takes {} operations, the three calls {all}",
        operations("control_terms")
    );
    assert!(operations("control_terms") < all);
    Ok(())
}

/// Multiplications, additions and divisions of a method.
fn operations(name: &str) -> u32 {
    let mut methods = Arm::OPERATIONS.iter();
    let found = methods.find(|(method, _)| *method == name);
    found.map_or(0, |(_, operations)| operations.total())
}
