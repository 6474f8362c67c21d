//! Inverse kinematics in closed form, of an arm of each class.

mod arms;
mod branches;
mod edges;
mod families;
mod languages;
mod long;
mod poses;
mod round;
mod run_time;
mod singular;

use std::f64::consts::TAU;

use arms::*;
use robot_dynamics::closed_form::{Real, Solutions};
use robot_dynamics::nalgebra::{DMatrix, Matrix4, SMatrix, SVector, Vector3};

/// An arm with a closed form.
trait Inverse<const N: usize> {
    const NAME: &'static str;
    /// Whether its equations read the rotation of the pose.
    const READS_ROTATION: bool;
    fn pose<T: Real>(&self, q: &SVector<T, N>) -> Matrix4<T>;
    fn links(&self, q: &SVector<f64, N>) -> [Matrix4<f64>; N];
    fn jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N>;
    /// `elbow` is of seven joints.
    fn solutions<T: Real>(&self, pose: &Matrix4<T>, elbow: T) -> Solutions<T, N>;

    /// The angle of the elbow about the line from shoulder to wrist. Axes 1 to 3 meet in the origin of the second link,
    /// axis 4 is the z axis of the third, and axes 5 to 7 meet in the origin of the sixth.
    fn elbow(&self, q: &SVector<f64, N>) -> f64 {
        if N != 7 {
            return 0.0;
        }
        let links = self.links(q);
        let origin = |i: usize| links[i].fixed_view::<3, 1>(0, 3).into_owned();
        let shoulder = origin(1);
        let axis = links[2].fixed_view::<3, 1>(0, 2).into_owned();
        let apart: Vector3<f64> = origin(2) - shoulder;
        let elbow = apart - axis * apart.dot(&axis);
        let line = origin(5) - shoulder;
        // The wrist in the shoulder: there is no line to turn about.
        if line.norm() < 1e-12 {
            return 0.0;
        }
        let line = line.normalize();
        let start = Vector3::z() - line * line.z;
        line.dot(&start.cross(&elbow)).atan2(start.dot(&elbow))
    }
}

/// Seven joints have one more argument.
macro_rules! solutions {
    ($arm:ident, $pose:ident, $elbow:ident, 7) => {
        $arm.inverse_kinematics($pose, $elbow)
    };
    ($arm:ident, $pose:ident, $elbow:ident, $n:tt) => {{
        let _ = $elbow;
        $arm.inverse_kinematics($pose)
    }};
}

macro_rules! inverses {
    ($($name:ident: $n:tt, $reads_rotation:literal;)*) => {
        $(
            impl Inverse<$n> for $name {
                const NAME: &'static str = stringify!($name);
                const READS_ROTATION: bool = $reads_rotation;

                fn pose<T: Real>(&self, q: &SVector<T, $n>) -> Matrix4<T> {
                    self.forward_kinematics(q)
                }

                fn links(&self, q: &SVector<f64, $n>) -> [Matrix4<f64>; $n] {
                    self.link_poses(q)
                }

                fn jacobian(&self, q: &SVector<f64, $n>) -> SMatrix<f64, 6, $n> {
                    self.jacobian(q)
                }

                fn solutions<T: Real>(&self, pose: &Matrix4<T>, elbow: T) -> Solutions<T, $n> {
                    solutions!(self, pose, elbow, $n)
                }
            }
        )*
    };
}
for_each_arm!(inverses);
for_more_arms!(inverses);

/// Numbers of a reproducible sequence from -1 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        let Random(state) = self;
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Positions of all joints, rad or m.
    fn joints<const N: usize>(&mut self) -> SVector<f64, N> {
        SVector::from_fn(|_, _| 3.1 * self.next())
    }
}

/// The largest difference of two joint positions, whole turns left out.
fn apart<const N: usize>(a: &SVector<f64, N>, b: &SVector<f64, N>) -> f64 {
    let way = (a - b).abs().map(|way| way.min((way - TAU).abs()));
    way.max()
}

/// How far a solution is from the pose, as far as that is read.
fn residual<const N: usize, A: Inverse<N>>(
    arm: &A,
    pose: &Matrix4<f64>,
    q: &SVector<f64, N>,
) -> f64 {
    let miss = (arm.pose(q) - pose).abs();
    let first = if A::READS_ROTATION { 0 } else { 3 };
    miss.columns(first, 4 - first).max()
}

/// The least singular value of what is read, by the joints: so much less than some joints does the pose change. For
/// seven joints the angle of the elbow is read, too.
fn conditioning<const N: usize, A: Inverse<N>>(arm: &A, q: &SVector<f64, N>) -> f64 {
    let rows = if A::READS_ROTATION { 6 } else { 3 };
    let jacobian = arm.jacobian(q);
    let slope = |joint: usize| {
        let step = SVector::from_fn(|i, _| if i == joint { 1e-6 } else { 0.0 });
        let change = arm.elbow(&(q + step)) - arm.elbow(&(q - step));
        (change - TAU * (change / TAU).round()) / 2e-6
    };
    let with_elbow = rows + usize::from(N == 7);
    let read = DMatrix::from_fn(with_elbow, N, |i, j| {
        if i < rows { jacobian[(i, j)] } else { slope(j) }
    });
    let values = read.svd(false, false).singular_values;
    values[with_elbow.min(N) - 1]
}

/// All solutions of random poses are right, and the joints from which the pose was made are among them.
fn random_poses_are_solved<const N: usize, A: Inverse<N>>(arm: &A, count: usize) {
    let mut random = Random(7);
    let (mut worst_residual, mut worst, mut roundings) = (0.0_f64, [0.0_f64; 2], 0.0_f64);
    for _ in 0..count {
        let q = random.joints();
        let pose = arm.pose(&q);
        let solutions = arm.solutions(&pose, arm.elbow(&q));
        let ways = solutions.iter().map(|solution| apart(&solution.q, &q));
        let nearest = ways.fold(f64::INFINITY, f64::min);
        let conditioning = conditioning(arm, &q);
        let near_singular = usize::from(conditioning < 5e-3);
        worst[near_singular] = worst[near_singular].max(nearest);
        roundings = roundings.max(nearest * conditioning.min(1.0));
        for solution in &solutions {
            worst_residual = worst_residual.max(residual(arm, &pose, &solution.q));
        }
    }
    let [away, near] = worst;
    println!(
        "{}: residual {worst_residual:.1e}, joints {away:.1e}, near singular {near:.1e}, times conditioning {roundings:.1e}",
        A::NAME
    );
    assert!(worst_residual < 1e-14, "{}: {worst_residual:e}", A::NAME);
    assert!(away < 1e-12, "{}: {away:e}", A::NAME);
    // The rounding of the pose alone moves the joints by this.
    assert!(roundings < 1e-14, "{}: {roundings:e}", A::NAME);
}

macro_rules! random_poses_of_all {
    ($($name:ident: $n:literal, $reads_rotation:literal;)*) => {
        $(random_poses_are_solved::<$n, _>(&$name, 500);)*
    };
}

#[test]
fn every_random_pose_is_solved() {
    for_each_arm!(random_poses_of_all);
}

/// The most solutions of a pose, all of them different.
#[test]
fn all_solutions_are_found() {
    fn most<const N: usize, A: Inverse<N>>(arm: &A) -> usize {
        let mut random = Random(11);
        let count = |_| {
            let q = random.joints();
            let solutions = arm.solutions(&arm.pose(&q), arm.elbow(&q));
            for (i, one) in solutions
                .iter()
                .enumerate()
                .filter(|(_, one)| !one.is_singular)
            {
                for other in solutions.iter().skip(i + 1) {
                    assert!(apart(&one.q, &other.q) > 1e-7, "{} {}", one.q, other.q);
                }
            }
            solutions.len()
        };
        (0..100).map(count).max().unwrap_or(0)
    }
    assert_eq!(most(&Puma560), 8);
    assert_eq!(most(&Ur5), 8);
    assert_eq!(most(&Stanford), 8);
    assert_eq!(most(&Shoulder), 8);
    assert_eq!(most(&ThreeRolls), 8);
    assert_eq!(most(&GantryWithWrist), 2);
    assert_eq!(most(&SevenJoints), 8);
    assert_eq!(most(&Iiwa14), 8);
    assert_eq!(most(&EqualHalves), 8);
    assert_eq!(most(&Scara), 2);
    assert_eq!(most(&Elbow3r), 4);
    assert_eq!(most(&RrrPlanar), 2);
    assert_eq!(most(&Cylindrical), 2);
    assert_eq!(most(&TwoLink), 2);
}

/// The elbow of each solution is where the angle says.
#[test]
fn the_elbow_is_in_its_half_plane() {
    fn check<A: Inverse<7>>(arm: &A) {
        let mut random = Random(3);
        for _ in 0..200 {
            let (q, elbow) = (random.joints(), 3.0 * random.next());
            let solutions = arm.solutions(&arm.pose(&q), elbow);
            assert_eq!(solutions.len(), 8);
            for solution in &solutions {
                let way = (arm.elbow(&solution.q) - elbow).abs();
                assert!(way.min((way - TAU).abs()) < 1e-9, "{way}");
            }
        }
    }
    check(&Iiwa14);
    check(&SevenJoints);
}

/// In single precision the same solutions, to its digits.
#[test]
fn single_precision_finds_the_same() {
    fn check<const N: usize, A: Inverse<N>>(arm: &A, q: [f64; N]) {
        let q = SVector::from(q);
        let (pose, elbow) = (arm.pose(&q), arm.elbow(&q));
        let doubles = arm.solutions(&pose, elbow);
        let singles = arm.solutions(&pose.map(|x| x as f32), elbow as f32);
        assert_eq!(singles.len(), doubles.len(), "{}", A::NAME);
        for (single, double) in singles.iter().zip(&doubles) {
            let way = apart(&single.q.map(f64::from), &double.q);
            assert!(way < 2e-5, "{} {way}", A::NAME);
        }
    }
    let six = [0.4, -0.9, 0.7, 0.5, 1.1, -0.3];
    check(&Puma560, six);
    check(&Ur5, six);
    check(&Stanford, six);
    check(&Shoulder, six);
    check(&ThreeRolls, six);
    check(&Iiwa14, [0.4, -0.9, 0.7, 0.5, 1.1, -0.3, 0.2]);
    check(&Scara, [0.4, -0.9, 0.7, 0.5]);
    check(&TwoLink, [0.4, -0.9]);
}

/// Out of reach, and poses that are no numbers.
#[test]
fn poses_out_of_reach_have_no_solution() {
    fn check<const N: usize, A: Inverse<N>>(arm: &A) {
        let mut pose = arm.pose(&SVector::from([0.3; N]));
        let inside = pose;
        pose[(1, 3)] += 100.0;
        let slides = ["Stanford", "GantryWithWrist", "Cylindrical"].contains(&A::NAME);
        assert_eq!(arm.solutions(&pose, 0.3).is_empty(), !slides, "{}", A::NAME);
        // An entry that is not read changes nothing.
        let solved = arm.solutions(&inside, 0.3);
        let places = (0..3).flat_map(|i| (0..4).map(move |j| (i, j)));
        for (i, j) in places {
            for x in [f64::NAN, f64::INFINITY] {
                let mut pose = inside;
                pose[(i, j)] = x;
                let solutions = arm.solutions(&pose, 0.3);
                let is_unread = j < 3 && solutions == solved;
                assert!(solutions.is_empty() || is_unread, "{} {i} {j} {x}", A::NAME);
            }
        }
        assert!(N != 7 || arm.solutions(&inside, f64::NAN).is_empty());
        // A position whose square is infinite.
        let slides = slides || A::NAME == "Scara";
        for i in 0..3 {
            let mut pose = inside;
            pose[(i, 3)] = 1e200;
            assert!(
                slides || arm.solutions(&pose, 0.3).is_empty(),
                "{} {i}",
                A::NAME
            );
        }
    }
    macro_rules! all {
        ($($name:ident: $n:literal, $reads_rotation:literal;)*) => { $(check::<$n, _>(&$name);)* };
    }
    for_each_arm!(all);
    // Beside the plane of an arm that moves in one, and tilted out of it.
    let mut pose = TwoLink.forward_kinematics(&SVector::from([0.3, 0.4]));
    assert_eq!(TwoLink.inverse_kinematics(&pose).len(), 2);
    pose[(2, 3)] = 1e-6;
    assert!(TwoLink.inverse_kinematics(&pose).is_empty());
}

/// A rotation that is none, where it is read: longer columns, a reflection, columns that are not at right angles.
#[test]
fn rotations_that_are_none_have_no_solution() {
    fn check<const N: usize, A: Inverse<N>>(arm: &A) {
        let pose = arm.pose(&SVector::from([0.3; N]));
        let solved = arm.solutions(&pose, 0.3);
        let changed = |change: &dyn Fn(&mut Matrix4<f64>)| {
            let mut pose = pose;
            change(&mut pose);
            arm.solutions(&pose, 0.3)
        };
        let none = [
            changed(&|pose| pose[(0, 0)] = 2.0),
            changed(&|pose| pose[(2, 1)] = 1e200),
            changed(&|pose| pose.fixed_view_mut::<3, 1>(0, 2).neg_mut()),
            changed(&|pose| pose.fixed_view_mut::<3, 3>(0, 0).neg_mut()),
            changed(&|pose| pose.fixed_view_mut::<3, 3>(0, 0).scale_mut(1.001)),
            changed(&|pose| pose.fixed_view_mut::<3, 3>(0, 0).fill(0.0)),
            changed(&|pose| pose[(3, 3)] = 0.0),
        ];
        for found in none {
            assert_eq!(found.is_empty(), A::READS_ROTATION, "{}", A::NAME);
            assert!(found.is_empty() || found == solved);
        }
        let transposed = arm.solutions(&pose.transpose(), 0.3);
        assert!(transposed.is_empty() || !A::READS_ROTATION, "{}", A::NAME);
        // Roundings are no reason.
        let near = changed(&|pose| pose[(1, 1)] += 1e-12);
        assert_eq!(near.len(), solved.len(), "{}", A::NAME);
    }
    macro_rules! all {
        ($($name:ident: $n:literal, $reads_rotation:literal;)*) => { $(check::<$n, _>(&$name);)* };
    }
    for_each_arm!(all);
}

/// Limits and seeds of a real arm: `JOINT_LIMITS` as they are.
#[test]
fn solutions_are_chosen_by_limits_and_seeds() {
    let q = SVector::from([3.3, -0.9, 0.7, 0.5, 1.1, -0.3]);
    let solutions = Puma560.inverse_kinematics(&Puma560.forward_kinematics(&q));
    assert_eq!(solutions.within(&Puma560::JOINT_LIMITS), solutions);
    let limits = [
        Some([0.0, TAU]),
        Some([-2.0, 2.0]),
        None,
        None,
        Some([0.0, 2.0]),
        None,
    ];
    let within = solutions.within(&limits);
    assert!(!within.is_empty() && within.len() < 8);
    let seed = q.add_scalar(0.05);
    let nearest = within.nearest(&seed).expect("q is within the limits");
    // The first angle is beyond pi, as the seed is.
    assert!((nearest.q - q).amax() < 1e-12);
}

/// Lengths and angles that are fields, in the rows and in the base.
#[test]
fn fields_may_stand_in_cells() {
    let arm = Fitted {
        reach: 0.7,
        skew: 0.3,
        tilt: -0.4,
    };
    let mut random = Random(9);
    for _ in 0..100 {
        let q = random.joints();
        let pose = arm.forward_kinematics(&q);
        let solutions = arm.inverse_kinematics(&pose);
        let ways = solutions.iter().map(|solution| apart(&solution.q, &q));
        assert!(ways.fold(f64::INFINITY, f64::min) < 1e-9);
        for solution in &solutions {
            let miss = (arm.forward_kinematics(&solution.q) - pose).abs().max();
            assert!(miss < 1e-14, "{miss:e}");
        }
    }
}

/// Many poses are solved as each by itself, and lengths that differ are told.
#[test]
fn batches_are_single_calls() {
    let mut random = Random(5);
    let joints: Vec<SVector<f64, 6>> = (0..20).map(|_| random.joints()).collect();
    let poses: Vec<_> = joints
        .iter()
        .map(|q| Puma560.forward_kinematics(q))
        .collect();
    let mut solutions = vec![Solutions::default(); 20];
    Puma560
        .inverse_kinematics_batch(&poses, &mut solutions)
        .expect("equal lengths");
    for (pose, solutions) in poses.iter().zip(&solutions) {
        assert_eq!(*solutions, Puma560.inverse_kinematics(pose));
    }
    let error = Puma560.inverse_kinematics_batch(&poses[1..], &mut solutions);
    assert_eq!(
        error.unwrap_err().to_string(),
        "`solutions` has 20 states where `pose` has 19"
    );
    let (seven, elbows) = ([Iiwa14.forward_kinematics(&random.joints())], [0.3]);
    let mut solutions = [Solutions::default()];
    Iiwa14
        .inverse_kinematics_batch(&seven, &elbows, &mut solutions)
        .expect("equal lengths");
    assert_eq!(solutions[0], Iiwa14.inverse_kinematics(&seven[0], 0.3));
    let error = Iiwa14.inverse_kinematics_batch(&seven, &elbows[1..], &mut solutions);
    assert_eq!(
        error.unwrap_err().to_string(),
        "`elbow` has 0 states where `pose` has 1"
    );
}

#[test]
fn nothing_is_allocated() {
    let pose = Puma560.forward_kinematics(&Random(2).joints());
    let info = allocation_counter::measure(|| {
        let solutions = Puma560
            .inverse_kinematics(&pose)
            .within(&Puma560::JOINT_LIMITS);
        assert!(solutions.nearest(&SVector::zeros()).is_some());
    });
    assert_eq!(info.count_total, 0);
}
