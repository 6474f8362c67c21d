//! Choice of the step size from the error estimate.

/// Constants of the control for a method: E. Hairer, G. Wanner, *Solving Ordinary Differential
/// Equations II*, section IV.2.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Constants {
    /// Power of h with which the estimated error falls.
    pub(super) order: f64,
    /// Weight of the error of the step before.
    pub(super) beta: f64,
    /// Least and greatest change of the step size.
    pub(super) factors: (f64, f64),
}

/// Proportional-integral control. With errors that are 1 at the tolerance,
///
/// `h_new = h * safety * err_n^-alpha * err_{n-1}^beta`, alpha = 1 / order - 3/4 beta.
pub(super) struct StepControl {
    constants: Constants,
    previous_error: f64,
    rejected: bool,
}

const SAFETY: f64 = 0.9;

impl StepControl {
    pub(super) fn new(constants: Constants) -> Self {
        StepControl {
            constants,
            previous_error: 1e-4,
            rejected: false,
        }
    }

    fn alpha(&self) -> f64 {
        1.0 / self.constants.order - 0.75 * self.constants.beta
    }

    /// Factor of the step size after a step whose error, 1 at the tolerance, was good enough.
    pub(super) fn accept(&mut self, error: f64) -> f64 {
        let (least, greatest) = self.constants.factors;
        let before = self.previous_error.powf(self.constants.beta);
        let wish = SAFETY * error.powf(-self.alpha()) * before;
        // A step that just failed is not followed by a longer one.
        let greatest = if self.rejected { 1.0 } else { greatest };
        self.previous_error = error.max(1e-4);
        self.rejected = false;
        wish.clamp(least, greatest)
    }

    /// Factor of the step size after a step whose error was too large, or not a number.
    pub(super) fn reject(&mut self, error: f64) -> f64 {
        let (least, _) = self.constants.factors;
        self.rejected = true;
        let wish = SAFETY * error.powf(-self.alpha());
        if wish.is_finite() {
            wish.clamp(least, 1.0)
        } else {
            least
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Constants, StepControl};

    const CONSTANTS: Constants = Constants {
        order: 5.0,
        beta: 0.04,
        factors: (0.2, 10.0),
    };

    #[test]
    fn small_errors_lengthen_the_step_and_large_ones_shorten_it() {
        let mut control = StepControl::new(CONSTANTS);
        assert_eq!(control.accept(0.0), 10.0);
        assert!(control.accept(1.0) < 1.0);
        assert!((0.2..1.0).contains(&control.reject(2.0)));
    }

    #[test]
    fn a_rejected_step_is_not_followed_by_a_longer_one() {
        let mut control = StepControl::new(CONSTANTS);
        control.reject(100.0);
        assert_eq!(control.accept(1e-9), 1.0);
        assert!(control.accept(1e-9) > 1.0);
    }

    #[test]
    fn an_error_that_is_not_a_number_shortens_the_step() {
        let mut control = StepControl::new(CONSTANTS);
        assert_eq!(control.reject(f64::NAN), 0.2);
        assert_eq!(control.reject(f64::INFINITY), 0.2);
    }
}
