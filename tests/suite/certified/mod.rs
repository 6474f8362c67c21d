//! Proven bounds of rounding errors beside the errors themselves.
//!
//! Every robot, at ordinary states, at rest and at angles of 1e6 rad: no error may exceed its bound, and of each
//! function the mean of error over bound must not be below 1/50, over all robots. For single robots it is: bounds
//! know nothing of errors that cancel, and long chains at any angles have many of them. Run with `--nocapture` to
//! see the means.

mod decimals;
mod every_function;
mod nearly_singular;
mod solved;

use decimals::Decimals;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Certified, CoriolisVector, DoubleDouble, ForwardDynamics, GravityVector, InverseDynamics,
    MassMatrix, Model, certified, certified::Rounded,
};
use robots::*;
use testkit::exact::Exact;
use testkit::random::Random;

/// How small errors may be beside their bounds, in the mean.
const LEAST_MEAN: f64 = 1.0 / 50.0;

/// How far the exact values may be off, relative to their magnitudes: 31 digits, of which elimination and
/// the digits of the table's decimals cost some.
const DIGITS: f64 = 1e-22;

/// Errors over bounds.
#[derive(Clone, Copy, Debug, Default)]
struct Ratios {
    sum: f64,
    count: u32,
    largest: f64,
}

impl Ratios {
    /// Compares computed numbers with exact ones, whose magnitude is `size`.
    #[track_caller]
    fn add<'a, F: Rounded<Magnitude: Into<f64>>>(
        &mut self,
        found: impl IntoIterator<Item = &'a Certified<F>>,
        exact: impl IntoIterator<Item = &'a DoubleDouble>,
        size: f64,
    ) {
        for (found, exact) in found.into_iter().zip(exact) {
            let value = DoubleDouble::from(found.value().to_f64());
            let error = (value - *exact).abs().high();
            let bound = found.bound().into();
            let uncertainty = DIGITS * size;
            assert!(error <= bound + uncertainty, "{error:e} above {bound:e}");
            // Entries that vanish identically have no rounding to bound.
            if bound > uncertainty {
                self.sum += error / bound;
                self.largest = self.largest.max(error / bound);
                self.count += 1;
            }
        }
    }

    fn mean(self) -> f64 {
        match self.count {
            0 => 1.0,
            count => self.sum / f64::from(count),
        }
    }
}

/// A state, and torques there.
struct State<const N: usize> {
    q: SVector<f64, N>,
    qd: SVector<f64, N>,
    qdd: SVector<f64, N>,
}

impl<const N: usize> State<N> {
    /// Every eighth at rest, every eighth far from zero.
    fn random(random: &mut Random, number: usize) -> Self {
        let (turn, speed) = match number % 8 {
            6 => (3.0, 0.0),
            7 => (1e6, 3.0),
            _ => (3.0, 3.0),
        };
        State {
            q: random.vector(turn),
            qd: random.vector(speed),
            qdd: random.vector(10.0),
        }
    }

    /// Numbers that both precisions have.
    fn in_single_precision(self) -> Self {
        let [q, qd, qdd] = [self.q, self.qd, self.qdd].map(|x| x.map(|x| f64::from(x as f32)));
        State { q, qd, qdd }
    }
}

fn exactly<F: Rounded, const N: usize>(x: &SVector<f64, N>) -> SVector<Certified<F>, N> {
    x.map(|x| Certified::exact(F::from_f64(x)))
}

fn values<F: Rounded, const R: usize, const C: usize>(
    found: &SMatrix<Certified<F>, R, C>,
) -> SMatrix<F, R, C> {
    found.map(|x| x.value())
}

/// The functions that are compared: accelerations by the method, and by the function of `certified` in both precisions.
const FUNCTIONS: [&str; 7] = ["M", "V", "G", "tau", "qdd", "certified", "in f32"];

/// M, V, G, tau and qdd of a robot whose cells are decimals, against Newton-Euler in 31 digits on these.
fn ratios<const N: usize, R>(
    name: &'static str,
    robot: &R,
    states: usize,
) -> (&'static str, [Ratios; FUNCTIONS.len()])
where
    R: Model<N>
        + MassMatrix<N>
        + CoriolisVector<N>
        + GravityVector<N>
        + InverseDynamics<N>
        + ForwardDynamics<N>,
{
    let decimals = Decimals::of(robot.table());
    let mut random = Random::seeded(13);
    let mut ratios = [Ratios::default(); FUNCTIONS.len()];
    for number in 0..states {
        let State { q, qd, qdd } = State::<N>::random(&mut random, number).in_single_precision();
        let [x, xd, xdd] = [&q, &qd, &qdd].map(|x| x.map(DoubleDouble::from));
        let of = |exact: &Exact<N>| exact.inverse_dynamics(&x, &xd, &xdd);
        let tau = decimals.exact(of);
        let m = decimals.exact(|exact| exact.mass_matrix(&x));
        let force = largest(&m) * (1.0 + qd.amax().powi(2) + qdd.amax()) + largest(&tau);
        let [cq, cqd, cqdd] = [&q, &qd, &qdd].map(exactly::<f64, N>);

        let found = robot.mass_matrix(&cq);
        assert_eq!(values(&found), robot.mass_matrix(&q));
        ratios[0].add(&found, &m, largest(&m));

        let found = robot.coriolis_vector(&cq, &cqd);
        assert_eq!(values(&found), robot.coriolis_vector(&q, &qd));
        let exact = decimals.exact(|exact| exact.coriolis_vector(&x, &xd));
        ratios[1].add(&found, &exact, force);

        let found = robot.gravity_vector(&cq);
        assert_eq!(values(&found), robot.gravity_vector(&q));
        let exact = decimals.exact(|exact| exact.gravity_vector(&x));
        ratios[2].add(&found, &exact, force);

        let found = robot.inverse_dynamics(&cq, &cqd, &cqdd);
        assert_eq!(values(&found), robot.inverse_dynamics(&q, &qd, &qdd));
        ratios[3].add(&found, &tau, force);

        let given = tau.map(|x| f64::from(x.high() as f32));
        let given_exactly = given.map(DoubleDouble::from);
        let exact = decimals.exact(|exact| exact.forward_dynamics(&x, &xd, &given_exactly));
        let tau = exactly(&given);
        let running = robot.forward_dynamics(&cq, &cqd, &tau).expect("regular");
        let sharp = certified::forward_dynamics(robot, &cq, &cqd, &tau).expect("regular");
        let plain = robot.forward_dynamics(&q, &qd, &given).expect("regular");
        for (k, found) in [(4, running), (5, sharp)] {
            assert_eq!(values(&found), plain);
            ratios[k].add(&found, &exact, force * largest(&exact));
        }
        let [sq, sqd, stau] = [&q, &qd, &given].map(exactly::<f32, N>);
        let single = certified::forward_dynamics(robot, &sq, &sqd, &stau).expect("regular");
        let [q, qd, tau] = [sq, sqd, stau].map(|x| values(&x));
        assert_eq!(
            values(&single),
            robot.forward_dynamics(&q, &qd, &tau).expect("regular")
        );
        ratios[6].add(&single, &exact, force * largest(&exact));
    }
    let means = ratios
        .map(|ratios| format!("{:8.5}", ratios.mean()))
        .join(" ");
    println!("{name:26} {means}");
    (name, ratios)
}

/// The largest of the entries.
fn largest<const R: usize, const C: usize>(x: &SMatrix<DoubleDouble, R, C>) -> f64 {
    super::exact::largest(x)
}

/// The cells of these are no decimals: the tensor of a rod has a twelfth in it.
const RODS: [&str; 2] = ["one_link", "two_link_saha"];

/// At so many states of each robot.
fn assert_below_bounds(states: usize) {
    macro_rules! ratios_of_all {
        ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {{
            let mut all = Vec::new();
            $(if !RODS.contains(&stringify!($file)) {
                all.push(ratios::<$n, _>(stringify!($file), &$robot, states));
            })*
            all
        }};
    }
    println!("{}", FUNCTIONS.join(", "));
    let all = for_each_robot!(ratios_of_all);
    for (k, function) in FUNCTIONS.iter().enumerate() {
        let mut means: Vec<f64> = all.iter().map(|(_, ratios)| ratios[k].mean()).collect();
        means.sort_by(f64::total_cmp);
        let mean = means.iter().sum::<f64>() / means.len() as f64;
        let [least, median] = [means[0], means[means.len() / 2]];
        println!("{function:9} mean {mean:.3}, median {median:.3}, least {least:.5}");
        assert!(
            mean >= LEAST_MEAN && median >= LEAST_MEAN,
            "{function}: {means:?}"
        );
    }
    // Each robot by itself: what is not rounded at all has no error, and of constants, which are known to half a unit in
    // the last place, long chains have hundreds.
    const LONG: [&str; 4] = [
        "generic_chain_n6",
        "generic_chain_n7",
        "generic_chain_n10",
        "generic_chain_n12",
    ];
    for (name, ratios) in &all {
        for ratios in ratios[5..].iter().filter(|ratios| ratios.largest > 0.0) {
            // Where the build fuses products with sums, errors get smaller by more than their bounds do.
            let share = match (LONG.contains(name), cfg!(target_feature = "fma")) {
                (true, _) => 0.01,
                (false, true) => 0.5,
                (false, false) => 1.0,
            };
            let least = share * LEAST_MEAN;
            assert!(ratios.mean() >= least, "{name}: {ratios:?}");
        }
    }
}

#[test]
fn errors_stay_below_bounds_that_are_not_much_larger() {
    assert_below_bounds(8);
}

/// `cargo test -p tests --test suite certified:: -- --ignored --nocapture`
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn errors_stay_below_bounds_at_many_states() {
    assert_below_bounds(40);
}
