//! Joints that a singular pose leaves free: the positions that are given are those nearest to zero that the arm can take.

use core::f64::consts::PI;

use robot_dynamics::closed_form::{Real, Solution};
use robot_dynamics::nalgebra::{Matrix4, Rotation3, SVector, Vector3};

use crate::arms::*;
use crate::{Inverse, Random, apart, residual};

/// How far the elbow of an arm of Universal Robots, wrist in line, is from reaching with another sixth angle, m: negative if it
/// reaches. `q` are positions that lead to the pose.
fn beyond<A: Inverse<6>>(arm: &A, q: &SVector<f64, 6>, sixth: f64) -> f64 {
    let links = arm.links(q);
    let point = |pose: &Matrix4<f64>| pose.fixed_view::<3, 1>(0, 3).into_owned();
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), q[5] - sixth);
    let fourth = links[5] * turn.to_homogeneous() * links[5].try_inverse().unwrap() * links[3];
    let axis = links[0].fixed_view::<3, 1>(0, 2).into_owned();
    let apart = point(&fourth) - point(&links[0]);
    let flat = (apart - axis * apart.dot(&axis)).norm();
    let length = |i: usize| (point(&links[i]) - point(&links[i - 1])).norm();
    (flat - length(1) - length(2)).max((length(1) - length(2)).abs() - flat)
}

/// Positions with the wrist in line, stretched by so much less than 180 degrees.
fn in_line(random: &mut Random, elbow: f64) -> SVector<f64, 6> {
    let mut q: SVector<f64, 6> = random.joints();
    q[4] = if random.next() < 0.0 { 0.0 } else { PI };
    q[2] = if random.next() < 0.0 { elbow } else { -elbow };
    q
}

/// The marked solution with the first and the fifth joint where they are.
fn of_branch<T: Real>(all: &[Solution<T, 6>], q: &SVector<f64, 6>) -> Option<SVector<f64, 6>> {
    let marked = all.iter().filter(|solution| solution.is_singular);
    let found = marked.map(|solution| solution.q.map(Into::into));
    let way = |found: &SVector<f64, 6>| {
        let [mut one, mut other] = [*found, *q];
        for i in [1, 2, 3, 5] {
            (one[i], other[i]) = (0.0, 0.0);
        }
        apart(&one, &other)
    };
    found.into_iter().find(|found| way(found) < 1e-2)
}

fn check<A: Inverse<6>>(arm: &A) {
    let mut random = Random(3);
    let (mut turned, mut free) = (0, 0);
    for elbow in [0.0, 1e-9, 1e-4, 0.09, 0.35, 0.8, 1.6] {
        for _ in 0..40 {
            let q = in_line(&mut random, elbow);
            let pose = arm.pose(&q);
            let solutions = arm.solutions(&pose, 0.0);
            for solution in &solutions {
                let miss = residual(arm, &pose, &solution.q);
                assert!(miss < 1e-13, "{}: {miss:e} at {q}", A::NAME);
            }
            let found = of_branch(&solutions, &q).expect("the arm stands there");
            let sixth = found[5];
            assert!(beyond(arm, &q, sixth) < 1e-9);
            // Next to where the first joint is at its edge, too, the wrist is not in line to all digits.
            let is_free = [0.0, PI].contains(&found[4]);
            free += usize::from(is_free);
            for k in 0..if is_free { 200 } else { 0 } {
                let nearer = f64::from(k) / 200.0 * (sixth.abs() - 1e-6).max(0.0);
                let reaches = [nearer, -nearer].map(|sixth| beyond(arm, &q, sixth) < 0.0);
                assert!(
                    sixth == 0.0 || reaches == [false; 2],
                    "{sixth} {nearer} {q}"
                );
            }
            turned += usize::from(sixth != 0.0);
            let single = arm.solutions(&pose.map(|x| x as f32), 0.0);
            of_branch(&single, &q).expect("in single precision, too");
        }
    }
    // Not all stand at zero.
    assert!(turned > 80 && free > 250, "{turned} {free}");
}

#[test]
fn a_free_sixth_joint_is_nearest_to_zero() {
    check(&Ur3e);
    check(&Ur5e);
    check(&Ur10e);
}

/// In single precision axes are in line a million times sooner.
#[test]
fn wrists_nearly_in_line_are_solved() {
    let mut random = Random(5);
    for off in [1e-15, 1e-14, 1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5] {
        for _ in 0..200 {
            let mut q = in_line(&mut random, 0.02 * random_unit(off));
            q[4] += off;
            let pose = Ur5e.pose(&q);
            assert_eq!(Ur5e.inverse_kinematics(&pose).reason(), None, "{off:e} {q}");
            let single = pose.map(|x| x as f32);
            assert_eq!(
                Ur5e.inverse_kinematics(&single).reason(),
                None,
                "{off:e} {q}"
            );
        }
    }
}

/// From 0 to 1, so that elbows are stretched by different parts.
fn random_unit(off: f64) -> f64 {
    (off.log10() * 7.3).fract().abs()
}

/// The wrist so little off the first axis that this joint has no digits: each solution is marked.
#[test]
fn joints_without_digits_are_marked() {
    for off in [0.0, 1e-14, 1e-12, 1e-10, 1e-8] {
        for k in 0..200 {
            let q2 = 0.3 + 0.002 * f64::from(k);
            let q3 = ((off - 0.4 * q2.cos()) / 0.35).asin() - q2;
            if q3.is_nan() {
                continue;
            }
            let q = SVector::from([0.7, q2, q3, 0.4, 0.9, -0.3]);
            let solutions = Upright.inverse_kinematics(&Upright.pose(&q));
            assert!(!solutions.is_empty());
            assert!(
                solutions.iter().all(|solution| solution.is_singular),
                "{off:e}"
            );
        }
    }
    // And those that have them are not.
    let q = SVector::from([0.7, 0.3, 0.5, 0.4, 0.9, -0.3]);
    let solutions = Upright.inverse_kinematics(&Upright.pose(&q));
    assert!(solutions.iter().all(|solution| !solution.is_singular));
}

/// Numbers of a line.
fn numbers(line: &str) -> Vec<f64> {
    let words = line.split_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

/// The solutions of singular poses of a UR3e: C and JavaScript are compared with the same file.
#[test]
fn singular_poses_have_the_solutions_of_the_file() {
    let mut lines = include_str!("../data/closed_forms.txt").lines();
    let mut found = String::new();
    while let Some(line) = lines.find(|line| !line.starts_with('#')) {
        let degrees = numbers(line);
        let q = SVector::from_fn(|i, _| degrees[i].to_radians());
        let solutions = Ur3e.inverse_kinematics(&Ur3e.pose(&q));
        found += &format!("{line}\n");
        for Solution { q, is_singular, .. } in &solutions {
            let angles: Vec<_> = q.iter().map(|angle| format!("{angle:.6}")).collect();
            found += &format!("# {} {}\n", angles.join(" "), u8::from(*is_singular));
            let expected = lines.next().expect("a solution").trim_start_matches('#');
            let expected = numbers(expected);
            let listed = SVector::from_fn(|i, _| expected[i]);
            assert!(apart(q, &listed) < 2e-6, "{found}");
            assert_eq!(f64::from(u8::from(*is_singular)), expected[6], "{found}");
        }
    }
}
