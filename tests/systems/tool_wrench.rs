//! Forces at the tool: what the surroundings do to an arm in a simulation.

use robot_dynamics::nalgebra::{Matrix4, SVector, Vector2, Vector3, Vector6};
use robot_dynamics::{
    Friction, Method, Simulation, robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, Radau5},
};

robot_dynamics! {
    /// Two links in a vertical plane, with a tool.
    struct Arm;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { mass: 2, com: [0.3, 0, 0], inertia: { zz: 0.1 } },
        elbow: revolute { a: 0.6, mass: 1, com: [0.2, 0, 0], inertia: { zz: 0.05 } },
    ],
    tool: { xyz: [0.5, 0, 0] },
    functions: [default, forward_kinematics, jacobian],
}

robot_dynamics! {
    /// A cart of 2 kg on a rail along z, with dry friction.
    struct Cart;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [rail: prismatic { mass: 2, friction: { coulomb: 5 } }],
    functions: [default, forward_kinematics, jacobian],
}

const START: Vector2<f64> = Vector2::new(0.3, 0.4);

/// A damped spring from the tool to a point, and a moment.
fn spring(pose: &Matrix4<f64>, twist: &Vector6<f64>) -> Vector6<f64> {
    let tip = Vector3::new(pose[(0, 3)], pose[(1, 3)], pose[(2, 3)]);
    let force = (Vector3::new(0.7, 0.5, 0.1) - tip) * 90.0 - twist.fixed_rows::<3>(0) * 3.0;
    Vector6::new(force[0], force[1], force[2], 0.2, -0.1, 0.4)
}

fn motor(t: f64, qd: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(9.0 + t, 3.0) - qd * 0.5
}

fn methods() -> Vec<Method> {
    let step = 2e-3;
    vec![
        Method::ExplicitEuler { step },
        Method::CraigEuler { step },
        Method::SemiImplicitEuler { step },
        Method::RungeKutta4 { step },
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step },
        DormandPrince::with_tolerance(1e-9).into(),
        Dop853::with_tolerance(1e-9).into(),
        Radau5::with_tolerance(1e-9).into(),
    ]
}

/// M qdd + V + G + F = tau + J' w: the motion is that of a torque law that adds J' w itself, by every
/// method. The same numbers are added, so that not one digit differs.
#[test]
fn the_force_is_handed_to_the_joints_by_the_jacobian() {
    for method in methods() {
        let simulation = || {
            let simulation = Simulation::new(&Arm).method(method);
            simulation
                .initial(START, Vector2::zeros())
                .duration(0.5)
                .samples(11)
        };
        let by_force = simulation()
            .tool_wrench(|_, pose, twist| spring(pose, twist))
            .torque(|t, _, qd| motor(t, qd))
            .run()
            .unwrap();
        let by_torque = simulation()
            .torque(|t, q, qd| {
                let jacobian = Arm.jacobian(q);
                let wrench = spring(&Arm.forward_kinematics(q), &(jacobian * qd));
                motor(t, qd) + jacobian.tr_mul(&wrench)
            })
            .run()
            .unwrap();
        assert_eq!(by_force.q, by_torque.q, "{method:?}");
        assert_eq!(by_force.qd, by_torque.qd, "{method:?}");
        let free = simulation().torque(|t, _, qd| motor(t, qd)).run().unwrap();
        assert!((free.q[10] - by_force.q[10]).amax() > 0.01, "{method:?}");
    }
}

/// The energy of the arm and of an elastic spring at its tool is what it was.
#[test]
fn a_spring_at_the_tool_keeps_the_energy() {
    let anchor = Vector3::new(0.2, -0.4, 0.0);
    let stretch =
        |pose: &Matrix4<f64>| anchor - Vector3::new(pose[(0, 3)], pose[(1, 3)], pose[(2, 3)]);
    let motion = Simulation::new(&Arm)
        .method(Dop853::with_tolerance(1e-12))
        .initial(START, Vector2::new(1.0, -2.0))
        .tool_wrench(|_, pose, _| {
            let f = stretch(pose) * 60.0;
            Vector6::new(f[0], f[1], f[2], 0.0, 0.0, 0.0)
        })
        .duration(3.0)
        .run()
        .unwrap();
    let energy = |i: usize| {
        let (q, qd) = (&motion.q[i], &motion.qd[i]);
        let spring = 30.0 * stretch(&Arm.forward_kinematics(q)).norm_squared();
        Arm.kinetic_energy(q, qd) + Arm.potential_energy(q) + spring
    };
    let errors = (0..motion.q.len()).map(|i| (energy(i) - energy(0)).abs());
    let worst = errors.fold(0.0, f64::max);
    // Some 1e-12 for each of a few hundred steps.
    assert!(worst < 1e-8, "{worst:e}");
}

/// Dry friction holds the cart against 4 N and not against 6 N, of which 1 N moves it.
#[test]
fn a_joint_that_sticks_feels_the_force() {
    let pushed = |force: f64| {
        let motion = Simulation::new(&Cart)
            .friction(Friction::Sticking)
            .tool_wrench(move |_, _, _| Vector6::new(1.0, 1.0, force, 1.0, 1.0, 1.0))
            .duration(1.0)
            .samples(2)
            .run()
            .unwrap();
        motion.q[1][0]
    };
    assert_eq!(pushed(4.0), 0.0);
    assert_eq!(pushed(-4.9), 0.0);
    assert!((pushed(6.0) - 0.25).abs() < 1e-9);
}

/// The run ends where the force is no number, with the samples up to there.
#[test]
fn a_force_that_is_not_finite_is_named() {
    for method in methods() {
        let error = Simulation::new(&Arm)
            .method(method)
            .tool_wrench(|t, _, _| {
                let moment = if t > 0.45 { f64::NAN } else { 0.0 };
                Vector6::new(0.0, 0.0, 0.0, moment, 0.0, moment)
            })
            .samples(11)
            .run()
            .unwrap_err();
        let Cause::NonFiniteToolWrench { component: 3 } = error.cause else {
            panic!("{method:?}: {error}");
        };
        assert!(
            error
                .to_string()
                .contains("nx of the force at the tool or at a frame is not finite")
        );
        assert_eq!(error.trajectory.t.len(), 5, "{method:?}");
        assert!(error.time <= 0.46);
    }
}

/// The motion goes on from where a run ended, at another time of the law.
#[test]
fn a_motion_in_two_runs_is_that_in_one() {
    let law = |start: f64| {
        move |t: f64, _: &Matrix4<f64>, _: &Vector6<f64>| {
            Vector6::new(0.0, 20.0 * (3.0 * (start + t)).sin(), 0.0, 0.0, 0.0, 0.0)
        }
    };
    let run = |start: f64, q: SVector<f64, 2>, qd: SVector<f64, 2>, duration: f64| {
        let simulation = Simulation::new(&Arm).method(Dop853::with_tolerance(1e-12));
        let simulation = simulation.tool_wrench(law(start)).initial(q, qd);
        let motion = simulation.duration(duration).samples(2).run().unwrap();
        (motion.q[1], motion.qd[1])
    };
    let (q, qd) = run(0.0, START, Vector2::zeros(), 0.4);
    let (q, _) = run(0.4, q, qd, 0.6);
    let (whole, _) = run(0.0, START, Vector2::zeros(), 1.0);
    assert!((q - whole).amax() < 1e-9, "{}", (q - whole).amax());
}
