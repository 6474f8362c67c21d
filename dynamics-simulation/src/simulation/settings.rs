//! Settings of the methods that choose their steps.

use super::error::InvalidSetting;
use crate::integrate::{StepRange, Tolerance};

/// The settings of all of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct ErrorControl {
    pub(super) tolerance: Tolerance,
    /// The longest step where it is chosen; the run is made in at least `least_steps` where not.
    pub(super) max_step: Option<f64>,
    pub(super) least_steps: f64,
    pub(super) max_steps: usize,
}

impl ErrorControl {
    /// Bounds of the step size in a run.
    pub(super) fn range(&self, duration: f64) -> StepRange {
        StepRange {
            // A few roundings of the time.
            least: 16.0 * f64::EPSILON * duration,
            greatest: self.max_step.unwrap_or(duration / self.least_steps),
        }
    }

    pub(super) fn validate(&self, duration: f64) -> Result<(), InvalidSetting> {
        for tolerance in [self.tolerance.relative, self.tolerance.absolute] {
            if !(tolerance > 0.0 && tolerance.is_finite()) {
                return Err(InvalidSetting::Tolerance(tolerance));
            }
        }
        match self.range(duration).greatest {
            f64::INFINITY => Ok(()),
            longest => validate_step(longest, duration),
        }
    }
}

/// Whether a run can be made of such steps or periods: it would never end if they were lost in the rounding of the time.
pub(super) fn is_possible(step: f64, duration: f64) -> bool {
    step > duration * f64::EPSILON && step.is_finite()
}

pub(super) fn validate_step(step: f64, duration: f64) -> Result<(), InvalidSetting> {
    if is_possible(step, duration) {
        Ok(())
    } else {
        Err(InvalidSetting::Step(step))
    }
}

macro_rules! settings {
    (
        $(#[$documentation:meta])*
        $name:ident, tolerance: $tolerance:literal, steps: $least_steps:literal, longest: $longest:literal
        $(, $(#[$about:meta])* $own:ident: $kind:ty)?
    ) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub struct $name {
            /// Relative tolerance of a step.
            pub relative_tolerance: f64,
            /// Absolute tolerance of a step, rad or m, and per second.
            pub absolute_tolerance: f64,
            $($(#[$about])* pub $own: Option<$kind>,)?
            #[doc = concat!("The longest step, s; `None` for a ", $longest, " of the duration, infinity for no bound.")]
            ///
            /// The estimate vanishes in an arm at rest. Without this bound a torque that comes and goes within one long
            /// step would never be noticed.
            pub max_step: Option<f64>,
            /// The greatest number of steps between two samples.
            pub max_steps: usize,
        }

        impl $name {
            /// One value for both tolerances, the other settings as by default.
            pub const fn with_tolerance(tolerance: f64) -> Self {
                $name {
                    relative_tolerance: tolerance,
                    absolute_tolerance: tolerance,
                    $($own: None,)?
                    max_step: None,
                    max_steps: 100_000,
                }
            }

            settings! { @set relative_tolerance: f64 => relative_tolerance }
            settings! { @set absolute_tolerance: f64 => absolute_tolerance }
            $(settings! { @set $own: $kind => Some($own) })?
            settings! { @set max_step: f64 => Some(max_step) }
            settings! { @set max_steps: usize => max_steps }

            pub(super) fn control(&self) -> ErrorControl {
                ErrorControl {
                    tolerance: Tolerance {
                        relative: self.relative_tolerance,
                        absolute: self.absolute_tolerance,
                    },
                    max_step: self.max_step,
                    least_steps: $least_steps,
                    max_steps: self.max_steps,
                }
            }
        }

        impl Default for $name {
            #[doc = concat!("Tolerances of ", $tolerance, ", steps of up to a ", $longest, " of the duration,")]
            /// at most 100 000 of them between two samples.
            fn default() -> Self {
                $name::with_tolerance($tolerance)
            }
        }
    };
    (@set $name:ident: $kind:ty => $value:expr) => {
        #[doc = concat!("With another [`", stringify!($name), "`](field@Self::", stringify!($name), ").")]
        pub const fn $name(mut self, $name: $kind) -> Self {
            self.$name = $value;
            self
        }
    };
}

settings! {
    /// Settings of the Dormand-Prince method of order 5(4), known as `ode45` and `RK45`.
    ///
    /// A step is as long as its estimated error in each position and velocity y stays below
    /// `absolute_tolerance + relative_tolerance |y|`. The error of a whole run grows with its length
    /// and with the motion's own sensitivity. Samples between the steps are taken from a polynomial
    /// of fourth order.
    ///
    /// Under dry friction a joint that sticks makes the steps minute, unless stopping and sticking are events
    /// ([`Friction::Sticking`](crate::Friction::Sticking)). A run that a million evaluations and steps do not lead
    /// on ends with [`Cause::Sticks`](crate::simulation::Cause::Sticks).
    DormandPrince, tolerance: 1e-9, steps: 50.0, longest: "fiftieth"
}

settings! {
    /// Settings of DOP853, the method of order 8(5,3) of Dormand and Prince (Hairer, Nørsett,
    /// Wanner, *Solving Ordinary Differential Equations I*, section II.5).
    ///
    /// It is the explicit method for accurate runs: at tolerances below 1e-8 it takes fewer evaluations of forward
    /// dynamics than [`DormandPrince`]. A step takes twelve of them, and three more where a sample lies within it,
    /// which is taken from a polynomial of seventh order. The settings mean the same.
    Dop853, tolerance: 1e-9, steps: 50.0, longest: "fiftieth"
}

settings! {
    /// Settings of the Radau IIA method of order 5 (Hairer, Wanner, *Solving Ordinary Differential
    /// Equations II*, section IV.8), for stiff arms: strong viscous friction at a small inertia,
    /// stiff controllers.
    ///
    /// The steps of an explicit method are shorter than the fastest of the motion's time constants, whatever the
    /// tolerance; those of this one are not. It is implicit: a step takes 9 to 21 evaluations of forward dynamics, and
    /// two for each joint where the Jacobian is renewed. That is formed by differences and so includes the torque law.
    /// Samples within the steps are taken from a polynomial of third degree. The settings mean the same as for
    /// [`DormandPrince`].
    Radau5, tolerance: 1e-9, steps: 50.0, longest: "fiftieth"
}

settings! {
    /// Settings of the Taylor method.
    ///
    /// The last terms of the series of each position and velocity y stay below `absolute_tolerance + relative_tolerance
    /// |y|`; the error of a step is a few times smaller. The error of a whole run grows with its length and with the
    /// motion's own sensitivity. Steps are added with compensated sums, so that a tolerance of 1e-16 makes sense: the
    /// rounding of the equations remains. Samples within steps are taken from the series and are as accurate as the
    /// ends.
    Taylor, tolerance: 1e-12, steps: 10.0, longest: "tenth",
    /// The order of the series, 8 to [`MAX_TAYLOR_ORDER`](crate::simulation::MAX_TAYLOR_ORDER); `None` for the
    /// one that suits the tolerance.
    order: usize
}
