//! Arms at the edge of their reach, stretched or folded: the branch in which they stand is not lost, and leads to the pose.

use core::f64::consts::{FRAC_PI_2, PI};

use robot_dynamics::nalgebra::{SVector, Vector2};

use crate::arms::*;
use crate::{Inverse, Random, apart, residual};

/// Distances from the edge, rad, from none to one that every digit sees.
const OFF: [f64; 12] = [
    0.0, 1e-16, 1e-15, -1e-14, 1e-12, -1e-10, 1e-9, 1e-8, 3e-8, -1e-7, 1e-6, 1e-4,
];

/// The pose of `at` with these joints has a solution that is as near to the joints as digits tell, and all solutions miss it
/// by rounding. `free` joints may stand anywhere; `most` is as near as is told apart, rad.
fn check<const N: usize, A: Inverse<N>>(
    arm: &A,
    (free, most): (&[usize], f64),
    at: impl Fn(&mut SVector<f64, N>, f64, f64),
) {
    let mut random = Random(17);
    for off in OFF {
        for k in 0..100 {
            let mut q = random.joints();
            at(&mut q, off, OFF[k % OFF.len()]);
            let pose = arm.pose(&q);
            let solutions = arm.solutions(&pose, arm.elbow(&q));
            let mut nearest = f64::INFINITY;
            for solution in &solutions {
                let miss = residual(arm, &pose, &solution.q);
                assert!(miss < 1e-13, "{}: {miss:e} at {off:e} {q}", A::NAME);
                let mut found = solution.q;
                for &i in free {
                    found[i] = q[i];
                }
                nearest = nearest.min(apart(&found, &q));
            }
            assert!(nearest < most, "{}: {nearest:e} at {off:e} {q}", A::NAME);
        }
    }
}

/// An angle of a wrist that is not in line.
fn bent(q: f64) -> f64 {
    q.signum() * (0.5 + 0.3 * q.abs())
}

#[test]
fn stretched_and_folded_elbows() {
    for edge in [0.0, PI] {
        // Nearly in line the wrist takes digits from the elbow, a root the half of those that are left.
        check(&Ur5e, (&[], 1e-3), |q, off, _| q[2] = edge + off);
        check(&Ur3e, (&[], 1e-3), |q, off, _| q[2] = edge + off);
        check(&Ur10e, (&[], 1e-5), |q, off, _| {
            (q[2], q[4]) = (edge + off, bent(q[4]));
        });
        check(&Iiwa14, (&[], 1e-6), |q, off, _| {
            // The elbow's angle is about nothing where it is stretched.
            q[3] = edge + off.abs().max(1e-4);
        });
        check(&TwoLink, (&[], 1e-6), |q, off, _| q[1] = edge + off);
        check(&Elbow3r, (&[], 1e-6), |q, off, _| q[2] = edge + off);
    }
    let puma = -(0.4318_f64.atan2(0.0203));
    for edge in [puma, puma + PI] {
        // Folded, the wrist is half a millimetre from the second axis.
        check(&Puma560, (&[], 1e-4), |q, off, _| {
            (q[2], q[4]) = (edge + off, bent(q[4]));
        });
    }
}

/// Links that fold onto each other: the tip is on the first axis, the wrist in the shoulder.
#[test]
fn folded_links_of_the_same_length() {
    check(&EqualLinks, (&[0, 1], 1e-6), |q, off, _| q[1] = PI + off);
    // The wrist of this one is in a plane through the shoulder.
    check(&Reversed, (&[0, 1, 2, 4], 1e-6), |q, off, _| {
        q[3] = -FRAC_PI_2 + off
    });
}

/// Two equations at once have one root: shoulder and elbow, elbow and wrist.
#[test]
fn two_edges_at_once() {
    // The wrist beside the first axis, as near as it comes, and the arm stretched.
    check(&Ur5e, (&[], 1e-6), |q, off, other| {
        (q[1], q[2]) = (FRAC_PI_2 + other, off);
        (q[3], q[4]) = (-q[1] - q[2], bent(q[4]));
    });
    // Rolls that incline the hand as far as they can.
    let stretched = (-0.7_f64).atan2(0.1);
    // One root has half of the digits, and the root of that a quarter.
    check(&ThreeRolls, (&[], 2e-3), |q, off, other| {
        (q[2], q[4]) = (stretched + other, PI + off);
    });
}

/// The tip over the waist, whose angle the direction of the roll alone tells.
#[test]
fn tips_over_the_waist() {
    let [d, a] = [0.0542, 0.0304];
    check(&So100, (&[], 1e-6), |q, off, _| {
        let mut plane = *q;
        plane[0] = 0.0;
        let pose = So100.forward_kinematics(&plane);
        // From the second axis in the plane of the arm, y down: turned until it is over the first axis.
        let way = Vector2::new(pose[(0, 3)] - a, d - pose[(2, 3)]);
        let over = (-a / way.norm()).max(-1.0).acos();
        q[1] += over - way.y.atan2(way.x) + off;
    });
}
