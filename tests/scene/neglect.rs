//! Abbreviated models: a pruned Lagrangian keeps its energy, pruned equations do not.

use robot_dynamics::nalgebra::{SVector, Vector6};
use robot_dynamics::{
    Energy, ForwardDynamics, Method, Scalar, Simulation, SingularMassMatrix, Trajectory,
    robot_dynamics, simulation::DormandPrince,
};
use scene::arms::{Puma, PumaAtFivePercent, PumaAtOnePercent};

/// A fall of some seconds from rest; the torques cancel the friction.
fn fall(arm: &impl ForwardDynamics<6>, seconds: f64) -> Trajectory<6> {
    Simulation::new(arm)
        .torque(|_, _, qd| Puma.friction_vector(qd))
        .initial(
            Vector6::from_fn(|i, _| 0.3 + 0.1 * i as f64),
            Vector6::zeros(),
        )
        .method(Method::DormandPrince(DormandPrince::with_tolerance(1e-12)))
        .duration(seconds)
        .samples(41)
        .run()
        .expect("a fall")
}

/// The largest change of the energy, and the largest kinetic energy.
fn energies(arm: &impl Energy<6>, fall: &Trajectory<6>) -> (f64, f64) {
    let states = fall.q.iter().zip(&fall.qd);
    let kinetic = states.map(|(q, qd)| arm.kinetic_energy::<f64>(q, qd));
    (fall.energy_drift(arm), kinetic.fold(0.0, f64::max))
}

/// Equations that were pruned each by itself: M and V at 5 %, G at 1 %, which belong to no Lagrangian.
struct PrunedEquations;

impl ForwardDynamics<6> for PrunedEquations {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 6>,
        qd: &SVector<T, 6>,
        tau: &SVector<T, 6>,
    ) -> Result<SVector<T, 6>, SingularMassMatrix> {
        let mass_matrix = PumaAtFivePercent.mass_matrix(q);
        let velocity_terms = PumaAtOnePercent.coriolis_vector(q, qd);
        let gravity = Puma.gravity_vector(q);
        let friction = Puma.friction_vector(qd);
        let mut m = mass_matrix;
        let mut x = SVector::from_fn(|i, _| tau[i] - velocity_terms[i] - gravity[i] - friction[i]);
        // Gauss's elimination.
        for k in 0..6 {
            for i in k + 1..6 {
                let factor = m[(i, k)] / m[(k, k)];
                for j in k..6 {
                    m[(i, j)] = m[(i, j)] - factor * m[(k, j)];
                }
                x[i] = x[i] - factor * x[k];
            }
        }
        for i in (0..6).rev() {
            for j in i + 1..6 {
                x[i] = x[i] - m[(i, j)] * x[j];
            }
            x[i] = x[i] / m[(i, i)];
        }
        Ok(x)
    }
}

/// T of the pruned M, U of the complete G.
impl Energy<6> for PrunedEquations {
    fn kinetic_energy<T: Scalar>(&self, q: &SVector<T, 6>, qd: &SVector<T, 6>) -> T {
        PumaAtFivePercent.kinetic_energy(q, qd)
    }

    fn potential_energy<T: Scalar>(&self, q: &SVector<T, 6>) -> T {
        Puma.potential_energy(q)
    }
}

fn energy_is_kept_by_lagrangians_alone(seconds: f64) {
    let (drift, kinetic) = energies(&PumaAtOnePercent, &fall(&PumaAtOnePercent, seconds));
    println!("Lagrangian at 1 %: {drift:.1e} J of {kinetic:.1} J");
    assert!(drift <= 1e-8 && kinetic > 10.0);
    let (drift, kinetic) = energies(&PumaAtFivePercent, &fall(&PumaAtFivePercent, seconds));
    println!("Lagrangian at 5 %: {drift:.1e} J of {kinetic:.1} J");
    assert!(drift <= 1e-8 && kinetic > 10.0);
    let (drift, kinetic) = energies(&PrunedEquations, &fall(&PrunedEquations, seconds));
    println!("pruned equations: {drift:.1e} J of {kinetic:.1} J");
    assert!(drift >= 0.1);
}

#[test]
fn a_pruned_lagrangian_keeps_its_energy() {
    energy_is_kept_by_lagrangians_alone(5.0);
}

/// `cargo test --release -p tests --test scene -- --ignored --nocapture`
#[test]
#[ignore = "takes a quarter of a minute in the dev profile"]
fn a_pruned_lagrangian_keeps_its_energy_for_twenty_seconds() {
    energy_is_kept_by_lagrangians_alone(20.0);
}

/// dE/dt = qd.(tau - F): what is pruned keeps the balance of power at every state.
#[test]
fn the_abbreviated_functions_belong_together() {
    let q = Vector6::from_fn(|i, _| 0.7 - 0.4 * i as f64);
    let qd = Vector6::from_fn(|i, _| (i as f64 + 0.3).sin());
    let qdd = Vector6::from_fn(|i, _| (2.0 * i as f64).cos());
    let arm = PumaAtFivePercent;
    let m = arm.mass_matrix(&q);
    let sum = m * qdd + arm.coriolis_vector(&q, &qd) + arm.gravity_vector(&q);
    let tau = arm.inverse_dynamics(&q, &qd, &qdd);
    assert!((sum + arm.friction_vector(&qd) - tau).amax() <= 1e-14 * tau.amax());
    assert!((arm.kinetic_energy(&q, &qd) - 0.5 * qd.dot(&(m * qd))).abs() < 1e-15);
    let found = arm.forward_dynamics(&q, &qd, &tau).expect("regular");
    assert!((found - qdd).amax() <= 1e-13);
    // G is the slope of U, to the error of a difference.
    let (step, slope) = (1e-5, arm.gravity_vector(&q));
    for i in 0..6 {
        let along = SVector::from_fn(|k, _| if k == i { step } else { 0.0 });
        let rise: f64 = arm.potential_energy(&(q + along)) - arm.potential_energy(&(q - along));
        assert!((rise / (2.0 * step) - slope[i]).abs() <= 1e-7);
    }
}

/// The table stays complete.
#[test]
fn the_table_is_the_whole_one() {
    assert_eq!(PumaAtOnePercent.table(), Puma.table());
}

robot_dynamics! {
    /// Sliding joints, whose ranges matter, a motor that hardly does, and a locked joint.
    struct Slides;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        lift: prismatic { mass: 5, com: [0.1, 0, 0], limits: [0, 0.8] },
        turn: revolute {
            mass: 3, com: [0.2, 0.01, 0], inertia: { xx: 0.01, yy: 0.1, zz: 0.1, xy: 1e-4 },
            motor: { inertia: 1e-7, gear_ratio: 20 },
        },
        tilt: revolute { alpha: PI/2, a: 0.3, mass: 1, com: [0.05, 0, 0] },
        reach: prismatic { alpha: PI/2, mass: 0.5, com: [0.001, 0, 0], limits: [0.1, 0.6] },
    ],
    lock: [tilt = deg(35)],
    neglect: 2%,
    functions: [mass_matrix, inverse_dynamics, forward_dynamics, coriolis_vector, gravity_vector],
}

#[test]
fn locked_and_sliding_joints_go_with_it() {
    let (q, qd) = (
        SVector::from([0.3, 0.4, 0.5]),
        SVector::from([0.1, -0.7, 0.2]),
    );
    let qdd = SVector::from([0.2, 0.4, -0.6]);
    let tau = Slides.inverse_dynamics(&q, &qd, &qdd);
    let found = Slides.forward_dynamics(&q, &qd, &tau).expect("regular");
    assert!((found - qdd).amax() <= 1e-13);
    let whole = robot_dynamics::NewtonEuler::new(&Slides.table());
    let difference = whole.inverse_dynamics(&q, &qd, &qdd) - tau;
    assert!(difference.amax() > 1e-6 && difference.amax() <= 0.02 * tau.amax());
}
