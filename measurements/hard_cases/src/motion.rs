//! Motions: counting the calls, and errors at the end.

use std::cell::Cell;

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    ForwardDynamics, Method, Model, Scalar, Simulation, SingularMassMatrix, Trajectory,
    simulation::{Dop853, DormandPrince},
    table::Table,
};

/// An arm that counts how often its accelerations are asked for.
pub(crate) struct Counted<'a, R> {
    arm: &'a R,
    calls: Cell<u64>,
}

impl<'a, R> Counted<'a, R> {
    pub(crate) fn new(arm: &'a R) -> Self {
        let calls = Cell::new(0);
        Counted { arm, calls }
    }

    pub(crate) fn calls(&self) -> f64 {
        self.calls.get() as f64
    }
}

impl<R: Model<N>, const N: usize> Model<N> for Counted<'_, R> {
    const JOINT_NAMES: [&'static str; N] = R::JOINT_NAMES;

    fn table(&self) -> Table<N> {
        self.arm.table()
    }
}

impl<R: ForwardDynamics<N>, const N: usize> ForwardDynamics<N> for Counted<'_, R> {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<SVector<T, N>, SingularMassMatrix> {
        self.calls.set(self.calls.get() + 1);
        self.arm.forward_dynamics(q, qd, tau)
    }
}

/// Dormand and Prince's method with one tolerance.
pub(crate) fn dormand_prince(tolerance: f64) -> Method {
    Method::DormandPrince(DormandPrince::with_tolerance(tolerance))
}

/// DOP853 with one tolerance.
pub(crate) fn dop853(tolerance: f64) -> Method {
    Method::Dop853(Dop853::with_tolerance(tolerance))
}

/// Free motion from a state; `None` where it ends early.
pub(crate) fn free<R: ForwardDynamics<N>, const N: usize>(
    arm: &R,
    method: impl Into<Method>,
    q: SVector<f64, N>,
    qd: SVector<f64, N>,
    duration: f64,
    samples: usize,
) -> Option<Trajectory<N>> {
    let simulation = Simulation::new(arm).method(method).initial(q, qd);
    simulation.duration(duration).samples(samples).run().ok()
}
