//! Constants of the table: right angles that are exact, and angles that only look it.

use robot_dynamics::nalgebra::{SVector, Vector1, Vector2, Vector6};
use robot_dynamics::{InverseDynamics, Scalar};

use super::arms::*;
use super::entries::{entry, largest};
use super::score::Score;

pub(crate) fn scores() -> Vec<Score> {
    let mut scores = right_angles();
    scores.push(spellings_of_a_right_angle());
    scores.push(what_is_no_right_angle());
    scores.extend(nearly_parallel());
    scores.push(special_angles());
    scores
}

/// The PUMA's right angles leave no cos(pi/2) behind.
fn right_angles() -> Vec<Score> {
    let id = "HC16";
    let spurious = states().filter(|q| Puma560.gravity_vector(q)[0].to_bits() != 0);
    let operations = Puma560::OPERATIONS
        .iter()
        .find(|(name, _)| *name == "inverse_dynamics")
        .map_or(f64::INFINITY, |(_, operations)| {
            f64::from(operations.total())
        });
    vec![
        Score::at_most(
            id,
            "states of 100 with G_1 other than 0.0",
            spurious.count() as f64,
            0.0,
        )
        .naive(100.0),
        Score::at_most(id, "operations of tau", operations, 704.0).naive(925.0),
    ]
}

/// 100 positions.
fn states() -> impl Iterator<Item = Vector6<f64>> {
    (0..100).map(|k| Vector6::from_fn(|i, _| 3.0 * f64::sin(1.7 * f64::from(k) + 2.3 * i as f64)))
}

fn torques(arm: &impl InverseDynamics<2>) -> Vec<Vector2<f64>> {
    let at = |q: Vector6<f64>| {
        let [q, qd, qdd] = [q.fixed_rows::<2>(0), q.fixed_rows(2), q.fixed_rows(4)];
        arm.inverse_dynamics(&q.into_owned(), &qd.into_owned(), &qdd.into_owned())
    };
    states().map(at).collect()
}

/// PI/2, deg(90) and decimals of it are one angle: the same program, to the bit.
fn spellings_of_a_right_angle() -> Score {
    let expected = torques(&TwistedByPi);
    let others = [
        torques(&TwistedByDegrees),
        torques(&TwistedByDecimals),
        torques(&TwistedByFewDecimals),
    ];
    let different = others.iter().filter(|other| **other != expected).count();
    Score::at_most(
        "HC16",
        "spellings of pi/2 that are not the same",
        different as f64,
        0.0,
    )
    .naive(3.0)
}

/// 1.5708 is what it says: its torques differ from those of a right angle by up to
/// 1.5708 - pi/2 = 3.7e-6 times what an axis turned by that angle feels.
fn what_is_no_right_angle() -> Score {
    let (right, rough) = (torques(&TwistedByPi), torques(&TwistedByRoughly));
    let size = largest(right.iter().flatten().copied());
    let difference = largest((0..right.len()).flat_map(|k| {
        let difference = right[k] - rough[k];
        [difference[0], difference[1]]
    }));
    Score::at_least(
        "HC17",
        "difference of torques between alpha = 1.5708 and pi/2",
        difference / size,
        1e-7,
    )
    .naive(0.0)
}

/// Axes that are parallel but for 10^-9 rad: gravity along the first is felt by the second.
fn nearly_parallel() -> [Score; 2] {
    let (id, entry) = ("HC17", entry("HC17"));
    let g = NearlyParallel.gravity_vector(&entry.vector("q"));
    let exact = entry.exact("G");
    [
        Score::at_most(
            id,
            "error of G_2, of itself",
            (exact[1].error_of(g[1]) / g[1]).abs(),
            1e-14,
        )
        .naive(1.0),
        Score::at_most(
            id,
            "error of G_1, N m",
            exact[0].error_of(g[0]).abs(),
            1e-24,
        ),
    ]
}

/// Sines and cosines of 30, 45, 60 and 120 degrees are those of exact values, rounded once.
fn special_angles() -> Score {
    let (root_3, root_2) = (Scalar::sqrt(3.0_f64) / 2.0, std::f64::consts::FRAC_1_SQRT_2);
    let along_z = |g: SVector<f64, 1>| g[0];
    let q = Vector1::new(0.0);
    let (gy, gz) = (0.0, -1.0);
    let (wall, zero) = (1.0, 0.0);
    // The force of gravity along a rail inclined by alpha: g_z cos(alpha) downwards, g_y sin(alpha).
    let found = [
        (along_z(Rail30 { gy, gz }.gravity_vector(&q)), root_3),
        (along_z(Rail45 { gy, gz }.gravity_vector(&q)), root_2),
        (along_z(Rail60 { gy, gz }.gravity_vector(&q)), 0.5),
        (along_z(Rail120 { gy, gz }.gravity_vector(&q)), -0.5),
        (
            along_z(Rail30 { gy: wall, gz: zero }.gravity_vector(&q)),
            0.5,
        ),
        (
            along_z(Rail45 { gy: wall, gz: zero }.gravity_vector(&q)),
            root_2,
        ),
        (
            along_z(Rail60 { gy: wall, gz: zero }.gravity_vector(&q)),
            root_3,
        ),
        (
            along_z(Rail120 { gy: wall, gz: zero }.gravity_vector(&q)),
            root_3,
        ),
    ];
    let wrong = found.iter().filter(|(found, exact)| found != exact).count();
    Score::at_most(
        "HC18",
        "special sines and cosines of 8 that are not exact",
        wrong as f64,
        0.0,
    )
    .naive(2.0)
}
