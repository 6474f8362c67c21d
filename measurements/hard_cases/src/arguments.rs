//! Arguments at the edge: huge angles and speeds, and sums that cancel.

use std::f64::consts::{FRAC_PI_2, PI};

use robot_dynamics::Scalar;
use robot_dynamics::nalgebra::{SVector, Vector1};

use super::arms::*;
use super::entries::{absolute_error, entry, relative_error};
use super::score::Score;

pub(crate) fn scores() -> Vec<Score> {
    let mut scores = Vec::new();
    for (id, sum_of_angles) in [
        ("HC09.1e+06", 1.1e-10),
        ("HC09.1e+12", 1.2e-4),
        ("HC09.1e+15", 0.12),
    ] {
        scores.extend(huge_angles(id, sum_of_angles));
    }
    scores.extend(right_angles_as_arguments());
    scores.push(nearly_upright());
    scores.extend(["HC13.1e-02", "HC13.1e-06", "HC13.1e-10"].map(velocities_that_cancel));
    scores.push(straight_elbow());
    scores.extend(high_speed());
    scores.push(overflow());
    scores
}

/// The angles of two parallel joints add up to multiples of a turn: the sum, rounded, has lost as
/// many digits as the angles have before the point.
fn huge_angles(id: &'static str, sum_of_angles: f64) -> [Score; 2] {
    let entry = entry(id);
    let q = entry.vector("q");
    let g = relative_error(&TwoRods.gravity_vector(&q), &entry.exact("G"));
    let m = relative_error(&TwoRods.mass_matrix(&q), &entry.exact("M"));
    [
        Score::at_most(id, "error of G", g, 1e-15).naive(sum_of_angles),
        Score::at_most(id, "error of M", m, 1e-15),
    ]
}

/// The doubles nearest to pi/2 and pi are not pi/2 and pi: what the cosine and the sine leave is
/// the distance, correct to its last digits.
fn right_angles_as_arguments() -> [Score; 2] {
    let id = "HC11";
    let (_, cosine) = Scalar::sin_cos(FRAC_PI_2);
    let (sine, _) = Scalar::sin_cos(PI);
    let exact = entry(id).exact_list();
    let errors = [cosine, sine].map(f64::abs);
    let error = |i: usize| (exact[i].error_of(errors[i]) / errors[i]).abs();
    // 4.905 N m times the sine, each rounded once, and the product.
    let torque = OneLink.gravity_vector(&Vector1::new(PI))[0] / 4.905;
    [
        Score::at_most(id, "error of cos, sin", error(0).max(error(1)), 2.3e-16).naive(1.0),
        Score::at_most(
            id,
            "error of G at pi",
            (exact[1].error_of(torque) / torque).abs(),
            6e-16,
        )
        .naive(1.0),
    ]
}

fn nearly_upright() -> Score {
    let entry = entry("HC12");
    let g = TwoRods.gravity_vector(&entry.vector("q"));
    let error = relative_error(&g, &entry.exact("G"));
    Score::at_most("HC12", "error of G, of its norm", error, 1e-15)
}

/// V_1 is proportional to qd_2 (2 qd_1 + qd_2) = (qd_1 + qd_2)^2 - qd_1^2, whose first factors are nearly 0.
/// The program forms the difference of the squares, which it shares with V_2: it is exact relative to V, not
/// relative to the entry, as Newton-Euler is.
fn velocities_that_cancel(id: &'static str) -> Score {
    let entry = entry(id);
    let v = TwoRods.coriolis_vector(&entry.vector("q"), &entry.vector("qd"));
    let error = relative_error(&v, &entry.exact("V"));
    Score::at_most(id, "error of V, of its norm", error, 1e-15)
}

fn straight_elbow() -> Score {
    let entry = entry("HC14");
    let v = TwoRods.coriolis_vector(&entry.vector("q"), &entry.vector("qd"));
    let non_zero = v.iter().filter(|x| **x != 0.0).count();
    Score::at_most("HC14", "entries of V that are not 0", non_zero as f64, 0.0).naive(1.0)
}

/// At 10^6 rad/s the inertial forces are 10^12 N m: G is computed by itself.
fn high_speed() -> [Score; 3] {
    let (id, entry) = ("HC15", entry("HC15"));
    let (q, qd) = (entry.vector("q"), entry.vector("qd"));
    let (g, exact_g) = (Puma560.gravity_vector(&q), entry.exact("G"));
    let (v, exact_v) = (Puma560.coriolis_vector(&q, &qd), entry.exact("V"));
    let tau = Puma560.inverse_dynamics(&q, &qd, &SVector::zeros());
    let sums: Vec<_> = exact_g.iter().zip(&exact_v).map(|(g, v)| *g + *v).collect();
    [
        Score::at_most(id, "error of G, N m", absolute_error(&g, &exact_g), 1e-13).naive(4.9e-4),
        Score::at_most(id, "error of V", relative_error(&v, &exact_v), 1e-14),
        Score::at_most(id, "error of tau", relative_error(&tau, &sums), 1e-14),
    ]
}

/// Speeds up to the largest double: what overflows is not finite, and nothing panics.
fn overflow() -> Score {
    let q = SVector::from([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    let is_wrong = |speed: &f64| {
        let qd = SVector::repeat(*speed);
        let v = Puma560.coriolis_vector(&q, &qd);
        let qdd = Puma560.forward_dynamics(&q, &qd, &SVector::zeros());
        // 1e150 squared is within range, 1e160 squared is not.
        let overflows = *speed > 1e155;
        let is_wrong = |x: &SVector<f64, 6>| x.iter().any(|x| x.is_finite() == overflows);
        is_wrong(&v) || qdd.is_ok_and(|qdd| is_wrong(&qdd))
    };
    let speeds = [1e100, 1e150, 1e160, 1e200, 1e300, f64::MAX];
    let wrong = speeds.iter().filter(|speed| is_wrong(speed)).count();
    Score::at_most(
        "HC15",
        "speeds to overflow with a finite result that is wrong",
        wrong as f64,
        0.0,
    )
}
