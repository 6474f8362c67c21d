//! Joints that are locked: beside the whole arm held still there, and beside Newton and Euler.

use robot_dynamics::nalgebra::{SMatrix, SVector};

/// Six joints of every kind; after it the macro that makes the arm, its name, more fields of its struct and entries.
macro_rules! arm {
    ($made_by:path: $name:ident { $($field:ident),* } $convention:ident, $($entries:tt)*) => {
        $made_by! {
            struct $name { $($field: f64,)* m: f64 }
            convention: $convention,
            gravity: [1, -2, -9.81],
            joints: [
                waist: revolute {
                    d: 0.67, alpha: PI/2, mass: 2, com: [0.1, 0.2, -0.1],
                    inertia: { xx: 0.3, yy: 0.35, zz: 0.2, xy: 0.01, xz: -0.02, yz: 0.03 },
                    motor: { inertia: 2e-4, gear_ratio: -62 },
                    friction: { viscous: 1.5, coulomb: 0.4 },
                },
                shoulder: revolute {
                    a: 0.43, mass: m, com: [-0.36, 0.006, 0.23],
                    inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
                    friction: { viscous: 0.8 },
                },
                slide: prismatic {
                    a: 0.02, d: 0.15, theta: 0.2, alpha: -PI/2, mass: 4.8, com: [-0.02, -0.014, 0.07],
                    inertia: { xx: 0.066, yy: 0.086, zz: 0.05, yz: 0.01 },
                    motor: { inertia: 1e-4, gear_ratio: 50 },
                    limits: [-1, 1],
                },
                roll: revolute {
                    d: 0.43, alpha: 0.7, theta: -0.3, mass: 0.82, com: [0, 0.019, 0.02],
                    inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
                    motor: { inertia: 3e-5, gear_ratio: 76 },
                    friction: { coulomb: 0.1 },
                },
                pitch: revolute {
                    a: 0.05, alpha: -PI/2, mass: 0.34, com: [0.01, 0, 0.03],
                    inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
                },
                yaw: revolute {
                    d: 0.1, mass: 0.09, com: [0, 0.01, 0.032],
                    inertia: { xx: 0.00015, yy: 0.00015, zz: 0.00004 },
                },
            ],
            $($entries)*
        }
    };
}

macro_rules! whole {
    ($name:ident $convention:ident) => {
        arm!(
            robot_dynamics::robot_dynamics: $name {} $convention,
            // The functions in which the locked arms are compared.
            functions: [
                mass_matrix, inverse_dynamics, coriolis_matrix, kinetic_energy, gravity_vector, potential_energy,
                forward_kinematics, link_poses, jacobian,
            ],
        );
    };
}
whole!(Whole standard);
whole!(WholeCraig modified);

macro_rules! locked {
    ($($arm:tt)*) => {
        arm!(robots::every_function: $($arm)*);
    };
}
locked!(WithoutWrist {} standard, lock: [roll = 0.3, pitch = deg(-90), yaw = 1.1],);
locked!(OddOnes { slid } standard, lock: [slide = slid, waist = -0.4, pitch = 0],);
locked!(CraigOnes { turned } modified, lock: [shoulder = turned, slide = 0.25],);
locked!(CraigWrist {} modified, lock: [waist = PI/3, yaw = -2, pitch = 0.5],);

/// The functions of an arm some of whose joints are locked are those of the whole arm at rest there.
macro_rules! agrees {
    ($locked:expr, $n:literal, $whole:expr, $moving:expr, $positions:expr) => {{
        let (locked, whole) = ($locked, $whole);
        let (moving, positions): ([usize; $n], [f64; 6]) = ($moving, $positions);
        let place = |x: &SVector<f64, $n>, rest: [f64; 6]| {
            let mut all = SVector::from(rest);
            for (k, &i) in moving.iter().enumerate() {
                all[i] = x[k];
            }
            all
        };
        let pick = |x: SVector<f64, 6>| SVector::<f64, $n>::from_fn(|k, _| x[moving[k]]);
        let block = |m: SMatrix<f64, 6, 6>| {
            SMatrix::<f64, $n, $n>::from_fn(|i, j| m[(moving[i], moving[j])])
        };
        for k in 0..5 {
            let sample = |at: usize| {
                SVector::<f64, $n>::from_fn(|i, _| (1.7 * (i + at) as f64 + k as f64).sin())
            };
            let (q, qd, qdd) = (sample(1), sample(7), sample(13));
            let (all_q, all_qd) = (place(&q, positions), place(&qd, [0.0; 6]));
            let all_qdd = place(&qdd, [0.0; 6]);
            let near = |error: f64, size: f64| assert!(error <= 1e-13 * size, "{error:e}");

            let m = block(whole.mass_matrix(&all_q));
            near((locked.mass_matrix(&q) - m).amax(), m.amax());
            let tau = pick(whole.inverse_dynamics(&all_q, &all_qd, &all_qdd));
            near(
                (locked.inverse_dynamics(&q, &qd, &qdd) - tau).amax(),
                tau.amax(),
            );
            let c = block(whole.coriolis_matrix(&all_q, &all_qd));
            near((locked.coriolis_matrix(&q, &qd) - c).amax(), m.amax());
            let energy = whole.kinetic_energy(&all_q, &all_qd);
            near((locked.kinetic_energy(&q, &qd) - energy).abs(), energy);
            let g = pick(whole.gravity_vector(&all_q));
            near((locked.gravity_vector(&q) - g).amax(), g.amax());
            let zero = SVector::zeros();
            let u = locked.potential_energy(&q) - locked.potential_energy(&zero);
            let rise =
                whole.potential_energy(&all_q) - whole.potential_energy(&place(&zero, positions));
            near((u - rise).abs(), 100.0);

            let tip = whole.forward_kinematics(&all_q);
            near((locked.forward_kinematics(&q) - tip).amax(), 2.0);
            let (poses, whole_poses) = (locked.link_poses(&q), whole.link_poses(&all_q));
            for (pose, &i) in poses.iter().zip(&moving) {
                near((pose - whole_poses[i]).amax(), 2.0);
            }
            let (jacobian, columns) = (locked.jacobian(&q), whole.jacobian(&all_q));
            for (k, &i) in moving.iter().enumerate() {
                near((jacobian.column(k) - columns.column(i)).amax(), 2.0);
            }
            for solution in [
                locked.forward_dynamics(&q, &qd, &tau),
                locked.forward_dynamics_aba(&q, &qd, &tau),
            ] {
                near((solution.expect("regular") - qdd).amax(), 100.0);
            }
        }
        let report = crate::check().run(&locked);
        println!("{report}");
        report.assert_ok();
    }};
}

const M: f64 = 17.4;

#[test]
fn an_arm_without_its_wrist() {
    assert_eq!(WithoutWrist::DOF, 3);
    assert_eq!(WithoutWrist::JOINT_NAMES, ["waist", "shoulder", "slide"]);
    let positions = [0.0, 0.0, 0.0, 0.3, -std::f64::consts::FRAC_PI_2, 1.1];
    agrees!(
        WithoutWrist { m: M },
        3,
        Whole { m: M },
        [0, 1, 2],
        positions
    );
}

#[test]
fn locked_joints_at_the_base_in_the_middle_and_at_a_parameter() {
    let positions = [-0.4, 0.0, 0.55, 0.0, 0.0, 0.0];
    let arm = OddOnes { m: M, slid: 0.55 };
    agrees!(arm, 3, Whole { m: M }, [1, 3, 5], positions);
}

#[test]
fn locked_joints_of_modified_tables() {
    let positions = [0.0, -0.8, 0.25, 0.0, 0.0, 0.0];
    let arm = CraigOnes { m: M, turned: -0.8 };
    agrees!(arm, 4, WholeCraig { m: M }, [0, 3, 4, 5], positions);
    let positions = [std::f64::consts::FRAC_PI_3, 0.0, 0.0, 0.0, 0.5, -2.0];
    agrees!(
        CraigWrist { m: M },
        3,
        WholeCraig { m: M },
        [1, 2, 3],
        positions
    );
}

/// A locked joint costs nothing.
#[test]
fn an_arm_without_its_wrist_is_as_short_as_one_of_three_joints() {
    let total = |of: &[(&str, robot_dynamics::Operations)], name: &str| {
        let (_, operations) = of.iter().find(|(function, _)| *function == name).unwrap();
        operations.multiplications + operations.additions + operations.divisions
    };
    let locked = total(&WithoutWrist::OPERATIONS, "inverse_dynamics");
    let whole = total(&Whole::OPERATIONS, "inverse_dynamics");
    assert!(3 * locked < whole, "{locked} of {whole}");
}
