//! Joints that follow others: beside the whole arm whose joints are moved as they have to, beside Newton
//! and Euler, and beside the whole arm in 31 digits.
//!
//! With q = S q_j + c of the whole arm, M_j = S' M S, and so for everything that has an index of joints.

use robot_dynamics::nalgebra::{DMatrix, DVector, SMatrix, SVector};
use robot_dynamics::{
    Certified, DoubleDouble, ForwardDynamics, Friction, GravityVector, InverseDynamics, MassMatrix,
    NewtonEuler, Scalar, Simulation, State, certified,
    check::{Evaluate, base_parameter_map},
    robot_dynamics,
    table::Table,
};
use robots::palletiser_table;
use testkit::exact::Exact;
use testkit::random::Random;

/// An arm with couplings and all functions, and the same arm without them.
macro_rules! arm {
    (
        $coupled:ident { $($field:ident),* } $whole:ident { $($own:ident),* } couple: $couple:tt,
        $($entries:tt)*
    ) => {
        coupled! { struct $coupled { $($field: f64),* } $($entries)* couple: $couple, }
        whole! { struct $whole { $($own: f64),* } $($entries)* }
    };
}

/// An arm with couplings.
macro_rules! coupled {
    ($($entries:tt)*) => {
        robot_dynamics! {
            $($entries)*
            functions: [
                default, friction_vector, spring_vector, bias_force, coriolis_matrix,
                coriolis_coefficients, centrifugal_coefficients, forward_kinematics, link_poses, jacobian,
                inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor, base_parameters,
                forward_dynamics_aba, wrench_torques, tool_velocity, tool_acceleration, jacobian_rate,
                link_jacobians, center_of_mass, center_of_mass_jacobian, operational_inertia_inverse,
                generalized_momentum, momentum_bias, passivity_torque, passivity_regressor,
                energy_regressors, inverse_dynamics_rates,
                control_terms = (mass_matrix, coriolis_vector, gravity_vector),
            ],
        }
    };
}

/// An arm whose joints all move by themselves.
macro_rules! whole {
    ($($entries:tt)*) => {
        robot_dynamics! {
            $($entries)*
            functions: [
                default, friction_vector, spring_vector, coriolis_matrix, jacobian, link_poses,
                forward_kinematics, inverse_dynamics_derivatives, momentum_bias,
            ],
        }
    };
}

// A two-finger gripper on a short arm; the fingers move against each other.
arm! {
    Gripper { load, tilt, width } OpenGripper { load, tilt } couple: [finger_2 = -finger_1 + width],
    convention: modified,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, 0.8], rpy: [0, tilt, 0] },
    joints: [
        lift: prismatic { mass: 3, spring: { stiffness: 200, rest: 0.1 } },
        turn: revolute {
            a: 0.3, alpha: 0.4, mass: 1, com: [0.1, 0.02, 0], inertia: cuboid(0.3, 0.1, 0.1),
            friction: { viscous: 0.1, coulomb: { positive: 0.5, negative: 0.4 } },
        },
        finger_1: prismatic {
            a: 0.2, alpha: PI/2, mass: 0.2, com: [0.05, 0, 0.01], inertia: sphere(0.02),
            motor: { inertia: 1e-6, gear_ratio: 400 },
            friction: { viscous: 3, coulomb: { positive: 0.3, negative: 0.2 } },
        },
        finger_2: prismatic {
            d: 0.03, mass: 0.15, com: [0.05, 0.01, -0.01], inertia: sphere(0.02),
            motor: { inertia: 1e-6, gear_ratio: 300 },
            spring: { stiffness: 50, rest: 0.03 },
            friction: {
                viscous: 2, coulomb: { positive: 0.25, negative: 0.15 },
                stribeck: { static: 0.4, velocity: 0.2 },
            },
        },
    ],
    tool: { xyz: [0.1, 0, 0.02], rpy: [0.3, 0, -0.2], mass: load, com: [0, 0, 0.05] },
}

// The palletiser of `testkit/robots`: the joints that follow are in front of the joints that move on.
palletiser_table! {
    coupled { struct Palletiser; } { couple: [level = -upper + PI/2, hand = -fore - 0.25], }
}
palletiser_table! { whole { struct Serial; } {} }

// Belts and gears: twice as far, half as far, by a field, three times by way of another follower, a rack
// that turns a pinion, and a joint that follows one behind it.
arm! {
    Geared { ratio, phase } Loose {} couple: [
        half = arm / 2 + deg(20),
        double = 2 * arm + phase,
        pinion = 25 * (rack - 0.01),
        last = 1.5 * double - 0.1,
        first = ratio * arm,
    ],
    convention: modified,
    gravity: [1, -2, -9.81],
    joints: [
        first: revolute {
            mass: 2, com: [0.1, 0.02, 0.03], inertia: { xx: 0.02, yy: 0.03, zz: 0.04, xz: 0.005 },
            friction: { coulomb: 0.2, viscous: 0.3 },
        },
        arm: revolute {
            a: 0.2, alpha: 0.5, mass: 3, com: [0.15, 0, 0.05], inertia: { xx: 0.02, yy: 0.06, zz: 0.07 },
            motor: { inertia: 1e-4, gear_ratio: 50 }, friction: { coulomb: 0.4, viscous: 0.2 },
        },
        half: revolute {
            a: 0.3, alpha: PI/2, d: 0.05, mass: 1, com: [0.1, 0.05, 0], inertia: { xx: 0.01, yy: 0.02, zz: 0.02 },
            spring: { stiffness: 5, rest: 0.2 },
        },
        double: revolute {
            a: 0.25, mass: 0.8, com: [0.1, 0, 0.02], inertia: { xx: 0.004, yy: 0.01, zz: 0.01 },
            friction: { viscous: 0.05, coulomb: 0.1, stribeck: { static: 0.15, velocity: 0.3 } },
        },
        rack: prismatic { alpha: -0.7, mass: 0.6, com: [0, 0.02, 0.1], friction: { viscous: 4 } },
        pinion: revolute {
            a: 0.05, alpha: 0.3, mass: 0.1, com: [0.01, 0, 0.005], inertia: { xx: 2e-5, yy: 2e-5, zz: 3e-5 },
            motor: { inertia: 2e-6, gear_ratio: 5 },
        },
        last: revolute { a: 0.1, mass: 0.3, com: [0.05, 0.01, 0], inertia: rod(0.1) },
    ],
}

/// S and c of an arm of N joints whose whole has L.
struct Coupling<const L: usize, const N: usize> {
    s: SMatrix<f64, L, N>,
    c: SVector<f64, L>,
}

impl<const L: usize, const N: usize> Coupling<L, N> {
    fn positions(&self, q: &SVector<f64, N>) -> SVector<f64, L> {
        self.s * q + self.c
    }

    fn felt(&self, forces: SVector<f64, L>) -> SVector<f64, N> {
        self.s.tr_mul(&forces)
    }

    fn block(&self, matrix: SMatrix<f64, L, L>) -> SMatrix<f64, N, N> {
        self.s.tr_mul(&matrix) * self.s
    }
}

/// An error beside what it is an error of.
fn near<const R: usize, const C: usize>(
    what: &str,
    found: SMatrix<f64, R, C>,
    expected: SMatrix<f64, R, C>,
) {
    let error = (found - expected).amax();
    let size = expected.amax().max(1.0);
    assert!(error <= 1e-12 * size, "{what}: {error:e} of {size:e}");
}

/// All functions of the coupled arm are those of the whole arm, contracted.
macro_rules! agrees {
    ($coupled:expr, $whole:expr, $n:literal, $l:literal, $coupling:expr, $joints:expr) => {{
        let (coupled, whole) = ($coupled, $whole);
        let coupling: Coupling<$l, $n> = $coupling;
        let joints: [usize; $n] = $joints;
        let (s, no) = (coupling.s, SVector::<f64, $n>::zeros());
        for k in 0..6 {
            let sample = |at: usize| {
                SVector::<f64, $n>::from_fn(|i, _| (1.7 * (i + at) as f64 + k as f64).sin())
            };
            let (q, qd, qdd) = (sample(1), sample(7), sample(13));
            let (all_q, all_qd, all_qdd) = (coupling.positions(&q), s * qd, s * qdd);

            let m = coupling.block(whole.mass_matrix(&all_q));
            near("M", coupled.mass_matrix(&q), m);
            let v = coupling.felt(whole.coriolis_vector(&all_q, &all_qd));
            near("V", coupled.coriolis_vector(&q, &qd), v);
            let g = coupling.felt(whole.gravity_vector(&all_q));
            near("G", coupled.gravity_vector(&q), g);
            let springs = coupling.felt(whole.spring_vector(&all_q));
            near("K", coupled.spring_vector(&q), springs);
            let friction = coupling.felt(whole.friction_vector(&all_qd));
            near("F", coupled.friction_vector(&qd), friction);
            let tau = coupling.felt(whole.inverse_dynamics(&all_q, &all_qd, &all_qdd));
            near("tau", coupled.inverse_dynamics(&q, &qd, &qdd), tau);
            let bias = coupling.felt(whole.momentum_bias(&all_q, &all_qd));
            near("momentum bias", coupled.momentum_bias(&q, &qd), bias);
            let c = coupling.block(whole.coriolis_matrix(&all_q, &all_qd));
            near("C", coupled.coriolis_matrix(&q, &qd), c);
            let jacobian = whole.jacobian(&all_q) * s;
            near("J", coupled.jacobian(&q), jacobian);
            let tip = whole.forward_kinematics(&all_q);
            near("tip", coupled.forward_kinematics(&q), tip);
            let poses = whole.link_poses(&all_q);
            for (pose, joint) in coupled.link_poses(&q).into_iter().zip(joints) {
                near("pose", pose, poses[joint]);
            }
            let (by_q, by_qd) = coupled.inverse_dynamics_derivatives(&q, &qd, &qdd);
            let slopes = whole.inverse_dynamics_derivatives(&all_q, &all_qd, &all_qdd);
            near("d tau/dq", by_q, coupling.block(slopes.0));
            near("d tau/dqd", by_qd, coupling.block(slopes.1));
            let energy = whole.kinetic_energy(&all_q, &all_qd);
            let difference = coupled.kinetic_energy(&q, &qd) - energy;
            assert!(difference.abs() <= 1e-12 * energy, "T: {difference:e}");
            let rest = coupling.positions(&no);
            let rise = whole.potential_energy(&all_q) - whole.potential_energy(&rest);
            let found = coupled.potential_energy(&q) - coupled.potential_energy(&no);
            assert!((found - rise).abs() <= 1e-11, "U: {:e}", found - rise);
            for solution in [
                coupled.forward_dynamics(&q, &qd, &tau),
                coupled.forward_dynamics_aba(&q, &qd, &tau),
            ] {
                near("qdd", solution.expect("regular"), qdd);
            }

            // The whole arm in 31 digits.
            let table = whole.table();
            let exact = Exact(&table);
            let digits = |x: SVector<f64, $l>| x.map(DoubleDouble::from);
            let exact_m = exact.mass_matrix(&digits(all_q)).map(|x| x.high());
            near("exact M", coupled.mass_matrix(&q), coupling.block(exact_m));
            let [q_, qd_, qdd_] = [all_q, all_qd, all_qdd].map(digits);
            let torque = exact.inverse_dynamics(&q_, &qd_, &qdd_).map(|x| x.high());
            let found = coupled.inverse_dynamics(&q, &qd, &qdd);
            near("exact tau", found, coupling.felt(torque));
        }
        let report = crate::check().run(&coupled);
        println!("{report}");
        report.assert_ok();
        links_give_the_torques(&coupled.table());
    }};
}

/// The standard regressor of all links, those of followers included, times their parameters, with the motors.
fn links_give_the_torques<const N: usize>(table: &Table<N>) {
    let numeric = NewtonEuler::new(table);
    let [q, qd, qdd] =
        [1, 7, 13].map(|at| SVector::<f64, N>::from_fn(|i, _| (1.7 * (i + at) as f64).sin()));
    let own = numeric.standard_regressor(&q, &qd, &qdd).into_iter();
    let own = own.zip(table.standard_parameters());
    let followers = numeric.standard_regressor_of_followers(&q, &qd, &qdd);
    let followers: Vec<_> = followers
        .zip(table.standard_parameters_of_followers())
        .collect();
    assert_eq!(followers.len(), table.followers.iter().count());
    let all = own.chain(followers);
    let mut torque = all.fold(SVector::zeros(), |sum, (block, x)| sum + block * x);
    for (joint, row) in table.rows.iter().enumerate() {
        torque[joint] += row.reflected_inertia() * qdd[joint];
    }
    for follower in table.followers.iter() {
        let felt = follower.factor * follower.factor * follower.row.reflected_inertia();
        torque[follower.leader] += felt * qdd[follower.leader];
    }
    let expected = numeric.inverse_dynamics(&q, &qd, &qdd)
        - numeric.friction_vector(&qd)
        - numeric.spring_vector(&q);
    near("standard parameters", torque, expected);
}

/// The parameters of all links, those of followers behind the others, and the motors lead to the base parameters
/// by a matrix: the only one, for no column of the regressor depends on others.
#[test]
fn links_lead_to_the_base_parameters() {
    leads(&gripper(), &gripper().base_parameters::<f64>());
    leads(&Palletiser {}, &Palletiser {}.base_parameters::<f64>());
    let geared = Geared {
        ratio: 1.7,
        phase: 0.4,
    };
    leads(&geared, &geared.base_parameters::<f64>());
}

fn leads<R: Evaluate<N>, const N: usize, const P: usize>(robot: &R, expected: &SVector<f64, P>) {
    let map = base_parameter_map(robot).expect("independent columns");
    let table = robot.table();
    let links = table.standard_parameters().into_iter();
    let links = links.chain(table.standard_parameters_of_followers());
    let mut x: Vec<f64> = links.flat_map(|link| link.as_slice().to_vec()).collect();
    let rows = table.rows.iter();
    let rows = rows.chain(table.followers.iter().map(|follower| &follower.row));
    x.extend(rows.map(|row| row.reflected_inertia()));
    let found = map * DVector::from(x);
    let error = (&found - expected).amax() / expected.amax();
    let condition = condition(robot);
    println!("base parameters: {P}, error {error:e}, condition {condition:e}");
    // Least squares lose what the condition number says: it is 4 and 6 for the gripper and the palletiser, and 6e4 for
    // the gears, whose followers turn by multiples of one angle.
    assert!(error < 4.0 * f64::EPSILON * condition, "{error:e}");
}

/// The condition number of the regressor's columns over some states, each column scaled to the same length.
fn condition<R: Evaluate<N>, const N: usize>(robot: &R) -> f64 {
    let mut random = Random::seeded(3);
    let mut rows = Vec::new();
    for _ in 0..100 {
        let [q, qd, qdd] = [(); 3].map(|()| random.vector::<N>(2.0));
        let state = State { q, qd, qdd };
        let values = robot.evaluate(&state, &SVector::zeros());
        let columns: Vec<SVector<f64, N>> = values.get("regressor").expect("generated");
        rows.extend((0..N).map(|i| columns.iter().map(|column| column[i]).collect::<Vec<_>>()));
    }
    let mut matrix = DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j]);
    for mut column in matrix.column_iter_mut() {
        column /= column.norm();
    }
    let values = matrix.singular_values();
    values.max() / values.min()
}

/// A run ends at the limit of the joint that leads, and the table has no others.
#[test]
fn limits_are_those_of_the_joints_that_lead() {
    assert_eq!(Limited.table().joint_limits(), [Some([0.0, 0.04])]);
    assert_eq!(Limited::JOINT_LIMITS, [Some([0.0, 0.04])]);
    let run = Simulation::new(&Limited)
        .torque(|_, _, _| SVector::from([0.3]))
        .initial(SVector::from([0.01]), SVector::zeros())
        .stops(0.0)
        .duration(2.0)
        .samples(5)
        .run()
        .expect("a run");
    let last = run.q.last().expect("a sample")[0];
    assert!((last - 0.04).abs() < 1e-12, "{last}");
}

robot_dynamics! {
    struct Limited;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        finger_1: prismatic { alpha: PI/2, mass: 0.2, limits: [0, 0.04] },
        finger_2: prismatic { mass: 0.15 },
    ],
    couple: [finger_2 = -finger_1 + 0.04],
}

fn gripper() -> Gripper {
    Gripper {
        load: 1.5,
        tilt: 0.3,
        width: 0.08,
    }
}

#[test]
fn fingers_that_move_against_each_other() {
    assert_eq!(Gripper::DOF, 3);
    assert_eq!(Gripper::JOINT_NAMES, ["lift", "turn", "finger_1"]);
    let Gripper { load, tilt, width } = gripper();
    let whole = OpenGripper { load, tilt };
    #[rustfmt::skip]
    let s = SMatrix::<f64, 4, 3>::from_row_slice(&[
        1.0, 0.0, 0.0,
        0.0, 1.0, 0.0,
        0.0, 0.0, 1.0,
        0.0, 0.0, -1.0,
    ]);
    let c = SVector::from([0.0, 0.0, 0.0, width]);
    agrees!(gripper(), whole, 3, 4, Coupling { s, c }, [0, 1, 2]);
}

#[test]
fn parallelograms_of_a_palletiser() {
    assert_eq!(Palletiser::JOINT_NAMES, ["waist", "upper", "fore"]);
    #[rustfmt::skip]
    let s = SMatrix::<f64, 5, 3>::from_row_slice(&[
        1.0, 0.0, 0.0,
        0.0, 1.0, 0.0,
        0.0, -1.0, 0.0,
        0.0, 0.0, 1.0,
        0.0, 0.0, -1.0,
    ]);
    let c = SVector::from([0.0, 0.0, std::f64::consts::FRAC_PI_2, 0.0, -0.25]);
    agrees!(Palletiser, Serial, 3, 5, Coupling { s, c }, [0, 1, 3]);
    // Three of five angles are read: the followers share sine and cosine with their leader.
    let count = |name: &str| {
        let mut operations = Palletiser::OPERATIONS.iter();
        operations
            .find(|(method, _)| *method == name)
            .map(|(_, count)| count.sin_cos)
    };
    assert!(count("inverse_dynamics") <= Some(3));
}

#[test]
fn belts_gears_and_a_rack() {
    assert_eq!(Geared::JOINT_NAMES, ["arm", "rack"]);
    let (ratio, phase) = (-0.4, 0.6);
    let (coupled, whole) = (Geared { ratio, phase }, Loose {});
    #[rustfmt::skip]
    let s = SMatrix::<f64, 7, 2>::from_row_slice(&[
        ratio, 0.0,
        1.0, 0.0,
        0.5, 0.0,
        2.0, 0.0,
        0.0, 1.0,
        0.0, 25.0,
        3.0, 0.0,
    ]);
    let c = SVector::from([
        0.0,
        0.0,
        20_f64.to_radians(),
        phase,
        0.0,
        -0.25,
        1.5 * phase - 0.1,
    ]);
    agrees!(coupled, whole, 2, 7, Coupling { s, c }, [1, 4]);
}

/// The table has the rows of the joints, and beside them those of the joints that follow.
#[test]
fn the_table_knows_what_follows() {
    let table = gripper().table();
    let [follower] = table.followers.iter().collect::<Vec<_>>()[..] else {
        panic!("one joint follows");
    };
    assert_eq!((follower.place, follower.leader), (3, 2));
    assert_eq!((follower.factor, follower.offset), (-1.0, 0.08));
    assert_eq!(follower.row.mass, 0.15);
    assert_eq!(table.total_mass(), 3.0 + 1.0 + 0.2 + 0.15 + 1.5);
    // Without it the arm is another one.
    let mut alone = table.clone();
    alone.followers = robot_dynamics::table::List::NONE;
    let q = SVector::from([0.1, 0.2, 0.03]);
    let [m, other] = [table, alone].map(|table| NewtonEuler::new(&table).mass_matrix(&q));
    assert!((m - other).amax() > 0.1);
    assert!((m - gripper().mass_matrix(&q)).amax() < 1e-13);
}

/// A gripper at rest holds by the friction of both fingers, and lets go above it.
#[test]
fn both_fingers_hold_by_friction() {
    let hand = Gripper {
        load: 0.0,
        tilt: 0.0,
        width: 0.08,
    };
    let q = SVector::from([0.1, 0.4, 0.02]);
    let still = hand.inverse_dynamics(&q, &SVector::zeros(), &SVector::zeros());
    // The threshold is 0.3 of the leader, and the static friction of the follower, which moves the other way.
    for (push, moves) in [(0.69, false), (0.71, true)] {
        let tau = still + SVector::from([0.0, 0.0, push]);
        let run = Simulation::new(&hand)
            .torque(move |_, _, _| tau)
            .friction(Friction::Sticking)
            .initial(q, SVector::zeros())
            .duration(0.02)
            .samples(3)
            .run()
            .expect("a run");
        let slid = run.q.last().map(|q| q[2] - 0.02);
        assert_eq!(slid.map(|slid| slid.abs() > 1e-9), Some(moves), "{slid:?}");
    }
}

robots::every_function! {
    struct LockedLeader { width: f64 }
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { mass: 1, com: [0.1, 0.02, 0.3], inertia: sphere(0.1) },
        finger_1: prismatic { a: 0.2, alpha: PI/2, mass: 0.2, com: [0.05, 0, 0.01] },
        finger_2: prismatic { d: 0.03, mass: 0.15, com: [0.05, 0.01, -0.01] },
    ],
    couple: [finger_2 = -finger_1 + width],
    lock: [finger_1 = 0.01],
}

robots::every_function! {
    struct BothLocked { width: f64 }
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { mass: 1, com: [0.1, 0.02, 0.3], inertia: sphere(0.1) },
        finger_1: prismatic { a: 0.2, alpha: PI/2, mass: 0.2, com: [0.05, 0, 0.01] },
        finger_2: prismatic { d: 0.03, mass: 0.15, com: [0.05, 0.01, -0.01] },
    ],
    lock: [finger_1 = 0.01, finger_2 = -0.01 + width],
}

/// A joint that follows a locked one is locked.
#[test]
fn a_follower_of_a_locked_joint_is_locked() {
    let (width, q) = (0.08, SVector::from([0.7]));
    let (following, locked) = (LockedLeader { width }, BothLocked { width });
    assert_eq!(following.table(), locked.table());
    assert_eq!(following.gravity_vector(&q), locked.gravity_vector(&q));
    assert_eq!(LockedLeader::OPERATIONS, BothLocked::OPERATIONS);
}

robot_dynamics! {
    /// A link that turns by 0.35 of the angle of a joint that carries nothing besides.
    struct Fraction;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [leader: revolute {}, follower: revolute { mass: 1.3, com: [0.4, 0, 0] }],
    couple: [follower = 0.35 * leader + 0.2],
}

robot_dynamics! {
    /// The same, its numbers fields.
    struct FractionOfFields { factor: f64, offset: f64, mass: f64, length: f64, g: f64 }
    convention: modified,
    gravity: [0, -g, 0],
    joints: [leader: revolute {}, follower: revolute { mass: mass, com: [length, 0, 0] }],
    couple: [follower = factor * leader + offset],
}

/// The largest and the mean error of G and of accelerations over their bounds, beside M = m (1 + f)^2 l^2 and
/// G = m g l (1 + f) cos((1 + f) q + offset) in 31 digits.
fn follower_ratios<R>(arm: &R, [f, offset, m, l, g]: [DoubleDouble; 5]) -> [[f64; 2]; 2]
where
    R: GravityVector<1> + ForwardDynamics<1> + InverseDynamics<1> + MassMatrix<1>,
{
    const STATES: usize = 60;
    let mut ratios = [[0.0_f64; 2]; 2];
    for k in 0..STATES {
        let q = (0.1 + 0.77 * k as f64) * [1.0, 1e3, 1e5][k % 3];
        let whole = DoubleDouble::from(1.0) + f;
        let angle = whole * DoubleDouble::from(q) + offset;
        let gravity = m * g * l * whole * angle.sin_cos().1;
        let tau = DoubleDouble::from(1.0);
        let acceleration = (tau - gravity) / (m * whole * whole * l * l);
        let [at, still, tau] = [q, 0.0, 1.0].map(|x| SVector::from([Certified::exact(x)]));
        let found = [
            (arm.gravity_vector(&at)[0], gravity),
            (
                certified::forward_dynamics(arm, &at, &still, &tau).expect("regular")[0],
                acceleration,
            ),
        ];
        for (ratios, (found, exact)) in ratios.iter_mut().zip(found) {
            let error = (DoubleDouble::from(found.value()) - exact).abs().high();
            assert!(error <= found.bound(), "q = {q}: {error:e} {found}");
            *ratios = [
                ratios[0].max(error / found.bound()),
                ratios[1] + error / found.bound() / STATES as f64,
            ];
        }
    }
    println!("{ratios:.3?}");
    ratios
}

/// A fraction of an angle of 1e6 rad is rounded before its sine is taken: `Certified` counts it.
#[test]
fn the_rounding_of_a_followers_angle_is_counted() {
    let quotient = |a: f64, b: f64| DoubleDouble::from(a) / DoubleDouble::from(b);
    let decimals = [
        (7.0, 20.0),
        (1.0, 5.0),
        (13.0, 10.0),
        (2.0, 5.0),
        (981.0, 100.0),
    ];
    let of_decimals = follower_ratios(&Fraction, decimals.map(|(a, b)| quotient(a, b)));
    let arm = FractionOfFields {
        factor: 0.35,
        offset: 0.2,
        mass: 1.3,
        length: 0.4,
        g: 9.81,
    };
    let fields = [arm.factor, arm.offset, arm.mass, arm.length, arm.g];
    let of_fields = follower_ratios(&arm, fields.map(DoubleDouble::from));
    for [largest, mean] in of_decimals.into_iter().chain(of_fields) {
        assert!(
            largest > 0.1 && mean >= 0.02,
            "{of_decimals:?} {of_fields:?}"
        );
    }
}
