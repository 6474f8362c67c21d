//! The functions that controllers ask for, in doubles beside the table in 31 digits.

use robot_dynamics::nalgebra::{Matrix6, SMatrix, SVector};
use robot_dynamics::{
    DoubleDouble, Model, State,
    check::{Evaluate, Evaluation},
};
use robots::*;
use testkit::exact::Exact;
use testkit::random::Random;

use super::exact::largest;

/// Relative to what is added up, for each joint: as for the functions of the default set.
const BOUND: f64 = 4e-15;

type Joints<const N: usize> = SVector<DoubleDouble, N>;

/// The state in 31 digits, with the arguments that the evaluation makes of it.
struct Motion<const N: usize> {
    q: Joints<N>,
    qd: Joints<N>,
    qdd: Joints<N>,
    qd_r: Joints<N>,
    qdd_r: Joints<N>,
    jerk: Joints<N>,
    snap: Joints<N>,
}

impl<const N: usize> Motion<N> {
    fn of(state: &State<N>) -> Self {
        let number = |x: SVector<f64, N>| x.map(DoubleDouble::from);
        Motion {
            q: number(state.q),
            qd: number(state.qd),
            qdd: number(state.qdd),
            qd_r: number(state.reference_velocity()),
            qdd_r: number(state.reference_acceleration()),
            jerk: number(state.jerk()),
            snap: number(state.snap()),
        }
    }
}

/// The largest error of the entries over their magnitude.
fn error<const R: usize, const C: usize>(
    found: Option<SMatrix<f64, R, C>>,
    exact: &SMatrix<DoubleDouble, R, C>,
    magnitude: f64,
) -> f64 {
    let found = found.expect("asked for").map(DoubleDouble::from);
    match largest(&(found - exact)) {
        0.0 => 0.0,
        error if error.is_nan() => f64::INFINITY,
        error => error / magnitude,
    }
}

/// How large are the terms of M, C and G, of the own forces of the joints, and of Jacobians.
struct Magnitude {
    inertia: f64,
    coriolis: f64,
    own: f64,
    lever: f64,
}

impl Magnitude {
    fn at<const N: usize>(exact: &Exact<N>, at: &Motion<N>) -> Self {
        let q = &at.q;
        let unit = |k: usize| {
            let mut unit = Joints::<N>::zeros();
            unit[k] = DoubleDouble::from(1.0);
            unit
        };
        let pairs = (0..N).flat_map(|i| (i..N).map(move |j| (i, j)));
        let symbols = pairs.map(|(i, j)| largest(&exact.coriolis(q, &unit(i), &unit(j))));
        let rest = exact.inverse_dynamics(q, &at.qd, &Joints::zeros());
        let moving = exact.coriolis_vector(q, &at.qd);
        let (links, tip) = (exact.link_jacobians(q), exact.jacobian(q));
        let levers = links.iter().chain([&tip]).map(largest);
        let centers = exact.masses(q).into_iter().map(|(_, c)| largest(&c));
        let inertia = largest(&exact.mass_matrix(q));
        Magnitude {
            inertia,
            // Where M is constant, all that is there of the symbols is the rounding of the table's side.
            coriolis: symbols.fold(1e-6 * inertia, f64::max),
            own: largest(&exact.gravity_vector(q)) + largest(&(rest - moving)),
            lever: levers.chain(centers).fold(1.0, f64::max),
        }
    }
}

/// The error of each function at a state.
fn errors<const N: usize>(
    found: &Evaluation,
    exact: &Exact<N>,
    at: &Motion<N>,
) -> [(&'static str, f64); 13] {
    let Motion { q, qd, qdd, .. } = at;
    let size = Magnitude::at(exact, at);
    let [v, a, jerk, snap] = [qd, qdd, &at.jerk, &at.snap].map(largest);
    let [v_r, a_r] = [&at.qd_r, &at.qdd_r].map(largest);
    let wrench = State::<N>::wrench().map(DoubleDouble::from);
    let jacobian = exact.jacobian(q);
    let n = N as f64;

    let torque = exact.passivity_torque(q, [qd, &at.qd_r, &at.qdd_r]);
    let without_own = {
        let friction = exact.inverse_dynamics(q, qd, &Joints::zeros())
            - exact.coriolis_vector(q, qd)
            - exact.gravity_vector(q);
        torque - friction
    };
    let torques = size.inertia * a_r + size.coriolis * v * v_r + size.own;
    let rates = exact.inverse_dynamics_rates(&[*q, *qd, *qdd, at.jerk, at.snap]);
    let (first, second) = found.get("inverse_dynamics_rates").expect("asked for");
    // Each derivative by a position leaves a product of sines, lengths and masses as large as it was.
    let of_first =
        size.inertia * jerk + size.coriolis * n * (3.0 * v * a + v.powi(3)) + size.own * (v + a);
    let of_second = size.inertia * snap
        + size.coriolis * n * (4.0 * v * jerk + 3.0 * a * a + 6.0 * v * v * a + v.powi(4))
        + size.own * (a + v * v + jerk);

    let inverse = found.get("operational_inertia_inverse");
    let inverse: Matrix6<f64> = inverse.expect("asked for, and M is positive definite");
    let of_inverse = exact.operational_inertia_inverse(q);
    let inverse_of_m = exact
        .mass_matrix(q)
        .map(DoubleDouble::high)
        .try_inverse()
        .expect("M is positive definite");
    // An error dM of M is one of M^-1 dM M^-1.
    let conditioned = size.lever * size.inertia.sqrt() * inverse_of_m.amax();

    let links: [SMatrix<f64, 6, N>; N] = found.get("link_jacobians").expect("asked for");
    let of_links = links.iter().zip(exact.link_jacobians(q));
    let of_links = of_links.map(|(j, exact)| error(Some(*j), &exact, size.lever));
    [
        (
            "J'w",
            error(
                found.get("wrench_torques"),
                &jacobian.tr_mul(&wrench),
                8.0 * size.lever,
            ),
        ),
        (
            "J qd",
            error(found.get("tool_velocity"), &(jacobian * qd), size.lever * v),
        ),
        ("d(J qd)", {
            let exact = exact.tool_acceleration(q, qd, qdd);
            error(
                found.get("tool_acceleration"),
                &exact,
                size.lever * (a + n * v * v),
            )
        }),
        (
            "dJ",
            error(
                found.get("jacobian_rate"),
                &exact.jacobian_rate(q, qd),
                size.lever * n * v,
            ),
        ),
        ("links", of_links.fold(0.0, f64::max)),
        (
            "com",
            error(
                found.get("center_of_mass"),
                &exact.center_of_mass(q),
                size.lever,
            ),
        ),
        ("d com", {
            let exact = exact.center_of_mass_jacobian(q);
            error(found.get("center_of_mass_jacobian"), &exact, size.lever)
        }),
        (
            "J M^-1 J'",
            error(Some(inverse), &of_inverse, conditioned * conditioned),
        ),
        ("M qd", {
            let exact = exact.mass_matrix(q) * qd;
            error(found.get("generalized_momentum"), &exact, size.inertia * v)
        }),
        ("bias", {
            let exact = exact.momentum_bias(q, qd);
            error(
                found.get("momentum_bias"),
                &exact,
                size.coriolis * v * v + size.own,
            )
        }),
        (
            "passive",
            error(found.get("passivity_torque"), &torque, torques),
        ),
        (
            "Y_r b",
            error(found.get("passivity_form"), &without_own, torques),
        ),
        ("rates", {
            let first = error(Some(first), &rates[0], of_first);
            f64::max(first, error(Some(second), &rates[1], of_second))
        }),
    ]
}

/// Prints the largest error of each function in units of 1e-15 for each joint, and asserts the bound.
fn check<const N: usize>(name: &str, robot: &(impl Model<N> + Evaluate<N>)) {
    let table = robot.table();
    let exact = Exact(&table);
    let mut random = Random::seeded(23);
    let mut worst = [("", 0.0_f64); 13];
    for _ in 0..3 {
        let state = State {
            q: random.vector(3.0),
            qd: random.vector(2.0),
            qdd: random.vector(5.0),
        };
        let found = robot.evaluate(&state, &SVector::zeros());
        let errors = errors(&found, &exact, &Motion::of(&state));
        for ((function, error), worst) in errors.into_iter().zip(&mut worst) {
            *worst = (function, worst.1.max(error));
        }
    }
    let unit = 1e-15 * N as f64;
    let shown = worst.map(|(function, error)| format!("{function} {:.2}", error / unit));
    println!("{name:26} {}", shown.join(", "));
    for (function, error) in worst {
        assert!(error <= BOUND * N as f64, "{name} {function}: {error:e}");
    }
}

macro_rules! check_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        $(check::<$n>(stringify!($file), &$robot);)*
    };
}

#[test]
fn functions_of_controllers_have_the_digits_of_the_table() {
    for_each_robot!(check_all);
    check_all! { tilting_cell: TiltingCell, 4, 6; }
}

/// T by the parameters is 1/2 qd' M qd; U differs from that of the weights by a constant.
fn energies<const N: usize>(robot: &(impl Model<N> + Evaluate<N>)) {
    let table = robot.table();
    let exact = Exact(&table);
    let gravity = SVector::<_, 3>::from(table.gravity).map(DoubleDouble::from);
    let mut random = Random::seeded(29);
    let mut constant = None;
    for _ in 0..4 {
        let state = State {
            q: random.vector(3.0),
            qd: random.vector(2.0),
            qdd: SVector::zeros(),
        };
        let found = robot.evaluate(&state, &SVector::zeros());
        let energies: Option<(f64, f64)> = found.get("energies_form");
        let (kinetic, potential) = energies.expect("asked for");
        let Motion { q, qd, .. } = Motion::of(&state);
        let m = exact.mass_matrix(&q);
        let half = DoubleDouble::from(0.5);
        let missing = (qd.dot(&(m * qd)) * half - DoubleDouble::from(kinetic)).high();
        let size = largest(&m) * (qd.map(DoubleDouble::high)).norm_squared() * N as f64;
        assert!(missing.abs() <= BOUND * size, "T: {missing:e}");

        let weights = exact.masses(&q);
        let zero = DoubleDouble::from(0.0);
        let expected = weights
            .iter()
            .fold(zero, |sum, (m, c)| sum - gravity.dot(c) * *m);
        let sizes = weights.iter().map(|(m, c)| m.high() * largest(c));
        let size = largest(&gravity) * sizes.sum::<f64>() * N as f64;
        let difference = (expected - DoubleDouble::from(potential)).high();
        let constant = *constant.get_or_insert(difference);
        let missing = difference - constant;
        assert!(missing.abs() <= 2.0 * BOUND * size, "U: {missing:e}");
    }
}

macro_rules! energies_of_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        $(energies::<$n>(&$robot);)*
    };
}

#[test]
fn energies_of_the_parameters_are_those_of_the_table() {
    for_each_robot!(energies_of_all);
    energies_of_all! { tilting_cell: TiltingCell, 4, 6; }
}
