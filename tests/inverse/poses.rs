//! Matrices that are taken as poses, and the reasons for those that are none or out of reach.

use robot_dynamics::closed_form::{NoSolution, Solutions};
use robot_dynamics::nalgebra::{Matrix3, Matrix4, SVector};

use crate::arms::*;
use crate::{Inverse, Random, residual};

/// The pose with the nearest rotation.
fn nearest(pose: &Matrix4<f64>) -> Matrix4<f64> {
    let rotation: Matrix3<f64> = pose.fixed_view::<3, 3>(0, 0).into_owned();
    let parts = rotation.svd(true, true);
    let mut nearest = *pose;
    let rotation = parts.u.unwrap() * parts.v_t.unwrap();
    nearest.fixed_view_mut::<3, 3>(0, 0).copy_from(&rotation);
    nearest
}

/// Poses with few decimals, as pendants and papers print them, are solved, and what is reached has the nearest rotation.
#[test]
fn rounded_poses_are_solved() {
    fn check<const N: usize, A: Inverse<N>>(arm: &A, q: [f64; N]) {
        let mut random = Random(23);
        for decimals in 4..10 {
            for _ in 0..100 {
                let q = SVector::from(q).map(|q| q + 0.2 * random.next());
                let by = 10.0_f64.powi(decimals);
                let pose = arm.pose(&q).map(|x| (x * by).round() / by);
                let solutions = arm.solutions(&pose, arm.elbow(&q));
                assert_eq!(solutions.reason(), None, "{} {decimals}", A::NAME);
                for solution in &solutions {
                    let miss = residual(arm, &nearest(&pose), &solution.q);
                    assert!(miss < 1e-13, "{} {miss:e}", A::NAME);
                }
                let single = arm.solutions(&pose.map(|x| x as f32), arm.elbow(&q) as f32);
                assert_eq!(single.reason(), None, "{} {decimals}", A::NAME);
            }
        }
    }
    let six = [0.4, -0.9, 0.7, 0.5, 1.1, -0.3];
    check(&Ur3e, [0.4, -0.9, 0.8, 0.5, 1.1, -0.3]);
    check(&Kr6, six);
    check(&Puma560, six);
    check(&Iiwa14, [0.4, -0.9, 0.7, 0.8, 1.1, -0.6, 0.2]);
    check(&Scara, [0.4, -0.9, 0.7, 0.5]);
}

/// A rotation is one to 1e-3 of its columns' products.
#[test]
fn rotations_that_miss_by_a_thousandth_are_taken() {
    let pose = Puma560.pose(&SVector::from([0.4, -0.9, 0.7, 0.5, 1.1, -0.3]));
    for (by, is_taken) in [(0.998e-3, true), (-0.998e-3, true), (1.01e-3, false)] {
        let mut scaled = pose;
        scaled
            .fixed_view_mut::<3, 3>(0, 0)
            .scale_mut((1.0_f64 + by).sqrt());
        let solutions = Puma560.inverse_kinematics(&scaled);
        assert_eq!(solutions.is_empty(), !is_taken, "{by}");
        for solution in &solutions {
            assert!(residual(&Puma560, &pose, &solution.q) < 1e-13);
        }
        // One column, and two that are not at right angles.
        let mut sheared = pose;
        let second = pose.column(1) * by;
        let mut first = sheared.column_mut(0);
        first += second;
        assert_eq!(
            Puma560.inverse_kinematics(&sheared).is_empty(),
            !is_taken,
            "{by}"
        );
    }
}

/// Why there is no solution, in both precisions.
#[test]
fn the_reason_is_told() {
    use NoSolution::{NotAPose, OutOfReach};
    let pose = Puma560.pose(&SVector::from([0.4, -0.9, 0.7, 0.5, 1.1, -0.3]));
    let reason = |change: &dyn Fn(&mut Matrix4<f64>)| {
        let mut pose = pose;
        change(&mut pose);
        let double = Puma560.inverse_kinematics(&pose);
        let single = Puma560.inverse_kinematics(&pose.map(|x| x as f32));
        assert_eq!(double.reason(), single.reason());
        assert_eq!(double.is_empty(), double.reason().is_some());
        double.reason()
    };
    assert_eq!(reason(&|_| ()), None);
    assert_eq!(reason(&|pose| pose[(0, 3)] += 3.0), Some(OutOfReach));
    assert_eq!(reason(&|pose| pose[(0, 3)] = f64::NAN), Some(NotAPose));
    assert_eq!(reason(&|pose| pose[(0, 0)] = f64::INFINITY), Some(NotAPose));
    assert_eq!(reason(&|pose| pose[(2, 2)] += 0.01), Some(NotAPose));
    assert_eq!(reason(&|pose| pose.transpose_mut()), Some(NotAPose));
    assert_eq!(reason(&|pose| pose.column_mut(2).neg_mut()), Some(NotAPose));
    // Where the position alone is read, and where an angle of the elbow is.
    let mut place = TwoLink.pose(&SVector::from([0.4, 0.3]));
    place[(0, 0)] = 7.0;
    assert_eq!(TwoLink.inverse_kinematics(&place).reason(), None);
    place[(0, 3)] = 7.0;
    assert_eq!(
        TwoLink.inverse_kinematics(&place).reason(),
        Some(OutOfReach)
    );
    place[(0, 3)] = f64::NAN;
    assert_eq!(TwoLink.inverse_kinematics(&place).reason(), Some(NotAPose));
    let seven = Iiwa14.pose(&SVector::from([0.4; 7]));
    let nowhere = Iiwa14.inverse_kinematics(&seven, f64::NAN);
    assert_eq!(nowhere.reason(), Some(NotAPose));
    // None of any pose, and none that limits allow.
    assert_eq!(Solutions::<f64, 6>::default().reason(), None);
    let none = Puma560
        .inverse_kinematics(&pose)
        .within(&[Some([9.0, 9.1]); 6]);
    assert!(none.is_empty() && none.reason().is_none());
}
