//! The arms of the data files against Newton-Euler, with fields among their cells too.

use dynamics_evaluation::RuntimeRobot;
use dynamics_numeric::check::{Check, Report};
use dynamics_symbolic::Function;

fn check(arm: &RuntimeRobot) -> Report {
    Check::new().samples(10).run_any(arm)
}

/// The functions that hold all others.
const FUNCTIONS: [Function; 3] = [
    Function::MassMatrix,
    Function::InverseDynamics,
    Function::ForwardDynamics,
];

#[test]
fn every_arm_agrees_with_newton_euler() {
    for name in arms::NAMES {
        let arm = RuntimeRobot::new(arms::robot(name), FUNCTIONS).expect(name);
        let report = check(&arm);
        assert!(report.is_ok(), "{name}: {report}");
    }
}

/// M and inverse dynamics say how far accelerations are from those that fulfil the equations of motion.
#[test]
fn accelerations_are_bounded_by_their_residuals() {
    let bound = |functions: &[Function]| {
        let robot = arms::robot("panda");
        let arm = RuntimeRobot::new(robot, functions.iter().copied()).expect("an arm");
        let report = Check::new().samples(3).certify_any(&arm);
        let mut functions = report.functions.iter();
        let known = functions.find(|known| known.function == "forward_dynamics");
        known.and_then(|known| known.rounding).expect("a bound")
    };
    let [by_residual, plain] = [&FUNCTIONS[..], &[Function::ForwardDynamics]].map(bound);
    println!("{by_residual:e}, {plain:e}");
    assert!(by_residual < 0.5 * plain, "{by_residual:e}, {plain:e}");
}

/// One derivation for all masses, centres of mass and tensors.
#[test]
fn fields_take_no_new_derivation() {
    let robot = arms::with_inertial_fields("ur5");
    let mut arm = RuntimeRobot::new(robot, FUNCTIONS).expect("ur5");
    for seed in 1..4 {
        let value = |index: usize| 0.3 + ((seed * 31 + index * 17) as f64).sin().abs();
        let values: Vec<f64> = (0..arm.fields().len()).map(value).collect();
        arm.set_fields(&values).expect("so many fields");
        let report = check(&arm);
        assert!(report.is_ok(), "{report}");
    }
}
