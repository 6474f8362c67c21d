//! Numbers computed by hand, ways there and back, and what stays the same.

use dynamics_runtime::Pose;
use dynamics_runtime::internal::quaternion;
use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3};
use tables::{random_pose, random_state};

use super::library::{DrakeRules, MuJoCoRules, PinocchioRules, RbdlRules};
use super::{Layout, Library, Pinocchio, WrongJoint};

const OURS: [&str; 3] = ["hip", "knee", "ankle"];
const THEIRS: [&str; 3] = ["ankle", "hip", "knee"];

type Nine = SVector<f64, 9>;

/// Turned left by a right angle: x is the y of the world.
fn turned() -> Pose<f64> {
    Pose {
        rotation: Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0),
        position: Vector3::new(0.1, 0.2, 0.3),
    }
}

fn nine(numbers: [f64; 9]) -> Nine {
    SVector::from(numbers)
}

/// The numbers of a library at the turned base, for the same motion.
struct Expected {
    position: [f64; 10],
    velocity: [f64; 9],
    acceleration: [f64; 9],
    /// The diagonal of the mass matrix whose diagonal here is 1 to 9.
    masses: [f64; 9],
}

fn check<L: Library>(expected: Expected) {
    let (layout, base) = (Layout::<L, 3>::new(&OURS, &THEIRS).unwrap(), turned());
    let q = SVector::from([1.0, 2.0, 3.0]);
    let found: SVector<f64, 10> = layout.position(&base, &q);
    assert!(
        (found - SVector::from(expected.position)).amax() < 1e-15,
        "{found}"
    );
    let v = nine([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 13.0, 14.0, 15.0]);
    assert_eq!(layout.velocity(&base, &v), nine(expected.velocity));
    assert_eq!(layout.force(&base, &v), nine(expected.velocity));
    // w x v = (3, -6, 3).
    let a = nine([7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 16.0, 17.0, 18.0]);
    let found = layout.acceleration(&base, &v, &a);
    assert_eq!(found, nine(expected.acceleration));
    let masses = SMatrix::from_diagonal(&nine([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]));
    let found = layout.mass_matrix(&base, &masses);
    assert_eq!(found, SMatrix::from_diagonal(&nine(expected.masses)));
}

#[test]
fn pinocchio() {
    let h = 0.5_f64.sqrt();
    check::<PinocchioRules>(Expected {
        position: [0.1, 0.2, 0.3, 0.0, 0.0, h, h, 3.0, 1.0, 2.0],
        velocity: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 15.0, 13.0, 14.0],
        acceleration: [7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 18.0, 16.0, 17.0],
        masses: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 9.0, 7.0, 8.0],
    });
}

#[test]
fn mujoco() {
    let h = 0.5_f64.sqrt();
    check::<MuJoCoRules>(Expected {
        position: [0.1, 0.2, 0.3, h, 0.0, 0.0, h, 3.0, 1.0, 2.0],
        velocity: [-2.0, 1.0, 3.0, 4.0, 5.0, 6.0, 15.0, 13.0, 14.0],
        acceleration: [-2.0, 10.0, 12.0, 10.0, 11.0, 12.0, 18.0, 16.0, 17.0],
        masses: [2.0, 1.0, 3.0, 4.0, 5.0, 6.0, 9.0, 7.0, 8.0],
    });
}

#[test]
fn drake() {
    let h = 0.5_f64.sqrt();
    check::<DrakeRules>(Expected {
        position: [h, 0.0, 0.0, h, 0.1, 0.2, 0.3, 3.0, 1.0, 2.0],
        velocity: [-5.0, 4.0, 6.0, -2.0, 1.0, 3.0, 15.0, 13.0, 14.0],
        acceleration: [-11.0, 10.0, 12.0, -2.0, 10.0, 12.0, 18.0, 16.0, 17.0],
        masses: [5.0, 4.0, 6.0, 2.0, 1.0, 3.0, 9.0, 7.0, 8.0],
    });
}

#[test]
fn rbdl() {
    let h = 0.5_f64.sqrt();
    check::<RbdlRules>(Expected {
        position: [0.1, 0.2, 0.3, 0.0, 0.0, h, 3.0, 1.0, 2.0, h],
        velocity: [-2.0, 1.0, 3.0, 4.0, 5.0, 6.0, 15.0, 13.0, 14.0],
        acceleration: [-2.0, 10.0, 12.0, 10.0, 11.0, 12.0, 18.0, 16.0, 17.0],
        masses: [2.0, 1.0, 3.0, 4.0, 5.0, 6.0, 9.0, 7.0, 8.0],
    });
}

/// There and back, power, energy, and the rate of the velocity along a motion.
fn identities<L: Library>() {
    let layout = Layout::<L, 3>::new(&OURS, &THEIRS).unwrap();
    for seed in 1..=50 {
        let base = random_pose(seed);
        let state = random_state::<9>(seed);
        let (v, a, f) = (state.q, state.qd, state.qdd);
        let q = SVector::from([v[0], a[0], f[0]]);
        let near = |found: Nine, expected: Nine| {
            let error = (found - expected).amax();
            assert!(error < 1e-14 * (1.0 + expected.amax()), "{error:e}");
        };

        let theirs: SVector<f64, 10> = layout.position(&base, &q);
        let (same, positions) = layout.from_position(&(theirs * 2.0));
        assert!((same.rotation - base.rotation).amax() < 1e-15);
        assert!(positions == q * 2.0 && same.position == base.position * 2.0);

        let (of_v, of_f) = (layout.velocity(&base, &v), layout.force(&base, &f));
        let of_a = layout.acceleration(&base, &v, &a);
        near(layout.from_velocity(&base, &of_v), v);
        near(layout.from_force(&base, &of_f), f);
        near(layout.from_acceleration(&base, &v, &of_a), a);
        assert!((of_v.dot(&of_f) - v.dot(&f)).abs() < 1e-12);

        let m = SMatrix::<f64, 9, 9>::from_fn(|i, j| (i * j + 1) as f64 + (i + j) as f64 * 0.1);
        let of_m = layout.mass_matrix(&base, &m);
        assert!((of_v.dot(&(of_m * of_v)) - v.dot(&(m * v))).abs() < 1e-10);
        near(of_m * of_v, layout.force(&base, &(m * v)));
        assert!((layout.from_mass_matrix(&base, &of_m) - m).amax() < 1e-12);
        let jacobian = SMatrix::<f64, 6, 9>::from_fn(|i, j| (3 * i) as f64 - (j * j) as f64);
        let of_jacobian = layout.jacobian(&base, &jacobian);
        assert!((of_jacobian * of_v - jacobian * v).amax() < 1e-11);
        assert!((layout.from_jacobian(&base, &of_jacobian) - jacobian).amax() < 1e-12);

        let later = |t: f64| {
            let turn = Rotation3::new(v.fixed_rows::<3>(3) * t).into_inner();
            let rotation = base.rotation * turn;
            layout.velocity(&Pose { rotation, ..base }, &(v + a * t))
        };
        let rate = (later(1e-5) - later(-1e-5)) / 2e-5;
        assert!((rate - of_a).amax() < 1e-7, "{rate} {of_a}");
    }
}

#[test]
fn there_and_back() {
    identities::<PinocchioRules>();
    identities::<MuJoCoRules>();
    identities::<DrakeRules>();
    identities::<RbdlRules>();
}

/// Half turns have no w to divide by.
#[test]
fn quaternions_of_half_turns() {
    for (k, diagonal) in [[1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
        .iter()
        .enumerate()
    {
        let half = Matrix3::from_diagonal(&Vector3::from(*diagonal));
        let mut expected = [0.0; 4];
        expected[1 + k] = 1.0;
        assert_eq!(quaternion::of(&half), expected);
        assert_eq!(quaternion::rotation(&expected), half);
    }
    assert_eq!(quaternion::of(&Matrix3::identity()), [1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn a_joint_that_is_not_there_is_named() {
    let missing = Pinocchio::new(&OURS, &["hip", "knee", "toe"]).unwrap_err();
    assert_eq!(missing, WrongJoint::Missing("ankle"));
    assert_eq!(
        missing.to_string(),
        "joint `ankle` is not among the names of the library"
    );
    let v = nine([1.0; 9]);
    assert_eq!(Pinocchio::<3>::in_order().velocity(&turned(), &v), v);
}

/// Each joint of the robot has a place of its own: a name that stands twice, here or there, would lose another one.
#[test]
fn a_joint_that_stands_twice_is_named() {
    let wrong = |ours, theirs| Pinocchio::new(&ours, &theirs).unwrap_err();
    let twice = wrong(["hip", "knee", "hip"], ["hip", "knee", "ankle"]);
    assert_eq!(twice, WrongJoint::Twice("hip"));
    assert_eq!(
        twice.to_string(),
        "joint `hip` stands twice among the names of the robot"
    );
    let lost = wrong(OURS, ["hip", "hip", "knee"]);
    assert_eq!(lost, WrongJoint::Missing("ankle"));
    let both = wrong(["hip", "hip", "knee"], ["hip", "hip", "knee"]);
    assert_eq!(both, WrongJoint::Twice("hip"));
}

/// Squares of numbers below 1e-154 are none, and those above 1e154 are infinite.
#[test]
fn quaternions_have_any_length() {
    let direction = [0.5, -0.1, 0.7, 0.5];
    let expected = quaternion::rotation(&direction);
    for length in [
        1e-310, 1e-300, 1e-200, 1e-155, 1e-150, 10.0, 1e150, 1e155, 1e200, 1e307,
    ] {
        let found = quaternion::rotation(&direction.map(|x| x * length));
        // Below 1e-308 numbers have fewer digits.
        let digits = 5e-324 / length;
        let error = (found - expected).amax();
        assert!(error <= 4e-16 + 8.0 * digits, "{length:e}: {error:e}");
    }
    let of_one = quaternion::rotation(&[0.0, 0.0, 5e-324, 0.0]);
    assert_eq!(
        of_one,
        Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, -1.0))
    );
    let theirs = SVector::from([0.1, 0.2, 0.3, 0.0, 0.0, 1e-200, 1e-200, 0.0, 0.0, 0.0]);
    let (base, _) = Pinocchio::<3>::in_order().from_position(&theirs);
    assert!((base.rotation - turned().rotation).amax() < 4e-16);
    let (long, _) = Pinocchio::<3>::in_order().from_position(&(theirs * 1e300 * 1e60));
    assert!((long.rotation - turned().rotation).amax() < 4e-16);
    assert!(quaternion::rotation(&[0.0; 4]).iter().all(|x| x.is_nan()));
}
