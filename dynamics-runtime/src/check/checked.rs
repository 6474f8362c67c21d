//! Robots as checks take them, whatever the number of their joints, on a base that stands or moves.

use nalgebra::{DVector, Dyn, SVector};

use super::{Evaluate, Evaluation, FloatingEvaluate};
use crate::{Certified, FloatingState, Pose, RuntimeTable, SizedState, State};

/// A robot that a check evaluates, whatever the number of its joints. [`Check::run`](super::Check::run) makes one of each robot with
/// [`Evaluate`].
pub trait Checked {
    /// The names of the joints, from the base outwards.
    fn names(&self) -> Vec<String>;

    /// The table as numbers.
    fn runtime_table(&self) -> RuntimeTable;

    /// As [`Evaluate::evaluate`].
    fn values(&self, state: &SizedState<Dyn>, tau: &DVector<f64>) -> Evaluation;

    /// The same with bounds of the rounding errors; by default, no function has a value.
    fn certified_values(
        &self,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        let _ = (state, tau);
        Evaluation::default()
    }

    /// As [`Evaluate::evaluate_parts`].
    fn values_of_parts(
        &self,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let _ = (state, tau, found);
    }

    /// As [`FloatingEvaluate::evaluate`] for a robot whose base moves and stands there: `qd`, `qdd` and `tau` have the six
    /// numbers of the base first. By default, [`values`](Checked::values).
    fn values_on(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation {
        let _ = base;
        self.values(state, tau)
    }

    /// The same with bounds of the rounding errors; by default, [`certified_values`](Checked::certified_values).
    fn certified_values_on(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        let _ = base;
        self.certified_values(state, tau)
    }

    /// As [`FloatingEvaluate::evaluate_parts`]; by default, [`values_of_parts`](Checked::values_of_parts).
    fn values_of_parts_on(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let _ = base;
        self.values_of_parts(state, tau, found);
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

impl<R: Evaluate<N>, const N: usize> Checkable<StandingRobot<N>> for R {
    fn checked(&self) -> Box<dyn Checked + '_> {
        Box::new(OfSize(self))
    }
}

impl<R: FloatingEvaluate<N, V>, const N: usize, const V: usize> Checkable<FloatingRobot<N, V>>
    for R
{
    fn checked(&self) -> Box<dyn Checked + '_> {
        Box::new(Floating(self))
    }
}

/// A robot whose number of joints the compiler knows.
struct OfSize<'a, R, const N: usize>(&'a R);

fn fixed<const N: usize>(vector: &DVector<f64>) -> SVector<f64, N> {
    SVector::from_column_slice(vector.as_slice())
}

fn fixed_state<const N: usize>(state: &SizedState<Dyn>) -> State<N> {
    State {
        q: fixed(&state.q),
        qd: fixed(&state.qd),
        qdd: fixed(&state.qdd),
    }
}

impl<R: Evaluate<N>, const N: usize> Checked for OfSize<'_, R, N> {
    fn names(&self) -> Vec<String> {
        self.0.joint_names().map(String::from).to_vec()
    }

    fn runtime_table(&self) -> RuntimeTable {
        (&self.0.table()).into()
    }

    fn values(&self, state: &SizedState<Dyn>, tau: &DVector<f64>) -> Evaluation {
        self.0.evaluate(&fixed_state(state), &fixed(tau))
    }

    fn certified_values(
        &self,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        self.0
            .evaluate_in(&fixed_state(state), &fixed(tau), Certified::exact)
    }

    fn values_of_parts(
        &self,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        self.0
            .evaluate_parts(&fixed_state(state), &fixed(tau), found);
    }
}

/// A robot on a base that moves.
struct Floating<'a, R, const N: usize, const V: usize>(&'a R);

fn on_base<const N: usize, const V: usize>(
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

impl<R: FloatingEvaluate<N, V>, const N: usize, const V: usize> Checked for Floating<'_, R, N, V> {
    fn names(&self) -> Vec<String> {
        self.0.joint_names().map(String::from).to_vec()
    }

    fn runtime_table(&self) -> RuntimeTable {
        (&self.0.table()).into()
    }

    fn values(&self, state: &SizedState<Dyn>, tau: &DVector<f64>) -> Evaluation {
        self.values_on(&Pose::identity(), state, tau)
    }

    fn values_on(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation {
        self.0.evaluate(&on_base(base, state), &fixed(tau))
    }

    fn certified_values_on(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        self.0
            .evaluate_in(&on_base(base, state), &fixed(tau), Certified::exact)
    }

    fn values_of_parts_on(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        self.0
            .evaluate_parts(&on_base(base, state), &fixed(tau), found);
    }
}
