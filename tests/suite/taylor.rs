//! The Taylor coefficients of every robot, against series of 31 digits in its forward dynamics.
//!
//! Two programs that share nothing but the table, the proof and the numbers of the tests: the
//! recurrences run over the inverse dynamics, these series over the forward dynamics, each operation
//! by its textbook definition.

use std::ops::{Add, Div, Mul, Neg, Sub};

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{DoubleDouble, Scalar, simulation::TaylorDynamics};
use robots::*;
use testkit::random::Random;

/// Coefficients 0 to 9 of q: 0 to 7 of the accelerations.
const ORDER: usize = 9;
const TERMS: usize = ORDER - 1;

/// A series, its coefficients from order 0 on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Truncated([DoubleDouble; TERMS]);

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from_f64(x)
}

impl Truncated {
    fn from_terms(term: impl FnMut(usize) -> DoubleDouble) -> Self {
        Truncated(std::array::from_fn(term))
    }

    fn constant_of(x: DoubleDouble) -> Self {
        Truncated::from_terms(|k| if k == 0 { x } else { number(0.0) })
    }
}

impl Add for Truncated {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Truncated::from_terms(|k| self.0[k] + other.0[k])
    }
}

impl Sub for Truncated {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Truncated {
    type Output = Self;
    fn neg(self) -> Self {
        Truncated(self.0.map(|x| -x))
    }
}

impl Mul for Truncated {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Truncated::from_terms(|k| {
            let products = (0..=k).map(|j| self.0[j] * other.0[k - j]);
            products.fold(number(0.0), |sum, x| sum + x)
        })
    }
}

impl Div for Truncated {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let mut quotient = Truncated::from_f64(0.0);
        for k in 0..TERMS {
            let known = quotient * other;
            quotient.0[k] = (self.0[k] - known.0[k]) / other.0[0];
        }
        quotient
    }
}

impl Scalar for Truncated {
    fn from_f64(x: f64) -> Self {
        Truncated::constant_of(number(x))
    }

    fn epsilon() -> Self {
        Truncated::constant_of(DoubleDouble::epsilon())
    }

    /// sin(a + x) with the series of sine and cosine of x, which has no constant term.
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0[0].sin_cos();
        let (s, c) = (Truncated::constant_of(s), Truncated::constant_of(c));
        let mut x = self;
        x.0[0] = number(0.0);
        let (mut sine, mut cosine) = (Truncated::from_f64(0.0), Truncated::from_f64(0.0));
        let mut power = Truncated::from_f64(1.0);
        for k in 0..TERMS {
            match k % 4 {
                0 => cosine = cosine + power,
                1 => sine = sine + power,
                2 => cosine = cosine - power,
                _ => sine = sine - power,
            }
            power = power * x / Truncated::from_f64((k + 1) as f64);
        }
        (s * cosine + c * sine, c * cosine - s * sine)
    }

    fn sqrt(self) -> Self {
        unimplemented!("no equation of motion has a root")
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn sign(self) -> Self {
        Truncated::constant_of(self.0[0].sign())
    }

    fn is_positive(self) -> bool {
        self.0[0].is_positive()
    }

    fn ratio_to_f64(self, of: Self) -> f64 {
        self.0[0].ratio_to_f64(of.0[0])
    }
}

/// q_0 to q_9: each evaluation of the accelerations gives one more coefficient.
fn by_forward_dynamics<const N: usize, const P: usize, R: Arm<N, P>>(
    robot: &R,
    [q, qd, tau]: [SVector<DoubleDouble, N>; 3],
) -> [SVector<DoubleDouble, N>; ORDER + 1] {
    let mut series = [SVector::repeat(number(0.0)); ORDER + 1];
    (series[0], series[1]) = (q, qd);
    let tau = tau.map(Truncated::constant_of);
    for k in 0..TERMS {
        let of = |i: usize| Truncated::from_terms(|j| series[j][i]);
        let rate = |i: usize| Truncated::from_terms(|j| series[j + 1][i] * number((j + 1) as f64));
        let (q, qd) = (
            SVector::from_fn(|i, _| of(i)),
            SVector::from_fn(|i, _| rate(i)),
        );
        let qdd = robot
            .forward_dynamics(&q, &qd, &tau)
            .expect("accelerations");
        let factor = number(((k + 1) * (k + 2)) as f64);
        series[k + 2] = qdd.map(|x| x.0[k] / factor);
    }
    series
}

/// The largest error of a coefficient, relative to the largest of its order.
fn worst<const N: usize>(
    computed: &[SVector<f64, N>],
    expected: &[SVector<DoubleDouble, N>],
) -> f64 {
    let error = |(x, exact): (&SVector<f64, N>, &SVector<DoubleDouble, N>)| {
        let size = exact.map(|x| x.high()).amax();
        let difference = x.zip_map(exact, |x, exact| (number(x) - exact).high());
        difference.amax() / size.max(1e-30)
    };
    computed.iter().zip(expected).map(error).fold(0.0, f64::max)
}

/// The error is what rounding, of the operations and of the constants in both programs, becomes by the
/// mass matrix: two digits or three.
fn agrees<const N: usize, const P: usize, R: Arm<N, P> + TaylorDynamics<N>>(robot: &R) {
    let mut random = Random::seeded(7);
    let [q, qd, tau] = [2.0, 1.0, 5.0].map(|size| random.vector(size));
    let exact = [q, qd, tau].map(|x: SVector<f64, N>| x.map(DoubleDouble::from));
    let expected = by_forward_dynamics(robot, exact);
    let computed = robot.taylor_series(&q, &qd, &tau, ORDER).expect("a series");
    let error = worst(&computed[..=ORDER], &expected);
    assert!(error < 1e-11, "{error:e}");
    assert!(computed[ORDER + 1].iter().all(|x| *x == 0.0));
}

macro_rules! tests {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {$(
        #[test]
        fn $file() {
            agrees(&$robot);
        }
    )*};
}
for_each_robot!(tests);
tests! { gripper_arm: GripperArm, 3, 3; palletiser: Palletiser, 3, 3; }
