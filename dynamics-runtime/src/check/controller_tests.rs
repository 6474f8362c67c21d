//! The check finds what is wrong in the functions that controllers ask for, and passes what is right.

use nalgebra::{Matrix2, SVector};

use crate::test_arms::{CRAIG_ARM, CraigArm};
use crate::{Check, Evaluate, Evaluation, Model, NewtonEuler, Report, State, Table};

/// Sets a value, times a factor.
type Value = fn(&State<2>, f64, &mut Evaluation<2>);

/// The textbook arm with all these values, one of them wrong by a factor.
struct Altered(Option<usize>);

/// A relative change far above the tolerance and far below what a wrong term does.
const WRONG: f64 = 1.0 + 1e-9;

fn numeric() -> NewtonEuler<2> {
    NewtonEuler::new(&CRAIG_ARM.table())
}

fn passivity(state: &State<2>) -> SVector<f64, 2> {
    let State { q, qd, .. } = state;
    let inertial = numeric().mass_matrix(q) * state.reference_acceleration();
    let coriolis = numeric().coriolis_matrix(q, qd) * state.reference_velocity();
    inertial + coriolis + numeric().gravity_vector(q)
}

const VALUES: [(&str, Value); 13] = [
    ("wrench_torques", |at, k, e| {
        let torques = numeric().jacobian(&at.q).transpose() * State::<2>::wrench();
        e.wrench_torques = Some(torques * k);
    }),
    ("tool_velocity", |at, k, e| {
        e.tool_velocity = Some(numeric().jacobian(&at.q) * at.qd * k);
    }),
    ("tool_acceleration", |at, k, e| {
        let own = numeric().jacobian(&at.q) * at.qdd;
        let acceleration = own + numeric().jacobian_rate(&at.q, &at.qd) * at.qd;
        e.tool_acceleration = Some(acceleration * k);
    }),
    ("jacobian_rate", |at, k, e| {
        e.jacobian_rate = Some(numeric().jacobian_rate(&at.q, &at.qd) * k);
    }),
    ("link_jacobians", |at, k, e| {
        e.link_jacobians = Some(numeric().link_jacobians(&at.q).map(|j| j * k));
    }),
    ("center_of_mass", |at, k, e| {
        e.center_of_mass = Some(numeric().center_of_mass(&at.q) * k);
    }),
    ("center_of_mass_jacobian", |at, k, e| {
        e.center_of_mass_jacobian = Some(numeric().center_of_mass_jacobian(&at.q) * k);
    }),
    ("operational_inertia_inverse", |at, k, e| {
        let inverse: Matrix2<f64> = numeric().mass_matrix(&at.q).try_inverse().expect("regular");
        let jacobian = numeric().jacobian(&at.q);
        let product = jacobian * inverse * jacobian.transpose();
        e.operational_inertia_inverse = Some(Ok(product * k));
    }),
    ("generalized_momentum", |at, k, e| {
        e.generalized_momentum = Some(numeric().mass_matrix(&at.q) * at.qd * k);
    }),
    ("momentum_bias", |at, k, e| {
        let coriolis = numeric().coriolis_matrix(&at.q, &at.qd).transpose() * at.qd;
        let own = numeric().gravity_vector(&at.q) + numeric().friction_vector(&at.qd);
        e.momentum_bias = Some((coriolis - own) * k);
    }),
    ("passivity_torque", |at, k, e| {
        e.passivity_torque = Some((passivity(at) + numeric().friction_vector(&at.qd)) * k);
    }),
    ("passivity_form", |at, k, e| {
        e.passivity_regressor_forces = Some(passivity(at) * k);
    }),
    ("inverse_dynamics_rates", |at, k, e| {
        let State { q, qd, qdd } = at;
        let (first, second) = numeric().inverse_dynamics_rates(q, qd, qdd, &at.jerk(), &at.snap());
        e.inverse_dynamics_rates = Some((first, second * k));
    }),
];

impl Model<2> for Altered {
    const JOINT_NAMES: [&'static str; 2] = CraigArm::JOINT_NAMES;

    fn table(&self) -> Table<2> {
        CRAIG_ARM.table()
    }
}

impl Evaluate<2> for Altered {
    fn evaluate(&self, state: &State<2>, tau: &SVector<f64, 2>) -> Evaluation<2> {
        let mut evaluation = CRAIG_ARM.evaluate(state, tau);
        for (index, (_, value)) in VALUES.iter().enumerate() {
            let factor = if self.0 == Some(index) { WRONG } else { 1.0 };
            value(state, factor, &mut evaluation);
        }
        evaluation
    }
}

fn check(altered: Option<usize>) -> Report {
    Check::new().samples(20).run(&Altered(altered))
}

#[test]
fn what_is_right_passes() {
    check(None).assert_ok();
}

/// Each damage is found, in the function that has it and in no other.
#[test]
fn every_damage_is_found() {
    for (index, (name, _)) in VALUES.iter().enumerate() {
        let report = check(Some(index));
        let wrong = report.functions.iter().filter(|function| !function.is_ok());
        let wrong: Vec<_> = wrong.map(|function| function.function).collect();
        assert_eq!(wrong, [*name]);
    }
}

/// The rates of the torques are limits of differences along the motion.
#[test]
fn rates_are_limits_of_differences() {
    let start = State {
        q: SVector::from([0.3, -0.8]),
        qd: SVector::from([1.1, 0.4]),
        qdd: SVector::from([-0.7, 2.0]),
    };
    let (jerk, snap) = (SVector::from([0.9, -1.3]), SVector::from([2.1, 0.6]));
    let torque = |t: f64| {
        let q = start.q
            + start.qd * t
            + start.qdd * (t * t / 2.0)
            + jerk * (t.powi(3) / 6.0)
            + snap * (t.powi(4) / 24.0);
        let qd = start.qd + start.qdd * t + jerk * (t * t / 2.0) + snap * (t.powi(3) / 6.0);
        let qdd = start.qdd + jerk * t + snap * (t * t / 2.0);
        numeric().inverse_dynamics(&q, &qd, &qdd)
    };
    let State { q, qd, qdd } = start;
    let (first, second) = numeric().inverse_dynamics_rates(&q, &qd, &qdd, &jerk, &snap);
    let h = 1e-3;
    let difference = (torque(h) - torque(-h)) / (2.0 * h);
    let curvature = (torque(h) - torque(0.0) * 2.0 + torque(-h)) / (h * h);
    // The differences err by h^2 times higher derivatives.
    assert!((first - difference).amax() < 1e-4 * first.amax());
    assert!((second - curvature).amax() < 1e-4 * second.amax());
}
