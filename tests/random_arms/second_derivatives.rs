//! Second derivatives of the torques of all robots beside the table in 31 digits. Generated code does the
//! same operations; that of long arms would be most of what is compiled.

use std::ops::RangeInclusive;

use dynamics_evaluation::RuntimeRobot;
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;
use robot_dynamics::nalgebra::{DVector, Dyn, SMatrix, SVector};
use robot_dynamics::{
    DoubleDouble, Pose, SecondDerivatives, SizedState, State, check::Checked as _, table::JointType,
};
use testkit::exact::Exact;
use testkit::random::Random;

/// Relative to what is added up, for each joint: as for the functions of the default set.
const BOUND: f64 = 4e-15;

fn state<const N: usize>(random: &mut Random) -> State<N> {
    State {
        q: random.vector(3.0),
        qd: random.vector(2.0),
        qdd: random.vector(5.0),
    }
}

/// The same for an arm whose number of joints is known at run time alone.
fn of_any_size<const N: usize>(state: &State<N>) -> SizedState<Dyn> {
    let vector = |vector: &SVector<f64, N>| DVector::from_column_slice(vector.as_slice());
    SizedState {
        q: vector(&state.q),
        qd: vector(&state.qd),
        qdd: vector(&state.qdd),
    }
}

fn four<T: Copy, const N: usize>(d: &SecondDerivatives<T, N>) -> [[SMatrix<T, N, N>; N]; 4] {
    [d.0, d.1, d.2, d.3]
}

/// How large are the terms of d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq. Each derivative by an
/// angle leaves a product of sines, lengths and masses as large as it was.
fn magnitudes<const N: usize>(exact: &Exact<N>, state: &State<N>) -> [f64; 4] {
    let [q, qd] = [state.q, state.qd].map(|x| x.map(DoubleDouble::from));
    let table = exact.0;
    let inertia = largest(&exact.mass_matrix(&q));
    let slides = table
        .rows
        .iter()
        .any(|row| row.joint_type == JointType::Prismatic);
    // The mass of what slides is in M; what it does to the inertia of a turn is of first order in the distance.
    let inertia = if slides {
        inertia + table.total_mass()
    } else {
        inertia
    };
    let symbols = largest(&exact.coriolis_vector(&q, &qd)) + inertia;
    let (v, a) = (state.qd.amax(), state.qdd.amax());
    [
        symbols * (1.0 + v * v + a) + largest(&exact.gravity_vector(&q)),
        2.0 * symbols,
        2.0 * symbols * (1.0 + v),
        symbols,
    ]
}

/// The largest of the entries.
fn largest<const R: usize, const C: usize>(matrix: &SMatrix<DoubleDouble, R, C>) -> f64 {
    matrix.iter().map(|x| x.high().abs()).fold(0.0, f64::max)
}

/// The largest error of an arm. Symmetric parts are symmetric to the last bit.
fn largest_error<const N: usize>(arm: &RuntimeRobot, states: usize) -> f64 {
    let table = arm.table().of_joints::<N>().expect("so many joints");
    let exact = Exact(&table);
    let mut random = Random::seeded(31);
    let mut worst = 0.0_f64;
    for _ in 0..states {
        let state: State<N> = state(&mut random);
        let sized = of_any_size(&state);
        let found = arm.values(&Pose::identity(), &sized, &DVector::zeros(N));
        let found: Option<SecondDerivatives<f64, N>> =
            found.get("inverse_dynamics_second_derivatives");
        let found = four(&found.expect("asked for"));
        for i in 0..N {
            assert_eq!(found[0][i], found[0][i].transpose());
            assert_eq!(found[1][i], found[1][i].transpose());
            for j in 0..N {
                assert_eq!(found[3][i].row(j), found[3][j].row(i));
            }
        }
        let State { q, qd, qdd } = state;
        let [q, qd, qdd] = [q, qd, qdd].map(|x| x.map(DoubleDouble::from));
        let expected = four(&exact.second_derivatives(&q, &qd, &qdd));
        let sizes = magnitudes(&exact, &state);
        for ((found, expected), size) in found.iter().zip(&expected).zip(sizes) {
            for (found, expected) in found.iter().zip(expected) {
                let error = largest(&(found.map(DoubleDouble::from) - expected));
                worst = worst.max(error / size);
            }
        }
    }
    worst
}

fn check<const N: usize>(robot: Robot) {
    let name = robot.name.clone();
    let function = Function::InverseDynamicsSecondDerivatives;
    let arm = RuntimeRobot::new(robot, [function]).expect("programs are proven");
    let worst = largest_error::<N>(&arm, if N < 7 { 3 } else { 1 });
    let unit = 1e-15 * N as f64;
    println!("{name:26} {:.2}", worst / unit);
    assert!(worst <= BOUND * N as f64, "{name}: {worst:e}");
}

/// Prints the largest errors in units of 1e-15 for each joint.
fn check_robots(joints: RangeInclusive<usize>) {
    for robot in arms::NAMES.map(arms::robot) {
        let dof = robot.dof();
        if !joints.contains(&dof) {
            continue;
        }
        match dof {
            1 => check::<1>(robot),
            2 => check::<2>(robot),
            3 => check::<3>(robot),
            4 => check::<4>(robot),
            6 => check::<6>(robot),
            7 => check::<7>(robot),
            10 => check::<10>(robot),
            12 => check::<12>(robot),
            _ => panic!("{}: {dof} joints", robot.name),
        }
    }
}

#[test]
fn second_derivatives_have_the_digits_of_the_table() {
    check_robots(1..=4);
}

/// `cargo test -p random_arms second_derivatives:: -- --ignored`
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn second_derivatives_of_longer_arms_have_the_digits_of_the_table() {
    check_robots(5..=usize::MAX);
}
