//! One arm for all states, or one for each.

use fearless_simd::{ExtractToken, Simd, SimdBase};

use super::wide::{Precision, Wide};
use crate::Scalar;
use crate::inputs::{Evaluated, Inputs};
use crate::sine::Part;

/// The fields of an arm's struct, in their order: they differ from state to state where each has an arm.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the fields of `{Self}` cannot be read in lanes",
    note = "a struct of `robot_dynamics!` with fields can: `pub struct {Self} {{ payload: f64 }}`"
)]
pub trait Fields: Sized {
    /// Arms of which each state has one: [`WithParameters`](super::WithParameters), or a type of the arm's own with
    /// further methods.
    type OfEach<'a>: From<&'a [Self]>
    where
        Self: 'a;

    /// A field.
    fn field(&self, index: usize) -> f64;
}

/// The arms of a batch.
pub trait Arms<R>: Copy {
    /// The number of arms, where each state has one.
    fn states(&self) -> Option<usize>;

    /// The arms of the first states, and of the others.
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);

    /// The arm of a state, the last one beyond the last state.
    fn arm(&self, state: usize) -> &R;

    /// The inputs of the function in the lanes from a state on.
    fn inputs<S: Simd, E: Precision>(&self, first: usize) -> impl Inputs<Wide<S, E>>;
}

/// One arm for all states.
impl<R> Arms<R> for &R {
    fn states(&self) -> Option<usize> {
        None
    }

    #[cfg(feature = "rayon")]
    fn split(self, _: usize) -> (Self, Self) {
        (self, self)
    }

    #[inline(always)]
    fn arm(&self, _: usize) -> &R {
        self
    }

    #[inline(always)]
    fn inputs<S: Simd, E: Precision>(&self, _: usize) -> impl Inputs<Wide<S, E>> {
        Evaluated
    }
}

/// One arm for each state.
impl<R: Fields> Arms<R> for &[R] {
    fn states(&self) -> Option<usize> {
        Some(self.len())
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        self.split_at(states)
    }

    #[inline(always)]
    fn arm(&self, state: usize) -> &R {
        &self[state.min(self.len() - 1)]
    }

    #[inline(always)]
    fn inputs<S: Simd, E: Precision>(&self, first: usize) -> impl Inputs<Wide<S, E>> {
        FieldsOfEach { arms: self, first }
    }
}

/// Sines are evaluated, and a field is read of the arm of each lane.
struct FieldsOfEach<'a, R> {
    arms: &'a [R],
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
