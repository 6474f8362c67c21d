//! Mountings and tools: beside the same arm said in another way, and beside Newton and Euler.

use robot_dynamics::nalgebra::{Matrix4, SMatrix, SVector, Vector3, Vector6};
use robot_dynamics::{Batch, Simulation, robot_dynamics};
use robots::TiltingCell;

/// Three joints; after the arm's name what follows it in the struct, gravity, more rows and entries.
macro_rules! arm {
    ($name:ident $body:tt $gravity:tt, [$($row:tt)*], $($entries:tt)*) => {
        robot_dynamics! {
            struct $name $body
            convention: modified,
            gravity: $gravity,
            joints: [
                turn: revolute {
                    d: 0.3, mass: 2, com: [0.1, 0.2, -0.1],
                    inertia: { xx: 0.3, yy: 0.35, zz: 0.2, xy: 0.01, xz: -0.02, yz: 0.03 },
                    motor: { inertia: 2e-4, gear_ratio: -62 },
                },
                slide: prismatic {
                    a: 0.02, d: 0.15, theta: 0.2, alpha: -PI/2, mass: 4.8, com: [-0.02, -0.014, 0.07],
                    inertia: { xx: 0.066, yy: 0.086, zz: 0.05, yz: 0.01 },
                    friction: { viscous: 0.8 },
                },
                pitch: revolute {
                    a: 0.25, alpha: 0.7, theta: -0.3, mass: 0.82, com: [0, 0.019, 0.02],
                    inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
                },
                $($row)*
            ],
            $($entries)*
            functions: [
                mass_matrix, coriolis_matrix, gravity_vector, inverse_dynamics, forward_dynamics,
                forward_dynamics_aba, kinetic_energy, potential_energy, forward_kinematics, link_poses,
                jacobian,
            ],
        }
    };
}

arm!(Bare; [0, 0, -9.81], [],);
arm!(WithTool; [0, 0, -9.81], [],
    tool: {
        xyz: [0.12, 0, 0.2], rpy: [0, 0, 0.4], mass: 1.5, com: [0.01, -0.02, 0.05],
        inertia: { xx: 0.004, yy: 0.005, zz: 0.003, xy: 0.0002 },
    },
);
arm!(WithLockedLink; [0, 0, -9.81], [
    flange: revolute {
        a: 0.12, d: 0.2, theta: 0.4, mass: 1.5, com: [0.01, -0.02, 0.05],
        inertia: { xx: 0.004, yy: 0.005, zz: 0.003, xy: 0.0002 },
    },
    ], lock: [flange = 0],
);
arm!(OnTheWall; [0, 0, -9.81], [], base: { xyz: [0.5, -0.25, 1.5], rpy: [0, PI/2, 0] },);
arm!(WallByHand; [9.81, 0, 0], [],);
arm!(Loaded { load: f64 } [0, 0, -9.81], [],
    tool: { xyz: [0.12, 0.03, 0.2], rpy: [0.1, 0.2, 0.4], mass: load, com: [0.01, -0.02, 0.05], inertia: sphere(0.04) },
);
arm!(Unloaded; [0, 0, -9.81], [],
    tool: { xyz: [0.12, 0.03, 0.2], rpy: [0.1, 0.2, 0.4], mass: 0, com: [0.01, -0.02, 0.05] },
);
arm!(ToolOnLocked { tilt: f64 } [0, 0, -9.81], [
    flange: revolute { a: 0.1, alpha: 0.5, d: 0.2, theta: 0.4, mass: 0.5, com: [0.01, 0, 0.05] },
    ], lock: [flange = 0.3], base: { xyz: [0, 0, 0.8], rpy: [0, tilt, 0] },
    tool: { xyz: [0.1, 0, 0.05], rpy: [0, PI/2, 0], mass: 2, com: [0, 0.05, 0.1], inertia: cuboid(0.1, 0.2, 0.05) },
);
arm!(ToolOnMoving { tilt: f64 } [0, 0, -9.81], [
    flange: revolute { a: 0.1, alpha: 0.5, d: 0.2, theta: 0.4, mass: 0.5, com: [0.01, 0, 0.05] },
    ], base: { xyz: [0, 0, 0.8], rpy: [0, tilt, 0] },
    tool: { xyz: [0.1, 0, 0.05], rpy: [0, PI/2, 0], mass: 2, com: [0, 0.05, 0.1], inertia: cuboid(0.1, 0.2, 0.05) },
);

type Vector = SVector<f64, 3>;

/// Positions, velocities, accelerations.
fn states() -> impl Iterator<Item = [Vector; 3]> {
    let sample = |k: usize, at: usize| {
        Vector::from_fn(|i, _| (1.7 * (i + at) as f64 + 0.9 * k as f64).sin())
    };
    (0..6).map(move |k| [1, 7, 13].map(|at| sample(k, at)))
}

/// The functions of two arms at one state, and the largest difference of all of them.
macro_rules! largest_difference {
    ($one:expr, $other:expr, $state:expr) => {{
        let ([q, qd, qdd], mut largest) = ($state, 0.0_f64);
        let mut compare = |difference: f64, size: f64| {
            largest = largest.max(difference / size.max(1.0));
        };
        let (one, other) = ($one, $other);
        let m = other.mass_matrix(&q);
        compare((one.mass_matrix(&q) - m).amax(), m.amax());
        let tau = other.inverse_dynamics(&q, &qd, &qdd);
        compare(
            (one.inverse_dynamics(&q, &qd, &qdd) - tau).amax(),
            tau.amax(),
        );
        compare(
            (one.gravity_vector(&q) - other.gravity_vector(&q)).amax(),
            tau.amax(),
        );
        let c = other.coriolis_matrix(&q, &qd);
        compare((one.coriolis_matrix(&q, &qd) - c).amax(), c.amax());
        let energy = one.kinetic_energy(&q, &qd) - other.kinetic_energy(&q, &qd);
        compare(energy.abs(), 10.0);
        for found in [
            one.forward_dynamics(&q, &qd, &tau),
            one.forward_dynamics_aba(&q, &qd, &tau),
        ] {
            compare((found.expect("regular") - qdd).amax(), 100.0);
        }
        largest
    }};
}

/// A tool, and a last link of the same body that is locked.
#[test]
fn a_tool_is_a_link_that_is_locked() {
    let (mut dynamics, mut poses) = (0.0_f64, 0.0_f64);
    for state @ [q, ..] in states() {
        dynamics = dynamics.max(largest_difference!(WithTool, WithLockedLink, state));
        let tip = WithTool.forward_kinematics(&q) - WithLockedLink.forward_kinematics(&q);
        let jacobian = WithTool.jacobian(&q) - WithLockedLink.jacobian(&q);
        let energy = WithTool.potential_energy(&q) - WithLockedLink.potential_energy(&q);
        poses = poses
            .max(tip.amax())
            .max(jacobian.amax())
            .max(energy.abs() / 100.0);
    }
    println!("tool and locked link: dynamics {dynamics:.1e}, poses and Jacobian {poses:.1e}");
    assert!(dynamics < 1e-13 && poses < 1e-14);
    let [poses, bare] = [
        WithTool.link_poses(&states().next().unwrap()[0]),
        Bare.link_poses(&states().next().unwrap()[0]),
    ];
    assert_eq!(poses, bare, "links stay where they are");
}

/// A base turned by 90 degrees about y, and gravity turned by hand: what was up is along the base's -x.
#[test]
fn a_wall_is_gravity_along_another_axis() {
    let mut worst = 0.0_f64;
    let quarter = Matrix4::new(
        0.0, 0.0, 1.0, 0.5, //
        0.0, 1.0, 0.0, -0.25, //
        -1.0, 0.0, 0.0, 1.5, //
        0.0, 0.0, 0.0, 1.0,
    );
    for state @ [q, ..] in states() {
        worst = worst.max(largest_difference!(OnTheWall, WallByHand, state));
        let pose = OnTheWall.forward_kinematics(&q) - quarter * WallByHand.forward_kinematics(&q);
        // At the height of the base everything weighs as much more.
        let weight = OnTheWall.table().total_mass() * 9.81;
        let energy = OnTheWall.potential_energy(&q) - WallByHand.potential_energy(&q);
        worst = worst.max(pose.amax()).max((energy / weight - 1.5).abs());
    }
    println!("wall and gravity by hand: {worst:.1e}");
    assert!(worst < 1e-13);
    for (name, operations) in WallByHand::OPERATIONS {
        let (_, on_wall) = OnTheWall::OPERATIONS
            .iter()
            .find(|(other, _)| *other == name)
            .expect("every function");
        if ![
            "forward_kinematics",
            "link_poses",
            "jacobian",
            "potential_energy",
        ]
        .contains(&name)
        {
            assert_eq!(*on_wall, operations, "{name}");
        }
    }
}

/// The velocity of the tool is J qd: the difference of its poses before and after.
#[test]
fn the_jacobian_moves_the_tool() {
    let h = 1e-6;
    let mut worst = 0.0_f64;
    let cell = TiltingCell;
    for k in 0..6 {
        let sample = |at: usize| {
            SVector::<f64, 4>::from_fn(|i, _| (1.7 * (i + at) as f64 + 0.9 * k as f64).sin())
        };
        let (q, qd) = (sample(1), sample(7));
        let velocity: Vector6<f64> = cell.jacobian(&q) * qd;
        let (before, after) = (
            cell.forward_kinematics(&(q - qd * h)),
            cell.forward_kinematics(&(q + qd * h)),
        );
        let rate = (after - before) / (2.0 * h);
        let rotation = cell.forward_kinematics(&q).fixed_resize::<3, 3>(0.0);
        let spin = rate.fixed_resize::<3, 3>(0.0) * rotation.transpose();
        let linear = rate.fixed_view::<3, 1>(0, 3) - velocity.fixed_rows::<3>(0);
        let angular = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
        let angular = angular - velocity.fixed_rows::<3>(3);
        worst = worst.max(linear.amax()).max(angular.amax());
    }
    println!("J qd and differences of poses: {worst:.1e}");
    assert!(worst < 1e-8);
}

/// A load that is put down leaves the bare arm, to rounding; where it is the number 0, to the last bit
/// and operation.
#[test]
fn a_load_of_nothing_is_no_load() {
    let mut worst = 0.0_f64;
    for state @ [q, qd, qdd] in states() {
        worst = worst.max(largest_difference!(Loaded { load: 0.0 }, Bare, state));
        assert_eq!(
            Unloaded.inverse_dynamics(&q, &qd, &qdd),
            Bare.inverse_dynamics(&q, &qd, &qdd)
        );
        assert_eq!(Unloaded.mass_matrix(&q), Bare.mass_matrix(&q));
    }
    println!("a load of 0 kg: {worst:.1e}");
    assert!(worst < 1e-14);
    for ((name, unloaded), (_, bare)) in Unloaded::OPERATIONS.iter().zip(Bare::OPERATIONS) {
        if !["forward_kinematics", "jacobian"].contains(name) {
            assert_eq!(*unloaded, bare, "{name}");
        }
    }
}

/// The forces that a load adds at rest are that of its weight at its centre, by the Jacobian.
#[test]
fn a_load_is_felt_by_the_jacobian_of_its_centre() {
    let load = 2.5;
    for [q, ..] in states() {
        let (with, without) = (Loaded { load }, Loaded { load: 0.0 });
        let pose = with.forward_kinematics(&q);
        let lever = (pose * Vector3::new(0.01, -0.02, 0.05).push(0.0)).xyz();
        let weight = Vector3::new(0.0, 0.0, -9.81 * load);
        let moment = lever.cross(&weight);
        let wrench = Vector6::new(weight.x, weight.y, weight.z, moment.x, moment.y, moment.z);
        let added = with.gravity_vector(&q) - without.gravity_vector(&q);
        let by_jacobian = -(with.jacobian(&q).transpose() * wrench);
        assert!(
            (added - by_jacobian).amax() < 1e-13,
            "{added} {by_jacobian}"
        );
    }
}

/// Where the last joint is locked, the tool hangs on its link all the same.
#[test]
fn a_tool_behind_a_locked_joint() {
    let (locked, whole) = (ToolOnLocked { tilt: 0.4 }, ToolOnMoving { tilt: 0.4 });
    for [q, qd, qdd] in states() {
        let (q4, qd4, qdd4) = (q.push(0.3), qd.push(0.0), qdd.push(0.0));
        let tau = whole.inverse_dynamics(&q4, &qd4, &qdd4);
        let difference = locked.inverse_dynamics(&q, &qd, &qdd) - tau.fixed_rows::<3>(0);
        assert!(difference.amax() < 1e-13 * tau.amax());
        let tip = locked.forward_kinematics(&q) - whole.forward_kinematics(&q4);
        let energy = locked.potential_energy(&q) - whole.potential_energy(&q4);
        let jacobian: SMatrix<f64, 6, 3> = whole.jacobian(&q4).fixed_columns::<3>(0).into();
        assert!(tip.amax() < 1e-14 && energy.abs() < 1e-12);
        assert!((locked.jacobian(&q) - jacobian).amax() < 1e-14);
    }
    crate::check().run(&locked).assert_ok();
    crate::check().run(&whole).assert_ok();
}

/// Every function beside the numeric algorithms, which read base and tool on their own.
#[test]
fn arms_with_base_and_tool_agree_with_newton_euler() {
    for (load, tilt) in [(0.0, 0.0), (1.25, 0.3), (20.0, -2.0), (1e-6, 1.5)] {
        let report = crate::check().run(&TiltingCell {
            load,
            tilt,
            ..TiltingCell
        });
        println!("{report}");
        report.assert_ok();
    }
    crate::check().run(&OnTheWall).assert_ok();
    crate::check().run(&WithTool).assert_ok();
}

/// A check of the wrong load is one that fails: the numeric side reads the tool.
#[test]
fn a_wrong_tool_in_the_table_would_be_found() {
    use robot_dynamics::NewtonEuler;
    let cell = TiltingCell;
    let q = SVector::from([0.1, 0.2, 0.3, 0.4]);
    let mut table = cell.table();
    let numeric = NewtonEuler::new(&table);
    assert!((numeric.gravity_vector(&q) - cell.gravity_vector(&q)).amax() < 1e-13);
    table.tool.mass += 0.01;
    let other = NewtonEuler::new(&table);
    assert!((other.gravity_vector(&q) - cell.gravity_vector(&q)).amax() > 1e-3);
    table = cell.table();
    table.base.rpy[1] += 0.01;
    let other = NewtonEuler::new(&table);
    assert!((other.gravity_vector(&q) - cell.gravity_vector(&q)).amax() > 1e-3);
}

/// Batches are single calls, and the energy of a fall on a tilted mounting stays.
#[test]
fn batches_and_motions_know_base_and_tool() {
    let cell = TiltingCell;
    let q: Vec<_> = (0..37)
        .map(|k| SVector::<f64, 4>::from_fn(|i, _| (0.3 * (k + i) as f64).sin()))
        .collect();
    let mut forces = vec![SVector::zeros(); q.len()];
    cell.inverse_dynamics_batch(&q, &q, &q, &mut forces)
        .unwrap();
    for (q, forces) in q.iter().zip(&forces) {
        let single: SVector<f64, 4> = cell.inverse_dynamics(q, q, q);
        assert!((forces - single).amax() < 1e-13 * single.amax());
    }
    let fall = Simulation::new(&WithFieldsOnly {
        tilt: 0.4,
        load: 2.0,
    })
    .duration(1.0)
    .initial([0.3, -0.2].into(), [0.0, 0.0].into())
    .run();
    let fall = fall.expect("it falls");
    let energies = fall.q.iter().zip(&fall.qd).map(|(q, qd)| {
        let arm = WithFieldsOnly {
            tilt: 0.4,
            load: 2.0,
        };
        arm.kinetic_energy(q, qd) + arm.potential_energy(q)
    });
    let energies: Vec<f64> = energies.collect();
    let drift = energies.iter().map(|e| (e - energies[0]).abs());
    assert!(drift.fold(0.0, f64::max) < 1e-6, "{energies:?}");
}

robot_dynamics! {
    /// Nothing but a mounting, a load and two joints.
    struct WithFieldsOnly { tilt: f64, load: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, 1], rpy: [tilt, 0, 0] },
    joints: [
        turn: revolute { a: 0.5, alpha: PI/2, mass: 1, com: [-0.25, 0, 0], inertia: rod(0.5) },
        nod: revolute { a: 0.4, mass: 1, com: [-0.2, 0, 0], inertia: rod(0.4) },
    ],
    tool: { mass: load, com: [0.1, 0, 0] },
}

robot_dynamics! {
    /// An arm without the parts that hardly matter, the tool's inertia among them.
    struct Abbreviated;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { rpy: [0.3, 0, 0] },
    joints: [
        turn: revolute { a: 0.5, alpha: PI/2, mass: 10, com: [-0.25, 0, 0], inertia: rod(0.5) },
        nod: revolute { a: 0.4, mass: 5, com: [-0.2, 0, 0], inertia: rod(0.4) },
    ],
    tool: { xyz: [0, 0.01, 0.02], mass: 2, com: [0.1, 0.001, 0], inertia: sphere(0.02) },
    neglect: 2%,
}

/// The abbreviated model of an arm with base and tool is near to the complete one.
#[test]
fn what_is_neglected_of_an_arm_with_base_and_tool() {
    use robot_dynamics::NewtonEuler;
    let complete = NewtonEuler::new(&Abbreviated.table());
    let q = SVector::from([0.4, -0.7]);
    let (found, expected): (SVector<f64, 2>, _) =
        (Abbreviated.gravity_vector(&q), complete.gravity_vector(&q));
    let error = (found - expected).amax() / expected.amax();
    println!("G of the abbreviated arm is off by {:.2} %", 100.0 * error);
    assert!(error > 0.0 && error < 0.02, "{error}");
}

robot_dynamics! {
    /// Every number a field: no constant of a program is rounded.
    struct AllFields {
        gx: f64, gy: f64, gz: f64,
        bx: f64, by: f64, bz: f64, b_roll: f64, b_pitch: f64, b_yaw: f64,
        a1: f64, alpha1: f64, d1: f64, m1: f64, x1: f64, z1: f64, ixx1: f64, iyy1: f64, izz1: f64,
        a2: f64, alpha2: f64, theta2: f64, m2: f64, y2: f64, ixx2: f64, iyy2: f64, izz2: f64, iyz2: f64,
        tx: f64, ty: f64, tz: f64, t_roll: f64, t_pitch: f64, t_yaw: f64,
        mt: f64, xt: f64, yt: f64, zt: f64, ixx_t: f64, iyy_t: f64, izz_t: f64, ixy_t: f64,
    }
    convention: standard,
    gravity: [gx, gy, gz],
    base: { xyz: [bx, by, bz], rpy: [b_roll, b_pitch, b_yaw] },
    joints: [
        turn: revolute {
            a: a1, alpha: alpha1, d: d1, mass: m1, com: [x1, 0, z1],
            inertia: { xx: ixx1, yy: iyy1, zz: izz1 },
        },
        slide: prismatic {
            a: a2, alpha: alpha2, theta: theta2, mass: m2, com: [0, y2, 0],
            inertia: { xx: ixx2, yy: iyy2, zz: izz2, yz: iyz2 },
        },
    ],
    tool: {
        xyz: [tx, ty, tz], rpy: [t_roll, t_pitch, t_yaw], mass: mt, com: [xt, yt, zt],
        inertia: { xx: ixx_t, yy: iyy_t, zz: izz_t, xy: ixy_t },
    },
    functions: [mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics, forward_dynamics],
}

#[rustfmt::skip]
const ALL_FIELDS: AllFields = AllFields {
    gx: 0.7, gy: -1.3, gz: -9.7,
    bx: 0.4, by: -0.9, bz: 1.1, b_roll: 0.3, b_pitch: -1.2, b_yaw: 2.5,
    a1: 0.4, alpha1: -1.1, d1: 0.3, m1: 2.1, x1: -0.2, z1: 0.05, ixx1: 0.03, iyy1: 0.04, izz1: 0.05,
    a2: 0.2, alpha2: 0.6, theta2: 0.8, m2: 1.3, y2: 0.1, ixx2: 0.02, iyy2: 0.03, izz2: 0.04, iyz2: 0.003,
    tx: 0.1, ty: -0.05, tz: 0.2, t_roll: 0.9, t_pitch: -0.4, t_yaw: 1.7,
    mt: 1.9, xt: 0.03, yt: -0.02, zt: 0.06, ixx_t: 0.007, iyy_t: 0.008, izz_t: 0.009, ixy_t: 0.001,
};

/// Programs in 31 digits beside Newton-Euler in 31 digits, which shares no formula with them.
#[test]
fn programs_with_base_and_tool_have_31_digits() {
    use robot_dynamics::DoubleDouble;
    use testkit::exact::Exact;
    type Vector = SVector<DoubleDouble, 2>;
    let table = ALL_FIELDS.table();
    let exact = Exact(&table);
    let mut worst = 0.0_f64;
    for k in 0..8 {
        let sample = |at: usize| {
            Vector::from_fn(|i, _| {
                DoubleDouble::from((1.7 * (i + at) as f64 + 0.9 * k as f64).sin())
            })
        };
        let (q, qd, qdd) = (sample(1), sample(7), sample(13));
        let tau = exact.inverse_dynamics(&q, &qd, &qdd);
        let largest = tau.iter().map(|x| x.high().abs()).fold(0.0, f64::max);
        let mut near = |difference: Vector| {
            let error = difference
                .iter()
                .map(|x| x.high().abs())
                .fold(0.0, f64::max);
            worst = worst.max(error / largest);
        };
        near(ALL_FIELDS.inverse_dynamics(&q, &qd, &qdd) - tau);
        near(ALL_FIELDS.coriolis_vector(&q, &qd) - exact.coriolis_vector(&q, &qd));
        near(ALL_FIELDS.gravity_vector(&q) - exact.gravity_vector(&q));
        let m = ALL_FIELDS.mass_matrix(&q);
        near((m - exact.mass_matrix(&q)) * qdd);
        let found = ALL_FIELDS.forward_dynamics(&q, &qd, &tau).expect("regular");
        near(m * (found - qdd));
    }
    println!("base and tool in 31 digits: {worst:.1e}");
    assert!(worst < 1e-29);
}
