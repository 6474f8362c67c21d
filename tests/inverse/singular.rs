//! Poses at which joints cannot be told apart, and arms that are stretched.

use robot_dynamics::closed_form::Solutions;
use robot_dynamics::nalgebra::SVector;

use crate::arms::*;
use crate::{Inverse, residual};

/// The solutions of the pose of these joints: each leads to the pose, and at least one is marked.
fn marked<const N: usize, A: Inverse<N>>(arm: &A, q: [f64; N]) -> Solutions<f64, N> {
    let q = SVector::from(q);
    let pose = arm.pose(&q);
    let solutions = arm.solutions(&pose, 0.3);
    assert!(!solutions.is_empty(), "{} {q}", A::NAME);
    for solution in &solutions {
        let miss = residual(arm, &pose, &solution.q);
        assert!(miss < 2e-14, "{} {miss:e} {}", A::NAME, solution.q);
    }
    let is_marked = solutions.iter().any(|solution| solution.is_singular);
    assert!(is_marked, "{} {q}", A::NAME);
    solutions
}

/// Axes 4 and 6 in one line: one of the two joints stands at zero.
#[test]
fn wrists_in_line() {
    for q5 in [0.0, 1e-9, -1e-9] {
        let six = [0.4, -0.9, 0.7, 0.5, q5, -0.3];
        for solution in marked(&Puma560, six).iter().filter(|one| one.is_singular) {
            let together = solution.q[3] + solution.q[5];
            assert!((together.sin() - 0.2_f64.sin()).abs() < 1e-6, "{together}");
        }
        marked(&Stanford, six);
        marked(&Ur5, six);
        marked(&ThreeRolls, six);
        marked(&GantryWithWrist, six);
    }
    marked(&Shoulder, [0.4, 0.0, 0.7, 0.5, 0.3, -0.3]);
}

/// A stretched elbow: the two solutions are one.
#[test]
fn stretched_elbows() {
    let stretched = |q: f64| [0.4, -0.9, q, 0.5, 1.1, -0.3];
    // The angle between the two links of the PUMA's arm vanishes where the wrist is farthest.
    let puma = -(0.4318_f64.atan2(0.0203));
    marked(&Puma560, stretched(puma));
    marked(&Ur5, stretched(0.0));
    marked(&Elbow3r, [0.4, -0.9, 0.0]);
    marked(&RrrPlanar, [0.4, 0.0, 0.7]);
    marked(&TwoLink, [0.4, 0.0]);
    marked(&Scara, [0.4, 0.0, 0.7, 0.5]);
    // Folded.
    marked(&TwoLink, [0.4, core::f64::consts::PI]);
    let seven = [0.4, -0.9, 0.7, 0.0, 1.1, -0.3, 0.2];
    marked(&Iiwa14, seven);
}

/// The wrist over the shoulder: the first joint stands at zero.
#[test]
fn wrists_over_the_shoulder() {
    let solutions = marked(&Elbow3r, [0.7, core::f64::consts::FRAC_PI_2, 0.0]);
    assert!(solutions.iter().any(|solution| solution.q[0] == 0.0));
    // Axis 1 and the line from the shoulder to the wrist are one.
    marked(&Iiwa14, [0.4, 0.0, 0.7, 0.0, 1.1, -0.3, 0.2]);
}

/// The wrist in the shoulder: joints 1 to 3 may stand as they like. Next to it the line between both has few digits.
#[test]
fn wrists_in_the_shoulder() {
    for missing in [0.0, 1e-15, 1e-12, 1e-9, -1e-9] {
        let folded = core::f64::consts::PI - missing;
        marked(&EqualHalves, [0.4, -0.9, 0.7, folded, 1.1, -0.3, 0.2]);
    }
}

/// All joints at zero, where most arms are singular.
#[test]
fn arms_at_zero() {
    macro_rules! all {
        ($($name:ident: $n:literal, $reads_rotation:literal;)*) => {
            $({
                let arm = $name;
                let pose = Inverse::<$n>::pose(&arm, &SVector::from([0.0; $n]));
                let solutions = arm.solutions(&pose, 0.0);
                assert!(!solutions.is_empty(), "{}", stringify!($name));
                for solution in &solutions {
                    let miss = residual(&arm, &pose, &solution.q);
                    assert!(miss < 2e-14, "{} {miss:e}", stringify!($name));
                }
            })*
        };
    }
    for_each_arm!(all);
}
