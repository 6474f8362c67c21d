//! When the laws of a simulation are asked.
//!
//! The type of a simulation says whether its laws are asked at every stage (`Continuous`, `Fn`) or once a period
//! (`Sampled`, `FnMut`). A method evaluates trial stages, out of order, and throws steps away: a law with a memory
//! would be silently wrong there, and so it does not compile. Times that differ by no more than their rounding are
//! one time. Without that, a sample of the run and a multiple of the period would make a step of 1e-19 s between
//! them.

/// Laws that are called wherever the integration evaluates the equations of motion. They are functions of time and
/// state alone (`Fn`).
///
/// A method of integration also evaluates trial stages, out of order, and throws steps away: a law with a memory
/// would be wrong there. Such a law needs [`Sampled`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Continuous;

/// Laws that are called once each period p, at 0, p, 2 p, ..., in order, and held in between, as those of a digital
/// controller. They may have a memory (`FnMut`).
///
/// Made by [`Simulation::control_period`](crate::Simulation::control_period).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    pub(super) period: f64,
}

/// Laws of which one is to be held for a period that is not known yet: `control_period` is still to be called.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AwaitsPeriod;

/// When the laws of a simulation are asked: [`Continuous`], [`Sampled`], or [`AwaitsPeriod`].
pub trait Asked {
    /// The same with a law that is held for a period.
    type Held: Asked;

    /// The same with a law that is held for a period.
    #[doc(hidden)]
    fn held(self) -> Self::Held;
}

macro_rules! asked {
    ($($asked:ty, $held:ty, $value:expr;)*) => {$(
        impl Asked for $asked {
            type Held = $held;

            fn held(self) -> $held {
                $value(self)
            }
        }
    )*};
}

asked! {
    Continuous, AwaitsPeriod, |_| AwaitsPeriod;
    AwaitsPeriod, AwaitsPeriod, |same| same;
    Sampled, Sampled, |same| same;
}

/// Laws that are functions of time and state, as far as they are given: there is no period yet.
pub trait WithoutPeriod: Asked {}

impl WithoutPeriod for Continuous {}

impl WithoutPeriod for AwaitsPeriod {}

/// Laws of which none waits for a period.
#[diagnostic::on_unimplemented(
    message = "a held force at the tool needs a period",
    label = "a law of `held_tool_wrench`, which is called once each period",
    note = "call `.control_period(period)` before `.run()`, or give the law by `.tool_wrench(..)` as a function of time and state"
)]
pub trait NothingHeld {}

impl NothingHeld for Continuous {}

/// Whether a time lies before another by more than the rounding of the two.
///
/// k periods and the time of a sample, which are the same in real numbers, differ by up to five roundings.
pub(super) fn before(t: f64, other: f64) -> bool {
    t < other - 4.0 * f64::EPSILON * other.abs()
}

/// The times at which laws are asked: multiples of the period before the end of a run. Products, not sums,
/// whose roundings add up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instants {
    period: Option<f64>,
    /// Periods begun.
    begun: u64,
    duration: f64,
}

impl Instants {
    /// From the start, where the laws have been asked.
    pub(super) fn new(period: Option<f64>, duration: f64) -> Self {
        Instants {
            period,
            begun: 1,
            duration,
        }
    }

    /// Up to when the laws hold.
    pub(super) fn next(&self) -> f64 {
        let next = self.period.map(|period| self.begun as f64 * period);
        next.filter(|next| before(*next, self.duration))
            .unwrap_or(self.duration)
    }

    /// Whether the laws are to be asked at the time reached; then their next period begins.
    pub(super) fn begin(&mut self, t: f64) -> bool {
        let due = t >= self.next() && t < self.duration;
        self.begun += u64::from(due);
        due
    }
}

#[cfg(test)]
mod tests {
    use super::{Instants, before};

    #[test]
    fn instants_are_products_and_end_before_the_end() {
        let mut instants = Instants::new(Some(0.1), 0.8);
        let mut found = vec![];
        while instants.next() < 0.8 {
            let t = instants.next();
            assert!(!instants.begin(0.5 * t));
            assert!(instants.begin(t));
            found.push(t);
        }
        let expected: Vec<f64> = (1..8).map(|k| k as f64 * 0.1).collect();
        assert_eq!(found, expected);
        assert!(!instants.begin(0.8));
    }

    #[test]
    fn a_period_longer_than_the_run_is_asked_for_once() {
        let mut instants = Instants::new(Some(2.0), 1.0);
        assert_eq!(instants.next(), 1.0);
        assert!(!instants.begin(1.0));
    }

    #[test]
    fn times_that_differ_by_rounding_are_the_same() {
        for k in 1..100_000 {
            let t = k as f64 * 1e-3;
            let sample = 100.0 * k as f64 / 100_000.0;
            assert!(!before(t, sample) && !before(sample, t), "{k}");
        }
        assert!(before(1.0, 1.0 + 1e-14) && !before(0.0, 0.0));
    }
}
