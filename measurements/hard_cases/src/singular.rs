//! Mass matrices that are singular, or become it.

use robot_dynamics::nalgebra::{Vector2, Vector3};
use robot_dynamics::{Conditioning, ForwardDynamics};

use super::arms::*;
use super::conditioning::proven;
use super::entries::{entry, relative_error};
use super::score::Score;

pub(crate) fn scores() -> Vec<Score> {
    let straight = [0.0, std::f64::consts::PI];
    let massless_root = PointMasses { m1: 0.0, m2: 1.0 };
    let mut scores = vec![
        refusals("HC06.0", &MasslessTip, &[0.7, 0.0, straight[1]], 1, "elbow"),
        refusals("HC06.1", &PointOnAxis, &[0.7], 1, "hand"),
        refusals("HC06.2", &massless_root, &straight, 0, "shoulder"),
        accelerations_of_a_massless_root(),
    ];
    for (id, angle, bound, naive) in [
        ("HC07.1e-02", 1e-2, 5e-14, 1.2e-13),
        ("HC07.1e-04", 1e-4, 2e-10, 2.7e-9),
        ("HC07.1e-06", 1e-6, 2e-7, 8.9e-6),
    ] {
        scores.extend(gimbal(id, angle, bound, naive));
    }
    scores
}

/// The states (0.3, `angles`) that are not refused with the joint's number and name.
fn refusals(
    id: &'static str,
    arm: &impl ForwardDynamics<2>,
    angles: &[f64],
    joint: usize,
    name: &'static str,
) -> Score {
    let is_right = |angle: &&f64| {
        let (q, qd, tau) = (
            Vector2::new(0.3, **angle),
            Vector2::new(0.5, -0.4),
            Vector2::new(0.1, 0.2),
        );
        let error = arm.forward_dynamics::<f64>(&q, &qd, &tau).err();
        error.is_some_and(|e| {
            e.joint == joint && e.joint_name == Some(name) && e.relative_pivot.abs() < 1e-15
        })
    };
    let missed = angles.len() - angles.iter().filter(is_right).count();
    let quantity = format!("states not refused with joint `{name}` named");
    Score::at_most(id, quantity, missed as f64, 0.0).naive(angles.len() as f64)
}

/// A first link without mass before a rod is legal.
fn accelerations_of_a_massless_root() -> Score {
    let (id, rest) = ("HC06.3", Vector2::zeros());
    let qdd = MasslessRoot.forward_dynamics::<f64>(&Vector2::new(0.3, 0.7), &rest, &rest);
    let error = match qdd {
        Ok(qdd) => relative_error(&qdd, &entry(id).exact("qdd_at_first_q")),
        Err(_) => f64::INFINITY,
    };
    Score::at_most(id, "error of qdd", error, 1e-14).naive(f64::INFINITY)
}

/// A wrist near the pose where its outer axes are parallel: the pivots say what is lost.
fn gimbal(id: &'static str, angle: f64, bound: f64, naive: f64) -> Vec<Score> {
    let entry = entry(id);
    let [q, qd, tau] = ["q", "qd", "tau"].map(|name| entry.vector::<3>(name));
    assert_eq!(q, Vector3::new(0.1, angle, 0.3));
    let found = match IdealWrist.forward_dynamics::<f64>(&q, &qd, &tau) {
        Ok(qdd) => relative_error(&qdd, &entry.exact("qdd")),
        Err(_) => f64::INFINITY,
    };
    let articulated = match ArticulatedWrist.forward_dynamics::<f64>(&q, &qd, &tau) {
        Ok(qdd) => relative_error(&qdd, &entry.exact("qdd")),
        Err(_) => f64::INFINITY,
    };
    let nearest = Conditioning::of(&IdealWrist.mass_matrix(&q));
    let mut scores = vec![
        Score::at_most(id, "error of qdd, forward_dynamics_aba", articulated, bound).naive(naive),
        Score::at_most(
            id,
            "error of qdd, over what the pivots predict",
            found / nearest.error(),
            10.0,
        ),
        Score::at_most(
            id,
            "digits lost, by the pivots, over those of 1/q^2: ratio minus 1",
            (nearest.lost_digits() / (-2.0 * angle.log10()) - 1.0).abs(),
            0.5,
        ),
    ];
    // The constants of a table of numbers are known to half a unit in the last place.
    scores.extend(proven(id, &IdealWrist, nearest.error(), 200.0));
    scores
}
