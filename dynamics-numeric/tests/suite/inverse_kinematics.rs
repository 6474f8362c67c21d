//! Numeric inverse kinematics: arms, trees, frames, limits, and why searches end.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use allocation_counter::measure;
use robot_dynamics::inverse_kinematics::{InverseKinematics, NotReached, Reason, Target};
use robot_dynamics::nalgebra::{
    Const, DVector, Dyn, Matrix4, SVector, Unit, UnitQuaternion, Vector3,
};
use robot_dynamics::table::{Convention, JointType, Row, Table};
use robot_dynamics::{
    Kinematics, Model, NewtonEuler, NumericArm, RuntimeTable, SizedKinematics as _, robot_dynamics,
};

robot_dynamics! {
    /// The PUMA 560 by its lengths, with its limits.
    struct Puma;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { limits: [deg(-160), deg(160)] },
        two: revolute { alpha: -PI/2, limits: [deg(-225), deg(45)] },
        three: revolute { a: 0.4318, d: 0.15005, limits: [deg(-45), deg(225)] },
        four: revolute { a: 0.0203, alpha: -PI/2, d: 0.4318, limits: [deg(-110), deg(170)] },
        five: revolute { alpha: PI/2, limits: [deg(-100), deg(100)] },
        six: revolute { alpha: -PI/2, limits: [deg(-266), deg(266)] },
    ],
    functions: [forward_kinematics, jacobian],
}

robot_dynamics! {
    /// Seven joints, as the Panda's.
    struct Seven;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { d: 0.333, limits: [-2.8973, 2.8973] },
        two: revolute { alpha: -PI/2, limits: [-1.7628, 1.7628] },
        three: revolute { alpha: PI/2, d: 0.316, limits: [-2.8973, 2.8973] },
        four: revolute { a: 0.0825, alpha: PI/2, limits: [-3.0718, -0.0698] },
        five: revolute { a: -0.0825, alpha: -PI/2, d: 0.384, limits: [-2.8973, 2.8973] },
        six: revolute { alpha: PI/2, limits: [-0.0175, 3.7525] },
        seven: revolute { a: 0.088, alpha: PI/2, limits: [-2.8973, 2.8973] },
    ],
    functions: [forward_kinematics, jacobian],
}

robot_dynamics! {
    /// Two arms on a waist, which slides up too.
    struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        lift: prismatic { limits: [0, 0.5] },
        waist: revolute {},
        left_shoulder: revolute { on: waist, gamma: PI/2, b: 0.4, a: 0.2, alpha: PI/2 },
        left_elbow: revolute { a: 0.3 },
        right_shoulder: revolute { on: waist, gamma: -PI/2, b: 0.4, a: 0.2, alpha: PI/2 },
        right_elbow: revolute { a: 0.3 },
    ],
    frames: {
        left_hand: { on: left_elbow, xyz: [0.3, 0, 0] },
        right_hand: { on: right_elbow, xyz: [0.3, 0, 0] },
    },
    functions: [
        left = (forward_kinematics(left_hand), jacobian(left_hand)),
        right = (forward_kinematics(right_hand), jacobian(right_hand)),
    ],
}

robot_dynamics! {
    /// A palletiser: the hand stays level, because the wrist follows elbow and shoulder.
    struct Level;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {},
        shoulder: revolute { alpha: PI/2, a: 0.2, limits: [-1.5, 1.5] },
        elbow: revolute { a: 0.6 },
        wrist: revolute { a: 0.5 },
    ],
    couple: [wrist = -elbow],
    tool: { xyz: [0.1, 0, 0] },
    functions: [forward_kinematics, jacobian],
}

/// Positions within the limits, or within a turn, which are the same in each run.
fn positions<const N: usize>(limits: &[Option<[f64; 2]>; N], count: usize) -> Vec<SVector<f64, N>> {
    let mut state = 0.5_f64;
    let mut next = move || {
        // The fractional parts of multiples of the golden ratio.
        state = (state + 0.618_033_988_749_894_9).fract();
        state
    };
    let within = |limits: Option<[f64; 2]>, share: f64| {
        let [low, high] = limits.unwrap_or([-PI, PI]);
        low + (high - low) * share
    };
    let position = |_| SVector::from_fn(|joint, _| within(limits[joint], next()));
    (0..count).map(position).collect()
}

/// Rotations and positions of two poses differ by less.
fn is_near(a: &Matrix4<f64>, b: &Matrix4<f64>, error: f64) -> bool {
    (a - b).amax() < error
}

fn reaches_all<R: Kinematics<N> + Model<N>, const N: usize>(robot: &R, count: usize) -> usize {
    let limits = robot.table().joint_limits();
    let solver = InverseKinematics::new(robot);
    let mut attempts = 0;
    for q in positions(&limits, count) {
        let pose = robot.forward_kinematics(&q);
        let found = solver.solve(&pose, &SVector::zeros()).unwrap();
        assert!(is_near(&robot.forward_kinematics(&found.q), &pose, 3e-9));
        for (limits, q) in limits.iter().zip(&found.q) {
            assert!(limits.is_none_or(|[low, high]| (low..=high).contains(&*q)));
        }
        attempts += found.attempts;
    }
    attempts
}

#[test]
fn poses_within_limits_are_reached() {
    assert!(reaches_all(&Puma, 300) < 5 * 300);
    assert!(reaches_all(&Seven, 300) < 3 * 300);
    assert!(reaches_all(&Level, 100) < 3 * 100);
}

/// A number between two ends, the next one of a sequence (S. Vigna's SplitMix64).
fn drawn(state: &mut u64, [low, high]: [f64; 2]) -> f64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut bits = *state;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    let share = ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64;
    low + (high - low) * share
}

/// The poses that are missed of so many reachable ones, of arms whose lengths and angles are random. Joints stop before a
/// whole turn.
fn missed<const N: usize>(arms: usize, poses: usize) -> usize {
    const LIMITS: [f64; 2] = [-2.9, 2.9];
    let mut state = N as u64;
    let mut missed = 0;
    for _ in 0..arms {
        let rows = [(); N].map(|()| Row {
            a: drawn(&mut state, [-0.4, 0.4]),
            d: drawn(&mut state, [-0.4, 0.4]),
            alpha: drawn(&mut state, [-3.0, 3.0]),
            limits: Some(LIMITS),
            ..Row::new(JointType::Revolute)
        });
        let table = Table::new(Convention::Standard, [0.0; 3], rows);
        let arm = NewtonEuler::new(&table);
        let solver = InverseKinematics::new(&arm);
        for _ in 0..poses {
            let q = SVector::<f64, N>::from_fn(|_, _| drawn(&mut state, LIMITS));
            let pose = arm.tip_pose(&q);
            missed += usize::from(solver.solve(&pose, &SVector::zeros()).is_err());
        }
    }
    missed
}

/// It was 52 of 10,000 where each descent kept to the limits.
#[test]
fn poses_of_general_arms_are_seldom_missed() {
    let [six, seven] = [missed::<6>(100, 100), missed::<7>(100, 100)];
    println!("missed of 10,000: {six} by six joints, {seven} by seven");
    assert!(six <= 3 && seven <= 1, "{six} {seven}");
}

/// Joints of another limb stay where they are, so that each solution is found once.
#[test]
fn other_limbs_stay_where_they_are() {
    let solver = InverseKinematics::of_frames(&Torso, [|q: &_| Torso.left(q)]);
    let start = SVector::from([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    let target = Torso
        .left(&SVector::from([0.2, -0.4, 0.9, -1.1, 0.0, 0.0]))
        .0;
    let limits = [Some([0.2, 0.2]), None, None, None, None, None];
    let solver = solver.limits(limits);
    let found = solver.solutions(&[(&target).into()], &start, 64).unwrap();
    for found in &found {
        assert_eq!((found.q[4], found.q[5]), (0.5, 0.6));
    }
    assert!(found.len() <= 4, "{}", found.len());
}

/// A table alone, with the number of joints known to the compiler and at run time.
#[test]
fn numeric_arms_find_the_same() {
    let table = Puma.table();
    let fixed = NewtonEuler::new(&table);
    let dynamic = NumericArm::<Dyn>::new(&RuntimeTable::from(&table));
    let q = SVector::from([0.3, -1.0, 0.7, 0.2, 0.5, -0.4]);
    let pose = Puma.forward_kinematics(&q);
    let start = SVector::from([0.1, -0.8, 0.5, 0.0, 0.3, 0.0]);
    let found = InverseKinematics::new(&fixed).solve(&pose, &start).unwrap();
    let at_run_time = InverseKinematics::new(&dynamic)
        .solve(&pose, &DVector::from_column_slice(start.as_slice()));
    assert!((found.q - q).amax() < 1e-8);
    assert_eq!(found.q.as_slice(), at_run_time.unwrap().q.as_slice());
}

#[test]
fn two_hands_reach_together() {
    let hands: [&dyn Fn(&SVector<f64, 6>) -> _; 2] = [&|q| Torso.left(q), &|q| Torso.right(q)];
    let solver = InverseKinematics::of_frames(&Torso, hands);
    for q in positions(&Torso.table().joint_limits(), 50) {
        let targets = [Torso.left(&q).0, Torso.right(&q).0].map(|pose| Target::pose(&pose));
        let found = solver.solve_all(&targets, &SVector::zeros()).unwrap();
        let residual = solver.residual(&targets, &found.q);
        assert!(residual == found.residual && residual.position < 1e-9 && residual.rotation < 1e-9);
    }
    // Hands that are farther apart than both arms reach: what weighs more is nearer.
    let at = |x: f64| Target::position(Vector3::new(x, 0.0, 0.2));
    let missing = |weight: f64| {
        let targets = [at(2.0).weights(weight, 1.0), at(-2.0)];
        let error = solver
            .solve_all(&targets, &SVector::from([0.0, 0.1, 0.2, 0.3, 0.4, 0.5]))
            .unwrap_err();
        (Torso.left(&error.q).0[(0, 3)] - 2.0).abs()
    };
    assert!(missing(10.0) < missing(0.1) - 1e-3);
}

#[test]
fn positions_and_directions_alone_are_reached() {
    let solver = InverseKinematics::new(&Seven);
    for q in positions(&Seven.table().joint_limits(), 100) {
        let pose = Seven.forward_kinematics(&q);
        let origin = Vector3::new(pose[(0, 3)], pose[(1, 3)], pose[(2, 3)]);
        let axis = Vector3::new(0.0, 0.6, 0.8);
        let direction = pose.fixed_view::<3, 3>(0, 0) * axis;
        let tip = |target: Target| {
            let found = solver.solve(target, &SVector::zeros()).unwrap();
            Seven.forward_kinematics(&found.q)
        };
        let place = |pose: &Matrix4<f64>| Vector3::new(pose[(0, 3)], pose[(1, 3)], pose[(2, 3)]);
        assert!((place(&tip(Target::position(origin))) - origin).norm() < 1e-9);
        let found = tip(Target::pointing(axis * 2.0, direction * 3.0).at(origin));
        assert!((place(&found) - origin).norm() < 1e-9);
        assert!((found.fixed_view::<3, 3>(0, 0) * axis - direction).norm() < 1.1e-9);
        let found = tip(Target::rotation(pose.fixed_view::<3, 3>(0, 0).into_owned()));
        assert!((found - pose).fixed_view::<3, 3>(0, 0).amax() < 1.1e-9);
    }
}

/// Half a turn away, where the axis of the missing turn is any.
#[test]
fn half_turns_are_made() {
    let solver = InverseKinematics::new(&Puma);
    let start = SVector::from([0.2, -1.0, 0.5, 0.1, 0.4, 0.3]);
    for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), PI);
        let rotation = Puma
            .forward_kinematics(&start)
            .fixed_view::<3, 3>(0, 0)
            .into_owned();
        let target = Target::rotation(turn.to_rotation_matrix() * rotation);
        assert!(solver.solve(target, &start).is_ok());
        let direction = rotation * axis;
        assert!(
            solver
                .solve(Target::pointing(axis, -direction), &start)
                .is_ok()
        );
    }
}

/// The posture that is nearest to the middle of the limits, among those with one pose of the hand.
#[test]
fn the_null_space_has_an_aim() {
    let middle = SVector::<f64, 7>::from_fn(|joint, _| {
        let [low, high] = Seven.table().rows[joint].limits.unwrap();
        0.5 * (low + high)
    });
    let aimed = InverseKinematics::new(&Seven).posture(middle);
    for q in positions(&Seven.table().joint_limits(), 30) {
        let pose = Seven.forward_kinematics(&q);
        let plain = InverseKinematics::new(&Seven).solve(&pose, &q).unwrap();
        let found = aimed.solve(&pose, &q).unwrap();
        assert!(is_near(&Seven.forward_kinematics(&found.q), &pose, 3e-9));
        let far = |q: &SVector<f64, 7>| (q - middle).norm();
        assert!(far(&found.q) <= far(&plain.q) + 1e-12);
        // Along the freedom that is left the distance no longer falls, unless a joint is on its limit.
        let free = Seven.jacobian(&found.q).svd(false, true).v_t.unwrap();
        let rows = free.transpose() * free;
        let along = (middle - found.q) - rows * (middle - found.q);
        let on_limit = (0..7).any(|joint| {
            let [low, high] = Seven.table().rows[joint].limits.unwrap();
            found.q[joint] == low || found.q[joint] == high
        });
        // Nearly singular poses leave two freedoms, of which one is all but one.
        let least = Seven
            .jacobian(&found.q)
            .svd(false, false)
            .singular_values
            .min();
        assert!(on_limit || least < 0.01 || along.amax() < 1e-3, "{along}");
    }
}

/// Where the arm is stretched, and where its wrist is singular.
#[test]
fn singular_poses_are_reached() {
    let solver = InverseKinematics::new(&Puma);
    for q in [
        SVector::from([0.3, -0.4, 0.7, 0.2, 0.0, -0.4]),
        SVector::from([0.3, -0.4, FRAC_PI_2 + 0.0470, 0.2, 0.5, -0.4]),
        SVector::zeros(),
    ] {
        let pose = Puma.forward_kinematics(&q);
        let start = q + SVector::repeat(0.2);
        let found = solver.solve(&pose, &start).unwrap();
        assert!(is_near(&Puma.forward_kinematics(&found.q), &pose, 3e-9));
    }
}

#[test]
fn the_eight_solutions_of_a_puma_are_found() {
    let free = InverseKinematics::new(&Puma).limits([None; 6]);
    let q = SVector::from([0.3, -1.0, 0.7, 0.2, 0.5, -0.4]);
    let pose = Puma.forward_kinematics(&q);
    let all = free.solutions(&[(&pose).into()], &q, 20).unwrap();
    assert_eq!(all.len(), 8);
    assert!((all[0].q - q).amax() < 1e-12);
    for found in &all {
        assert!(is_near(&Puma.forward_kinematics(&found.q), &pose, 3e-9));
        assert!((found.q - q).amax() <= PI);
    }
    let within = InverseKinematics::new(&Puma)
        .solutions(&[(&pose).into()], &q, 20)
        .unwrap();
    assert!(within.len() < 8 && !within.is_empty());
}

/// Whole turns are those nearest to the start, as far as limits allow them.
#[test]
fn whole_turns_are_near_the_start() {
    let q = SVector::from([0.3, -1.0, 0.7, 0.2, 0.5, -0.4]);
    let pose = Puma.forward_kinematics(&q);
    let mut start = q;
    start[5] += TAU;
    let free = InverseKinematics::new(&Puma).limits([None; 6]);
    assert!((free.solve(&pose, &start).unwrap().q - start).amax() < 1e-8);
    let within = InverseKinematics::new(&Puma).solve(&pose, &start).unwrap();
    assert!(within.q[5].abs() <= 266_f64.to_radians());
    // The wrist of the palletiser follows: a turn of the elbow is a turn of the wrist, and none is taken off.
    let level = InverseKinematics::new(&Level);
    let found = level.solve(
        &Level.forward_kinematics(&SVector::from([0.1, 0.2, 0.3])),
        &SVector::from([0.1, 0.2, 0.3 + TAU]),
    );
    assert!((found.unwrap().q[2] - 0.3 - TAU).abs() < 1e-8);
}

fn reason<const N: usize>(
    found: Result<impl Sized, NotReached<Const<N>>>,
) -> (Reason, NotReached<Const<N>>) {
    let error = found.err().expect("no success");
    (error.reason, error)
}

#[test]
fn ends_say_why() {
    let solver = InverseKinematics::new(&Puma);
    let start = SVector::from([0.3, -1.0, 0.7, 0.2, 0.5, -0.4]);
    let pose = Puma.forward_kinematics(&start);
    let at = |x, y, z| Target::position(Vector3::new(x, y, z));

    let (why, error) = reason(solver.solve(at(2.0, 0.0, 0.0), &start));
    assert!(matches!(why, Reason::OutOfReach { target: 0, distance: 2.0, reach } if reach < 1.1));
    assert_eq!(error.attempts, 1);
    assert!(
        error
            .to_string()
            .starts_with("not reached: target 1 is 2.000000 m from the base")
    );
    // It is stretched towards the target.
    assert!(error.residual.position < 1.2, "{error:?}");
    // Nearer to the base's axis than the offset of the elbow.
    let (why, error) = reason(solver.solve(at(0.05, 0.0, 0.3), &start));
    assert_eq!(why, Reason::Minimum);
    assert!((error.residual.position - 0.1).abs() < 2e-3, "{error}");
    // Within the limits alone.
    let narrow = InverseKinematics::new(&Puma)
        .limits([0, 1, 2, 3, 4, 5].map(|joint| Some([start[joint] - 0.1, start[joint] + 0.1])));
    let far = Puma.forward_kinematics(&SVector::from([0.5, -1.0, 0.7, 0.2, 0.5, -0.4]));
    assert_eq!(
        reason(narrow.solve(&far, &start)).0,
        Reason::Limits { joint: 0 }
    );
    // The nearest positions are on a limit, and no position beyond it reaches the target.
    let away = narrow.solve(at(0.05, 0.0, 0.3), &start);
    assert_eq!(reason(away).0, Reason::Minimum);
    let hasty = solver.clone().attempts(1).iterations(1);
    assert!(
        hasty.solve(&far, &start).is_ok(),
        "the last descent goes to the end"
    );

    // Its square is beyond the numbers.
    let (_, error) = reason(solver.solve(at(1e300, 0.0, 0.0), &start));
    assert!(
        error.to_string().starts_with(
            "not reached: target 1 is 1.000e300 m from the base, and the arm reaches 0.8"
        ) && error
            .to_string()
            .ends_with("; 1.000e300 m and 0.000e0 rad are missing at the nearest of 1 attempt"),
        "{error}"
    );

    assert_eq!(
        reason(solver.solve(&pose.transpose(), &start)).0,
        Reason::Target { target: 0 }
    );
    let mut not_a_number = pose;
    not_a_number[(0, 3)] = f64::NAN;
    assert_eq!(
        reason(solver.solve(&not_a_number, &start)).0,
        Reason::Target { target: 0 }
    );
    assert_eq!(
        reason(solver.solve(&(pose * 2.0), &start)).0,
        Reason::Target { target: 0 }
    );
    let mut mirrored = pose;
    mirrored.column_mut(0).neg_mut();
    assert_eq!(
        reason(solver.solve(&mirrored, &start)).0,
        Reason::Target { target: 0 }
    );
    let weightless = Target::pose(&pose).weights(0.0, 1.0);
    assert_eq!(
        reason(solver.solve(weightless, &start)).0,
        Reason::Target { target: 0 }
    );
    let nowhere = Target::pointing(Vector3::zeros(), Vector3::x());
    assert_eq!(
        reason(solver.solve(nowhere, &start)).0,
        Reason::Target { target: 0 }
    );
    let mut unknown = start;
    unknown[4] = f64::INFINITY;
    assert_eq!(
        reason(solver.solve(&pose, &unknown)).0,
        Reason::Start { joint: 4 }
    );
    let aimed = solver.clone().posture(unknown);
    assert_eq!(
        reason(aimed.solve(&pose, &start)).0,
        Reason::Start { joint: 4 }
    );
    let backwards = solver.clone().limits([Some([1.0, -1.0]); 6]);
    assert_eq!(
        reason(backwards.solve(&pose, &start)).0,
        Reason::Range { joint: 0 }
    );
    let exact = solver.clone().tolerance(0.0, 1e-9);
    assert_eq!(reason(exact.solve(&pose, &start)).0, Reason::Tolerance);
    let two = [Target::pose(&pose); 2];
    assert_eq!(
        reason(solver.solve_all(&two, &start)).0,
        Reason::Count {
            targets: 2,
            frames: 1
        }
    );
    assert_eq!(
        reason(solver.solve_all(&[], &start)).0,
        Reason::Count {
            targets: 0,
            frames: 1
        }
    );
}

/// A tree without a tip has poses that are not numbers.
#[test]
fn trees_without_a_tip_are_told() {
    let arm = NewtonEuler::new(&Torso.table());
    let target = Target::position(Vector3::zeros());
    let (why, _) = reason(InverseKinematics::new(&arm).solve(target, &SVector::zeros()));
    assert_eq!(why, Reason::NonFinite);
}

#[test]
fn arms_of_no_joints_are_where_they_are() {
    let table = Table::<0>::new(Convention::Modified, [0.0; 3], []);
    let arm = NewtonEuler::new(&table);
    let solver = InverseKinematics::new(&arm);
    assert!(
        solver
            .solve(&Matrix4::identity(), &SVector::zeros())
            .is_ok()
    );
    let (why, _) = reason(solver.solve(
        Target::pointing(Vector3::x(), Vector3::y()),
        &SVector::zeros(),
    ));
    assert_eq!(why, Reason::Minimum);
}

/// A slide has no end without limits, and the table's ends with them.
#[test]
fn slides_reach_as_far_as_their_limits() {
    let row = |limits| Row {
        limits,
        ..Row::new(JointType::Prismatic)
    };
    let slide =
        |limits| NewtonEuler::new(&Table::new(Convention::Modified, [0.0; 3], [row(limits)]));
    let at = |z| Target::position(Vector3::new(0.0, 0.0, z));
    let endless = slide(None);
    let found = InverseKinematics::new(&endless)
        .solve(at(-300.0), &SVector::from([0.0]))
        .unwrap();
    assert!((found.q[0] + 300.0).abs() < 1e-9);
    let short = slide(Some([-0.2, 0.5]));
    let short = InverseKinematics::new(&short);
    assert!((short.solve(at(0.4), &SVector::from([0.0])).unwrap().q[0] - 0.4).abs() < 1e-9);
    assert_eq!(
        reason(short.solve(at(-0.3), &SVector::from([0.0]))).0,
        Reason::Limits { joint: 0 }
    );
    assert!(matches!(
        reason(short.solve(at(0.6), &SVector::from([0.0]))).0,
        Reason::OutOfReach { .. }
    ));
}

#[test]
fn seeds_repeat_and_nothing_is_allocated() {
    let solver = InverseKinematics::new(&Seven);
    let (mut restarted, mut differs) = (0, 0);
    for q in positions(&Seven.table().joint_limits(), 50) {
        let pose = Seven.forward_kinematics(&q);
        let solve = |seed| {
            solver
                .clone()
                .seed(seed)
                .solve(&pose, &SVector::zeros())
                .unwrap()
        };
        let mut found = None;
        let info = measure(|| found = Some(solve(1)));
        assert_eq!(info.count_total, 0);
        let found = found.unwrap();
        assert_eq!(found, solve(1));
        if found.attempts > 1 {
            restarted += 1;
            differs += usize::from(found.q != solve(2).q);
        }
    }
    assert!(restarted > 5 && differs > restarted / 2);
}
