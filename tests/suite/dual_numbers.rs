//! Generated functions on the dual numbers of the crate `num-dual`.

use num_dual::{Dual, Dual64, DualSVec64, HyperDual64, jacobian};
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{Scalar, State};
use robots::*;
use testkit::random::Random;

fn states<const N: usize>() -> [State<N>; 8] {
    let mut random = Random::seeded(7);
    std::array::from_fn(|_| State {
        q: random.vector(std::f64::consts::PI),
        qd: random.vector(3.0),
        qdd: random.vector(10.0),
    })
}

/// Asserts that two matrices differ by no more than some roundings of their largest number.
#[track_caller]
fn assert_near<const R: usize, const C: usize>(a: SMatrix<f64, R, C>, b: SMatrix<f64, R, C>) {
    let bound = 1e-13 * b.amax().max(1.0);
    assert!((a - b).amax() <= bound, "{a} is not {b}");
}

/// One evaluation on vectors of derivatives is the whole Jacobian of the torques, and of the
/// accelerations; the value beside it is that of the function itself.
fn jacobians_are_the_generated_derivatives<const N: usize, const P: usize>(robot: &impl Arm<N, P>) {
    for State { q, qd, qdd } in &states() {
        let tau = robot.inverse_dynamics(q, qd, qdd);
        let [at_q, at_qd, at_qdd, at_tau] = [*q, *qd, *qdd, tau].map(|x| x.map(DualSVec64::from));
        let (by_position, by_velocity) = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let (value, found) = jacobian(|q| robot.inverse_dynamics(&q, &at_qd, &at_qdd), q);
        assert_near(value, tau);
        assert_near(found, by_position);
        let (_, found) = jacobian(|qd| robot.inverse_dynamics(&at_q, &qd, &at_qdd), qd);
        assert_near(found, by_velocity);

        let derivatives = robot.forward_dynamics_derivatives(q, qd, &tau);
        let (by_position, _, by_torque) = derivatives.expect("M is positive definite");
        let qdd = |q: &SVector<_, N>, tau: &SVector<_, N>| {
            let qdd = robot.forward_dynamics(q, &at_qd, tau);
            qdd.expect("M is positive definite")
        };
        assert_near(jacobian(|q| qdd(&q, &at_tau), q).1, by_position);
        assert_near(jacobian(|tau| qdd(&at_q, &tau), &tau).1, by_torque);
    }
}

/// d2 U / dq_i dq_j by hyper-dual numbers, by dual numbers of dual numbers, and as dG/dq.
fn second_derivatives_are_those_of_gravity<const N: usize, const P: usize>(robot: &impl Arm<N, P>) {
    for State { q, .. } in &states() {
        let gravity = |q: SVector<DualSVec64<N>, N>| robot.gravity_vector(&q);
        let (_, expected) = jacobian(gravity, q);
        let hyper = SMatrix::<f64, N, N>::from_fn(|i, j| {
            let is = |k: usize, i: usize| if k == i { 1.0 } else { 0.0 };
            let q =
                SVector::<_, N>::from_fn(|k, _| HyperDual64::new(q[k], is(k, i), is(k, j), 0.0));
            robot.potential_energy(&q).eps1eps2
        });
        assert_near(hyper, expected);
        let nested = SMatrix::<f64, N, N>::from_fn(|i, j| {
            let is = |k: usize, i: usize| if k == i { 1.0 } else { 0.0 };
            let q = SVector::<_, N>::from_fn(|k, _| {
                Dual::new(Dual64::new(q[k], is(k, i)), Dual64::new(is(k, j), 0.0))
            });
            robot.potential_energy(&q).eps.eps
        });
        assert_near(nested, expected);
    }
}

macro_rules! on {
    ($($module:ident: $robot:ident;)*) => {$(
        mod $module {
            use super::*;

            #[test]
            fn jacobians() {
                jacobians_are_the_generated_derivatives(&$robot);
            }

            #[test]
            fn second_derivatives() {
                second_derivatives_are_those_of_gravity(&$robot);
            }
        }
    )*};
}

on! {
    two_link_saha: TwoLinkSaha;
    scara: Scara;
    tilting_cell: TiltingCell;
    stanford: Stanford;
    puma560: Puma560;
    panda: Panda;
}

/// The functions of a scalar, at a value whose roots and signs have derivatives.
#[test]
fn roots_signs_and_products() {
    let x = Dual64::new(-2.25, 1.0);
    assert_eq!(Scalar::sqrt(-x), Dual64::new(1.5, -1.0 / 3.0));
    assert_eq!(Scalar::sign(x).eps, 0.0);
    assert_eq!(Scalar::mul_add(x, x, x).eps, -3.5);
    assert_eq!(x.ratio_to_f64(<Dual64 as Scalar>::from_f64(4.5)), -0.5);
    assert!(!Scalar::is_positive(x) && Scalar::is_positive(-x));
    let (s, c) = Scalar::sin_cos(x);
    assert_eq!((s.eps, c.eps), (c.re, -s.re));
    assert_eq!((s.re, c.re), Scalar::sin_cos(-2.25_f64));
}
