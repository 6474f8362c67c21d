//! Robots on a base that moves, compiled: HyQ beside the values that Pinocchio has from the same file, a free body, and
//! batches, tuples and other numbers beside single calls.

use std::collections::BTreeSet;

use dynamics_evaluation::{ReadOptions, RuntimeRobot};
use dynamics_symbolic::Function;
use robot_dynamics::nalgebra::{DVector, Rotation3, SVector, Vector3};
use robot_dynamics::simulation::Place;
use robot_dynamics::{
    Certified, DoubleDouble, FloatingNewtonEuler, Pose, Scalar, Simulation, check_against_rnea,
    robot_dynamics,
};

use super::trees::{MOVING, Reference, State, assert_near, file, reference, robot};

robot_dynamics! {
    /// Four legs on a trunk that moves.
    struct Hyq;
    file: "../data/urdf/trees/hyq_no_sensors.urdf",
    base: floating,
    gravity: [0, 0, -9.81],
    allow: [unphysical_inertia],
    functions: [
        default, bias_force, center_of_mass, centroidal_momentum_matrix, centroidal_momentum_bias, jacobian(lf_foot), wrench_torques(lf_foot), forward_kinematics(lf_foot),
        forward_kinematics(rh_foot), inverse_dynamics_derivatives,
        control_terms = (mass_matrix, coriolis_vector, gravity_vector),
    ],
}

robot_dynamics! {
    /// A body without joints.
    struct Stone { m: f64 }
    gravity: [0, 0, -9.81],
    base: floating { mass: m, com: [0.1, 0, 0.2], inertia: { xx: 0.5, yy: 0.4, zz: 0.6 } },
    joints: [],
}

robot_dynamics! {
    /// A trunk with an arm of two joints, one of which slides, far from any weight.
    struct Weightless;
    convention: modified,
    gravity: [0, 0, 0],
    base: floating { mass: 12, com: [0.1, -0.2, 0.05], inertia: cuboid(0.5, 0.3, 0.2) },
    joints: [
        turn: revolute { on: base, at: { xyz: [0.3, 0.1, 0.2], rpy: [0.4, -0.2, 0.7] }, mass: 3, com: [0.2, 0, 0.1], inertia: rod(0.5) },
        slide: prismatic { a: 0.4, alpha: 0.6, mass: 2, com: [0, 0.1, 0.3], inertia: sphere(0.1) },
    ],
    functions: [default, centroidal_momentum_matrix, centroidal_momentum_bias],
}

/// Robots of `tests/data/files/kinds` with these functions, the second ones at a frame where there is one.
macro_rules! kinds {
    ([$($function:ident),* $(,)?], [$($of_tip:ident),* $(,)?]) => {
        robot_dynamics! {
            struct MovingTree;
            file: "../data/files/kinds/moving_tree.toml",
            functions: [$($function,)* $($of_tip(foot),)*],
        }

        robot_dynamics! {
            struct Body;
            file: "../data/files/kinds/body.toml",
            functions: [$($function,)* $($of_tip(camera),)*],
        }

        robot_dynamics! {
            struct MovingArm { g: f64, trunk: f64, reach: f64 }
            file: "../data/files/kinds/moving_arm.toml",
            functions: [$($function,)* $($of_tip,)*],
        }

        robot_dynamics! {
            struct LockedArm;
            file: "../data/files/kinds/locked_arm.toml",
            functions: [$($function,)* $($of_tip,)*],
        }

        const FUNCTIONS: &[&str] = &[$(stringify!($function),)* $(stringify!($of_tip)),*];
    };
}

kinds! {
    [
        mass_matrix, coriolis_vector, gravity_vector, friction_vector, spring_vector, inverse_dynamics, forward_dynamics,
        kinetic_energy, potential_energy, bias_force, coriolis_matrix, link_poses, inverse_dynamics_derivatives,
        forward_dynamics_derivatives, regressor, base_parameters, forward_dynamics_aba, link_jacobians, center_of_mass,
        center_of_mass_jacobian, centroidal_momentum_matrix, centroidal_momentum_bias, generalized_momentum, momentum_bias,
        passivity_torque, passivity_regressor, energy_regressors, inverse_dynamics_rates, inverse_dynamics_second_derivatives,
    ],
    [
        forward_kinematics, jacobian, wrench_torques, tool_velocity, tool_acceleration, jacobian_rate,
        operational_inertia_inverse,
    ]
}

type Velocity = SVector<f64, 18>;

/// The state of a reference, in the order of the joints here.
fn state(reference: &Reference, state: &State) -> (Pose<f64>, SVector<f64, 12>, [Velocity; 3]) {
    let state = state.of(reference, Hyq::JOINT_NAMES.into_iter());
    let q = SVector::from_column_slice(&state.q[7..]);
    let vectors = [&state.v, &state.a, &state.tau].map(|x| Velocity::from_column_slice(x));
    (state.base().expect("a base that moves"), q, vectors)
}

/// Every function that robots on a base that moves have is compiled, for each kind of them.
#[test]
fn every_function_on_a_moving_base_agrees_with_newton_euler() {
    let is_of_standing = |function: &Function| {
        let name = function.name();
        name == "taylor_series" || name.ends_with("_coefficients")
    };
    let names = Function::ALL
        .iter()
        .filter(|function| !is_of_standing(function));
    let names: BTreeSet<_> = names.map(|function| function.name()).collect();
    assert_eq!(FUNCTIONS.iter().copied().collect::<BTreeSet<_>>(), names);
    let arm = MovingArm {
        g: 9.81,
        trunk: 4.0,
        reach: 0.3,
    };
    for report in [
        check_against_rnea(&Hyq),
        check_against_rnea(&Stone { m: 2.5 }),
        check_against_rnea(&MovingTree),
        check_against_rnea(&Body),
        check_against_rnea(&arm),
        check_against_rnea(&LockedArm),
    ] {
        println!("{report}");
        report.assert_ok();
    }
}

/// A robot that is read at run time has the digits of the compiled one, whose values are thus those of Pinocchio.
#[test]
fn a_robot_at_run_time_has_the_digits_of_the_compiled_one() {
    assert_eq!((Hyq::DOF, Hyq::JOINT_NAMES.len()), (18, 12));
    let robot = robot(file("hyq_no_sensors"), MOVING, &["lf_foot"]);
    assert_eq!(robot.dof(), 18);
    let reference = reference("hyq_no_sensors_free");
    for of_state in &reference.states {
        let (base, q, [v, a, tau]) = state(&reference, of_state);
        let of_state = of_state.of(&reference, robot.joint_names());
        let read = |function: &str| of_state.value(&robot, function, tau.as_slice());
        let found = Hyq.inverse_dynamics(&base, &q, &v, &a);
        let (m, bias) = (Hyq.mass_matrix(&q), Hyq.bias_force(&base, &q, &v));
        let solved = Hyq.forward_dynamics(&base, &q, &v, &tau);
        let foot = Hyq.forward_kinematics_lf_foot(&base, &q);
        for (function, compiled) in [
            ("inverse_dynamics", found.as_slice()),
            ("mass_matrix", m.as_slice()),
            ("bias_force", bias.as_slice()),
            (
                "forward_dynamics",
                solved.expect("M is definite").as_slice(),
            ),
            ("friction_vector", Hyq.friction_vector(&v).as_slice()),
            ("kinetic_energy", &[Hyq.kinetic_energy(&q, &v)]),
            ("center_of_mass", Hyq.center_of_mass(&base, &q).as_slice()),
            ("forward_kinematics_lf_foot", foot.as_slice()),
        ] {
            assert_eq!(read(function), compiled, "{function}");
        }
        let sum = m * a + bias;
        assert_near("M a", sum.as_slice(), found.as_slice(), 100.0 * tau.amax());
    }
}

/// In free fall a robot that is read at run time moves as the compiled one.
#[test]
fn a_robot_at_run_time_falls_like_the_compiled_one() {
    // The last two are of a tip.
    let functions = RuntimeRobot::simulation_functions();
    let functions = &functions[..5];
    let options = ReadOptions::new()
        .functions(functions.iter().copied())
        .entries(MOVING);
    let robot = RuntimeRobot::from_file(file("hyq_no_sensors"), &options)
        .unwrap_or_else(|error| panic!("{error}"));
    let robot = robot.dynamics().expect("its functions");
    let pushes = |t: f64| 5.0 * (3.0 * t).sin();
    let (base, v) = (Pose::identity(), Velocity::from_fn(|i, _| 0.1 * i as f64));
    let middle =
        |i: usize, _| Hyq::JOINT_LIMITS[i].map_or(0.0, |[low, high]| 0.4 * low + 0.6 * high);
    let q: SVector<f64, 12> = SVector::from_fn(middle);
    let compiled = Simulation::new(&Hyq)
        .initial(base, q, v)
        .torque(|t, _, _, v| v * -0.2 + SVector::repeat(pushes(t)));
    let compiled = compiled.duration(0.1).samples(3).run().expect("a motion");
    let dynamic = |vector: &[f64]| DVector::from_column_slice(vector);
    let read = Simulation::new(&robot)
        .initial(
            Place {
                base: Some(base),
                q: dynamic(q.as_slice()),
            },
            dynamic(v.as_slice()),
        )
        .torque(|t, _, v| v * -0.2 + DVector::repeat(18, pushes(t)));
    let read = read.duration(0.1).samples(3).run().expect("a motion");
    assert!(
        read.energies(&robot)
            .iter()
            .all(|energy| energy.is_finite())
    );
    for (one, other) in compiled.samples().zip(read.samples()) {
        let turn = (one.base.rotation - other.base.rotation).amax();
        let speed = one
            .qd
            .iter()
            .zip(&other.qd)
            .map(|(one, other)| (one - other).abs());
        let speed = speed.fold(0.0, f64::max);
        assert!(
            turn < 1e-7 && speed < 1e-6,
            "{} s: {turn:e} {speed:e}",
            one.t
        );
    }
}

/// Without gravity and outer forces the momentum of the whole robot does not change, at many states: A a + dA/dt v = 0.
#[test]
fn inner_forces_change_no_momentum() {
    let weightless = Weightless;
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut largest: f64 = 0.0;
    for _ in 0..10_000 {
        let turn = Vector3::from_fn(|_, _| 3.0 * random());
        let base = Pose {
            rotation: Rotation3::new(turn).into_inner(),
            position: Vector3::from_fn(|_, _| random()),
        };
        let q = SVector::<f64, 2>::from_fn(|_, _| 3.0 * random());
        let v = SVector::<f64, 8>::from_fn(|_, _| random());
        let tau = SVector::<f64, 8>::from_fn(|k, _| if k < 6 { 0.0 } else { 10.0 * random() });
        let a = weightless
            .forward_dynamics(&base, &q, &v, &tau)
            .expect("M is definite");
        let (matrix, bias) = (
            weightless.centroidal_momentum_matrix(&base, &q),
            weightless.centroidal_momentum_bias(&base, &q, &v),
        );
        let scale = matrix.amax() * a.amax() + bias.amax();
        largest = largest.max((matrix * a + bias).amax() / scale);
    }
    println!("A a + dA/dt v: {largest:.1e} of scale");
    assert!(largest < 1e-13);
}

/// The power of a force at a foot is that of the torques which it makes.
#[test]
fn a_push_at_a_foot_is_handed_to_base_and_joints() {
    let reference = reference("hyq_no_sensors_free");
    let (base, q, [v, ..]) = state(&reference, &reference.states[0]);
    let wrench = SVector::from([10.0, -5.0, 80.0, 0.3, 0.2, -0.1]);
    let torques = Hyq.wrench_torques_lf_foot(&base, &q, &wrench);
    let power = wrench.dot(&(Hyq.jacobian_lf_foot(&base, &q) * v));
    assert!((torques.dot(&v) - power).abs() < 1e-11 * power.abs().max(1.0));
    // The whole robot is pushed as its base is: the force is the same, in the axes of the base.
    let force = base.rotation.transpose() * Vector3::new(10.0, -5.0, 80.0);
    assert!((torques.fixed_rows::<3>(0) - force).amax() < 1e-12);
}

/// On a stack with room: unoptimised, the frame of a long function in lanes or in 31 digits takes a thread's usual one.
#[test]
fn batches_tuples_and_other_numbers_are_single_calls() {
    let thread = std::thread::Builder::new().stack_size(64 << 20);
    let test = thread
        .spawn(other_forms_are_single_calls)
        .expect("a thread");
    test.join().expect("the same values");
}

fn other_forms_are_single_calls() {
    let reference = reference("hyq_no_sensors_free");
    let states: Vec<_> = (0..37)
        .map(|k| state(&reference, &reference.states[k % reference.states.len()]))
        .collect();
    let poses: Vec<Pose<f64>> = states.iter().map(|(pose, ..)| *pose).collect();
    let q: Vec<_> = states.iter().map(|(_, q, _)| *q).collect();
    let [v, a] = [0, 1].map(|i| states.iter().map(|state| state.2[i]).collect::<Vec<_>>());
    let mut tau = vec![Velocity::zeros(); states.len()];
    Hyq.inverse_dynamics_batch(&poses, &q, &v, &a, &mut tau)
        .expect("as many");
    // Twelve columns, the rotation by rows.
    let columns: [Vec<f64>; 12] = core::array::from_fn(|k| {
        let entry = |pose: &Pose<f64>| match k {
            0..9 => pose.rotation[(k / 3, k % 3)],
            _ => pose.position[k - 9],
        };
        poses.iter().map(entry).collect()
    });
    let mut by_columns: [Vec<f64>; 18] = core::array::from_fn(|_| vec![0.0; states.len()]);
    Hyq.inverse_dynamics_batch(&columns, &q, &v, &a, &mut by_columns)
        .expect("as many");
    for (k, (base, q, [v, a, _])) in states.iter().enumerate() {
        let single = Hyq.inverse_dynamics(base, q, v, a);
        assert_near("batch", tau[k].as_slice(), single.as_slice(), single.amax());
        let row: Vec<f64> = by_columns.iter().map(|column| column[k]).collect();
        assert_near("columns", &row, single.as_slice(), single.amax());
        let (m, coriolis, gravity) = Hyq.control_terms(base, q, v);
        let whole = m * a + coriolis + gravity + Hyq.friction_vector(v);
        assert_near(
            "terms",
            whole.as_slice(),
            single.as_slice(),
            100.0 * single.amax(),
        );
        // Thirty-one digits say how far the doubles are off, and certified bounds know it.
        let exact = Hyq.inverse_dynamics(
            &in_numbers(base, DoubleDouble::from),
            &q.map(DoubleDouble::from),
            &v.map(DoubleDouble::from),
            &a.map(DoubleDouble::from),
        );
        let certified = Hyq.inverse_dynamics(
            &in_numbers(base, Certified::exact),
            &q.map(Certified::exact),
            &v.map(Certified::exact),
            &a.map(Certified::exact),
        );
        for i in 0..18 {
            let error = (exact[i] - DoubleDouble::from(certified[i].value()))
                .to_f64()
                .abs();
            assert!(error <= certified[i].bound(), "{error}");
            assert!((single[i] - exact[i].to_f64()).abs() < 1e-14 * single.amax());
        }
    }
}

fn in_numbers<T: Scalar>(pose: &Pose<f64>, number: fn(f64) -> T) -> Pose<T> {
    Pose {
        rotation: pose.rotation.map(number),
        position: pose.position.map(number),
    }
}

/// Newton's and Euler's equations of a free body, which the numeric algorithm has in its own tests; batches, whose vectors of
/// positions are empty.
#[test]
fn a_free_body_obeys_newton_and_euler() {
    assert_eq!(Stone::DOF, 6);
    let stone = Stone { m: 3.0 };
    let numeric = FloatingNewtonEuler::<0, 6>::new(&stone.table());
    let base = Pose {
        rotation: Rotation3::from_euler_angles(0.3, -0.8, 1.1).into_inner(),
        position: Vector3::new(1.0, 2.0, 3.0),
    };
    let none = SVector::<f64, 0>::zeros();
    let v = SVector::from([0.2, -0.4, 0.9, 1.1, 0.6, -0.7]);
    let a = SVector::from([-0.3, 0.8, 0.1, 0.5, -0.9, 0.4]);
    let found = stone.inverse_dynamics(&base, &none, &v, &a);
    let expected = numeric.inverse_dynamics(&base, &none, &v, &a);
    assert!((found - expected).amax() < 1e-13, "{found}");
    let back = stone.forward_dynamics(&base, &none, &v, &found);
    assert!((back.expect("a mass") - a).amax() < 1e-13);
    let potential = numeric.potential_energy(&base, &none);
    assert!((stone.potential_energy(&base, &none) - potential).abs() < 1e-12);
    let (poses, positions, velocities) = (vec![base; 21], vec![none; 21], vec![v; 21]);
    let mut forces = vec![SVector::<f64, 6>::zeros(); 21];
    stone
        .inverse_dynamics_batch(&poses, &positions, &velocities, &vec![a; 21], &mut forces)
        .expect("as many");
    assert!(forces.iter().all(|one| (one - found).amax() < 1e-13));
    stone
        .coriolis_vector_batch(&positions, &velocities, &mut forces)
        .expect("as many");
    let bias = stone.coriolis_vector(&none, &v);
    assert!(forces.iter().all(|one| (one - bias).amax() < 1e-13));
    // Without mass there is no acceleration; the base is named.
    let error = Stone { m: 0.0 }.forward_dynamics(&base, &none, &v, &found);
    assert!(error.is_err_and(|error| error.to_string().contains("base")));
}
