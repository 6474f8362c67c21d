//! Numeric inverse kinematics of the Panda: how many poses are reached, how long that takes, and how searches end, as a
//! table for `benches/inverse.sh`.
//!
//! `taskset -c 0 cargo bench -p benches --bench reach`. Reachable poses are those of random positions within the
//! limits; for the others the tip is farther from the shoulder than the lengths of the links allow. Numeric
//! Newton-Euler decides whether a pose is reached: it shares nothing with the generated functions of the search.

use std::collections::BTreeMap;
use std::hint::black_box;

use measured_arms::Panda;
use measuring::table::{Table, digits};
use measuring::{median, thread_seconds};
use robot_dynamics::NewtonEuler;
use robot_dynamics::inverse_kinematics::{InverseKinematics, Reason, Tip};
use robot_dynamics::nalgebra::{Const, Matrix3, Matrix4, SVector, Vector3};
use testkit::random::Random;

/// The manufacturer's limits of the joints.
const LIMITS: [[f64; 2]; 7] = [
    [-2.8973, 2.8973],
    [-1.7628, 1.7628],
    [-2.8973, 2.8973],
    [-3.0718, -0.0698],
    [-2.8973, 2.8973],
    [-0.0175, 3.7525],
    [-2.8973, 2.8973],
];

const REACHABLE: usize = 10_000;
const UNREACHABLE: usize = 100_000;

type Solver<'a> = InverseKinematics<Const<7>, Tip<'a, Panda>>;

fn positions(random: &mut Random) -> SVector<f64, 7> {
    SVector::from_fn(|joint, _| random.between(LIMITS[joint][0], LIMITS[joint][1]))
}

/// A pose whose origin is farther from the shoulder than elbow, wrist and flange together reach.
fn unreachable(random: &mut Random) -> Matrix4<f64> {
    let mut pose = Panda.forward_kinematics(&positions(random));
    let shoulder = Vector3::new(0.0, 0.0, 0.333);
    let longest = 0.316_f64.hypot(0.0825) + 0.384_f64.hypot(0.0825) + 0.088_f64.hypot(0.107);
    let way = pose.fixed_view::<3, 1>(0, 3) - shoulder;
    let far = longest * random.between(1.001, 1.5);
    pose.fixed_view_mut::<3, 1>(0, 3)
        .copy_from(&(shoulder + way.normalize() * far));
    pose
}

/// Whether positions are within the limits and the tip is there, by Newton-Euler.
fn is_right(numeric: &NewtonEuler<7>, pose: &Matrix4<f64>, q: &SVector<f64, 7>) -> bool {
    let there = numeric.forward_kinematics(q);
    let turn = there.fixed_view::<3, 3>(0, 0).transpose() * pose.fixed_view::<3, 3>(0, 0);
    let way = (there - pose).fixed_view::<3, 1>(0, 3).norm();
    let within = (0..7).all(|joint| (LIMITS[joint][0]..=LIMITS[joint][1]).contains(&q[joint]));
    within && way < 1.01e-9 && (turn - Matrix3::identity()).norm() < 1.5e-9
}

fn kind(reason: &Reason) -> &'static str {
    match reason {
        Reason::OutOfReach { .. } => "out of reach",
        Reason::Minimum => "in a minimum",
        Reason::Limits { .. } => "beyond limits",
        Reason::Iterations => "out of iterations",
        _ => "other",
    }
}

/// How searches end, and how many ends are wrong successes.
fn ends(
    solver: &Solver<'_>,
    poses: &[Matrix4<f64>],
    start: &SVector<f64, 7>,
) -> (BTreeMap<&'static str, usize>, usize) {
    let numeric = NewtonEuler::new(&Panda.table());
    let (mut counts, mut wrong) = (BTreeMap::new(), 0);
    for pose in poses {
        let end = match solver.solve(pose, start) {
            Ok(found) => {
                wrong += usize::from(!is_right(&numeric, pose, &found.q));
                "reached"
            }
            Err(error) => kind(&error.reason),
        };
        *counts.entry(end).or_insert(0) += 1;
    }
    (counts, wrong)
}

/// A number below a million, with a comma behind its thousands.
fn grouped(number: usize) -> String {
    match number {
        0..1_000 => number.to_string(),
        _ => format!("{},{:03}", number / 1_000, number % 1_000),
    }
}

fn main() {
    let mut random = Random::seeded(7);
    let start = SVector::from_fn(|joint, _| 0.5 * (LIMITS[joint][0] + LIMITS[joint][1]));
    let solver = InverseKinematics::new(&Panda).limits(LIMITS.map(Some));
    let reachable: Vec<_> = (0..REACHABLE)
        .map(|_| Panda.forward_kinematics(&positions(&mut random)))
        .collect();
    let others: Vec<_> = (0..UNREACHABLE).map(|_| unreachable(&mut random)).collect();
    let heads = ["poses", "mean, us a pose", "ends", "wrong successes"];
    let mut table = Table::new("", &heads);
    for (name, poses, passes) in [("reachable", &reachable, 11), ("out of reach", &others, 1)] {
        let (counts, wrong) = ends(&solver, poses, &start);
        let solve_all = || {
            for pose in poses {
                black_box(&solver.solve(black_box(pose), &start));
            }
        };
        let passes = (0..passes).map(|_| {
            let before = thread_seconds();
            solve_all();
            1e6 * (thread_seconds() - before) / poses.len() as f64
        });
        let mean = median(passes);
        let ends: Vec<_> = counts
            .iter()
            .map(|(end, count)| format!("{} {end}", grouped(*count)))
            .collect();
        table.row([
            format!("{} {name}", grouped(poses.len())),
            digits(mean),
            ends.join(", "),
            wrong.to_string(),
        ]);
    }
    print!("{}", table.markdown_rows());
}
