//! Random poses and poses of round angles: the joints from which a pose was made are among its solutions, or one of these is
//! marked as one of many.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use robot_dynamics::closed_form::Real;
use robot_dynamics::nalgebra::SVector;

use crate::arms::*;
use crate::{Inverse, Random, apart, residual};

/// Angles at which arms stand in drawings and programs: axes in line, links stretched or folded. First those of joints 1, 5
/// and 6, then those of joints 2 to 4.
const OF_ARMS: [[&[f64]; 2]; 2] = [
    [
        &[0.0, FRAC_PI_2, PI, -FRAC_PI_2],
        &[0.0, FRAC_PI_4, -FRAC_PI_2],
    ],
    [&[0.0, FRAC_PI_2, PI], &[0.0, FRAC_PI_2, PI, -FRAC_PI_2]],
];

/// 1,728 positions of such angles. A seventh joint stands at a quarter turn.
fn round<const N: usize>([outer, inner]: [&[f64]; 2]) -> impl Iterator<Item = SVector<f64, N>> {
    (0..1728).map(move |k| {
        let mut rest = k;
        SVector::from_fn(|i, _| {
            let angles = match i {
                0 | 4 | 5 => outer,
                1..=3 => inner,
                _ => &[FRAC_PI_2],
            };
            let angle = angles[rest % angles.len()];
            rest /= angles.len();
            angle
        })
    })
}

/// The length of an arm through all joints, from its base to its tip.
fn reach<const N: usize, A: Inverse<N>>(arm: &A) -> f64 {
    let links = arm.links(&SVector::zeros());
    let origins = links.map(|link| link.fixed_view::<3, 1>(0, 3).into_owned());
    let steps = (1..N).map(|i| (origins[i] - origins[i - 1]).norm());
    origins[0].norm() + steps.sum::<f64>()
}

/// The solutions of the pose of each of some positions, as a precision has them: they miss it by this part of the arm's reach at
/// most, and the nearest is so near to the positions, unless one is marked.
pub(crate) fn check<T: Real, const N: usize, A: Inverse<N>>(
    arm: &A,
    all: impl Iterator<Item = SVector<f64, N>>,
    [most_miss, most_way]: [f64; 2],
) {
    for q in all {
        let pose = arm.pose(&q).map(T::from_f64);
        let solutions = arm.solutions(&pose, T::from_f64(arm.elbow(&q)));
        assert!(solutions.reason().is_none(), "{}: none at {q}", A::NAME);
        let (mut nearest, mut is_marked) = (f64::INFINITY, false);
        for solution in &solutions {
            let found: SVector<f64, N> = solution.q.map(Into::into);
            let miss = residual(arm, &pose.map(Into::into), &found) / reach(arm);
            assert!(miss <= most_miss, "{}: {miss:e} at {q} by {found}", A::NAME);
            nearest = nearest.min(apart(&found, &q));
            is_marked |= solution.is_singular;
        }
        assert!(
            is_marked || nearest <= most_way,
            "{}: {nearest:e} away from {q}",
            A::NAME
        );
    }
}

/// Random poses and round ones, in one precision.
fn check_poses<T: Real, const N: usize, A: Inverse<N>>(arm: &A, bounds: [f64; 2]) {
    let mut random = Random(31);
    let all = (0..2000).map(|_| random.joints());
    check::<T, N, A>(arm, all, bounds);
    for angles in OF_ARMS {
        check::<T, N, A>(arm, round(angles), bounds);
    }
}

fn check_all<const N: usize, A: Inverse<N>>(arm: &A) {
    check_poses::<f64, N, A>(arm, [1e-13, 1e-7]);
    check_poses::<f32, N, A>(arm, [4e-6, 1e-2]);
}

#[test]
fn random_and_round_poses_are_solved() {
    check_all(&Ur3e);
    check_all(&Ur5e);
    check_all(&Ur10e);
    check_all(&Puma560);
    check_all(&Iiwa14);
    check_all(&Kr6);
}

/// The same of arms whose shoulders, wrists and halves are of other kinds.
#[test]
fn random_and_round_poses_of_other_kinds_are_solved() {
    check_all(&NoStep);
    check_all(&Upright);
    check_all(&ThreeRolls);
    check_all(&Reversed);
    check_all(&Inclined);
    // In single precision its fourth joint has no digits below 1e-3 rad, and later ones see that.
    check_poses::<f64, 6, _>(&ParallelBase, [1e-13, 1e-7]);
    check_all(&Shoulder);
    check_all(&Stanford);
    check_all(&EqualHalves);
    check_all(&SevenJoints);
}
