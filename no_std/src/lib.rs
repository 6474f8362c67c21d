//! Generated functions and the runtime's core where there is no standard library and no allocator:
//! `cargo test` compares them with the numeric Newton-Euler algorithm, `cargo build` compiles them as a
//! controller would, and `cargo build --target thumbv7em-none-eabihf` for one.
#![no_std]

use core::hint::black_box;

use robot_dynamics::nalgebra::{Matrix3, Vector3, Vector6};
use robot_dynamics::{
    Cycloidal, Model, NewtonEuler, SharedSines, SingularMassMatrix, robot_dynamics,
};

#[macro_use]
#[path = "../../testkit/robots/src/functions.rs"]
mod functions;

/// The arm with the functions of a list.
macro_rules! arm_with {
    ({} $($name:ident $arguments:tt)*) => {
        robot_dynamics! {
            /// An elbow arm with motors and friction on a slope, and a payload.
            pub struct Arm { payload: f64 }

            convention: standard,
            gravity: [0, 0, -9.81],
            base: { xyz: [0, 0, 0.8], rpy: [0, 0.1, 0] },
            joints: [
                waist: revolute {
                    d: 0.5, alpha: PI/2, mass: 9, com: [0, -0.1, 0], inertia: cylinder(0.1, 0.5),
                    motor: { inertia: 1e-4, gear_ratio: 50 }, friction: { viscous: 0.3, coulomb: 1.5 },
                },
                shoulder: revolute { a: 0.4, mass: 5, com: [-0.2, 0, 0.02], inertia: rod(0.4) },
                elbow: revolute { a: 0.3, mass: 2, com: [-0.1, 0, 0], inertia: rod(0.3) },
            ],
            tool: { xyz: [0.1, 0, 0.05], mass: payload, inertia: sphere(0.03) },
            functions: [$($name,)* control_terms = (mass_matrix, coriolis_vector, gravity_vector)],
        }
    };
}

each_function! { arm_with {} }

/// A control law, in single precision as on a controller that has no other: torques that move the arm
/// from `start` to `end` in `duration` seconds, at time `t`.
pub fn feed_forward(start: [f64; 3], end: [f64; 3], duration: f64, t: f64) -> Option<Vector3<f32>> {
    let motion = Cycloidal::new(start.into(), end.into(), duration).ok()?;
    let state = motion.at(t);
    let [q, qd, qdd] = [state.q, state.qd, state.qdd].map(|x| x.cast::<f32>());
    Some(Arm { payload: 0.5 }.inverse_dynamics(&q, &qd, &qdd))
}

/// Computed torque on such a controller, all terms by one call: tau = M qdd + V + G.
pub fn computed_torque(q: &Vector3<f32>, qd: &Vector3<f32>, qdd: &Vector3<f32>) -> Vector3<f32> {
    let (m, v, g) = Arm { payload: 0.5 }.control_terms(q, qd);
    m * qdd + v + g
}

/// Everything at one q, the sines evaluated once.
///
/// # Errors
///
/// Where M is singular.
pub fn at(q: &Vector3<f64>) -> Result<(Matrix3<f64>, Vector3<f64>), SingularMassMatrix> {
    let arm = Arm { payload: 0.5 };
    let configuration = SharedSines::new(&arm, q);
    let gravity = configuration.gravity_vector();
    let qdd = configuration.forward_dynamics(&Vector3::zeros(), &gravity)?;
    Ok((configuration.mass_matrix(), qdd))
}

/// The numeric algorithms on the same table.
pub fn numeric(q: &Vector3<f64>, qd: &Vector3<f64>, qdd: &Vector3<f64>) -> Vector3<f64> {
    NewtonEuler::new(&Model::table(&Arm { payload: 0.5 })).inverse_dynamics(q, qd, qdd)
}

/// The arguments of all functions, by their names.
#[derive(Clone, Copy)]
pub struct Arguments<'a> {
    /// Positions.
    pub q: &'a Vector3<f64>,
    /// Velocities.
    pub qd: &'a Vector3<f64>,
    /// Accelerations.
    pub qdd: &'a Vector3<f64>,
    /// Torques.
    pub tau: &'a Vector3<f64>,
    /// Velocities of a reference motion.
    pub qd_r: &'a Vector3<f64>,
    /// Accelerations of a reference motion.
    pub qdd_r: &'a Vector3<f64>,
    /// Rates of the accelerations.
    pub jerk: &'a Vector3<f64>,
    /// Rates of the jerk.
    pub snap: &'a Vector3<f64>,
    /// Force and moment at the tip.
    pub wrench: &'a Vector6<f64>,
    /// The order of the Taylor series.
    pub order: usize,
}

/// Calls the functions of a list.
macro_rules! calls {
    ({ $arm:ident, $at:ident } $($name:ident [$($argument:ident),*])*) => {
        $(let _ = black_box($arm.$name::<f64>($($at.$argument),*));)*
    };
}

/// Every function, called so that it is compiled.
pub fn everything(at: Arguments) {
    let arm = black_box(Arm { payload: 0.5 });
    each_function! { calls { arm, at } }
}

#[cfg(not(test))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;

    const Q: Vector3<f64> = Vector3::new(0.3, -1.2, 2.0);
    const QD: Vector3<f64> = Vector3::new(1.0, 0.5, -2.0);
    const QDD: Vector3<f64> = Vector3::new(-3.0, 0.2, 4.0);

    #[test]
    fn generated_and_numeric_dynamics_agree() {
        let tau: Vector3<f64> = Arm { payload: 0.5 }.inverse_dynamics(&Q, &QD, &QDD);
        assert!((tau - numeric(&Q, &QD, &QDD)).amax() < 1e-12 * tau.amax());
    }

    #[test]
    fn terms_of_one_call_are_the_torque_but_for_friction() {
        let [q, qd, qdd] = [Q, QD, QDD].map(|x| x.cast::<f32>());
        let arm = Arm { payload: 0.5 };
        let tau = arm.inverse_dynamics(&q, &qd, &qdd) - arm.friction_vector(&qd);
        assert!((computed_torque(&q, &qd, &qdd) - tau).amax() < 1e-5 * tau.amax());
    }

    #[test]
    fn a_motion_ends_where_gravity_is_held() {
        let end = [1.0, 2.0, 3.0];
        let torque = feed_forward([0.0; 3], end, 2.0, 2.0).expect("a duration");
        let gravity: Vector3<f64> = Arm { payload: 0.5 }.gravity_vector(&end.into());
        assert!((torque.cast::<f64>() - gravity).amax() < 1e-5 * gravity.amax());
    }

    #[test]
    fn an_arm_that_is_held_stays() {
        let (mass, qdd) = at(&Q).expect("a regular matrix");
        assert!(mass.determinant() > 0.0 && qdd.amax() < 1e-12);
    }

    #[test]
    fn every_function_can_be_evaluated() {
        everything(Arguments {
            q: &Q,
            qd: &QD,
            qdd: &QDD,
            tau: &QDD,
            qd_r: &QDD,
            qdd_r: &QD,
            jerk: &QD,
            snap: &QDD,
            wrench: &Vector6::new(5.0, -3.0, 8.0, 2.0, -1.0, 0.5),
            order: 10,
        });
    }
}
