//! Choice of the step size from the error estimate.

/// Proportional-integral control: E. Hairer, G. Wanner, *Solving Ordinary Differential Equations
/// II*, section IV.2, with the constants of their program DOPRI5. With errors that are 1 at the
/// tolerance,
///
/// `h_new = h * safety * err_n^-alpha * err_{n-1}^beta`, alpha = 1/5 - 3/4 beta.
pub(super) struct StepControl {
    previous_error: f64,
    rejected: bool,
}

const BETA: f64 = 0.04;
const ALPHA: f64 = 0.2 - 0.75 * BETA;
const SAFETY: f64 = 0.9;
const LEAST_FACTOR: f64 = 0.2;
const GREATEST_FACTOR: f64 = 10.0;

impl StepControl {
    pub(super) fn new() -> Self {
        StepControl {
            previous_error: 1e-4,
            rejected: false,
        }
    }

    /// Factor of the step size after a step whose error, 1 at the tolerance, was good enough.
    pub(super) fn accept(&mut self, error: f64) -> f64 {
        let wish = SAFETY * error.powf(-ALPHA) * self.previous_error.powf(BETA);
        // A step that just failed is not followed by a longer one.
        let greatest = if self.rejected { 1.0 } else { GREATEST_FACTOR };
        self.previous_error = error.max(1e-4);
        self.rejected = false;
        wish.clamp(LEAST_FACTOR, greatest)
    }

    /// Factor of the step size after a step whose error was too large, or not a number.
    pub(super) fn reject(&mut self, error: f64) -> f64 {
        self.rejected = true;
        let wish = SAFETY * error.powf(-ALPHA);
        if wish.is_finite() {
            wish.clamp(LEAST_FACTOR, 1.0)
        } else {
            LEAST_FACTOR
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{GREATEST_FACTOR, LEAST_FACTOR, StepControl};

    #[test]
    fn small_errors_lengthen_the_step_and_large_ones_shorten_it() {
        let mut control = StepControl::new();
        assert_eq!(control.accept(0.0), GREATEST_FACTOR);
        assert!(control.accept(1.0) < 1.0);
        assert!((LEAST_FACTOR..1.0).contains(&control.reject(2.0)));
    }

    #[test]
    fn a_rejected_step_is_not_followed_by_a_longer_one() {
        let mut control = StepControl::new();
        control.reject(100.0);
        assert_eq!(control.accept(1e-9), 1.0);
        assert!(control.accept(1e-9) > 1.0);
    }

    #[test]
    fn an_error_that_is_not_a_number_shortens_the_step() {
        let mut control = StepControl::new();
        assert_eq!(control.reject(f64::NAN), LEAST_FACTOR);
        assert_eq!(control.reject(f64::INFINITY), LEAST_FACTOR);
    }
}
