//! A robot with branches and frames, from its call to its numbers.

use robot_dynamics::nalgebra::{SMatrix, SVector, Vector6};
use robot_dynamics::simulation::TaylorSimulation;
use robot_dynamics::{Batch, DoubleDouble, Simulation, check_against_rnea, robot_dynamics};
use testkit::five::states;

robot_dynamics! {
    /// Two arms on a waist, and a lift beside them.
    struct Torso { load: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist:          revolute { mass: 9, com: [0, 0, 0.2], inertia: cylinder(0.15, 0.4) },
        left_shoulder:  revolute { on: waist, gamma: PI/2, b: 0.4, a: 0.2, alpha: PI/2, mass: 2 },
        left_elbow:     revolute { a: 0.3, mass: 1, com: [0.1, 0, 0], inertia: rod(0.2) },
        right_shoulder: revolute { on: waist, gamma: -PI/2, b: 0.4, a: 0.2, alpha: PI/2, mass: 2 },
        right_elbow:    revolute { a: 0.3, mass: 1, com: [0.1, 0, 0], inertia: rod(0.2) },
        lift:           prismatic { on: base, at: { xyz: [1, 0, 0], rpy: [0, 0, PI/2] }, mass: 3 },
    ],
    frames: {
        left_hand: { on: left_elbow, xyz: [0.3, 0, 0], mass: load, com: [0, 0, 0.05], inertia: sphere(0.04) },
        camera:    { on: waist, xyz: [0.1, 0, 0.5], rpy: [0, 0.3, 0] },
        door:      { on: base, xyz: [2, 0, 1] },
    },
    functions: [
        default, taylor_series, regressor, base_parameters, link_poses, link_jacobians, inverse_dynamics_derivatives,
        forward_dynamics_derivatives, jacobian(left_hand), jacobian(camera), jacobian(door), jacobian_rate(left_hand),
        wrench_torques(left_hand), tool_velocity(left_hand), tool_acceleration(left_hand),
        operational_inertia_inverse(left_hand), forward_kinematics(camera), forward_kinematics(left_hand),
        grasp = (mass_matrix, jacobian(left_hand), forward_kinematics(left_hand), forward_kinematics(camera)),
    ],
}

const TORSO: Torso = Torso { load: 0.7 };

#[test]
fn functions_of_a_tree_agree_with_newton_euler() {
    let report = check_against_rnea(&TORSO);
    report.assert_ok();
    assert!(report.not_compared.is_empty(), "{report}");
    let of = |name: &str| {
        let functions = report.functions.iter();
        functions
            .filter(|found| found.frame.as_deref() == Some(name))
            .count()
    };
    // Alone, and in the tuple.
    assert_eq!(
        (of("left_hand"), of("camera"), of("door")),
        (7 + 2, 2 + 1, 1)
    );
}

/// The joints of one arm are no part of what the other does: these numbers are constants of the program.
#[test]
fn branches_know_nothing_of_each_other() {
    for [q, qd, qdd] in states::<f64, 6>(24) {
        let mass_matrix = TORSO.mass_matrix(&q);
        for (row, column) in [(1, 3), (1, 4), (2, 3), (2, 4)] {
            assert_eq!(mass_matrix[(row, column)].to_bits(), 0.0_f64.to_bits());
        }
        assert!((0..5).all(|joint| mass_matrix[(joint, 5)] == 0.0));
        let [at_hand, at_camera] = [TORSO.jacobian_left_hand(&q), TORSO.jacobian_camera(&q)];
        assert_eq!(at_hand.columns(3, 3).amax(), 0.0);
        assert_eq!(at_camera.columns(1, 5).amax(), 0.0);
        assert_eq!(TORSO.jacobian_door(&q).amax(), 0.0);
        let wrench = Vector6::new(1.0, -2.0, 0.5, 0.3, -0.1, 0.7);
        let torques = TORSO.wrench_torques_left_hand(&q, &wrench);
        assert!((torques - at_hand.tr_mul(&wrench)).amax() < 1e-14);
        let (matrix, jacobian, hand, camera) = TORSO.grasp(&q);
        assert!((matrix - mass_matrix).amax() < 1e-13);
        assert!((jacobian - at_hand).amax() < 1e-14);
        assert!((hand - TORSO.forward_kinematics_left_hand(&q)).amax() < 1e-14);
        assert!((camera - TORSO.forward_kinematics_camera(&q)).amax() < 1e-14);
        let tau = TORSO.inverse_dynamics(&q, &qd, &qdd);
        let found = TORSO.forward_dynamics(&q, &qd, &tau).expect("M is regular");
        assert!((mass_matrix * (found - qdd)).amax() < 1e-15 * tau.amax());
    }
}

/// In 31 digits, in doubles and in single precision.
#[test]
fn functions_of_frames_have_the_digits_of_their_numbers() {
    fn largest<const R: usize, const C: usize>(
        found: SMatrix<f64, R, C>,
        exact: SMatrix<DoubleDouble, R, C>,
    ) -> f64 {
        let errors = found.zip_map(&exact, |found, exact| {
            (exact - DoubleDouble::from(found)).high()
        });
        errors.amax() / exact.map(DoubleDouble::high).amax()
    }
    for [q, qd, _] in states::<f64, 6>(24) {
        let exact = |x: &SVector<f64, 6>| x.map(DoubleDouble::from);
        let exact = [
            TORSO.jacobian_left_hand(&exact(&q)),
            TORSO.jacobian_rate_left_hand(&exact(&q), &exact(&qd)),
        ];
        assert!(largest(TORSO.jacobian_left_hand(&q), exact[0]) < 1e-15);
        assert!(largest(TORSO.jacobian_rate_left_hand(&q, &qd), exact[1]) < 1e-15);
        let single = |x: &SVector<f64, 6>| x.map(|x| x as f32);
        // The angles are rounded too.
        let [q, qd] = [single(&q), single(&qd)];
        let found = TORSO.jacobian_rate_left_hand(&q, &qd).map(f64::from);
        let double = |x: &SVector<f32, 6>| x.map(f64::from);
        let expected = TORSO.jacobian_rate_left_hand(&double(&q), &double(&qd));
        assert!((found - expected).amax() < 1e-6 * expected.amax());
    }
}

/// Batches of functions of frames and of the whole tree are their single calls.
#[test]
fn batches_of_a_tree_are_its_calls() {
    let states = states::<f64, 6>(19);
    let q: Vec<SVector<f64, 6>> = states.iter().map(|state| state[0]).collect();
    let [qd, qdd] = [1, 2].map(|k| {
        states
            .iter()
            .map(|state| state[k])
            .collect::<Vec<SVector<f64, 6>>>()
    });
    let mut tau = vec![SVector::zeros(); q.len()];
    TORSO
        .inverse_dynamics_batch(&q, &qd, &qdd, &mut tau)
        .expect("vectors of one length");
    let mut jacobians = vec![SMatrix::<f64, 6, 6>::zeros(); q.len()];
    TORSO
        .jacobian_left_hand_batch(&q, &mut jacobians)
        .expect("vectors of one length");
    for (k, q) in q.iter().enumerate() {
        let expected = TORSO.inverse_dynamics(q, &qd[k], &qdd[k]);
        assert!((tau[k] - expected).amax() < 1e-13 * expected.amax());
        assert!((jacobians[k] - TORSO.jacobian_left_hand(q)).amax() < 1e-14);
    }
}

/// Series in time, and an explicit method.
#[test]
fn a_tree_falls_by_its_taylor_series() {
    let start = SVector::from([0.1, 0.4, -0.6, -0.5, 0.8, 0.1]);
    let by_series = TaylorSimulation::new(&TORSO)
        .initial(start, SVector::zeros())
        .duration(0.4)
        .samples(3)
        .run();
    let by_steps = Simulation::new(&TORSO)
        .initial(start, SVector::zeros())
        .duration(0.4)
        .samples(3)
        .run();
    let [series, steps] = [by_series, by_steps].map(|motion| motion.expect("a motion").q[2]);
    assert!((series - steps).amax() < 1e-8, "{}", series - steps);
}

/// Forces at two frames are torques J' w, also beside sampled torques.
#[test]
fn forces_at_frames_move_a_tree() {
    let wrench = |t: f64| Vector6::new(2.0 * t, -1.0, 0.5, 0.1, 0.2, -0.1);
    let start = SVector::from([0.1, 0.4, -0.6, -0.5, 0.8, 0.1]);
    let begun = || {
        let simulation = Simulation::new(&TORSO).initial(start, SVector::zeros());
        simulation.duration(0.3).samples(4)
    };
    let at_frames = begun()
        .wrench_at(
            |torso, q| {
                (
                    torso.forward_kinematics_left_hand(q),
                    torso.jacobian_left_hand(q),
                )
            },
            |t, _, _| wrench(t),
        )
        .wrench_at(
            |torso, q| (torso.forward_kinematics_camera(q), torso.jacobian_camera(q)),
            |_, _, twist| -3.0 * twist,
        );
    let torque = |t: f64, q: &SVector<f64, 6>, qd: &SVector<f64, 6>| {
        let camera = TORSO.jacobian_camera(q);
        TORSO.jacobian_left_hand(q).tr_mul(&wrench(t)) - camera.tr_mul(&(camera * qd)) * 3.0
    };
    let as_torques = begun().torque(torque).run().expect("a motion");
    let found = at_frames.run().expect("a motion");
    assert!(
        (found.q[3] - as_torques.q[3]).amax() < 1e-9,
        "{}",
        found.q[3] - as_torques.q[3]
    );
    let damped = begun().control_period(0.01).torque(|_, _, qd| -qd);
    let camera = |torso: &Torso, q: &SVector<f64, 6>| {
        (torso.forward_kinematics_camera(q), torso.jacobian_camera(q))
    };
    let not_finite = damped
        .wrench_at(camera, |_, _, _| Vector6::repeat(f64::NAN))
        .run();
    assert!(not_finite.unwrap_err().to_string().contains("at a frame"));
}
