//! A quadruped: the torques of its legs for a motion of its trunk and given forces on its feet.
//!
//! `cargo run --release --example quadruped`

use robot_dynamics::layouts::Pinocchio;
use robot_dynamics::nalgebra::{Rotation3, SVector, Vector3, Vector6};
use robot_dynamics::{Pose, check_against_rnea, robot_dynamics};

robot_dynamics! {
    /// A trunk of 40 kg on four legs of three joints: the hip turns outwards about x, then hip and knee turn about y.
    struct Quadruped;

    let reach = 0.35;
    let side = 0.2;
    let length = 0.35;
    convention: modified,
    gravity: [0, 0, -9.81],
    base: floating { mass: 40, com: [0.02, 0, 0.03], inertia: cuboid(0.9, 0.4, 0.3) },
    joints: [
        lf_out: revolute { on: base, at: { xyz: [reach, side, 0], rpy: [0, PI/2, 0] }, mass: 2 },
        lf_hip: revolute { alpha: -PI/2, mass: 3, com: [0.15, 0, 0], inertia: rod(length) },
        lf_knee: revolute { a: length, mass: 1, com: [0.12, 0, 0], inertia: rod(length) },
        rf_out: revolute { on: base, at: { xyz: [reach, -side, 0], rpy: [0, PI/2, 0] }, mass: 2 },
        rf_hip: revolute { alpha: -PI/2, mass: 3, com: [0.15, 0, 0], inertia: rod(length) },
        rf_knee: revolute { a: length, mass: 1, com: [0.12, 0, 0], inertia: rod(length) },
        lh_out: revolute { on: base, at: { xyz: [-reach, side, 0], rpy: [0, PI/2, 0] }, mass: 2 },
        lh_hip: revolute { alpha: -PI/2, mass: 3, com: [0.15, 0, 0], inertia: rod(length) },
        lh_knee: revolute { a: length, mass: 1, com: [0.12, 0, 0], inertia: rod(length) },
        rh_out: revolute { on: base, at: { xyz: [-reach, -side, 0], rpy: [0, PI/2, 0] }, mass: 2 },
        rh_hip: revolute { alpha: -PI/2, mass: 3, com: [0.15, 0, 0], inertia: rod(length) },
        rh_knee: revolute { a: length, mass: 1, com: [0.12, 0, 0], inertia: rod(length) },
    ],
    frames: {
        lf: { on: lf_knee, xyz: [length, 0, 0] },
        rf: { on: rf_knee, xyz: [length, 0, 0] },
        lh: { on: lh_knee, xyz: [length, 0, 0] },
        rh: { on: rh_knee, xyz: [length, 0, 0] },
    },
    functions: [
        default, forward_kinematics(lf), center_of_mass,
        feet = (wrench_torques(lf), wrench_torques(rf), wrench_torques(lh), wrench_torques(rh)),
    ],
}

fn main() {
    check_against_rnea(&Quadruped).assert_ok();

    // All legs bent alike, the trunk level.
    let leg = [0.0, 0.6, -1.2];
    let q = SVector::<f64, 12>::from_fn(|i, _| leg[i % 3]);
    let base = Pose {
        rotation: Rotation3::identity().into_inner(),
        position: Vector3::new(0.0, 0.0, 0.58),
    };
    let foot = Quadruped.forward_kinematics_lf(&base, &q);
    println!("left front foot at z = {:.3} m", foot[(2, 3)]);

    // The trunk is lifted by 2 m/s^2. Four equal forces carry weight and acceleration.
    let rest = SVector::<f64, 18>::zeros();
    let mut a = rest;
    a[2] = 2.0;
    let lift = Quadruped.inverse_dynamics(&base, &q, &rest, &a);
    let quarter = Vector6::new(0.0, 0.0, lift[2] / 4.0, 0.0, 0.0, 0.0);
    let (lf, rf, lh, rh) = Quadruped.feet(&base, &q, &quarter);
    let tau = lift - (lf + rf + lh + rh);
    println!("each foot pushes with {:.1} N", quarter[2]);
    println!(
        "force that the base lacks: {:.1e} N",
        tau.fixed_rows::<3>(0).amax()
    );
    // The centre of mass is ahead of the middle of the feet: they would have to push differently.
    println!("moment that the base lacks: {:.2} N m about y", tau[4]);
    println!(
        "torques of the left front leg: {:.2?} N m",
        [tau[6], tau[7], tau[8]]
    );

    // The same state as Pinocchio has it: xyz, quaternion xyzw, the joints by the alphabet.
    let mut names = Quadruped::JOINT_NAMES;
    names.sort_unstable();
    let layout = Pinocchio::new(&Quadruped::JOINT_NAMES, &names).expect("the same names");
    let theirs: SVector<f64, 19> = layout.position(&base, &q);
    println!("q of Pinocchio: {:.2?}", &theirs.as_slice()[..10]);
    assert!(tau.fixed_rows::<3>(0).amax() < 1e-10);
}
