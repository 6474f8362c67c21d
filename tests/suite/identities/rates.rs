//! Derivatives along the motion and second derivatives, of robots on a base that moves: their programs run on dual numbers of
//! dual numbers, too.

use num_dual::{Dual64, HyperDual64};
use robot_dynamics::Scalar;
use robot_dynamics::nalgebra::{DMatrix, DVector};

use super::gradient::unit;
use super::moving::Moving;
use super::place::{Along, Argument, Place, State};
use super::samples::{largest, states};

/// A motion at one instant.
struct Motion<T> {
    q: Place<T>,
    /// Velocities, accelerations, jerk and snap.
    rates: [DVector<T>; 4],
}

impl<T: Scalar> Motion<T> {
    fn numbers(&self, robot: &Moving, function: &str) -> DVector<T> {
        let mut named = Vec::new();
        self.q.name("q", &mut named);
        for (name, rate) in ["qd", "qdd", "jerk", "snap"].into_iter().zip(&self.rates) {
            rate.name(name, &mut named);
        }
        DVector::from(robot.numbers(function, &named))
    }
}

impl Motion<f64> {
    fn of(robot: &Moving, state: State) -> Self {
        let motion = |factor: f64| state.qdd.map(|x| (factor * x).sin());
        let (jerk, snap) = (motion(3.0), motion(5.0));
        assert_eq!(jerk.len(), robot.robot.dof());
        Motion {
            rates: [state.qd, state.qdd, jerk, snap],
            q: state.q,
        }
    }

    /// The motion goes on: values carry their derivatives by time.
    fn moving(&self) -> Motion<Dual64> {
        let [v, a, jerk, snap] = &self.rates;
        Motion {
            q: self.q.along(v),
            rates: [v.along(a), a.along(jerk), jerk.along(snap), snap.still()],
        }
    }

    fn rate(&self, robot: &Moving, function: &str) -> DVector<f64> {
        self.moving().numbers(robot, function).map(|x| x.eps)
    }
}

fn motions(robot: &Moving) -> impl Iterator<Item = Motion<f64>> {
    states(robot).map(|state| Motion::of(robot, state))
}

/// Equal but for rounding.
#[track_caller]
fn same(function: &str, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{function}");
    let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(
            error <= 1e-11 * size,
            "{function}: {found} beside {expected}, of {size}"
        );
    }
}

/// dJ/dt, d(M v)/dt = tau + the momentum bias, d tau/dt and d2 tau/dt2.
pub(super) fn rates_are_those_along_the_motion(robot: &Moving) {
    for motion in motions(robot) {
        let of = |function: &str| motion.numbers(robot, function);
        let along = |function: &str| motion.rate(robot, function);
        same(
            "dJ/dt",
            of("jacobian_rate").as_slice(),
            along("jacobian").as_slice(),
        );
        let momentum = of("inverse_dynamics") + of("momentum_bias");
        same(
            "d(M v)/dt",
            momentum.as_slice(),
            along("generalized_momentum").as_slice(),
        );
        let rates = of("inverse_dynamics_rates");
        let (first, second) = rates.as_slice().split_at(rates.len() / 2);
        same("d tau/dt", first, along("inverse_dynamics").as_slice());
        let of_rates = along("inverse_dynamics_rates");
        same("d2 tau/dt2", second, &of_rates.as_slice()[..second.len()]);
    }
}

/// d com, by each degree of freedom.
pub(super) fn the_center_of_mass_moves_by_its_jacobian(robot: &Moving) {
    for motion in motions(robot) {
        let n = motion.rates[0].len();
        let found = motion.numbers(robot, "center_of_mass_jacobian");
        let columns = (0..n).flat_map(|k| {
            let mut along = motion.moving();
            along.q = motion.q.along(&unit(n, k));
            let com = along.numbers(robot, "center_of_mass");
            com.iter().map(|x| x.eps).collect::<Vec<_>>()
        });
        same("d com", found.as_slice(), &columns.collect::<Vec<_>>());
    }
}

/// The second derivatives by positions are the symmetric ones of f(p + R d, R exp(phi), q).
pub(super) fn second_derivatives_are_those_of_displacements(robot: &Moving) {
    for motion in motions(robot).take(2) {
        let n = motion.rates[0].len();
        let found = motion.numbers(robot, "inverse_dynamics_second_derivatives");
        let cube = n.pow(3);
        let [by_q, by_v, mixed, of_m] =
            [0, 1, 2, 3].map(|i| &found.as_slice()[i * cube..(i + 1) * cube]);
        // Matrix i of each has the derivatives of row i, in its row j those by position j.
        let at = |values: &dyn Fn(usize, usize) -> DVector<f64>| {
            let mut all = vec![0.0; cube];
            for (j, k) in (0..n * n).map(|jk| (jk / n, jk % n)) {
                let values = values(j, k);
                (0..n).for_each(|i| all[(i * n + k) * n + j] = values[i]);
            }
            all
        };
        let hessian = |j: usize, k: usize| {
            let is = |i, j| if i == j { 1.0 } else { 0.0 };
            let by = DVector::from_fn(n, |i, _| HyperDual64::new(0.0, is(i, j), is(i, k), 0.0));
            let still = |x: &DVector<f64>| x.map(HyperDual64::from);
            let other = Motion {
                q: motion.q.displaced(&by),
                rates: motion.rates.each_ref().map(still),
            };
            other.numbers(robot, "inverse_dynamics").map(|x| x.eps1eps2)
        };
        same("by q and q", by_q, &at(&hessian));
        // Matrices by columns, d tau/dq and then d tau/dv: their slopes along q or v.
        let slopes = |function: &str, by_position: bool| -> Vec<DMatrix<f64>> {
            let along = |k: usize| {
                let mut other = Motion {
                    q: motion.q.still(),
                    rates: motion.rates.each_ref().map(Along::still),
                };
                match by_position {
                    true => other.q = motion.q.along(&unit(n, k)),
                    false => other.rates[0] = motion.rates[0].along(&unit(n, k)),
                }
                let slope = other.numbers(robot, function).map(|x| x.eps);
                let first = slope.len() - n * n;
                DMatrix::from_column_slice(n, n, &slope.as_slice()[first..])
            };
            (0..n).map(along).collect()
        };
        let by_velocity = slopes("inverse_dynamics_derivatives", false);
        same(
            "by v and v",
            by_v,
            &at(&|j, k| by_velocity[j].column(k).into_owned()),
        );
        let by_both = slopes("inverse_dynamics_derivatives", true);
        same(
            "by q and v",
            mixed,
            &at(&|j, k| by_both[j].column(k).into_owned()),
        );
        let of_inertia = slopes("mass_matrix", true);
        same(
            "dM",
            of_m,
            &at(&|j, k| of_inertia[k].column(j).into_owned()),
        );
        assert!(largest(&found) > 0.0);
    }
}
