//! Robots with branches at 24 states, each beside numbers of 31 digits and beside the runtime's Newton-Euler.

mod exact;

use std::path::{Path, PathBuf};

use dynamics_evaluation::{ReadOptions, RuntimeRobot, Value, read_file};
use dynamics_symbolic::robot::{Frame, JointType, Placement, Robot};
use dynamics_symbolic::{Function, Request};
use robot_dynamics::check::Check;
use robot_dynamics::nalgebra::{Rotation3, Vector3};
use robot_dynamics::{Certified, DoubleDouble, Pose};
use testkit::random::Random;

use exact::{Exact, Forces, Vector};

/// Relative to the sum of the sizes of all terms.
const BOUND: f64 = 1e-15;

/// Robots in files. RBDL's five joints and KDL's Y have printed values. Two arms are on a waist, and a palletiser has
/// rods beside its arm. A gripper has followers on both sides, and legs are on a trunk. The fingers of one arm move
/// together, those of the other do not.
const FILES: [&str; 9] = [
    "files/trees/five.toml",
    "files/trees/y.toml",
    "files/torso.toml",
    "files/trees/palletiser.toml",
    "urdf/trees/parallel_gripper.urdf",
    "urdf/trees/hyq_no_sensors.urdf",
    "urdf/trees/anymal_erd.urdf",
    "urdf/trees/panda_erd.urdf",
    "urdf/trees/panda_free.urdf",
];

fn from_file(name: &str) -> Robot {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data");
    let path: PathBuf = data.join(name);
    let options = ReadOptions::new().entries("allow = [\"unphysical_inertia\"]");
    let options = match path.extension().and_then(|end| end.to_str()) {
        Some("urdf") => options.entries("gravity = [0.3, -0.2, -9.81]"),
        _ => options.entries("let.load = 1.5"),
    };
    let model = read_file(&path, &options.functions(["mass_matrix"]));
    model.unwrap_or_else(|error| panic!("{error}")).robot
}

/// The robot with frames on the last row, in the middle and on the base.
fn with_frames(mut robot: Robot) -> Robot {
    let last = robot.rows.len().checked_sub(1);
    for (name, on) in [
        ("last", last),
        ("middle", last.map(|last| last / 2)),
        ("base frame", None),
    ] {
        robot.frames.push(Frame {
            name: name.to_owned(),
            on,
            places: vec![Placement {
                xyz: [0.1, 0.02, -0.03].map(arms::decimal),
                rpy: [0.3, -0.2, 0.7].map(arms::decimal),
            }],
            body: None,
        });
    }
    robot
}

/// A state: where a base that moves stands, its rotation by rows and its position, and positions, velocities and
/// accelerations.
struct State {
    base: Vec<f64>,
    motion: [Vec<f64>; 3],
}

/// States at rest, at right angles, slow, fast, at angles of up to 1e6 rad, and random.
fn states(robot: &Robot) -> Vec<State> {
    let mut random = Random::seeded(28);
    let [poses, twists] = [12, 6].map(|count| {
        if robot.freedoms().has_base() {
            count
        } else {
            0
        }
    });
    let motions = motions(robot).into_iter().enumerate();
    let states = motions.map(|(number, [q, qd, qdd])| {
        let mut between = |size: f64| random.between(-size, size);
        // At first in the axes of the world.
        let turn = Rotation3::new(Vector3::from_fn(|_, _| number.min(1) as f64 * between(2.0)));
        let place = Vector3::from_fn(|_, _| between(3.0));
        let pose = Pose {
            rotation: turn.into_inner(),
            position: place,
        };
        let mut with_base = |joints: Vec<f64>| {
            let of_joints = joints.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            let size = if joints.is_empty() { 3.0 } else { of_joints };
            let twist = (0..twists).map(|_| between(size));
            twist
                .collect::<Vec<f64>>()
                .into_iter()
                .chain(joints)
                .collect()
        };
        State {
            motion: [q, with_base(qd), with_base(qdd)],
            base: <[f64; 12]>::from(pose.entries())[..poses].to_vec(),
        }
    });
    states.collect()
}

/// The motions of the joints.
fn motions(robot: &Robot) -> Vec<[Vec<f64>; 3]> {
    let mut random = Random::seeded(27);
    let mut vector = |angle: f64, length: f64| -> Vec<f64> {
        let sizes = robot.joints().map(|row| match row.joint_type {
            JointType::Revolute => angle,
            JointType::Prismatic => length,
        });
        sizes.map(|size| random.between(-size, size)).collect()
    };
    (0..24)
        .map(|state| match state {
            0 => [vector(0.0, 0.0), vector(0.0, 0.0), vector(0.0, 0.0)],
            1..4 => {
                let turns = vector(4.0, 0.5)
                    .into_iter()
                    .map(|x| x.round() * std::f64::consts::FRAC_PI_2);
                [turns.collect(), vector(3.0, 1.0), vector(10.0, 5.0)]
            }
            4..6 => [vector(3.0, 0.5), vector(1e-6, 1e-6), vector(1e-6, 1e-6)],
            6..8 => [vector(3.0, 0.5), vector(100.0, 20.0), vector(1e3, 1e3)],
            8..10 => [vector(1e6, 0.5), vector(3.0, 1.0), vector(10.0, 5.0)],
            _ => [vector(3.1, 0.5), vector(3.0, 1.0), vector(10.0, 5.0)],
        })
        .collect()
}

/// Errors of the functions of a robot: the largest of all states, relative to the sizes of terms.
#[derive(Default)]
struct Errors(Vec<(String, f64)>);

impl Errors {
    fn add(&mut self, function: &str, error: f64) {
        assert!(error.is_finite(), "{function}");
        match self.0.iter_mut().find(|(name, _)| name == function) {
            Some((_, largest)) => *largest = largest.max(error),
            None => self.0.push((function.to_owned(), error)),
        }
    }

    /// Adds certified forces, whose errors are below their bounds: the share of a bound that an error takes. Numbers of
    /// 31 digits tell no smaller errors than those of their own.
    fn add_certified(&mut self, function: &str, found: &[Certified<f64>], expected: &Forces) {
        assert_eq!(found.len(), expected.len(), "{function}");
        for (found, (expected, size)) in found.iter().zip(expected) {
            let error = (*expected - DoubleDouble::from(found.value())).abs();
            let bound = found.bound() + 1e-30 * size;
            assert!(bound.is_finite(), "{function}");
            self.add("bound", error.to_f64() / bound.max(f64::MIN_POSITIVE));
        }
    }

    /// Adds the errors of forces, each relative to the largest of their sizes.
    fn add_forces(&mut self, function: &str, found: &[f64], expected: &Forces) {
        assert_eq!(found.len(), expected.len(), "{function}");
        let size = expected
            .iter()
            .fold(f64::MIN_POSITIVE, |size, of| size.max(of.1));
        for (found, (expected, _)) in found.iter().zip(expected) {
            let error = (*expected - DoubleDouble::from(*found)).abs().to_f64();
            self.add(function, error / size);
        }
    }

    fn add_vector(&mut self, function: &str, found: &[f64], expected: &Vector, size: f64) {
        for (found, expected) in found.iter().zip(expected.iter()) {
            let error = (*expected - DoubleDouble::from(*found)).abs().to_f64();
            self.add(function, error / size);
        }
    }
}

/// The numbers of a function, matrices by columns, on that base if it takes one.
fn value(robot: &RuntimeRobot, base: &[f64], function: &str, arguments: &[&[f64]]) -> Vec<f64> {
    match robot.evaluate(function, &on_base(robot, base, function, arguments)) {
        Ok(Value::Matrix(matrix)) => matrix.as_slice().to_vec(),
        other => panic!("{function}: {other:?}"),
    }
}

/// The arguments of a function, behind that of the base if it takes one.
fn on_base<'a, T>(
    robot: &RuntimeRobot,
    base: &'a [T],
    function: &str,
    arguments: &[&'a [T]],
) -> Vec<&'a [T]> {
    let mut names = robot.arguments(function).expect("a function");
    let takes_base = names.next().is_some_and(|(name, _)| name == "base");
    let first = takes_base.then_some(base);
    first.into_iter().chain(arguments.iter().copied()).collect()
}

fn compare(robot: Robot) -> Errors {
    let robot = with_frames(robot);
    let exact = Exact(&robot);
    let functions = [
        Function::MassMatrix,
        Function::CoriolisVector,
        Function::GravityVector,
        Function::InverseDynamics,
        Function::ForwardDynamics,
    ];
    let at_frames = robot.frames.iter().enumerate().flat_map(|(i, frame)| {
        let functions = [Function::ForwardKinematics, Function::Jacobian];
        functions.map(|function| Request::of_frame(function, i, &frame.name))
    });
    let requests = functions.map(Request::from).into_iter().chain(at_frames);
    let arm = RuntimeRobot::new(robot.clone(), requests.collect::<Vec<_>>()).expect("proven");
    let mut errors = Errors::default();
    for State {
        base,
        motion: [q, qd, qdd],
    } in &states(&robot)
    {
        let of = |function: &str, arguments: &[&[f64]]| value(&arm, base, function, arguments);
        let matrix = exact.mass_matrix(q);
        let found = of("mass_matrix", &[q]);
        for (found, expected) in found.chunks(robot.dof()).zip(&matrix) {
            errors.add_forces("M", found, expected);
        }
        errors.add_forces(
            "V",
            &of("coriolis_vector", &[q, qd]),
            &exact.coriolis_vector(q, qd),
        );
        errors.add_forces(
            "G",
            &of("gravity_vector", &[q]),
            &exact.gravity_vector(base, q),
        );
        let tau = exact.inverse_dynamics(base, [q, qd, qdd]);
        errors.add_forces("tau", &of("inverse_dynamics", &[q, qd, qdd]), &tau);
        let certified =
            [base, q, qd, qdd].map(|x| x.iter().map(|x| Certified::exact(*x)).collect::<Vec<_>>());
        let [certain_base, certain_q, certain_qd, certain_qdd] =
            certified.each_ref().map(Vec::as_slice);
        let bounded = |function: &str, arguments: &[&[Certified<f64>]]| {
            let arguments = on_base(&arm, certain_base, function, arguments);
            arm.evaluate_in(function, &arguments).expect("numbers")
        };
        let found = bounded("inverse_dynamics", &[certain_q, certain_qd, certain_qdd]);
        errors.add_certified("tau", &found, &tau);
        let found = bounded("gravity_vector", &[certain_q]);
        errors.add_certified("G", &found, &exact.gravity_vector(base, q));
        // The forces that the accelerations take which are found.
        let given: Vec<f64> = tau.iter().map(|(tau, _)| tau.to_f64()).collect();
        let found = of("forward_dynamics", &[q, qd, &given]);
        let mut taken = exact.inverse_dynamics(base, [q, qd, &found]);
        for (taken, tau) in taken.iter_mut().zip(&tau) {
            taken.1 = taken.1.max(tau.1);
        }
        errors.add_forces("qdd", &given, &taken);
        for (i, frame) in robot.frames.iter().enumerate() {
            let (pose, columns) = exact.at_frame(i, base, q);
            let method = |function: Function| function.name_of_frame(&frame.name);
            let found = of(&method(Function::ForwardKinematics), &[q]);
            let far = pose.position.map(DoubleDouble::to_f64).amax().max(1.0);
            for (k, found) in found.chunks(4).enumerate() {
                let (expected, size) = match k {
                    3 => (pose.position, far),
                    _ => (pose.rotation.column(k).into_owned(), 1.0),
                };
                errors.add_vector("pose", &found[..3], &expected, size);
            }
            let found = of(&method(Function::Jacobian), &[q]);
            for (found, [linear, angular]) in found.chunks(6).zip(&columns) {
                errors.add_vector("J", &found[..3], linear, far);
                errors.add_vector("J", &found[3..], angular, far);
            }
        }
    }
    let report = Check::new().samples(24).run_any(&arm);
    assert!(report.is_ok(), "{}: {report}", robot.name);
    errors
}

fn compare_all(robots: impl Iterator<Item = Robot>) -> usize {
    let mut trees = 0;
    for robot in robots {
        let name = robot.name.clone();
        trees += usize::from(!robot.is_serial());
        let Errors(errors) = compare(robot);
        let line = errors
            .iter()
            .map(|(function, error)| format!("{function} {error:.1e}"));
        println!("{name:<20} {}", line.collect::<Vec<_>>().join("  "));
        let bound = |function: &str| if function == "bound" { 1.0 } else { BOUND };
        let is_within = errors
            .iter()
            .all(|(function, error)| *error <= bound(function));
        assert!(is_within, "{name}: {errors:?}");
    }
    trees
}

/// The trees of 14 joints and more.
const LARGE: [&str; 4] = ["two_pandas", "four_fingers", "torso", "humanoid"];

#[test]
fn trees_agree_with_newton_euler_in_31_digits() {
    let others = arms::TREES.iter().filter(|name| !LARGE.contains(name));
    let robots = FILES
        .map(from_file)
        .into_iter()
        .chain(others.map(|name| arms::tree(name)));
    assert_eq!(compare_all(robots), 12);
}

#[test]
#[ignore = "half a minute: large trees"]
fn large_trees_agree_with_newton_euler_in_31_digits() {
    assert_eq!(compare_all(LARGE.map(arms::tree).into_iter()), 4);
}

/// The same robots and a body without joints, on a base that moves.
#[test]
fn robots_on_moving_bases_agree_with_newton_euler_in_31_digits() {
    let names = arms::FLOATING.iter().filter(|name| !LARGE.contains(name));
    let of_files = [
        "files/torso.toml",
        "files/trees/palletiser.toml",
        "urdf/trees/panda_erd.urdf",
    ];
    let trunk = arms::floating("free_body").base;
    let on_trunk = |name: &str| Robot {
        base: trunk.clone(),
        ..from_file(name)
    };
    let robots = names.map(|name| arms::floating(name));
    compare_all(robots.chain(of_files.map(on_trunk)));
}
