//! The four Denavit-Hartenberg parameters of a row, and the step that they are.

use dynamics_codegen::geometry::{Transform, tidy};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Convention;

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
    /// Those of a step from a frame to the next one.
    pub(super) fn of(convention: Convention, step: &Transform) -> Parameters {
        let Transform {
            rotation: r,
            origin: [x, y, z],
        } = step;
        match convention {
            // Rz(theta) Tz(d) Tx(a) Rx(alpha), of which the origin is (a cos theta, a sin theta, d).
            Convention::Standard => Parameters {
                a: tidy(x * &r[0][0] + y * &r[1][0]),
                alpha: Angle::of(&r[2][1], &r[2][2]),
                d: z.clone(),
                theta: Angle::of(&r[1][0], &r[0][0]),
            },
            // Rx(alpha) Tx(a) Rz(theta) Tz(d), of which the origin is (a, -d sin alpha, d cos alpha).
            Convention::Modified => Parameters {
                a: x.clone(),
                alpha: Angle::of(&-&r[1][2], &r[2][2]),
                d: tidy(y * &r[1][2] + z * &r[2][2]),
                theta: Angle::of(&-&r[0][1], &r[0][0]),
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
        match (convention, whole_theta) {
            // Rx(whole) Rx(rest) Tx Rz(theta + q) Tz
            (Convention::Modified, None) => {
                let moves = Parameters { a, alpha, d, theta };
                in_order(whole_alpha, moves, None)
            }
            // Rx(whole) Rx(rest) Tx Rz(rest) Rz(whole + q) Tz
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
                in_order(whole_alpha.into_iter().chain([before]), moves, None)
            }
            // Rz(theta + q) Tz Tx Rx(rest) Rx(whole)
            (Convention::Standard, None) => {
                let moves = Parameters { a, alpha, d, theta };
                in_order(None, moves, whole_alpha)
            }
            // Rz(rest) Rz(whole + q) Tz Tx Rx(rest) Rx(whole)
            (Convention::Standard, Some(whole)) => {
                let before = Parameters {
                    theta,
                    ..Parameters::none()
                };
                let moves = Parameters {
                    a,
                    alpha,
                    d,
                    theta: whole,
                };
                in_order([before], moves, whole_alpha)
            }
        }
    }

    /// Those of a step to the same frame.
    fn none() -> Self {
        Parameters {
            a: Rational::ZERO,
            alpha: Angle::ZERO,
            d: Rational::ZERO,
            theta: Angle::ZERO,
        }
    }

    /// The step that they are the parameters of.
    pub(super) fn step(&self, convention: Convention) -> Option<Transform> {
        let zero = || Angle::ZERO.value();
        let along = |x: &Rational, z: &Rational| [x.clone(), Rational::ZERO, z.clone()];
        let nothing = Rational::ZERO;
        let about_x = Transform::new(
            &along(&self.a, &nothing),
            &[self.alpha.value(), zero(), zero()],
        )?;
        let about_z = Transform::new(
            &along(&nothing, &self.d),
            &[zero(), zero(), self.theta.value()],
        )?;
        Some(match convention {
            Convention::Standard => about_z.then(&about_x),
            Convention::Modified => about_x.then(&about_z),
        })
    }
}

/// Rows one after the other, of which the one that moves is marked.
fn in_order(
    before: impl IntoIterator<Item = Parameters>,
    moves: Parameters,
    after: impl IntoIterator<Item = Parameters>,
) -> Vec<(Parameters, bool)> {
    let still = |parameters| (parameters, false);
    let before = before.into_iter().map(still);
    let after = after.into_iter().map(still);
    before.chain([(moves, true)]).chain(after).collect()
}
