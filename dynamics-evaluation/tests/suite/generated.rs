//! The same arm generated and at run time: the same bits.

use arms::decimal;
use dynamics_evaluation::{RuntimeDynamics, RuntimeRobot};
use dynamics_numeric::check::{Checked, Evaluate, Evaluation};
use dynamics_runtime::nalgebra::{DVector, Dyn, SVector, Vector3, Vector6};
use dynamics_runtime::{Pose, SizedState, State, robot_dynamics};
use dynamics_simulation::{
    Friction, Method, Simulation,
    simulation::{DormandPrince, Place},
};
use dynamics_symbolic::robot::{
    Base, Body, Convention, Coupling, JointType, Placement, Robot, Row, Spring, Stribeck, Tool,
    Value,
};
use dynamics_symbolic::{Function, Request};

macro_rules! scene {
    ($($function:ident),*) => {
        robot_dynamics! {
            /// All that a table may hold.
            struct Scene { load: f64, tilt: f64, twist: f64, stiffness: f64, ratio: f64, slow: f64 }

            convention: modified,
            gravity: [0, 0, -9.81],
            base: { xyz: [0, 0, 0.8], rpy: [0, tilt, 0] },
            joints: [
                lift: prismatic { mass: 3, spring: { stiffness: stiffness, rest: 0.1 } },
                turn: revolute {
                    a: 0.3, alpha: PI/2, mass: 1, com: [0.1, 0, 0.02],
                    inertia: { xx: 0.01, yy: 0.02, zz: 0.02, xy: 0.001 },
                    friction: {
                        viscous: 0.1, coulomb: { positive: 0.5, negative: 0.4 },
                        stribeck: { static: 0.8, velocity: slow },
                    },
                },
                still: revolute { a: 0.2, alpha: 0.4, mass: 0.5, com: [0, 0.1, 0] },
                bend: revolute {
                    a: 0.25, alpha: twist, d: 0.1, theta: 0.3, mass: 2, com: [0.1, 0.02, 0],
                    inertia: { xx: 0.01, yy: 0.03, zz: 0.03 },
                    motor: { inertia: 1e-4, gear_ratio: 50 },
                },
                lever: revolute {
                    a: 0.15, mass: 0.4, com: [0.05, 0, 0.01],
                    friction: { coulomb: 0.02, stribeck: { static: 0.03, velocity: slow } },
                },
            ],
            lock: [still = 0.7],
            couple: [lever = ratio * turn + 0.4],
            tool: { xyz: [0, 0, 0.1], rpy: [0, 0, PI/4], mass: load, com: [0, 0, 0.05] },
            functions: [$($function,)* together = (mass_matrix, forward_dynamics, gravity_vector)],
        }

        const FUNCTIONS: &[&str] = &[$(stringify!($function)),*];
    };
}

scene! {
    mass_matrix, coriolis_vector, gravity_vector, friction_vector, spring_vector, inverse_dynamics,
    forward_dynamics, kinetic_energy, potential_energy, bias_force, coriolis_matrix,
    coriolis_coefficients, centrifugal_coefficients, forward_kinematics, link_poses, jacobian,
    inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor, base_parameters,
    forward_dynamics_aba, wrench_torques, tool_velocity, tool_acceleration, jacobian_rate,
    link_jacobians, center_of_mass, center_of_mass_jacobian, centroidal_momentum_matrix,
    centroidal_momentum_bias, operational_inertia_inverse,
    generalized_momentum, momentum_bias, passivity_torque, passivity_regressor, energy_regressors,
    inverse_dynamics_rates, inverse_dynamics_second_derivatives
}

fn numbers<const K: usize>(values: [f64; K]) -> [Value; K] {
    values.map(decimal)
}

fn row(name: &str, joint_type: JointType, mass: f64, com: [f64; 3]) -> Row {
    Row {
        mass: decimal(mass),
        com: numbers(com),
        ..Row::new(name, joint_type)
    }
}

fn of_pi(divisor: i64) -> Value {
    Value::Pi.checked_div(Value::integer(divisor)).unwrap()
}

/// The same scene as a description.
pub(crate) fn description() -> Robot {
    let zero = Value::zero;
    let [load, tilt, twist, stiffness, ratio, slow] = [0, 1, 2, 3, 4, 5].map(Value::field);
    let lift = Row {
        spring: Some(Spring {
            stiffness,
            rest: decimal(0.1),
        }),
        ..row("lift", JointType::Prismatic, 3.0, [0.0; 3])
    };
    let turn = Row {
        a: decimal(0.3),
        alpha: of_pi(2),
        inertia: numbers([0.01, 0.02, 0.02, 0.001, 0.0, 0.0]),
        viscous: decimal(0.1),
        coulomb: numbers([0.5, 0.4]),
        stribeck: Some(Stribeck {
            friction: decimal(0.8),
            velocity: slow.clone(),
        }),
        ..row("turn", JointType::Revolute, 1.0, [0.1, 0.0, 0.02])
    };
    let still = Row {
        a: decimal(0.2),
        alpha: decimal(0.4),
        locked: Some(decimal(0.7)),
        ..row("still", JointType::Revolute, 0.5, [0.0, 0.1, 0.0])
    };
    let bend = Row {
        a: decimal(0.25),
        alpha: twist,
        d: decimal(0.1),
        theta: decimal(0.3),
        inertia: numbers([0.01, 0.03, 0.03, 0.0, 0.0, 0.0]),
        motor_inertia: decimal(1e-4),
        gear_ratio: decimal(50.0),
        ..row("bend", JointType::Revolute, 2.0, [0.1, 0.02, 0.0])
    };
    let lever = Row {
        a: decimal(0.15),
        coulomb: numbers([0.02, 0.02]),
        stribeck: Some(Stribeck {
            friction: decimal(0.03),
            velocity: slow,
        }),
        follows: Some(Coupling {
            leader: 1,
            factor: ratio,
            offset: decimal(0.4),
        }),
        ..row("lever", JointType::Revolute, 0.4, [0.05, 0.0, 0.01])
    };
    Robot {
        name: "Scene".to_owned(),
        fields: ["load", "tilt", "twist", "stiffness", "ratio", "slow"]
            .map(str::to_owned)
            .to_vec(),
        convention: Convention::Modified,
        gravity: numbers([0.0, 0.0, -9.81]),
        base: Some(Base::Standing(Placement {
            xyz: numbers([0.0, 0.0, 0.8]),
            rpy: [zero(), tilt, zero()],
        })),
        rows: vec![lift, turn, still, bend, lever],
        tool: Some(Tool {
            placement: Placement {
                xyz: numbers([0.0, 0.0, 0.1]),
                rpy: [zero(), zero(), of_pi(4)],
            },
            body: Body {
                mass: load,
                com: numbers([0.0, 0.0, 0.05]),
                inertia: [(); 6].map(|()| zero()),
            },
        }),
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
    }
}

pub(crate) const FIELDS: [f64; 6] = [1.5, 0.2, -0.3, 120.0, -0.7, 0.05];

fn generated(fields: [f64; 6]) -> Scene {
    let [load, tilt, twist, stiffness, ratio, slow] = fields;
    Scene {
        load,
        tilt,
        twist,
        stiffness,
        ratio,
        slow,
    }
}

fn runtime(functions: impl IntoIterator<Item = Function>) -> RuntimeRobot {
    let parts = [
        Function::MassMatrix,
        Function::ForwardDynamics,
        Function::GravityVector,
    ];
    let requests = functions
        .into_iter()
        .map(Request::from)
        .chain([Request::fused("together", parts)]);
    let mut arm = RuntimeRobot::new(description(), requests).expect("a robot");
    arm.set_fields(&FIELDS).expect("six fields");
    arm
}

pub(crate) fn all_functions() -> impl Iterator<Item = Function> {
    FUNCTIONS
        .iter()
        .map(|name| Function::from_name(name).expect("a function"))
}

fn state(number: usize) -> (State<3>, Vector3<f64>) {
    let entry = |k: usize| (number as f64 * 1.7 + k as f64 * 0.9).sin() * 2.0;
    let vector = |first: usize| Vector3::from_fn(|i, _| entry(first + i));
    let state = State {
        q: vector(0),
        // A joint at rest has no dry friction.
        qd: if number == 1 {
            Vector3::zeros()
        } else {
            vector(3) * 0.02
        },
        qdd: vector(6),
    };
    (state, vector(9))
}

/// The text of a double says all of its bits but those of NaN.
#[test]
fn every_value_is_that_of_generated_code() {
    let mut arm = runtime(all_functions());
    assert_eq!(FUNCTIONS.len() + 1, Function::ALL.len());
    for fields in [FIELDS, [0.25, -1.0, 2.0, 10.0, 1.9, 0.5]] {
        arm.set_fields(&fields).expect("six fields");
        let scene = generated(fields);
        assert_eq!(arm.table().of_joints(), Some(scene.table()));
        for number in 0..20 {
            let (state, tau) = state(number);
            let expected = scene.evaluate(&state, &tau);
            let (sized, forces) = of_any_size(&state, &tau);
            let found = arm.values(&Pose::identity(), &sized, &forces);
            assert_eq!(
                format!("{found:?}"),
                format!("{expected:?}"),
                "state {number}"
            );
            assert_eq!(
                parts(&tau, |tau, found| {
                    let (state, tau) = of_any_size(&state, tau);
                    arm.values_of_parts(&Pose::identity(), &state, &tau, found);
                }),
                parts(&tau, |tau, found| scene.evaluate_parts(&state, tau, found)),
                "state {number}"
            );
        }
    }
}

/// The same for an arm whose number of joints is known at run time alone.
fn of_any_size(state: &State<3>, tau: &Vector3<f64>) -> (SizedState<Dyn>, DVector<f64>) {
    let vector = |vector: &Vector3<f64>| DVector::from_column_slice(vector.as_slice());
    let (q, qd, qdd) = (vector(&state.q), vector(&state.qd), vector(&state.qdd));
    (SizedState { q, qd, qdd }, vector(tau))
}

/// The parts of methods that return several functions, as text: a refusal too.
fn parts(
    tau: &Vector3<f64>,
    evaluate: impl Fn(&Vector3<f64>, &mut dyn FnMut(&str, Evaluation)),
) -> Vec<String> {
    let mut parts = Vec::new();
    for tau in [*tau, tau * f64::NAN] {
        evaluate(&tau, &mut |name, values| {
            parts.push(format!("{name}: {values:?}"));
        });
    }
    assert_eq!(parts.len(), 2);
    parts
}

#[test]
fn several_functions_are_one_value() {
    let arm = runtime([Function::KineticEnergy]);
    let (state, tau) = state(3);
    let found = arm
        .evaluate(
            "together",
            &[state.q.as_slice(), state.qd.as_slice(), tau.as_slice()],
        )
        .expect("a value");
    let (m, qdd, g) = generated(FIELDS)
        .together(&state.q, &state.qd, &tau)
        .expect("regular");
    let expected = format!(
        "{:?}",
        m.iter()
            .chain(qdd.iter())
            .chain(g.iter())
            .collect::<Vec<_>>()
    );
    let dynamics_evaluation::Value::Tuple(parts) = found else {
        panic!("a tuple");
    };
    let entries = parts.iter().flat_map(|part| match part {
        dynamics_evaluation::Value::Matrix(matrix) => matrix.iter().copied(),
        other => panic!("{other:?}"),
    });
    assert_eq!(format!("{:?}", entries.collect::<Vec<_>>()), expected);
}

fn moving(arm: &RuntimeRobot) -> RuntimeDynamics<'_> {
    arm.dynamics().expect("the default functions")
}

/// An explicit method, and one in momenta; friction by events.
#[test]
fn motions_are_those_of_generated_code() {
    let arm = runtime(Function::default_set(true));
    let (moving, scene) = (moving(&arm), generated(FIELDS));
    let start = SVector::from([0.2, -0.4, 0.9]);
    let methods = [
        Method::DormandPrince(DormandPrince::default()),
        Method::GaussLegendre4 { step: 0.01 },
    ];
    for method in methods {
        let expected = Simulation::new(&scene)
            .initial(start, SVector::zeros())
            .method(method);
        let found = Simulation::new(&moving)
            .initial(
                Place {
                    base: None,
                    q: DVector::from_column_slice(start.as_slice()),
                },
                DVector::zeros(3),
            )
            .method(method);
        let expected = expected
            .friction(Friction::Sticking)
            .duration(0.2)
            .samples(5)
            .run();
        let found = found
            .friction(Friction::Sticking)
            .duration(0.2)
            .samples(5)
            .run();
        let expected = expected.expect("a motion").q;
        let expected: Vec<_> = expected.iter().map(|q| q.as_slice().to_vec()).collect();
        let found = found.expect("a motion").q;
        let found: Vec<_> = found.iter().map(|q| q.as_slice().to_vec()).collect();
        assert_eq!(found, expected, "{method:?}");
    }
}

#[test]
fn a_force_at_the_tool_moves_the_arm() {
    let tip = [Function::ForwardKinematics, Function::Jacobian];
    let arm = runtime(Function::default_set(true).into_iter().chain(tip));
    let (moving, tip) = (moving(&arm), arm.place(None).expect("a tip"));
    let simulation = Simulation::new(&moving)
        .friction(Friction::Sticking)
        .duration(0.1);
    let force = Vector6::new(50.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let pushed = simulation
        .clone()
        .wrench_at(|_, place| tip.at(place), |_t, _pose, _twist| force)
        .run();
    let free = simulation.run();
    assert_ne!(
        pushed.expect("a motion").q.last(),
        free.expect("a motion").q.last()
    );
}
