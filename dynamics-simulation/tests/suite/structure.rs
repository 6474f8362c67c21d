//! Energy in long runs: methods that preserve the structure of a motion, and those that do not.

use robot_dynamics::nalgebra::Vector1;
use robot_dynamics::{ForwardDynamics, Method, Simulation, Trajectory};

use crate::arms::{OneLink, TwoLink};

/// The energy that the two links exchange between kinetic and potential, J.
const EXCHANGED: f64 = 54.0;

/// The fall of the two links from the horizontal.
fn fall(arm: &impl ForwardDynamics<2>, method: Method, duration: f64) -> Trajectory<2> {
    let run = Simulation::new(arm).duration(duration).samples(1001);
    run.method(method).run().unwrap()
}

/// Semi-implicit Euler is symplectic where M is constant: the energy of one link stays near. The energy of an arm does
/// not, or the arm flies away: the last digit decides which.
#[test]
fn semi_implicit_euler_does_not_keep_the_energy_of_an_arm() {
    let method = Method::SemiImplicitEuler { step: 0.01 };
    let two = Simulation::new(&TwoLink).duration(100.0).method(method);
    let drift = match two.run() {
        Ok(run) => run.energy_drift(&TwoLink),
        Err(error) => error.trajectory.energy_drift(&TwoLink),
    };
    assert!(drift > 0.3 * EXCHANGED, "{drift} J");

    let one = Simulation::new(&OneLink).initial(Vector1::new(2.0), Vector1::new(0.0));
    let run = one.duration(100.0).method(method).run().unwrap();
    let drift = run.energy_drift(&OneLink);
    assert!(drift < 0.03 * 9.81, "{drift} J");
}

/// Twenty seconds of chaos; errors are those of the steps, and do not grow.
#[test]
fn structure_preserving_methods_keep_the_energy() {
    let step = 0.01;
    for (method, bound) in [
        (Method::ImplicitMidpoint { step }, 4e-3),
        (Method::GaussLegendre4 { step }, 5e-6),
        (Method::GaussLegendre6 { step }, 2e-8),
    ] {
        let run = fall(&TwoLink, method, 20.0);
        let drift = run.energy_drift(&TwoLink) / EXCHANGED;
        assert!(drift < bound, "{method:?}: {drift:e}");
    }
}
