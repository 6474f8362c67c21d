//! Bounds of rounding over the joint limits, of arms whose files have limits.

use dynamics_symbolic::bounds::{over_limits, rounding};
use dynamics_symbolic::derive::{derive, derive_plain};
use dynamics_symbolic::exact::SplitMix64;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::robot::{Bounds, JointType, Robot, Value};
use dynamics_symbolic::{Function, Proven};
use interpreter::{Inputs, Rounded};

use super::urdf::{references, robot};

/// States of one arm: at every third all joints are at an end, and all other arguments are 1 or -1.
const STATES: usize = 12;

/// Functions of every arm.
const FUNCTIONS: [Function; 9] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
    Function::ForwardKinematics,
    Function::Jacobian,
    Function::InverseDynamicsDerivatives,
];

/// Positions within the limits, and what else is an argument.
struct State {
    q: Vec<f64>,
    others: [Vec<f64>; 4],
}

/// A number that single precision has, near to one between two ends.
fn single(x: f64, [lower, upper]: [f64; 2]) -> f64 {
    let x = x as f32;
    let is_within = |x: &f32| (lower..=upper).contains(&f64::from(*x));
    let near = [x, x.next_down(), x.next_up()].into_iter().find(is_within);
    near.map_or(lower, f64::from)
}

impl State {
    fn new(robot: &Robot, random: &mut SplitMix64, is_at_ends: bool) -> Self {
        let mut along = || match is_at_ends {
            true => (random.next_u64() % 2) as f64,
            false => random.unit(),
        };
        let q = robot.joints().map(|row| {
            let [lower, upper] = match (&row.limits, row.joint_type) {
                (Some(limits), _) => limits.each_ref().map(|limit| limit.to_f64(&[])),
                (None, JointType::Revolute) => [-9.0, 9.0],
                (None, JointType::Prismatic) => [-1.0, 1.0],
            };
            single(lower + along() * (upper - lower), [lower, upper])
        });
        // Symbols of a base that moves stand in front of those of its joints.
        let of_base = robot.freedoms().base;
        let q = core::iter::repeat_n(0.0, of_base).chain(q).collect();
        let count = robot.dof().max(6);
        let mut other = |_| single(2.0 * along() - 1.0, [-1.0, 1.0]);
        let others = [(); 4].map(|()| (0..count).map(&mut other).collect());
        State { q, others }
    }

    fn inputs(&self) -> Inputs<'_> {
        let [qd, qdd, tau, wrench] = &self.others;
        Inputs {
            fields: &[],
            q: &self.q,
            qd,
            qdd,
            tau,
            stribeck: &[],
            qd_r: qdd,
            qdd_r: tau,
            jerk: tau,
            snap: qdd,
            wrench,
        }
    }
}

/// The largest error of a function's values at some states, and the largest bound; no error exceeds its own, in either precision.
fn measured(robot: &Robot, function: Function, program: &Program, label: &str) -> Option<[f64; 2]> {
    let bounds = over_limits(robot, program, &program.rounded_constants())?;
    let count = function.entries(robot.dof(), program.outputs.len());
    Some(beside(robot, program, &bounds[..count], STATES, label))
}

/// The same beside other bounds.
fn beside(
    robot: &Robot,
    program: &Program,
    bounds: &[[f64; 2]],
    states: usize,
    label: &str,
) -> [f64; 2] {
    let program = Rounded::new(program);
    let exact = program.with_all_digits();
    let mut random = SplitMix64::new(31);
    let mut largest = 0.0_f64;
    for number in 0..states {
        let state = State::new(robot, &mut random, number % 3 == 0);
        let inputs = state.inputs();
        let (found, single) = (program.run::<f64>(&inputs), program.run::<f32>(&inputs));
        let found = found.into_iter().zip(single.into_iter().map(f64::from));
        for (k, ((double, single), exact)) in
            found.zip(exact.run(&inputs)).take(bounds.len()).enumerate()
        {
            for (found, bound) in [double, single].into_iter().zip(bounds[k]) {
                let error = (exact - found.into()).abs().to_f64();
                assert!(error <= bound, "{label}: {error:e} of {k}, {bound:e}");
            }
            largest = largest.max((exact - double.into()).abs().to_f64());
        }
    }
    [
        largest,
        bounds.iter().map(|[double, _]| *double).fold(0.0, f64::max),
    ]
}

/// The geometric mean of bounds over the largest errors, and the largest.
fn print_ratios(function: Function, measured: &[[f64; 2]]) -> f64 {
    let ratios = measured.iter().filter(|[error, _]| *error > 0.0);
    let ratios: Vec<f64> = ratios.map(|[error, bound]| bound / error).collect();
    let mean = (ratios.iter().map(|x| x.ln()).sum::<f64>() / ratios.len() as f64).exp();
    let largest = ratios.iter().copied().fold(0.0, f64::max);
    println!(
        "{:32} {:4} programs {mean:10.1} {largest:10.1}",
        function.name(),
        ratios.len()
    );
    largest
}

/// Every arm of a file, by the plain recursion.
#[test]
fn no_error_within_the_limits_exceeds_its_bound() {
    let robots: Vec<_> = references()
        .iter()
        .map(|(name, reference)| (name.clone(), robot(name, reference)))
        .collect();
    for function in FUNCTIONS {
        let measured = robots.iter().filter_map(|(name, robot)| {
            let program = derive_plain(robot, function);
            measured(
                robot,
                function,
                &program,
                &format!("{} of {name}", function.name()),
            )
        });
        let measured: Vec<_> = measured.collect();
        assert!(measured.len() > 20);
        print_ratios(function, &measured);
    }
}

/// Robots with branches, read whole.
#[test]
fn no_error_within_the_limits_of_a_tree_exceeds_its_bound() {
    let robots: Vec<_> = ["hyq_no_sensors", "anymal_erd", "panda_erd", "panda_free"]
        .map(|name| {
            (
                name,
                super::trees::robot(super::trees::file(name), super::trees::STANDING, &[]),
            )
        })
        .map(|(name, robot)| (name, robot.robot().clone()))
        .into();
    let functions = FUNCTIONS
        .into_iter()
        .filter(|function| !function.row().of_tip);
    for function in functions {
        let measured = robots.iter().filter_map(|(name, robot)| {
            let program = derive_plain(robot, function);
            let label = format!("{} of {name}", function.name());
            measured(robot, function, &program, &label)
        });
        let measured: Vec<_> = measured.collect();
        assert_eq!(measured.len(), robots.len(), "{function:?}");
        print_ratios(function, &measured);
    }
}

/// Every function as it is generated.
#[test]
fn bounds_of_generated_programs_hold_for_every_function() {
    for name in ["panda", "ur5"] {
        let all = references();
        let (_, reference) = all
            .iter()
            .find(|(other, _)| other == name)
            .expect("a reference");
        let robot = robot(name, reference);
        for function in Function::ALL {
            let program = derive(&robot, function);
            let label = format!("{} of {name}", function.name());
            if let Some([error, bound]) = measured(&robot, function, &program, &label) {
                println!(
                    "{label:48} {error:10.1e} {bound:10.1e} {:10.1}",
                    bound / error
                );
            }
        }
    }
}

/// The largest bound of a function's values, in both precisions.
fn largest(robot: &Robot, function: Function, proven: &Proven, bounds: Bounds) -> [f64; 2] {
    let robot = Robot {
        bounds,
        ..robot.clone()
    };
    let found = rounding(&robot, &function.into(), proven);
    found.expect("limits").largest()
}

/// Arms, a tree and a moving base, positions being cut: no error exceeds its bound, and none is looser than without.
#[test]
fn tight_bounds_hold_and_are_no_looser() {
    let all = references();
    let arm = |name: &str| {
        let reference = &all
            .iter()
            .find(|(other, _)| other == name)
            .expect("there")
            .1;
        robot(name, reference)
    };
    let tree = |placement| {
        let file = super::trees::file("hyq_no_sensors");
        super::trees::robot(file, placement, &[]).robot().clone()
    };
    let cases = [
        ("panda", arm("panda"), Function::MassMatrix, 1.7e-14),
        ("panda", arm("panda"), Function::GravityVector, 6e-14),
        (
            "puma",
            arms_limited("puma560"),
            Function::ForwardDynamics,
            2e-13,
        ),
        (
            "hyq",
            tree(super::trees::STANDING),
            Function::MassMatrix,
            f64::INFINITY,
        ),
        (
            "hyq",
            tree(super::trees::MOVING),
            Function::MassMatrix,
            f64::INFINITY,
        ),
    ];
    for (name, robot, function, expected) in cases {
        let label = format!("{} of {name}", function.name());
        let program = derive(&robot, function);
        let constants = program.rounded_constants();
        let proven = Proven { program, constants };
        let [whole, tight] =
            [Bounds::Whole, Bounds::Tight].map(|bounds| largest(&robot, function, &proven, bounds));
        println!("{label}: {:.2e} {:.2e}", whole[0], tight[0]);
        assert!(tight[0] <= whole[0] && tight[1] <= whole[1], "{label}");
        assert!(tight[0] <= expected, "{label}: {:e}", tight[0]);
        let count = function.entries(robot.dof(), proven.program.outputs.len());
        let bounds = vec![tight; count];
        beside(&robot, &proven.program, &bounds, 20 * STATES, &label);
    }
}

/// A textbook's arm with limits of 2 rad.
fn arms_limited(name: &str) -> Robot {
    let mut robot = arms::robot(name);
    for row in &mut robot.rows {
        row.limits = Some([-2, 2].map(Value::integer));
    }
    robot
}
