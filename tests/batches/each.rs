//! A robot for each state in the batches that belong to a robot: frames, several functions as one, bases that move.

use robot_dynamics::nalgebra::{Matrix2, Rotation3, SMatrix, SVector, Vector2, Vector3};
use robot_dynamics::{Batch, Pose, robot_dynamics};

use super::states::States;

robot_dynamics! {
    /// Two rods, a lamp on each.
    struct Mast { mass: f64, length: f64, g: f64 }

    convention: modified,
    gravity: [0, -g, 0],
    joints: [
        foot: revolute { mass: 2, com: [length / 2, 0, 0], inertia: rod(length) },
        knee: revolute { a: length, mass: mass, com: [0.2, 0, 0.1] },
    ],
    frames: {
        low: { on: foot, xyz: [length / 3, 0, 0.1] },
        high: { on: knee, xyz: [0.4, 0.1, 0] },
    },
    functions: [gravity_vector, jacobian(low), jacobian(high), together = (mass_matrix, forward_dynamics)],
}

robot_dynamics! {
    /// A body that swings a weight.
    pub struct Glider { mass: f64, arm: f64, g: f64 }

    convention: modified,
    gravity: [0, 0, -g],
    base: floating { mass: 3, com: [0.1, 0, arm], inertia: cuboid(0.3, 0.2, 0.4) },
    joints: [
        swing: revolute { a: arm, alpha: 0.4, mass: mass, com: [0.2, 0, 0.1], inertia: cuboid(0.1, 0.2, 0.1) },
        reach: prismatic { a: 0.1, alpha: PI/2, mass: 1, com: [0, 0, 0.2] },
    ],
    functions: [inverse_dynamics, forward_dynamics, gravity_vector],
}

const STATES: usize = 19;

fn differ(i: usize) -> f64 {
    1.0 + i as f64 / 7.0
}

fn masts() -> Vec<Mast> {
    let mast = |x: f64| Mast {
        mass: x,
        length: 0.5 + x / 4.0,
        g: 9.81 - x,
    };
    (0..STATES).map(|i| mast(differ(i))).collect()
}

fn assert_near<const R: usize, const C: usize>(
    found: &SMatrix<f64, R, C>,
    expected: &SMatrix<f64, R, C>,
) {
    let largest = expected.amax().max(1.0);
    assert!(
        (found - expected).amax() <= 1e-13 * largest,
        "{found} {expected}"
    );
}

#[test]
fn functions_at_frames_and_several_as_one() {
    let arms = masts();
    let States { q, qd, tau, .. } = States::<f64, 2>::random(STATES, 6);
    let many = Batch::with_parameters(&arms);
    let mut low = vec![SMatrix::<f64, 6, 2>::zeros(); STATES];
    let mut high = low.clone();
    many.jacobian_low_batch(&q, &mut low).unwrap();
    many.par_jacobian_high_batch(&q, &mut high).unwrap();
    let mut together = vec![(Matrix2::zeros(), Vector2::zeros()); STATES];
    many.together_batch(&q, &qd, &tau, &mut together).unwrap();
    // Functions of the runtime's trait are there too.
    let mut gravity = vec![Vector2::zeros(); STATES];
    many.gravity_vector_batch(&q, &mut gravity).unwrap();
    for (i, arm) in arms.iter().enumerate() {
        assert_near(&low[i], &arm.jacobian_low(&q[i]));
        assert_near(&high[i], &arm.jacobian_high(&q[i]));
        assert_near(&gravity[i], &arm.gravity_vector(&q[i]));
        let (mass, qdd) = arm.together(&q[i], &qd[i], &tau[i]).unwrap();
        assert_near(&together[i].0, &mass);
        assert_near(&together[i].1, &qdd);
    }
    let error = many.jacobian_low_batch(&q[1..], &mut low[1..]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "`parameters` has 19 states where `q` has 18"
    );
}

#[test]
fn bases_that_move() {
    let glider = |x: f64| Glider {
        mass: x,
        arm: x / 5.0,
        g: 9.81 - x,
    };
    let robots: Vec<Glider> = (0..STATES).map(|i| glider(differ(i))).collect();
    let poses: Vec<_> = (0..STATES)
        .map(|i| Pose {
            rotation: *Rotation3::from_euler_angles(differ(i), -0.3, 2.0 - differ(i)).matrix(),
            position: Vector3::new(0.1, differ(i), -2.0),
        })
        .collect();
    let States { q, .. } = States::<f64, 2>::random(STATES, 7);
    let States { qd: v, qdd: a, .. } = States::<f64, 8>::random(STATES, 8);
    let many = Glider::with_parameters(&robots);
    let mut tau = vec![SVector::<f64, 8>::zeros(); STATES];
    let (mut again, mut gravity) = (tau.clone(), tau.clone());
    many.inverse_dynamics_batch(&poses, &q, &v, &a, &mut tau)
        .unwrap();
    many.par_forward_dynamics_batch(&poses, &q, &v, &tau, &mut again)
        .unwrap();
    many.gravity_vector_batch(&poses, &q, &mut gravity).unwrap();
    for (i, robot) in robots.iter().enumerate() {
        assert_near(
            &tau[i],
            &robot.inverse_dynamics(&poses[i], &q[i], &v[i], &a[i]),
        );
        assert_near(&gravity[i], &robot.gravity_vector(&poses[i], &q[i]));
        assert!((again[i] - a[i]).amax() < 1e-11 * a[i].amax(), "{i}");
    }
}
