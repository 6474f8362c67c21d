//! Robots as checks take them, whatever the number of their joints, on a base that stands or moves.

use dynamics_runtime::{Certified, FloatingState, Pose, RuntimeTable, SizedState, State};
use nalgebra::{DVector, Dyn, SVector};

use super::{Evaluate, Evaluation, FloatingEvaluate};

/// A robot that a check evaluates, whatever the number of its joints. [`Check::run`](super::Check::run) makes one of each robot with
/// [`Evaluate`].
pub trait Checked {
    /// The names of the joints, from the base outwards.
    fn names(&self) -> Vec<String>;

    /// The table as numbers.
    fn runtime_table(&self) -> RuntimeTable;

    /// As [`Evaluate::evaluate`]; as [`FloatingEvaluate::evaluate`] for a robot whose base moves and stands there: `qd`, `qdd`
    /// and `tau` have the six numbers of the base first.
    fn values(&self, base: &Pose<f64>, state: &SizedState<Dyn>, tau: &DVector<f64>) -> Evaluation;

    /// The same with bounds of the rounding errors; by default, no function has a value.
    fn certified_values(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        let _ = (base, state, tau);
        Evaluation::default()
    }

    /// As [`Evaluate::evaluate_parts`] and [`FloatingEvaluate::evaluate_parts`].
    fn values_of_parts(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let _ = (base, state, tau, found);
    }
}

/// A robot that checks take: one with [`Evaluate`], or one with [`FloatingEvaluate`]. The compiler finds out which `K` it is.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no robot that `robot_dynamics!` made",
    note = "checks compare what the macro generated with the table that it was generated from"
)]
pub trait Checkable<K> {
    /// The robot, whatever the number of its joints.
    fn checked(&self) -> Box<dyn Checked + '_>;
}

/// The kind of a robot whose base stands.
#[derive(Debug)]
pub enum StandingRobot<const N: usize> {}

/// The kind of a robot whose base moves.
#[derive(Debug)]
pub enum FloatingRobot<const N: usize, const V: usize> {}

fn fixed<const N: usize>(vector: &DVector<f64>) -> SVector<f64, N> {
    SVector::from_column_slice(vector.as_slice())
}

fn standing<const N: usize>(
    _: &Pose<f64>,
    SizedState { q, qd, qdd }: &SizedState<Dyn>,
) -> State<N> {
    State {
        q: fixed(q),
        qd: fixed(qd),
        qdd: fixed(qdd),
    }
}

fn floating<const N: usize, const V: usize>(
    base: &Pose<f64>,
    SizedState { q, qd, qdd }: &SizedState<Dyn>,
) -> FloatingState<N, V> {
    FloatingState {
        base: *base,
        q: fixed(q),
        v: fixed(qd),
        a: fixed(qdd),
    }
}

/// Robots of a kind, the numbers of whose joints and velocities the compiler knows: `$state` makes their states.
macro_rules! checkable {
    ($kind:ident, $evaluate:ident<$($size:ident),+>, $robot:ident, $state:ident) => {
        struct $robot<'a, R, $(const $size: usize),+>(&'a R);

        impl<R: $evaluate<$($size),+>, $(const $size: usize),+> Checkable<$kind<$($size),+>> for R {
            fn checked(&self) -> Box<dyn Checked + '_> {
                Box::new($robot(self))
            }
        }

        impl<R: $evaluate<$($size),+>, $(const $size: usize),+> Checked for $robot<'_, R, $($size),+> {
            fn names(&self) -> Vec<String> {
                self.0.joint_names().map(String::from).to_vec()
            }

            fn runtime_table(&self) -> RuntimeTable {
                (&self.0.table()).into()
            }

            fn values(
                &self,
                base: &Pose<f64>,
                state: &SizedState<Dyn>,
                tau: &DVector<f64>,
            ) -> Evaluation {
                self.0.evaluate(&$state(base, state), &fixed(tau))
            }

            fn certified_values(
                &self,
                base: &Pose<f64>,
                state: &SizedState<Dyn>,
                tau: &DVector<f64>,
            ) -> Evaluation<Certified> {
                let state = $state(base, state);
                self.0.evaluate_in(&state, &fixed(tau), Certified::exact)
            }

            fn values_of_parts(
                &self,
                base: &Pose<f64>,
                state: &SizedState<Dyn>,
                tau: &DVector<f64>,
                found: &mut dyn FnMut(&str, Evaluation),
            ) {
                self.0.evaluate_parts(&$state(base, state), &fixed(tau), found);
            }
        }
    };
}

checkable!(StandingRobot, Evaluate<N>, Standing, standing);
checkable!(FloatingRobot, FloatingEvaluate<N, V>, Floating, floating);
