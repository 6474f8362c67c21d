//! The values of all generated functions of a robot on a base that moves.

use nalgebra::{Matrix3, SVector, Vector3, Vector6};

use super::Evaluation;
use crate::{FloatingState, Model, Pose, Scalar, State};

/// A robot on a base that moves that evaluates all of its generated functions at a state, as the checks need it. `V` is 6 + N.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no robot with `base: floating` that `robot_dynamics!` made",
    note = "checks compare what the macro generated with the table that it was generated from"
)]
pub trait FloatingEvaluate<const N: usize, const V: usize>: Model<N, V> {
    /// Every function at one state; without a value where the function was not generated.
    ///
    /// `tau` are the forces on the base and at the joints at which the forward dynamics is evaluated. By default, the values
    /// are those of [`evaluate_in`](FloatingEvaluate::evaluate_in): a robot of your own implements one of the two.
    fn evaluate(&self, state: &FloatingState<N, V>, tau: &SVector<f64, V>) -> Evaluation {
        self.evaluate_in(state, tau, |x| x)
    }

    /// The same in the arithmetic `T`; `real` turns the doubles of the state into its numbers.
    ///
    /// Generated robots implement it. By default, no function has a value.
    fn evaluate_in<T: Scalar>(
        &self,
        state: &FloatingState<N, V>,
        tau: &SVector<f64, V>,
        real: fn(f64) -> T,
    ) -> Evaluation<T> {
        let _ = (state, tau, real);
        Evaluation::default()
    }

    /// Calls `found` for each method that returns several functions, with its name and the values of these functions
    /// at one state.
    fn evaluate_parts(
        &self,
        state: &FloatingState<N, V>,
        tau: &SVector<f64, V>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let _ = (state, tau, found);
    }
}

/// The arguments of the generated functions at one state, by the names that the methods give them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct FloatingArguments<const N: usize, const V: usize, T: Scalar> {
    pub base: Pose<T>,
    pub q: SVector<T, N>,
    pub qd: SVector<T, V>,
    pub qdd: SVector<T, V>,
    pub tau: SVector<T, V>,
    pub qd_r: SVector<T, V>,
    pub qdd_r: SVector<T, V>,
    pub jerk: SVector<T, V>,
    pub snap: SVector<T, V>,
    pub wrench: Vector6<T>,
}

impl<const N: usize, const V: usize, T: Scalar> FloatingArguments<N, V, T> {
    /// The arguments at a state, in numbers that `real` makes of the state's.
    pub fn new(state: &FloatingState<N, V>, tau: &SVector<f64, V>, real: fn(f64) -> T) -> Self {
        let motion = state.motion();
        FloatingArguments {
            base: Pose {
                rotation: Matrix3::from_fn(|i, j| real(state.base.rotation[(i, j)])),
                position: Vector3::from_fn(|i, _| real(state.base.position[i])),
            },
            q: state.q.map(real),
            qd: state.v.map(real),
            qdd: state.a.map(real),
            tau: tau.map(real),
            qd_r: motion.reference_velocity().map(real),
            qdd_r: motion.reference_acceleration().map(real),
            jerk: motion.jerk().map(real),
            snap: motion.snap().map(real),
            wrench: State::<V>::wrench().map(real),
        }
    }
}
