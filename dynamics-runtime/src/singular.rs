//! Mass matrices that cannot be solved with.

use core::fmt;

use crate::Scalar;

/// The mass matrix was not positive definite, as far as its digits can tell: a pivot of its
/// factorisation was not greater than the rounding errors of its diagonal entry (8 epsilon of it).
///
/// It happens where the links beyond a joint have no inertia about it, where the data are
/// unphysical, and where the state is not finite. Printed, it says which of the three, and what
/// helps. [`Conditioning`](crate::Conditioning) says how near a mass matrix is to being singular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingularMassMatrix {
    /// The joint of the pivot, counted from 0.
    pub joint: usize,
    /// The joint's name in the table, where the code that failed knows it: generated code does.
    pub joint_name: Option<&'static str>,
    /// The pivot over the size of the diagonal entry of M that it came from: negative where the
    /// pivot is, 0 where it is 0, NaN where either is NaN.
    pub relative_pivot: f64,
}

impl SingularMassMatrix {
    /// A failure at a joint without a name.
    pub const fn new(joint: usize, relative_pivot: f64) -> Self {
        SingularMassMatrix {
            joint,
            joint_name: None,
            relative_pivot,
        }
    }

    /// Tests a pivot: a factorisation calls it for each, from the tip inwards.
    ///
    /// A pivot that is not greater than the rounding errors of the differences that
    /// it is made of cannot be told from zero: no digit of the accelerations would be right.
    /// The diagonal entry gives their size, whatever its sign: that M is positive
    /// definite is a matter of the pivots alone.
    ///
    /// # Errors
    ///
    /// Where the pivot cannot be told from zero, is negative or NaN.
    #[doc(hidden)]
    #[inline(always)]
    pub fn test<T: Scalar>(joint: usize, pivot: T, diagonal: T) -> Result<(), Self> {
        if pivot.exceeds_rounding_of(diagonal) {
            return Ok(());
        }
        Err(SingularMassMatrix::new(
            joint,
            relative_pivot(pivot, diagonal),
        ))
    }

    /// [`test`](SingularMassMatrix::test), by generated code, which knows the joint's name.
    #[doc(hidden)]
    #[inline(always)]
    pub fn test_joint<T: Scalar>(
        joint: usize,
        name: &'static str,
        pivot: T,
        diagonal: T,
    ) -> Result<(), Self> {
        Self::test(joint, pivot, diagonal).map_err(|error| error.named(name))
    }

    /// The same, where the name of the joint is known.
    #[doc(hidden)]
    pub fn named(self, name: &'static str) -> Self {
        SingularMassMatrix {
            joint_name: Some(name),
            ..self
        }
    }

    /// The cause, as far as the ratio tells it, and a remedy.
    fn advice(&self) -> &'static str {
        // The rounding errors of single precision, with room.
        const ROUNDING: f64 = 1e-5;
        if self.relative_pivot.is_nan() {
            "a position or a parameter is not finite"
        } else if self.relative_pivot < -ROUNDING {
            "the inertia that it feels is negative: check masses, inertia tensors and motors for data that no body can have"
        } else {
            "with the joints beyond it free nothing resists it: give the links beyond it inertia about its axis, or the \
             joint a motor, or keep away from this configuration"
        }
    }
}

/// `pivot / |diagonal|`, and the pivot itself where that is 0/0 or the quotient of infinities.
#[cold]
#[inline(never)]
pub(crate) fn relative_pivot<T: Scalar>(pivot: T, diagonal: T) -> f64 {
    let [zero, one] = [0.0, 1.0].map(|x| pivot.constant(x));
    // In the precision of the numbers: a controller of singles has no doubles.
    let is_nan = |x: T| !(x * x + one).is_positive();
    let quotient = pivot / (diagonal * diagonal.sign());
    let ratio = if is_nan(quotient) && !is_nan(diagonal) {
        pivot
    } else {
        quotient
    };
    // The sum turns a zero that is negative into one that is not.
    (ratio + zero).ratio_to_f64(one)
}

impl fmt::Display for SingularMassMatrix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let joint = self.joint + 1;
        write!(
            f,
            "the mass matrix is not positive definite at joint {joint}"
        )?;
        if let Some(name) = self.joint_name {
            write!(f, " `{name}`")?;
        }
        let ratio = self.relative_pivot;
        write!(f, " (relative pivot {ratio:e}): {}", self.advice())
    }
}

impl core::error::Error for SingularMassMatrix {}

#[cfg(test)]
mod tests {
    use super::SingularMassMatrix;

    #[test]
    fn a_pivot_of_rounding_errors_is_no_pivot() {
        assert!(SingularMassMatrix::test(0, 1e-14, 1.0).is_ok());
        assert!(SingularMassMatrix::test(0, 1e-15, 1.0).is_err());
        assert!(SingularMassMatrix::test(0, 1e-15, 1e-10).is_ok());
        assert!(SingularMassMatrix::test(0, 1e-7_f32, 1.0).is_err());
        let error = SingularMassMatrix::test(3, f64::NAN, 1.0).unwrap_err();
        assert!(error.joint == 3 && error.relative_pivot.is_nan());
    }

    fn relative_pivot(pivot: f64, diagonal: f64) -> f64 {
        SingularMassMatrix::test(0, pivot, diagonal)
            .unwrap_err()
            .relative_pivot
    }

    #[test]
    fn the_relative_pivot_has_the_sign_of_the_pivot() {
        assert_eq!(relative_pivot(-0.5, -0.25), -2.0);
        assert_eq!(relative_pivot(-0.5, 0.25), -2.0);
        assert_eq!(relative_pivot(-1.0, 0.0), f64::NEG_INFINITY);
        assert_eq!(
            relative_pivot(f64::NEG_INFINITY, f64::INFINITY),
            f64::NEG_INFINITY
        );
        for diagonal in [-1.0, -0.0, 0.0, 1.0, f64::INFINITY] {
            for pivot in [0.0, -0.0] {
                let zero = relative_pivot(pivot, diagonal);
                assert!(zero == 0.0 && zero.is_sign_positive(), "{diagonal}");
            }
        }
        assert!(relative_pivot(1.0, f64::NAN).is_nan());
        assert!(relative_pivot(f64::NAN, 0.0).is_nan());
    }

    #[test]
    fn a_negative_inertia_does_not_read_as_a_regular_one() {
        let error = SingularMassMatrix::test(0, -1.0, -1.0).unwrap_err();
        let text = error.to_string();
        assert!(text.starts_with(
            "the mass matrix is not positive definite at joint 1 (relative pivot -1e0): "
        ));
        assert!(text.contains("inertia that it feels is negative"), "{text}");
    }

    #[test]
    fn the_error_names_the_joint_and_counts_from_one() {
        let error = SingularMassMatrix::test_joint(2, "wrist", -1e-17, 1.0).unwrap_err();
        let text = error.to_string();
        assert!(
            text.starts_with("the mass matrix is not positive definite at joint 3 `wrist` (relative pivot -1e-17): "),
            "{text}"
        );
        assert!(text.contains("nothing resists it"), "{text}");
        let nan = SingularMassMatrix::new(0, f64::NAN).to_string();
        assert!(nan.contains("not finite"), "{nan}");
    }
}
