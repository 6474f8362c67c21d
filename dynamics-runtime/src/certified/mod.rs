//! Numbers that carry a proven bound of their error, and functions that solve with M on them.
//!
//! Any generated method runs on [`Certified`] numbers. For methods that solve with M, the functions of this module return
//! the same values with sharper bounds: those of one operation after the other grow faster than the error.

mod dynamics;
mod operations;
mod outward;
mod rounded;
mod scalar;
mod solution;
#[cfg(test)]
mod tests;

use core::fmt;

#[cfg(feature = "std")]
#[doc(hidden)]
pub use dynamics::accelerations_near;
pub use dynamics::{
    forward_dynamics, forward_dynamics_aba, forward_dynamics_derivatives,
    operational_inertia_inverse,
};
use outward::Bound;
use rounded::Magnitude as _;
pub use rounded::Rounded;

/// A number as a processor computes it, and a proven bound of its distance from the exact one.
///
/// Every generated function runs on it. The values are those of the plain float, bit for bit; the bounds hold
/// at the state at hand, however near it is to a singular one. The bound of each operation follows from the errors of
/// its operands and its own rounding (a running error analysis), and is rounded upwards. The exact number, from which
/// the bound is counted, follows from the equations of the table:
///
/// - a constant of a function stands for an exact number that was rounded once, so that it counts as wrong by half a
///   unit in its last place;
/// - a field of the struct is exactly the double that it holds;
/// - an argument is [exact](Certified::exact), or known up to [an error](Certified::with_error).
///
/// A bound is infinite where nothing is proven: a value that is not finite, a quotient by a number that may be
/// zero, the root of one that may be negative, and all that is computed from them. The sign of a velocity that
/// may be zero is uncertain, and with it the dry friction.
///
/// The proof assumes arithmetic of IEEE 754, rounded to nearest, and sines, cosines and exponentials within one unit in
/// the last place. That is proven for the sines of this crate, and assumed of the crate `libm` for exponentials and
/// angles beyond 1e5 rad.
///
/// ```
/// use robot_dynamics::nalgebra::Vector2;
/// use robot_dynamics::{Certified, robot_dynamics};
///
/// robot_dynamics! {
///     /// Two point masses at the ends of two links.
///     struct Arm;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [
///         shoulder: revolute { mass: 1.2, com: [0.4, 0, 0] },
///         elbow: revolute { a: 0.4, mass: 0.7, com: [0.3, 0, 0] },
///     ],
/// }
///
/// // How much of a torque is rounding?
/// let q = Vector2::new(0.3, -1.1).map(Certified::exact);
/// let torque = Arm.gravity_vector(&q);
/// assert_eq!(torque.map(|x| x.value()), Arm.gravity_vector(&Vector2::new(0.3, -1.1)));
/// assert!(torque[0].bound() < 1e-14);
///
/// // And how much is the resolution of the encoders, 1e-5 rad?
/// let measured = q.map(|x| Certified::with_error(x.value(), 1e-5));
/// let torque = Arm.gravity_vector(&measured);
/// assert!((1e-5..1e-3).contains(&torque[0].bound()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certified<F: Rounded = f64> {
    value: F,
    error: Bound<F::Magnitude>,
}

impl<F: Rounded> Certified<F> {
    /// A number without an error.
    pub fn exact(value: F) -> Self {
        Certified::new(value, Bound::NONE)
    }

    /// A number that is at most `error` away from the exact one. If `error` is negative or NaN, the bound is infinite.
    pub fn with_error(value: F, error: F::Magnitude) -> Self {
        Certified::new(value, Bound::new(error))
    }

    /// The computed number: the same digits as without a bound.
    pub fn value(self) -> F {
        self.value
    }

    /// The greatest distance of the exact number from the value: infinite where nothing is proven.
    pub fn bound(self) -> F::Magnitude {
        self.error.get()
    }

    fn new(value: F, error: Bound<F::Magnitude>) -> Self {
        let is_finite = value.magnitude() < F::Magnitude::INFINITY;
        Certified {
            value,
            error: if is_finite { error } else { Bound::UNKNOWN },
        }
    }
}

/// `0.25 +- 3e-17`.
impl<F: Rounded<Magnitude: fmt::LowerExp> + fmt::Display> fmt::Display for Certified<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} +- {:.1e}", self.value, self.bound())
    }
}
