//! Many states at once beside one at a time.

use dynamics_evaluation::{EvaluationError, RuntimeRobot};
use dynamics_symbolic::Function;

/// Functions of every kind: matrices, numbers, arrays, tuples; with pivots, friction, and a wrench.
const FUNCTIONS: [Function; 9] = [
    Function::MassMatrix,
    Function::FrictionVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::LinkPoses,
    Function::ForwardDynamicsDerivatives,
    Function::WrenchTorques,
    Function::BaseParameters,
];

fn entries(count: usize, seed: usize) -> Vec<f64> {
    (0..count)
        .map(|i| 2.0 * ((i * 7 + seed * 13) as f64 * 0.61).sin())
        .collect()
}

fn arguments(function: Function, states: usize, dof: usize) -> Vec<(usize, Vec<f64>)> {
    let arguments = function.arguments().iter().enumerate();
    let argument = |(seed, argument): (usize, &dynamics_symbolic::function::Argument)| {
        let width = if argument.name() == "wrench" { 6 } else { dof };
        (width, entries(states * width, seed))
    };
    arguments.map(argument).collect()
}

/// The entries of a value in the order of a batch.
fn flat(value: &dynamics_evaluation::Value) -> Vec<f64> {
    use dynamics_evaluation::Value;
    match value {
        Value::Number(x) => vec![*x],
        Value::Matrix(matrix) => matrix.iter().copied().collect(),
        Value::Each(values) | Value::Tuple(values) => values.iter().flat_map(flat).collect(),
    }
}

/// One state is evaluated by steps that are all alike, other scalars operation by operation: the digits, and the signs of
/// zeros, are the same. States with zeros of both signs have terms that vanish.
#[test]
fn one_state_has_the_digits_of_its_operations() {
    let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let mut compared = 0;
    let names = ["two_link_craig", "puma560", "stanford", "panda"];
    let robots = names.map(arms::robot).into_iter();
    for robot in robots.chain([arms::tree("forked_chain")]) {
        let name = robot.name.clone();
        let functions = FUNCTIONS.into_iter();
        // The tree has no tip.
        let functions = functions.filter(|f| !f.row().of_tip || robot.tip_row().is_some());
        let functions: Vec<Function> = functions.collect();
        let arm = RuntimeRobot::new(robot, functions.iter().copied()).expect(&name);
        for function in functions {
            let mut states = vec![arguments(function, 3, arm.dof())];
            for zero in [0.0, -0.0] {
                let every_second = |(width, mut entries): (usize, Vec<f64>)| {
                    entries.iter_mut().step_by(2).for_each(|x| *x = zero);
                    (width, entries)
                };
                let others = arguments(function, 3, arm.dof()).into_iter();
                states.push(others.map(every_second).collect());
            }
            for (state, entries) in states
                .iter()
                .flat_map(|entries| (0..3).map(move |k| (k, entries)))
            {
                let of_state = entries
                    .iter()
                    .map(|(width, entries)| &entries[state * width..][..*width]);
                let of_state: Vec<&[f64]> = of_state.collect();
                let alike = arm
                    .evaluate(function.name(), &of_state)
                    .map(|value| flat(&value));
                let plain = arm.evaluate_in(function.name(), &of_state);
                let name = format!("{name} {}", function.name());
                assert_eq!(alike.as_ref().err(), plain.as_ref().err(), "{name}");
                let [alike, plain] = [alike, plain].map(|values| bits(&values.unwrap_or_default()));
                assert_eq!(alike, plain, "{name}");
                compared += alike.len();
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}

/// Sums may be fused in lanes: the bound is a hundred roundings of the largest entry of an output.
#[test]
fn batches_of_any_length_have_the_values_of_single_states() {
    let arm = RuntimeRobot::new(arms::robot("puma560"), FUNCTIONS).expect("an arm");
    for function in FUNCTIONS {
        for states in [1, 7, 8, 9, 16, 17, 31, 32, 33, 64, 81, 130] {
            let arguments = arguments(function, states, 6);
            let slices: Vec<&[f64]> = arguments.iter().map(|(_, x)| x.as_slice()).collect();
            let width = arm.entries(function.name()).expect("derived");
            let mut results = vec![f64::NAN; states * width];
            arm.batch(function.name(), &slices, &mut results)
                .expect("regular states");
            for state in 0..states {
                let at = arguments
                    .iter()
                    .map(|(n, x)| &x[state * n..(state + 1) * n]);
                let value = arm.evaluate(function.name(), &at.collect::<Vec<_>>());
                let expected = flat(&value.expect("a value"));
                let found = &results[state * width..(state + 1) * width];
                let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
                for (found, expected) in found.iter().zip(&expected) {
                    let error = (found - expected).abs();
                    assert!(
                        error <= 1e-11 * size,
                        "{}: {found} {expected}",
                        function.name()
                    );
                }
            }
        }
    }
}

/// A massless link has no acceleration; beside it others have.
#[test]
fn a_state_that_is_refused_spoils_no_other() {
    // Two sliding masses on one line: M is singular where the field that is the first mass is zero.
    let mut robot = arms::robot("two_link_craig");
    robot.rows[1].a = dynamics_symbolic::robot::Value::zero();
    let arm = RuntimeRobot::new(robot, [Function::ForwardDynamics]).expect("an arm");
    let (q, other) = (entries(140, 0), entries(140, 1));
    let mut qdd = vec![0.0; 140];
    let error = arm.forward_dynamics_batch(&q, &other, &other, &mut qdd);
    let single = arm.forward_dynamics(&q[..2], &other[..2], &other[..2]);
    let (Err(EvaluationError::Singular { state, .. }), Err(_)) = (&error, &single) else {
        panic!("{error:?} {single:?}");
    };
    assert_eq!(*state, Some(0));
    assert!(qdd.iter().all(|x| x.is_nan()));

    let arm = RuntimeRobot::new(arms::robot("panda"), [Function::ForwardDynamics]).expect("an arm");
    let mut q = entries(70 * 7, 0);
    q[66 * 7 + 3] = f64::INFINITY;
    let (qd, tau) = (entries(70 * 7, 1), entries(70 * 7, 2));
    let mut qdd = vec![0.0; 70 * 7];
    let error = arm.forward_dynamics_batch(&q, &qd, &tau, &mut qdd);
    let Err(EvaluationError::Singular {
        state: Some(66),
        joint,
        error,
    }) = error
    else {
        panic!("{error:?}");
    };
    let single = arm.forward_dynamics(&q[462..469], &qd[462..469], &tau[462..469]);
    let Err(EvaluationError::Singular {
        joint: of_single,
        error: alone,
        ..
    }) = single
    else {
        panic!("{single:?}");
    };
    assert_eq!((joint, error.joint), (of_single, alone.joint));
    for (state, qdd) in qdd.chunks_exact(7).enumerate() {
        assert_eq!(qdd.iter().all(|x| x.is_nan()), state == 66, "{state}");
        assert!(state == 66 || qdd.iter().all(|x| x.is_finite()), "{state}");
    }
}

#[test]
fn threads_share_an_arm() {
    let arm = RuntimeRobot::new(arms::robot("ur5"), [Function::MassMatrix]).expect("an arm");
    let q = entries(600, 0);
    let run = || {
        let mut m = vec![0.0; 3600];
        arm.mass_matrix_batch(&q, &mut m).expect("values");
        m
    };
    let here = run();
    std::thread::scope(|scope| {
        let threads = [(); 4].map(|()| scope.spawn(run));
        for thread in threads {
            assert_eq!(thread.join().expect("values"), here);
        }
    });
}

/// Positions of no joints do not say how many states there are: another argument does, or the results.
#[test]
fn a_body_without_joints_has_batches() {
    let functions = [
        Function::MassMatrix,
        Function::CoriolisVector,
        Function::LinkPoses,
    ];
    let body = RuntimeRobot::new(arms::floating("free_body"), functions).expect("a body");
    let at_one = |function: &str, arguments: &[&[f64]]| {
        let value = body.evaluate_in(function, arguments);
        value.expect("a value")
    };
    let mut found = vec![0.0; 3 * 36];
    body.batch("mass_matrix", &[&[]], &mut found)
        .expect("values");
    let m = at_one("mass_matrix", &[&[]]);
    assert!(found.chunks(36).all(|of_state| of_state == m));
    let v = entries(18, 0);
    let mut found = vec![0.0; 18];
    body.batch("coriolis_vector", &[&[], &v], &mut found)
        .expect("values");
    for (found, v) in found.chunks(6).zip(v.chunks(6)) {
        for (x, y) in found.iter().zip(at_one("coriolis_vector", &[&[], v])) {
            assert!((x - y).abs() <= 1e-13 * (1.0 + y.abs()), "{x} {y}");
        }
    }
    let poses = entries(36, 1);
    body.batch("link_poses", &[&poses, &[]], &mut [])
        .expect("no values");
}
