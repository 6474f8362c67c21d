//! Joints of a URDF file that follow others, beside the arm of the same file in which each of them moves by itself.
//! With q = S q_j + c of that arm, M_j = S' M S, tau_j = S' tau and J_j = J S.

use dynamics_codegen::description::{Entry, Name, Place, Positioned, Table};
use dynamics_codegen::files::{Format, model_beside};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::mechanism::Mechanism;
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::Robot;
use interpreter::{Inputs, Rounded};
use robot_dynamics::nalgebra::{DMatrix, DVector};
use robot_dynamics::{check_against_rnea, robot_dynamics};

use super::{number, text};

const FUNCTIONS: [Function; 5] = [
    Function::MassMatrix,
    Function::InverseDynamics,
    Function::Jacobian,
    Function::LinkPoses,
    Function::ForwardKinematics,
];

fn name(name: &str) -> Name {
    Name::new(name, Place::File { line: 1, column: 1 })
}

fn finger(file: &str, last: &str, lock: &[(&str, f64)]) -> Robot {
    finger_beside(file, last, lock, None)
}

/// With an entry of the call beside those of the file.
fn finger_beside(file: &str, last: &str, lock: &[(&str, f64)], entry: Option<Entry>) -> Robot {
    let locked = lock.iter().map(|(joint, q)| Positioned {
        name: name(joint),
        position: Some(number(*q)),
    });
    let gravity = [0.0, 0.0, -9.81].map(|g| Some(number(g)));
    let entries = [
        Entry::Chain(Some(["palm", last].map(name).to_vec())),
        Entry::Lock(Some(locked.collect())),
        Entry::Gravity(Some(gravity)),
    ];
    let beside = Table {
        entries: entries.into_iter().chain(entry).collect(),
        ..Table::default()
    };
    let model = model_beside("finger", file, Format::Urdf, beside);
    model.unwrap_or_else(|errors| panic!("{errors:#?}")).robot
}

fn file() -> String {
    text("files/finger.urdf")
}

/// The file without the lines that couple its joints.
fn without_mimic() -> String {
    let file = file();
    let lines = file.lines().filter(|line| !line.contains("<mimic"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The values of the functions, each program proven.
fn values(robot: &Robot, q: &[f64], qd: &[f64], qdd: &[f64]) -> [DMatrix<f64>; 5] {
    let arm = Mechanism::from(robot);
    let inputs = Inputs {
        fields: &[],
        q: &arm.with_followers(q, &[]),
        qd: &arm.with_followers(qd, &[]),
        qdd,
        tau: &[],
        stribeck: &[],
        qd_r: &[],
        qdd_r: &[],
        jerk: &[],
        snap: &[],
        wrench: &[],
    };
    FUNCTIONS.map(|function| {
        let program = derive_plain(robot, function);
        prove(robot, function, &program).unwrap_or_else(|failure| panic!("{failure}"));
        let values: Vec<f64> = Rounded::new(&program).run(&inputs);
        let columns = match function {
            Function::InverseDynamics => 1,
            Function::LinkPoses | Function::ForwardKinematics => 4,
            _ => robot.dof(),
        };
        DMatrix::from_row_slice(values.len() / columns, columns, &values)
    })
}

#[track_caller]
fn near(found: &DMatrix<f64>, expected: &DMatrix<f64>) {
    let error = (found - expected).amax();
    let size = expected.amax();
    assert!(error <= 1e-13 * size.max(1e-3), "{error:e} of {size:e}");
}

#[test]
fn joints_that_mimic_others_follow_them() {
    let lock = [("bolt", 0.015), ("lift", 0.2)];
    let coupled = finger(&file(), "nail", &lock[..1]);
    let whole = finger(&without_mimic(), "nail", &lock);
    let names: Vec<&str> = coupled.joints().map(|row| row.name.as_str()).collect();
    assert_eq!(names, ["turn", "knuckle"]);
    assert_eq!(whole.dof(), 4);
    // Exactly: 1.25, and -0.01 * 1.25 with -0.01 * -0.2 + 0.004.
    let laws: Vec<[f64; 2]> = coupled
        .followers()
        .map(|(_, law)| [&law.factor, &law.offset].map(|x| x.to_f64(&[])))
        .collect();
    assert_eq!(laws, [[1.25, -0.2], [-0.0125, 0.006]]);
    assert!(
        coupled
            .followers()
            .all(|(_, law)| law.factor.as_rational().is_some())
    );
    #[rustfmt::skip]
    let s = DMatrix::from_row_slice(4, 2, &[
        1.0, 0.0,
        0.0, 1.0,
        0.0, 1.25,
        0.0, -0.0125,
    ]);
    let c = DVector::from_vec(vec![0.0, 0.0, -0.2, 0.006]);
    for k in 0..4 {
        let sample =
            |at: usize| DVector::from_fn(2, |i, _| (1.7 * (i + at) as f64 + k as f64).sin());
        let [q, qd, qdd] = [1, 7, 13].map(sample);
        let all_q = &s * &q + &c;
        let [all_qd, all_qdd] = [&qd, &qdd].map(|x| &s * x);
        let [m, tau, j, links, tip] = values(&coupled, q.as_slice(), qd.as_slice(), qdd.as_slice());
        let all = values(
            &whole,
            all_q.as_slice(),
            all_qd.as_slice(),
            all_qdd.as_slice(),
        );
        near(&m, &(s.transpose() * &all[0] * &s));
        near(&tau, &(s.transpose() * &all[1]));
        near(&j, &(&all[2] * &s));
        near(&links, &all[3].rows(0, 8).into_owned());
        near(&tip, &all[4]);
    }
}

/// A joint that follows a locked one stands still, on the chain and beside it. A joint that is locked itself follows
/// none.
#[test]
fn what_follows_a_joint_that_stands_still_is_locked() {
    let same = |found: &Robot, expected: &Robot| {
        let still = |robot: &Robot| -> Vec<f64> {
            let locked = robot.rows.iter().filter_map(|row| row.locked.as_ref());
            locked.map(|position| position.to_f64(&[])).collect()
        };
        let (positions, others) = (still(found), still(expected));
        assert_eq!(positions.len(), others.len());
        let differences = positions.iter().zip(&others).map(|(a, b)| (a - b).abs());
        assert!(differences.fold(0.0, f64::max) < 1e-15);
        let at = [0.3; 2];
        let found = values(found, &at[..found.dof()], &at, &at);
        let expected = values(expected, &at[..expected.dof()], &at, &at);
        for (found, expected) in found.iter().zip(&expected) {
            near(found, expected);
        }
    };
    // A leader on the chain, by way of a follower.
    same(
        &finger(&file(), "nail", &[("bolt", 0.015), ("knuckle", 0.4)]),
        &finger(
            &without_mimic(),
            "nail",
            &[
                ("bolt", 0.015),
                ("lift", 0.2),
                ("knuckle", 0.4),
                ("middle", 0.3),
                ("extend", 0.001),
            ],
        ),
    );
    // A leader beside the chain.
    same(
        &finger(
            &file(),
            "cover",
            &[("bolt", 0.015), ("middle", 0.3), ("knuckle", 0.4)],
        ),
        &finger(
            &without_mimic(),
            "cover",
            &[
                ("bolt", 0.015),
                ("lift", 0.2),
                ("knuckle", 0.4),
                ("middle", 0.3),
                ("extend", 0.001),
            ],
        ),
    );
}

/// Couplings of the call stand beside those of the file.
#[test]
fn a_call_may_couple_more() {
    let [factor, offset] = [0.5, 0.25].map(number);
    let coupled = Positioned::following(name("turn"), factor, &name("knuckle"), offset);
    let entry = Entry::Couple(Some(vec![coupled]));
    let robot = finger_beside(&file(), "nail", &[("bolt", 0.015)], Some(entry));
    assert_eq!(robot.dof(), 1);
    assert_eq!(robot.followers().count(), 3);
}

robot_dynamics! {
    /// As a user writes it.
    struct Finger;
    file: "../data/files/finger.urdf", chain: ["palm", "nail"],
    lock: [bolt = 0.015],
    gravity: [0, 0, -9.81],
    functions: [default, jacobian, link_poses, forward_kinematics, regressor, base_parameters],
}

/// The numeric algorithms read the table alone, which has the followers' own rows and frames.
#[test]
fn generated_functions_agree_with_newton_euler() {
    assert_eq!(Finger::JOINT_NAMES, ["turn", "knuckle"]);
    check_against_rnea(&Finger).assert_ok();
}
