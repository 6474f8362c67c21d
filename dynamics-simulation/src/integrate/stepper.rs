//! The one interface of all methods.

use dynamics_runtime::Size;

use super::Phase;

/// An integration under way, at the end of its last step.
///
/// `S` are the equations that the method needs, and gives the reasons for which they may refuse
/// an evaluation.
pub(crate) trait Stepper<S, E, D: Size> {
    /// The time reached.
    fn t(&self) -> f64;

    /// The phase reached.
    fn phase(&self) -> &Phase<D>;

    /// Makes one step, which ends at `end` at the latest.
    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<E>>;

    /// The phase at a time within the last step.
    fn at(&mut self, system: &S, t: f64) -> Result<Phase<D>, Failure<E>>;

    /// Makes the last step again from where it started, so that it ends at an earlier time. It is
    /// not judged: it is shorter than a step that was good enough.
    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<E>>;

    /// Goes on from another phase, or under other equations, at the time reached.
    fn restart(&mut self, system: &S, phase: Phase<D>) -> Result<(), Failure<E>>;

    /// Goes on in a chart around the phase reached, where the positions are coordinates in charts. The last step is no
    /// longer known.
    fn recentre(&mut self, _system: &S) {}

    /// The number of steps that were tried and thrown away.
    fn rejected(&self) -> u64 {
        0
    }
}

/// Why a step could not be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Failure<E> {
    /// The equations refuse, however short the step is.
    Refused(E),
    /// The error stays too large however short the step is.
    StepTooSmall,
    /// The equations of an implicit step are not solved by iteration.
    NoConvergence,
}

impl<E> From<E> for Failure<E> {
    fn from(refusal: E) -> Self {
        Failure::Refused(refusal)
    }
}
