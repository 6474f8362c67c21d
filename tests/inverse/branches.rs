//! The names of branches, paths that stay on one, and the angle of an elbow.

use std::f64::consts::PI;

use robot_dynamics::closed_form::{BranchEnds, Solutions};
use robot_dynamics::nalgebra::{Isometry3, Matrix4, SVector, UnitQuaternion, Vector3};

use crate::arms::*;
use crate::{Inverse, Random, apart};

/// Whether an arm reaches forwards, and words for it. It is left if it passes axis 1 on the left. Its elbow is up if it is above
/// the line from the second axis to the point `end`. `None` if it is near to being neither.
fn seen(links: &[Matrix4<f64>], wrist: usize, end: usize) -> Option<(bool, [&'static str; 2])> {
    let origin = |i: usize| links[i].fixed_view::<3, 1>(0, 3).into_owned();
    let beside: Vector3<f64> = links[0].fixed_view::<3, 1>(0, 2).into_owned();
    let [shoulder, elbow, wrist, end] = [0, 1, wrist, end].map(origin);
    let step = wrist.dot(&beside);
    // The wrist, seen from above, and the arm's plane beside axis 1.
    let left = Vector3::new(-wrist.y, wrist.x, 0.0).dot(&beside);
    let left = if step.abs() > 1e-9 { left * step } else { left };
    let in_plane = |v: Vector3<f64>| v - beside * beside.dot(&v);
    let [line, upper] = [end - shoulder, elbow - shoulder].map(in_plane);
    let foot = upper.dot(&line) / line.norm_squared();
    let above = (upper - line * foot).z;
    // A line that is upright has no side above it, and what is above depends on where the wrist is seen from axis 1.
    let forwards = beside.cross(&Vector3::z());
    let is_ahead = line.dot(&forwards) * wrist.dot(&forwards) > 1e-3 * line.norm() * wrist.norm();
    let is_clear = left.abs() > 1e-6 && above.abs() > 1e-6 && is_ahead;
    let words = [
        if left > 0.0 {
            "shoulder left"
        } else {
            "shoulder right"
        },
        if above > 0.0 {
            "elbow up"
        } else {
            "elbow down"
        },
    ];
    is_clear.then_some((line.dot(&forwards) > 0.0, words))
}

/// Names are those of what is seen, and no two solutions of a pose have one.
#[test]
fn branches_are_named_as_they_look() {
    fn check<const N: usize, A: Inverse<N>>(arm: &A, wrist: usize, end: usize) {
        let mut random = Random(31);
        let mut count = 0;
        for _ in 0..300 {
            let q = random.joints();
            let solutions = arm.solutions(&arm.pose(&q), 0.0);
            let mut names: Vec<&str> = solutions.iter().map(|one| one.branch).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), solutions.len(), "{}", A::NAME);
            for solution in &solutions {
                if let Some((is_forwards, words)) = seen(&arm.links(&solution.q), wrist, end) {
                    // An arm whose waist has one solution is named as if it reached forwards.
                    if !is_forwards && !solution.branch.contains("shoulder") {
                        continue;
                    }
                    for word in words {
                        let part = word.split(' ').next().expect("a word");
                        let is_so = solution.branch.contains(word);
                        let is_named = solution.branch.contains(part);
                        assert_eq!(is_so, is_named, "{}: {} {word}", A::NAME, solution.branch);
                        count += usize::from(is_named);
                    }
                }
            }
        }
        assert!(count > 200, "{}: {count}", A::NAME);
    }
    check(&Puma560, 3, 3);
    check(&Kr6, 3, 3);
    check(&Ur5, 4, 2);
    check(&Ur10e, 4, 2);
    check(&Elbow3r, 2, 2);
    check(&OpenManipulator, 3, 2);
    check(&So100, 4, 2);
}

/// The last word is that of the wrist, of which the fifth joint turns the other way.
#[test]
fn wrists_are_flipped() {
    let mut random = Random(3);
    for _ in 0..100 {
        let q = random.joints();
        for solution in &Puma560.inverse_kinematics(&Puma560.forward_kinematics(&q)) {
            let is_flipped = solution.branch.ends_with("wrist flipped");
            assert_eq!(is_flipped, solution.q[4] < 0.0, "{}", solution.q);
        }
    }
    let pose = Cylindrical.pose(&[0.1, 0.2, 0.3].into());
    let names: Vec<_> = Cylindrical
        .inverse_kinematics(&pose)
        .iter()
        .map(|one| one.branch)
        .collect();
    assert_eq!(names.len(), 2);
}

/// Poses on the straight line from one pose to another one.
fn line(from: &Matrix4<f64>, to: &Matrix4<f64>, steps: u32) -> impl Iterator<Item = Matrix4<f64>> {
    let place = |pose: &Matrix4<f64>| {
        let rotation = UnitQuaternion::from_matrix(&pose.fixed_view::<3, 3>(0, 0).into_owned());
        let position: Vector3<f64> = pose.fixed_view::<3, 1>(0, 3).into_owned();
        Isometry3::from_parts(position.into(), rotation)
    };
    let [from, to] = [from, to].map(place);
    (0..=steps).map(move |k| {
        let part = f64::from(k) / f64::from(steps);
        from.lerp_slerp(&to, part).to_homogeneous()
    })
}

/// A path along a line: how many steps it has, and how it ends.
fn path<const N: usize>(
    poses: impl Iterator<Item = Matrix4<f64>>,
    start: SVector<f64, N>,
    most: f64,
    solve: impl Fn(&Matrix4<f64>, &SVector<f64, N>) -> Solutions<f64, N>,
) -> (usize, Result<(), BranchEnds>) {
    let (mut last, mut steps, mut branch) = (start, 0, None);
    for pose in poses {
        let solutions = solve(&pose, &last);
        match solutions.follow(&last, most) {
            Ok(next) => {
                assert!(apart(&next.q, &last) <= most);
                let same = *branch.get_or_insert(next.branch) == next.branch;
                assert!(same || next.is_singular || N == 7, "{}", next.branch);
                (last, steps) = (next.q, steps + 1);
            }
            Err(ends) => {
                // The error tells the truth about the nearest solution.
                match (ends.joint, solutions.nearest(&last)) {
                    (None, nearest) => assert!(nearest.is_none()),
                    (Some(_), nearest) => {
                        let way = apart(&nearest.expect("one is too far").q, &last);
                        assert!((way - ends.way).abs() < 1e-12 && way > most);
                    }
                }
                return (steps, Err(ends));
            }
        }
    }
    (steps, Ok(()))
}

/// Straight lines of 60 arms each: no joint moves by more than it can in a step, or the error says at which step and why.
#[test]
fn lines_are_followed() {
    const STEPS: u32 = 250;
    let mut random = Random(77);
    let mut whole = [0, 0];
    for _ in 0..60 {
        let q: SVector<f64, 6> = random.joints();
        let near = q + SVector::from_fn(|_, _| 0.5 * random.next());
        let poses = [q, near].map(|q| Ur5e.forward_kinematics(&q));
        let poses = line(&poses[0], &poses[1], STEPS);
        let (steps, end) = path(poses, q, 0.05, |pose, _| Ur5e.inverse_kinematics(pose));
        assert_eq!(end.is_ok(), steps == STEPS as usize + 1);
        whole[0] += usize::from(end.is_ok());

        let q: SVector<f64, 7> = random.joints();
        let near = q + SVector::from_fn(|_, _| 0.5 * random.next());
        let poses = [q, near].map(|q| Iiwa14.forward_kinematics(&q));
        let poses = line(&poses[0], &poses[1], STEPS);
        let (steps, end) = path(poses, q, 0.05, |pose, last| {
            Iiwa14.inverse_kinematics(pose, Iiwa14.elbow_angle(last))
        });
        assert_eq!(end.is_ok(), steps == STEPS as usize + 1);
        whole[1] += usize::from(end.is_ok());
    }
    assert!(whole.iter().all(|count| *count > 45), "{whole:?}");
}

/// The joint that moves farthest is named, counted from 1.
#[test]
fn ends_of_branches_are_told() {
    let q = SVector::from([0.4, -0.9, 0.7, 0.5, 1.1, -0.3]);
    let solutions = Puma560.inverse_kinematics(&Puma560.forward_kinematics(&q));
    let mut last = q;
    last[3] += 0.2;
    assert_eq!(
        solutions
            .follow(&last, 0.3)
            .map(|one| apart(&one.q, &q) < 1e-12),
        Ok(true)
    );
    let error = solutions.follow(&last, 0.1).unwrap_err();
    assert_eq!(error.joint, Some(3));
    assert_eq!(
        error.to_string(),
        "the branch ends: to the nearest solution joint 4 moves by 0.200, more than 0.100"
    );
    assert!(solutions.follow(&[f64::NAN; 6].into(), 0.1).is_err());
    let none = Puma560.inverse_kinematics(&Matrix4::zeros());
    assert_eq!(none.follow(&q, 0.1).unwrap_err().joint, None);
    // Beyond half a turn the way is short, also within limits that allow both.
    let q = SVector::from([PI - 0.01, -0.9, 0.7, 0.5, 1.1, -0.3]);
    let mut last = q;
    last[0] = PI + 0.01;
    let solutions = Puma560.inverse_kinematics(&Puma560.forward_kinematics(&q));
    assert!(solutions.follow(&last, 0.03).is_ok());
    let wide = solutions.within(&[Some([-2.0 * PI, 2.0 * PI]); 6]);
    assert!(wide.follow(&last, 0.03).is_ok());
}

/// The angle of the elbow is the one by which the joints are found again.
#[test]
fn elbow_angles_lead_back() {
    let mut random = Random(41);
    for _ in 0..300 {
        let q: SVector<f64, 7> = random.joints();
        macro_rules! check {
            ($($arm:ident)*) => {$(
                let elbow = $arm.elbow_angle(&q);
                let expected = $arm.elbow(&q);
                let way = (elbow - expected) / (2.0 * PI);
                assert!((way - way.round()).abs() < 1e-12, "{} {elbow} {expected}", stringify!($arm));
                let solutions = $arm.inverse_kinematics(&$arm.forward_kinematics(&q), elbow);
                let ways = solutions.iter().map(|one| apart(&one.q, &q));
                assert!(ways.fold(f64::INFINITY, f64::min) < 1e-8, "{}", stringify!($arm));
            )*};
        }
        check!(Iiwa14 SevenJoints EqualHalves);
    }
    // A stretched arm has the elbow on the line: any angle leads back to the pose.
    let q = SVector::from([0.3, 0.5, -0.2, 0.0, 0.4, 0.7, 0.1]);
    let pose = Iiwa14.forward_kinematics(&q);
    let solutions = Iiwa14.inverse_kinematics(&pose, Iiwa14.elbow_angle(&q));
    assert!(!solutions.is_empty());
}

/// Ranges of elbow angles are those at which a solution is within the limits.
#[test]
fn elbow_ranges_are_complete() {
    let mut random = Random(53);
    let limits: [Option<[f64; 2]>; 7] =
        [2.967, 2.094, 2.967, 2.094, 2.967, 2.094, 3.054].map(|most: f64| Some([-most, most]));
    let narrow = limits.map(|range| range.map(|range| range.map(|x| x * 0.6)));
    let mut inside = [0; 2];
    for _ in 0..25 {
        let q: SVector<f64, 7> = random.joints() * 0.6;
        let pose = Iiwa14.forward_kinematics(&q);
        for limits in [limits, narrow] {
            let ranges = Iiwa14.elbow_ranges(&pose, &limits);
            assert!(ranges.windows(2).all(|two| two[0][1] < two[1][0]));
            for k in 0..2_000 {
                let elbow = (f64::from(k) + 0.5) * (PI / 1_000.0) - PI;
                let solutions = Iiwa14.inverse_kinematics(&pose, elbow).within(&limits);
                let is_in = ranges
                    .iter()
                    .any(|[lower, upper]| (lower..=upper).contains(&&elbow));
                let ends = ranges.iter().flatten().map(|end| (end - elbow).abs());
                if ends.fold(f64::INFINITY, f64::min) > 1e-9 {
                    assert_eq!(!solutions.is_empty(), is_in, "{elbow} {ranges:?}");
                    inside[usize::from(is_in)] += 1;
                }
            }
        }
    }
    assert!(inside.iter().all(|count| *count > 10_000), "{inside:?}");
    // Ranges that are none, and some that leave a joint free.
    let pose = Iiwa14.forward_kinematics(&SVector::from([0.4; 7]));
    let ranges = |range| Iiwa14.elbow_ranges(&pose, &[range; 7]).to_vec();
    assert!(ranges(Some([f64::NAN; 2])).is_empty() && ranges(Some([1.0, -1.0])).is_empty());
    let free = Some([f64::NEG_INFINITY, f64::INFINITY]);
    assert!(
        [ranges(None), ranges(free)]
            .iter()
            .all(|all| *all == [[-PI, PI]])
    );
}
