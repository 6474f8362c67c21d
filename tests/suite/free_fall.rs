//! Arms fall from rest without losing energy.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{Method, Simulation, simulation::DormandPrince};
use robots::*;

/// A second from a pose in which no arm hangs. The torques cancel the friction, so that the
/// energy is constant; what it drifts by is the error of about a thousand steps of 1e-12 each,
/// relative to the energy of the fall.
fn conserves_energy<const N: usize, const P: usize, R: Arm<N, P>>(robot: &R) {
    let q = SVector::from_fn(|i, _| 0.3 + 0.1 * i as f64);
    let rest = SVector::zeros();
    let motion = Simulation::new(robot)
        .torque(|_, _, qd| robot.friction_vector(qd))
        .initial(q, rest)
        .method(Method::DormandPrince(DormandPrince::with_tolerance(1e-12)))
        .duration(1.0)
        .samples(11)
        .run()
        .expect("a fall");

    let states = motion.q.iter().zip(&motion.qd);
    let gained = states
        .map(|(q, qd)| robot.kinetic_energy::<f64>(q, qd))
        .fold(0.0, f64::max);
    let falls = robot.gravity_vector(&q).amax() > 0.0;
    assert_eq!(falls, gained > 0.01, "{gained} J");
    let drift = motion.energy_drift(robot);
    assert!(drift <= 1e-9 * (1.0 + gained), "{drift:e} J of {gained} J");
}

/// Joints of both kinds, friction, motors, one joint to seven. That power is the rate of the energy is held
/// for every robot by `identities::energy`; this is what integration makes of it.
macro_rules! tests {
    ($($file:ident: $robot:ident;)*) => {$(
        #[test]
        fn $file() {
            conserves_energy(&$robot);
        }
    )*};
}
tests! {
    moving_mass: MovingMass;
    two_link_craig: TwoLinkCraig;
    cylindrical_rpp: CylindricalRpp;
    scara: Scara;
    puma560: Puma560;
    generic_mixed_n6_standard: GenericMixed6;
    panda: Panda;
}
