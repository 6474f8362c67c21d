//! Mass matrices that are ill-conditioned, or look it.

use robot_dynamics::nalgebra::{SMatrix, SVector, Vector2};
use robot_dynamics::{
    Certified, Conditioning, ForwardDynamics, InverseDynamics, MassMatrix, NewtonEuler, Operations,
    certified,
};

use super::arms::*;
use super::entries::{absolute_error, entry, relative_error};
use super::motion::{Counted, dop853, free};
use super::score::Score;

pub(crate) fn scores() -> Vec<Score> {
    let mut scores = straight_chain(
        "HC01.10",
        &Chain10,
        &ArticulatedChain10,
        NewtonEuler::new(&Chain10.table()),
    );
    scores.push(cost(
        "HC01.10",
        &Chain10::OPERATIONS,
        &ArticulatedChain10::OPERATIONS,
    ));
    scores.extend(straight_chain(
        "HC01.30",
        &Chain30,
        &ArticulatedChain30,
        NewtonEuler::new(&Chain30.table()),
    ));
    scores.push(cost(
        "HC01.30",
        &Chain30::OPERATIONS,
        &ArticulatedChain30::OPERATIONS,
    ));
    scores.extend(heavy_payload());
    scores.extend(through_the_stretched_pose());
    scores.extend(light_payload());
    scores.extend(graded_wrist());
    scores.extend(reflected_inertia());
    scores
}

/// Relative error of the accelerations of an entry; infinite where they are refused.
fn error<const N: usize>(id: &str, arm: &impl ForwardDynamics<N>) -> f64 {
    let entry = entry(id);
    let [q, qd, tau] = ["q", "qd", "tau"].map(|name| entry.vector(name));
    match arm.forward_dynamics::<f64>(&q, &qd, &tau) {
        Ok(qdd) => relative_error(&qdd, &entry.exact("qdd")),
        Err(_) => f64::INFINITY,
    }
}

/// The same in single precision.
fn single_error<const N: usize>(id: &str, arm: &impl ForwardDynamics<N>) -> f64 {
    let entry = entry(id);
    let [q, qd, tau] = ["q", "qd", "tau"].map(|name| entry.vector::<N>(name).map(|x| x as f32));
    match arm.forward_dynamics(&q, &qd, &tau) {
        Ok(qdd) => relative_error(&qdd.map(f64::from), &entry.exact("qdd")),
        Err(_) => f64::INFINITY,
    }
}

/// Accelerations by M and its factors.
fn by_factors<const N: usize>(id: &str, arm: &NewtonEuler<N>) -> f64 {
    let entry = entry(id);
    let [q, qd, tau] = ["q", "qd", "tau"].map(|name| entry.vector(name));
    match arm.forward_dynamics(&q, &qd, &tau) {
        Ok(qdd) => relative_error(&qdd, &entry.exact("qdd")),
        Err(_) => f64::INFINITY,
    }
}

/// The error of accelerations that the pivots of M predict.
fn predicted<const N: usize>(mass_matrix: &SMatrix<f64, N, N>) -> f64 {
    Conditioning::of(mass_matrix).error()
}

/// The proven bound of the accelerations' errors beside the errors, and beside what the pivots say that
/// accelerations lose: no more than some roundings more, and less where the program has a small pivot as a product.
/// The bound is at most `sharpness` times the error.
pub(crate) fn proven<const N: usize>(
    id: &'static str,
    arm: &(impl ForwardDynamics<N> + InverseDynamics<N> + MassMatrix<N>),
    predicted: f64,
    sharpness: f64,
) -> [Score; 3] {
    let entry = entry(id);
    let [q, qd, tau] = ["q", "qd", "tau"].map(|name| entry.vector::<N>(name).map(Certified::exact));
    let unknown = SVector::repeat(Certified::with_error(f64::NAN, f64::INFINITY));
    let qdd = certified::forward_dynamics(arm, &q, &qd, &tau).unwrap_or(unknown);
    let bound = qdd.map(|x| x.bound()).norm();
    let relative = bound / qdd.map(|x| x.value()).norm();
    let error = relative_error(&qdd.map(|x| x.value()), &entry.exact("qdd"));
    [
        Score::at_least(
            id,
            "proven bound of the error of qdd, over the error",
            relative / error,
            1.0,
        ),
        Score::at_most(
            id,
            "proven bound of the error of qdd, over the error, at most",
            relative / error,
            sharpness,
        ),
        Score::at_most(
            id,
            "proven bound of the error of qdd, over what the pivots predict",
            relative / predicted,
            10.0,
        ),
    ]
}

/// A straight chain of equal rods: the condition number of M grows with the fourth power of the
/// number of joints, the error of articulated bodies hardly at all.
fn straight_chain<const N: usize>(
    id: &'static str,
    arm: &impl ForwardDynamics<N>,
    articulated: &impl ForwardDynamics<N>,
    numeric: NewtonEuler<N>,
) -> Vec<Score> {
    let m = numeric.mass_matrix(&entry(id).vector("q"));
    let bounds = match N {
        10 => Bounds {
            double: (1e-13, 2e-13),
            single: (5e-5, 1.1e-4),
            factors: 1e-11,
        },
        _ => Bounds {
            double: (5e-12, 5e-11),
            single: (1e-3, 2e-2),
            factors: 1e-9,
        },
    };
    let (double, single) = (error(id, arm), single_error(id, arm));
    let of_factors = by_factors(id, &numeric);
    let at_most = |what: &str, value: f64, bound: f64| {
        Score::at_most(id, format!("error of qdd, {what}"), value, bound)
    };
    vec![
        at_most("forward_dynamics", double, bounds.double.0).naive(bounds.double.1),
        at_most("forward_dynamics, f32", single, bounds.single.0).naive(bounds.single.1),
        at_most("forward_dynamics_aba", error(id, articulated), 1e-13).naive(bounds.double.1),
        at_most(
            "forward_dynamics_aba, f32",
            single_error(id, articulated),
            1e-5,
        )
        .naive(bounds.single.1),
        at_most("M and its factors", of_factors, bounds.factors),
        at_most(
            "M and its factors, over what the pivots predict",
            of_factors / predicted(&m),
            10.0,
        ),
    ]
}

/// The price of the accuracy of `forward_dynamics_aba`. On a planar chain it is low: there `forward_dynamics` is
/// written by articulated bodies too, in two passes.
fn cost(
    id: &'static str,
    short: &[(&str, Operations)],
    articulated: &[(&str, Operations)],
) -> Score {
    let total = |functions: &[(&str, Operations)]| f64::from(functions[0].1.total());
    let ratio = total(articulated) / total(short);
    let quantity = "operations of forward_dynamics_aba over those of forward_dynamics";
    Score::at_most(id, quantity, ratio, 2.0)
}

/// Bounds of the errors of a chain; where there are two, the second is what a factorisation of M by
/// Cholesky gets.
struct Bounds {
    double: (f64, f64),
    single: (f64, f64),
    factors: f64,
}

/// 10^9 kg at the end of a light arm that is nearly straight: what the first joint feels with the
/// second free is 10^-8 of what it feels with it locked.
fn heavy_payload() -> Vec<Score> {
    let id = "HC02";
    let arm = PointMasses { m1: 1.0, m2: 1e9 };
    let m = arm.mass_matrix(&entry(id).vector("q"));
    let predicted = predicted(&m);
    let found = error(id, &arm);
    let mut scores = vec![
        Score::at_most(id, "error of M", matrix_error(id, &m), 1e-15),
        Score::at_least(id, "predicted error of qdd", predicted, 1e-8),
        Score::at_most(
            id,
            "error of qdd, over what the pivots predict",
            found / predicted,
            10.0,
        ),
        Score::at_most(
            id,
            "joint that the pivots name",
            Conditioning::of(&m).joint as f64,
            0.0,
        ),
        Score::at_most(
            id,
            "error of qdd, forward_dynamics_aba",
            error(id, &ArticulatedMasses { m1: 1.0, m2: 1e9 }),
            1e-13,
        )
        .naive(4e-8),
    ];
    scores.extend(proven(id, &arm, predicted, 2.0));
    scores
}

/// The same arm, and lighter payloads, moves through the stretched pose: accelerations with few correct
/// digits are noise, which an error control answers with ever smaller steps.
fn through_the_stretched_pose() -> Vec<Score> {
    let (id, entry) = ("HC03", entry("HC03"));
    let (q, qd) = (Vector2::new(-1.2, 0.6), Vector2::new(0.0, -1.0));
    let mut scores = Vec::new();
    for (name, m2) in [("1", 1.0), ("1e3", 1e3), ("1e6", 1e6), ("1e9", 1e9)] {
        let arm = ArticulatedMasses { m1: 1.0, m2 };
        let counted = Counted::new(&arm);
        let motion = free(&counted, dop853(1e-12), q, qd, 1.0, 2);
        let exact = entry.exact(&format!("q(1), r={name}"));
        let error = motion.map_or(f64::INFINITY, |m| absolute_error(&m.q[1], &exact));
        let calls = counted.calls();
        scores.extend([
            Score::at_most(
                id,
                format!("error of q after 1 s, payload {name}, aba, DOP853 at 1e-12"),
                error,
                1e-9,
            ),
            Score::at_most(
                id,
                format!("evaluations, payload {name}, aba, DOP853 at 1e-12"),
                calls,
                30_000.0,
            )
            .naive(4_137_486.0),
        ]);
    }
    scores
}

fn matrix_error<const N: usize>(id: &str, m: &SMatrix<f64, N, N>) -> f64 {
    relative_error(m, &entry(id).exact("M"))
}

/// 10^-12 kg at the end: the condition number is 10^12, and no digit is lost.
fn light_payload() -> Vec<Score> {
    let id = "HC04";
    let arm = PointMasses { m1: 1.0, m2: 1e-12 };
    let m = arm.mass_matrix(&entry(id).vector("q"));
    vec![
        Score::at_most(id, "error of M", matrix_error(id, &m), 1e-15),
        Score::at_most(id, "error of qdd", error(id, &arm), 1e-14).naive(f64::INFINITY),
        Score::at_most(
            id,
            "digits lost, by the pivots",
            Conditioning::of(&m).lost_digits(),
            1.0,
        )
        .naive(12.0),
    ]
}

/// A wrist of 10^-12 of the PUMA's: a condition number beyond 10^16, and no digit is lost.
fn graded_wrist() -> Vec<Score> {
    let id = "HC05";
    let m = GradedPuma.mass_matrix(&entry(id).vector("q"));
    vec![
        Score::at_most(id, "error of qdd", error(id, &GradedPuma), 1e-14).naive(f64::INFINITY),
        Score::at_most(
            id,
            "digits lost, by the pivots",
            Conditioning::of(&m).lost_digits(),
            1.0,
        )
        .naive(16.0),
    ]
}

/// The condition number of the PUMA's M, with its motors and without: 25 and 75,000.
fn reflected_inertia() -> Vec<Score> {
    let id = "HC08";
    let q: SVector<f64, 6> = entry(id).vector("q");
    let condition = |m: SMatrix<f64, 6, 6>| {
        let values = m.symmetric_eigenvalues();
        values.max() / values.min()
    };
    let arms = [
        ("with motors", Puma560.mass_matrix(&q), 25.446),
        ("without motors", DirectPuma.mass_matrix(&q), 74_531.0),
    ];
    let score = |(name, m, expected): (&str, SMatrix<f64, 6, 6>, f64)| {
        [
            Score::at_most(
                id,
                format!("condition number {name}, relative error"),
                (condition(m) / expected - 1.0).abs(),
                2e-5,
            ),
            Score::at_most(
                id,
                format!("digits lost {name}, by the pivots"),
                Conditioning::of(&m).lost_digits(),
                1.0,
            ),
        ]
    };
    arms.map(score).concat()
}
