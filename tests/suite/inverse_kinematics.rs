//! Numeric inverse kinematics of every robot: it reaches where the robot has been, and says the same of one pose for ever.

use robot_dynamics::inverse_kinematics::InverseKinematics;
use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{Kinematics, Model, NewtonEuler};
use robots::*;
use testkit::random::Random;

/// Where the tip has been at positions up to 2 rad or 2 m from zero, numeric Newton-Euler has it again.
fn check<const N: usize>(name: &str, robot: &(impl Kinematics<N> + Model<N>)) {
    const POSES: usize = 12;
    let numeric = NewtonEuler::new(&robot.table());
    let solver = InverseKinematics::new(robot);
    let length = 1.0 + numeric.jacobian(&SVector::zeros()).amax();
    let mut random = Random::seeded(31);
    let mut attempts = 0;
    for _ in 0..POSES {
        let q: SVector<f64, N> = random.vector(2.0);
        let pose = robot.forward_kinematics(&q);
        let found = solver.solve(&pose, &SVector::zeros());
        let found = found.unwrap_or_else(|error| panic!("{name} at {q}: {error}"));
        let error = (numeric.forward_kinematics(&found.q) - pose).amax();
        assert!(error < 1e-8 * length, "{name}: {error:e}");
        attempts += found.attempts;
    }
    println!(
        "{name:26} {:.1} attempts a pose",
        attempts as f64 / POSES as f64
    );
}

macro_rules! check_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        $(check::<$n>(stringify!($file), &$robot);)*
    };
}

#[test]
fn every_robot_reaches_where_it_has_been() {
    for_each_robot!(check_all);
    check_all! { tilting_cell: TiltingCell, 4, 6; }
}
