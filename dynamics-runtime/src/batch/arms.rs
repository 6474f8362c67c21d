//! One arm for all states, or one for each.

use fearless_simd::{ExtractToken, Simd, SimdBase};

use super::wide::Precision;
use super::wide::Wide;
use crate::Scalar;
use crate::inputs::{Evaluated, Inputs};
use crate::sine::Part;

/// The fields of an arm's struct, in their order: what differs from state to state where there is an arm for
/// each.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the fields of `{Self}` cannot be read in lanes",
    note = "a struct of `robot_dynamics!` with fields can: `pub struct {Self} {{ payload: f64 }}`"
)]
pub trait Fields {
    /// A field.
    fn field(&self, index: usize) -> f64;
}

/// The arms of a batch.
pub trait Arms<R>: Copy {
    /// The number of states, where that of the arms is it.
    fn states(&self) -> Option<usize>;

    /// Those of the first states, and of the others.
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);

    /// The arm of a state, the last one beyond the last state.
    fn arm(&self, state: usize) -> &R;

    /// What the function reads in the lanes from a state on.
    fn inputs<S: Simd, E: Precision>(&self, first: usize) -> impl Inputs<Wide<S, E>>;
}

/// One arm for all states.
#[doc(hidden)]
#[derive(Debug)]
pub struct Same<'a, R>(pub &'a R);

impl<R> Clone for Same<'_, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Same<'_, R> {}

impl<R> Arms<R> for Same<'_, R> {
    fn states(&self) -> Option<usize> {
        None
    }

    #[cfg(feature = "rayon")]
    fn split(self, _: usize) -> (Self, Self) {
        (self, self)
    }

    #[inline(always)]
    fn arm(&self, _: usize) -> &R {
        self.0
    }

    #[inline(always)]
    fn inputs<S: Simd, E: Precision>(&self, _: usize) -> impl Inputs<Wide<S, E>> {
        Evaluated
    }
}

/// One arm for each state.
#[doc(hidden)]
#[derive(Debug)]
pub struct Each<'a, R>(pub &'a [R]);

impl<R> Clone for Each<'_, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Each<'_, R> {}

impl<R: Fields> Arms<R> for Each<'_, R> {
    fn states(&self) -> Option<usize> {
        Some(self.0.len())
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let (first, others) = self.0.split_at(states);
        (Each(first), Each(others))
    }

    #[inline(always)]
    fn arm(&self, state: usize) -> &R {
        &self.0[state.min(self.0.len() - 1)]
    }

    #[inline(always)]
    fn inputs<S: Simd, E: Precision>(&self, first: usize) -> impl Inputs<Wide<S, E>> {
        FieldsOfEach { arms: *self, first }
    }
}

/// Sines are evaluated, and a field is read of the arm of each lane.
struct FieldsOfEach<'a, R> {
    arms: Each<'a, R>,
    first: usize,
}

impl<R: Fields, S: Simd, E: Precision> Inputs<Wide<S, E>> for FieldsOfEach<'_, R> {
    #[inline(always)]
    fn sin_cos<const K: usize>(
        &self,
        _: [usize; K],
        positions: [Wide<S, E>; K],
    ) -> [(Wide<S, E>, Wide<S, E>); K] {
        Wide::sin_cos_array(positions)
    }

    #[inline(always)]
    fn sin_cos_parts<const K: usize>(
        &self,
        _: [usize; K],
        parts: [Part; K],
        positions: [Wide<S, E>; K],
    ) -> [(Wide<S, E>, Wide<S, E>); K] {
        Wide::sin_cos_parts(positions, parts)
    }

    #[inline(always)]
    fn field(&self, index: usize, _: f64, like: Wide<S, E>) -> Wide<S, E> {
        Wide(E::Native::<S>::from_fn(
            like.0.token(),
            #[inline(always)]
            |lane| E::from_f64(self.arms.arm(self.first + lane).field(index)),
        ))
    }
}
