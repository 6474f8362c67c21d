//! Several functions at one configuration: the values are those of the methods, bit for bit.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{Model, Scalar, SharedSines, robot_dynamics};

robot_dynamics! {
    /// A turning column, a slide, a tilted wrist and a tip: every kind of joint and of angle.
    struct Arm { tilt: f64 }

    convention: modified,
    gravity: [0, 0.3, -9.81],
    joints: [
        column: revolute { mass: 4, com: [0.1, 0.02, 0.2], inertia: { zz: 0.3 } },
        slide: prismatic { alpha: deg(90), mass: 2, com: [0, 0.1, 0.05] },
        wrist: revolute {
            a: 0.3, alpha: tilt, mass: 1, com: [0.05, 0.1, 0.02], inertia: { xx: 0.1, yy: 0.15, zz: 0.2 },
            friction: { viscous: 0.3, coulomb: 0.2 },
        },
        tip: revolute { a: 0.2, alpha: 0.4, mass: 0.5, com: [0.1, 0.03, 0.02] },
    ],
}

fn state<T: Scalar>(phase: f64) -> SVector<T, 4> {
    SVector::from_fn(|i, _| T::from_f64((phase + 1.7 * i as f64).sin() * 2.5))
}

fn agrees<T: Scalar>() {
    let arm = Arm { tilt: 0.7 };
    for k in 0..50 {
        let phase = f64::from(k);
        let [q, qd, qdd] = [phase, phase + 0.4, phase + 0.8].map(state::<T>);
        let here = SharedSines::new(&arm, &q);
        assert_eq!(here.mass_matrix(), arm.mass_matrix(&q));
        assert_eq!(here.gravity_vector(), arm.gravity_vector(&q));
        assert_eq!(here.coriolis_vector(&qd), arm.coriolis_vector(&q, &qd));
        assert_eq!(
            here.inverse_dynamics(&qd, &qdd),
            arm.inverse_dynamics(&q, &qd, &qdd)
        );
        assert_eq!(
            here.forward_dynamics(&qd, &qdd),
            arm.forward_dynamics(&q, &qd, &qdd)
        );
    }
}

#[test]
fn values_are_those_of_the_methods() {
    agrees::<f64>();
    agrees::<f32>();
}

/// The slide has no angle. The column's own matters, for gravity is not along its axis.
#[test]
fn only_angles_that_are_read_are_evaluated() {
    assert_eq!(<Arm as Model<4>>::READS_ANGLE, [true, false, true, true]);
    let arm = Arm { tilt: 0.7 };
    let mut q = state::<f64>(0.2);
    q[1] = f64::MAX;
    let here = SharedSines::new(&arm, &q);
    assert_eq!(here.gravity_vector(), arm.gravity_vector(&q));
}

mod upright {
    use super::*;

    robot_dynamics! {
        struct Upright;
        convention: modified,
        gravity: [0, 0, -9.81],
        joints: [
            column: revolute { mass: 4, com: [0.1, 0.02, 0.2], inertia: { zz: 0.3 } },
            tip: revolute { alpha: deg(90), a: 0.2, mass: 0.5, com: [0.1, 0.03, 0.02] },
        ],
        functions: [mass_matrix, gravity_vector, forward_kinematics],
    }

    /// The pose of the last frame reads the column's angle, but the pose is not shared.
    #[test]
    fn the_column_s_angle_is_not_evaluated() {
        assert_eq!(<Upright as Model<2>>::READS_ANGLE, [false, true]);
    }
}

/// `ForwardDynamics` of an arm whose only forward dynamics is by articulated bodies.
mod by_articulated_bodies {
    use robot_dynamics::nalgebra::Vector2;
    use robot_dynamics::{Batch, ForwardDynamics, SharedSines, robot_dynamics};

    robot_dynamics! {
        struct Arm { m: f64 }
        convention: modified,
        gravity: [0, -9.81, 0],
        joints: [
            a: revolute { mass: 1, com: [0.5, 0, 0], inertia: rod(1) },
            b: revolute { a: 1, mass: m, com: [0.3, 0, 0], inertia: rod(1) },
        ],
        functions: [forward_dynamics_aba, mass_matrix],
    }

    #[test]
    fn sines_and_fields_of_each_arm_are_read() {
        let (light, heavy) = (Arm { m: 0.7 }, Arm { m: 1.7 });
        let [q, qd, tau] = [[0.3, 0.4], [0.5, -0.6], [1.0, 2.0]].map(Vector2::<f64>::from);
        let of_arm = |arm: Arm| {
            arm.forward_dynamics_aba(&q, &qd, &tau)
                .expect("M is regular")
        };
        let by_trait = ForwardDynamics::forward_dynamics(&light, &q, &qd, &tau);
        assert_eq!(by_trait, Ok(of_arm(light)));
        let here = SharedSines::new(&light, &q);
        assert_eq!(here.forward_dynamics(&qd, &tau), Ok(of_arm(light)));
        let arms: [Arm; 20] = std::array::from_fn(|i| if i % 2 == 0 { light } else { heavy });
        let mut found = [Vector2::zeros(); 20];
        Batch::with_parameters(&arms)
            .forward_dynamics_batch(&[q; 20], &[qd; 20], &[tau; 20], &mut found)
            .expect("as many accelerations");
        for (arm, qdd) in arms.into_iter().zip(found) {
            let expected = of_arm(arm);
            assert!((qdd - expected).norm() < 1e-13 * expected.norm(), "{qdd}");
        }
    }
}
