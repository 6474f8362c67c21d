//! The four Denavit-Hartenberg parameters of a row, and the step that they are.

use dynamics_codegen::geometry::{Transform, tidy};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, Value};

use super::angle::Angle;

/// The four parameters of a row.
#[derive(Clone)]
pub(super) struct Parameters {
    pub(super) a: Rational,
    pub(super) alpha: Angle,
    pub(super) d: Rational,
    pub(super) theta: Angle,
}

impl Parameters {
    /// The parameters of a step from a frame to the next one.
    pub(super) fn from_step(convention: Convention, step: &Transform) -> Parameters {
        let Transform {
            rotation: r,
            origin: [x, y, z],
        } = step;
        match convention {
            // Rz(theta) Tz(d) Tx(a) Rx(alpha), of which the origin is (a cos theta, a sin theta, d).
            Convention::Standard => Parameters {
                a: tidy(x * &r[0][0] + y * &r[1][0]),
                alpha: Angle::atan2(&r[2][1], &r[2][2]),
                d: z.clone(),
                theta: Angle::atan2(&r[1][0], &r[0][0]),
            },
            // Rx(alpha) Tx(a) Rz(theta) Tz(d), of which the origin is (a, -d sin alpha, d cos alpha).
            Convention::Modified => Parameters {
                a: x.clone(),
                alpha: Angle::atan2(&-&r[1][2], &r[2][2]),
                d: tidy(y * &r[1][2] + z * &r[2][2]),
                theta: Angle::atan2(&-&r[0][1], &r[0][0]),
            },
        }
    }

    /// The same step in rows whose angles mean what they say: one within 1e-9 of a quarter turn is that
    /// turn to every reader, and what is left of it is an angle of another row. The row that moves is marked.
    pub(super) fn in_steps(self, convention: Convention) -> Vec<(Parameters, bool)> {
        let Parameters { a, alpha, d, theta } = self;
        let (whole_alpha, alpha) = alpha.split();
        let whole_alpha = whole_alpha.map(|alpha| Parameters {
            alpha,
            ..Parameters::none()
        });
        let (whole_theta, theta) = theta.split();
        let (before, moves) = match (convention, whole_theta) {
            (_, None) => (None, Parameters { a, alpha, d, theta }),
            // Rx(rest) Tx Rz(rest) Rz(whole + q) Tz
            (Convention::Modified, Some(whole)) => {
                let before = Parameters {
                    a,
                    alpha,
                    d: Rational::ZERO,
                    theta,
                };
                let moves = Parameters {
                    d,
                    theta: whole,
                    ..Parameters::none()
                };
                (Some(before), moves)
            }
            // Rz(rest) Rz(whole + q) Tz Tx Rx(rest)
            (Convention::Standard, Some(whole)) => {
                let before = Parameters {
                    theta,
                    ..Parameters::none()
                };
                let theta = whole;
                (Some(before), Parameters { a, alpha, d, theta })
            }
        };
        // Rx(whole) comes first in a modified table, and last in a standard one.
        let (first, last) = match convention {
            Convention::Modified => (whole_alpha, None),
            Convention::Standard => (None, whole_alpha),
        };
        let still = |parameters| (parameters, false);
        let before = first.into_iter().chain(before).map(still);
        let after = last.into_iter().map(still);
        before.chain([(moves, true)]).chain(after).collect()
    }

    /// The parameters of a step to the same frame.
    pub(super) fn none() -> Self {
        Parameters {
            a: Rational::ZERO,
            alpha: Angle::ZERO,
            d: Rational::ZERO,
            theta: Angle::ZERO,
        }
    }

    /// The step that they are the parameters of.
    pub(super) fn step(&self, convention: Convention) -> Option<Transform> {
        let [alpha, theta] = [&self.alpha, &self.theta].map(Angle::value);
        step(convention, [&self.a, &self.d], [alpha, theta])
    }
}

/// A row's step: `Rz(theta) Tz(d) Tx(a) Rx(alpha)`, or in a modified table `Rx(alpha) Tx(a) Rz(theta) Tz(d)`.
pub(super) fn step(
    convention: Convention,
    [a, d]: [&Rational; 2],
    [alpha, theta]: [Value; 2],
) -> Option<Transform> {
    let (zero, nowhere) = (Value::zero, || Rational::ZERO);
    let about_x = Transform::new(&[a.clone(), nowhere(), nowhere()], &[alpha, zero(), zero()])?;
    let about_z = Transform::new(&[nowhere(), nowhere(), d.clone()], &[zero(), zero(), theta])?;
    Some(match convention {
        Convention::Standard => about_z.then(&about_x),
        Convention::Modified => about_x.then(&about_z),
    })
}
