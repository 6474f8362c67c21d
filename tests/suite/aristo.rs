//! The Aristo on the joint trajectory of the lecture slides' simulation: three seconds, joint 1
//! from 0 to 60 degrees and joint 2 from 90 to 60; the wrist's end values are ours.

use robot_dynamics::nalgebra::Vector6;
use robot_dynamics::{Cycloidal, Method, NewtonEuler, Simulation, simulation::DormandPrince};
use robots::Aristo;

fn trajectory() -> Cycloidal<6> {
    let degrees = |q: [f64; 6]| Vector6::from(q).map(f64::to_radians);
    let start = degrees([0.0, 90.0, 180.0, 0.0, 180.0, 0.0]);
    let end = degrees([60.0, 60.0, 180.0, 45.0, 150.0, 90.0]);
    Cycloidal::new(start, end, 3.0).expect("a duration")
}

#[test]
fn torques_on_the_trajectory_are_those_of_newton_and_euler() {
    let numeric = NewtonEuler::new(&Aristo.table());
    for k in 0..=60 {
        let at = trajectory().at(0.05 * f64::from(k));
        let tau = Aristo.inverse_dynamics(&at.q, &at.qd, &at.qdd);
        let expected = numeric.inverse_dynamics(&at.q, &at.qd, &at.qdd);
        assert!((tau - expected).amax() < 1e-13, "{}", tau - expected);
    }
}

/// Computed torque: with tau = inverse dynamics of qdd + 2 w ed + w^2 e the error of each joint
/// is that of a critically damped oscillator, e = e0 (1 + w t) exp(-w t), whatever the arm.
#[test]
fn computed_torque_drives_the_arm_onto_its_trajectory() {
    const W: f64 = 4.0;
    let law = trajectory();
    let start = law.at(0.0);
    let offset = Vector6::new(0.1, -0.2, 0.1, 0.3, -0.1, 0.2);
    let motion = Simulation::new(&Aristo)
        .torque(|t, q, qd| {
            let at = law.at(t);
            let qdd = at.qdd + (at.qd - qd) * (2.0 * W) + (at.q - q) * (W * W);
            Aristo.inverse_dynamics(q, qd, &qdd)
        })
        .initial(start.q + offset, start.qd)
        .method(Method::DormandPrince(DormandPrince::with_tolerance(1e-12)))
        .duration(3.0)
        .samples(31)
        .run()
        .expect("the motion");
    for (t, q) in motion.t.iter().zip(&motion.q) {
        let expected = offset * ((1.0 + W * t) * (-W * t).exp());
        let error = (q - law.at(*t).q - expected).amax();
        // A thousand steps of 1e-12 each, on a motion that damps them.
        assert!(error < 1e-9, "t = {t}: {error:e}");
    }
}
