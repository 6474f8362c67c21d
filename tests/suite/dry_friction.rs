//! Six joints that slide, stop and stick.

use robot_dynamics::nalgebra::Vector6;
use robot_dynamics::{
    Friction, Method, Simulation, Trajectory,
    simulation::{Dop853, Radau5},
};
use robots::Puma560;

/// The PUMA 560 under gravity, its motors off, from a motion of all joints.
fn run_out(method: Method) -> Trajectory<6> {
    let q = Vector6::new(0.3, 0.4, -0.5, 1.0, 0.5, 0.2);
    let qd = Vector6::new(1.0, -2.0, 3.0, -4.0, 5.0, -6.0);
    Simulation::new(&Puma560)
        .initial(q, qd)
        .friction(Friction::Sticking)
        .method(method)
        .duration(6.0)
        .samples(61)
        .run()
        .expect("a motion that runs out")
}

/// It comes to rest, each joint at its time, to the same place by methods that have nothing in
/// common, and friction gives no energy on the way.
#[test]
fn a_motion_runs_out() {
    let motion = run_out(Dop853::with_tolerance(1e-9).into());
    assert_eq!(motion.qd[60], Vector6::zeros());
    for joint in 0..6 {
        let moving = motion.qd.iter().filter(|qd| qd[joint] != 0.0).count();
        assert!((1..40).contains(&moving), "joint {joint}: {moving}");
    }
    let energies = motion.energies(&Puma560);
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9));
    assert!(motion.work.evaluations < 20_000, "{:?}", motion.work);

    let implicit = run_out(Radau5::with_tolerance(1e-8).into());
    let error = (implicit.q[60] - motion.q[60]).amax();
    assert!(error < 1e-8, "{error:e}");
}
