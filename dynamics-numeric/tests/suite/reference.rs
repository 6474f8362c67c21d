//! The numeric algorithms against references of 25 digits, in both conventions, with revolute and
//! prismatic joints, at singular, fast, slow and huge-angle states.

use robot_dynamics::NewtonEuler;
use robot_dynamics::nalgebra::SMatrix;
use serde_json::Value;
use tables::data::{load, matrix, number, table, vector};

/// Bound of the error over scale, per joint: the contract of the generated functions, for the
/// measure that they are compared with.
const TOLERANCE: f64 = 4e-15;

fn assert_near<const R: usize, const C: usize>(
    computed: SMatrix<f64, R, C>,
    expected: SMatrix<f64, R, C>,
    bound: f64,
    what: &str,
) {
    let error = (computed - expected).abs();
    // Not `error.amax() <= bound`, which leaves a NaN out.
    let within = error.iter().all(|e| *e <= bound);
    assert!(within, "{what}: error {:e}, bound {bound:e}", error.amax());
}

fn check_state<const N: usize>(arm: &NewtonEuler<N>, name: &str, state: &Value) {
    let [q, qd, qdd] = ["q", "qd", "qdd"].map(|key| vector::<N>(&state[key]));
    let label = state["label"].as_str().unwrap();
    let what = |quantity: &str| format!("{name}, {label}: {quantity}");
    let bound = |quantity: &str| TOLERANCE * N as f64 * number(&state["scale"][quantity]);
    let scalar = |value: f64| SMatrix::<f64, 1, 1>::new(value);

    assert_near(
        arm.mass_matrix(&q),
        matrix(&state["M"]),
        bound("M"),
        &what("M"),
    );
    assert_near(
        arm.coriolis_vector(&q, &qd),
        vector(&state["V"]),
        bound("V"),
        &what("V"),
    );
    assert_near(
        arm.gravity_vector(&q),
        vector(&state["G"]),
        bound("G"),
        &what("G"),
    );
    let tau = vector::<N>(&state["tau"]);
    let friction = vector::<N>(&state["friction"]);
    let frictionless = arm.inverse_dynamics(&q, &qd, &qdd) - arm.friction_vector(&qd);
    let with_friction = bound("tau") + f64::EPSILON * friction.amax();
    assert_near(frictionless, tau, with_friction, &what("tau"));
    let friction_bound = f64::EPSILON * friction.amax();
    assert_near(
        arm.friction_vector(&qd),
        friction,
        friction_bound,
        &what("friction"),
    );
    // The accelerations are judged by the torques that they need beyond those applied.
    let qdd_found = arm.forward_dynamics(&q, &qd, &(tau + friction)).unwrap();
    assert_near(
        matrix::<N, N>(&state["M"]) * (qdd_found - qdd),
        SMatrix::<f64, N, 1>::zeros(),
        with_friction,
        &what("qdd"),
    );
    assert_near(
        arm.coriolis_matrix(&q, &qd),
        matrix(&state["C"]),
        bound("C"),
        &what("C"),
    );
    let kinetic = number(&state["kinetic_energy"]);
    let potential = number(&state["potential_energy"]);
    assert_near(
        scalar(arm.kinetic_energy(&q, &qd)),
        scalar(kinetic),
        bound("T"),
        &what("T"),
    );
    assert_near(
        scalar(arm.potential_energy(&q)),
        scalar(potential),
        bound("U"),
        &what("U"),
    );

    // The files give no scale of lengths: the longest distance in the pose and the Jacobian.
    let pose = matrix::<4, 4>(&state["ee_pose"]);
    let jacobian = matrix::<6, N>(&state["jacobian"]);
    let length = TOLERANCE * N as f64 * pose.amax().max(jacobian.amax());
    assert_near(arm.forward_kinematics(&q), pose, length, &what("pose"));
    assert_near(arm.jacobian(&q), jacobian, length, &what("jacobian"));
}

fn check_robot<const N: usize>(name: &str) {
    let arm = NewtonEuler::new(&table::<N>(name));
    let reference = load(&format!("reference/{name}"));
    let states = reference["states"].as_array().unwrap();
    assert_eq!(states.len(), 24);
    for state in states {
        check_state(&arm, name, state);
    }
}

#[test]
fn puma560() {
    check_robot::<6>("puma560");
}

#[test]
fn panda() {
    check_robot::<7>("panda");
}

#[test]
fn cylindrical_rpp() {
    check_robot::<3>("cylindrical_rpp");
}

#[test]
fn generic_mixed_n6_standard() {
    check_robot::<6>("generic_mixed_n6_standard");
}
