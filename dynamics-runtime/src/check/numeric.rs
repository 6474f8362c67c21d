//! The numeric algorithms at a state, whether the base stands or moves.

use nalgebra::{Const, DMatrix, DVector, Dyn, OMatrix};

use crate::table::AsArm as _;
use crate::{Conditioning, NumericArm, NumericFloating, Pose, RuntimeTable, SizedState};

/// The numeric algorithms of a robot.
pub(super) enum Numeric {
    Standing(Box<NumericArm<Dyn>>),
    Floating(Box<NumericFloating<Dyn, Dyn>>),
}

impl Numeric {
    /// By the table, which says whether the base moves.
    pub(super) fn new(table: &RuntimeTable) -> Self {
        match table.arm().floating {
            None => Numeric::Standing(Box::new(NumericArm::<Dyn>::new(table))),
            Some(_) => Numeric::Floating(Box::new(NumericFloating::<Dyn, Dyn>::new(table))),
        }
    }

    pub(super) fn conditioning(&self, q: &DVector<f64>) -> Conditioning {
        match self {
            Numeric::Standing(arm) => arm.conditioning(q),
            Numeric::Floating(robot) => robot.conditioning(q),
        }
    }

    pub(super) fn mass_matrix(&self, q: &DVector<f64>) -> DMatrix<f64> {
        match self {
            Numeric::Standing(arm) => arm.mass_matrix(q),
            Numeric::Floating(robot) => robot.mass_matrix(q),
        }
    }

    /// Forces of a motion; `base` is read where the base moves.
    pub(super) fn inverse_dynamics(
        &self,
        base: &Pose<f64>,
        SizedState { q, qd, qdd }: &SizedState<Dyn>,
    ) -> DVector<f64> {
        match self {
            Numeric::Standing(arm) => arm.inverse_dynamics(q, qd, qdd),
            Numeric::Floating(robot) => robot.inverse_dynamics(base, q, qd, qdd),
        }
    }

    /// The standard regressor at a base that is not turned, a block of ten columns for each body: that of a base that moves,
    /// those of the joints' links and of the followers'.
    pub(super) fn standard_regressors(
        &self,
        SizedState { q, qd, qdd }: &SizedState<Dyn>,
    ) -> Vec<OMatrix<f64, Dyn, Const<10>>> {
        match self {
            Numeric::Standing(arm) => {
                let own = arm.standard_regressor(q, qd, qdd).into_iter();
                own.chain(arm.standard_regressor_of_followers(q, qd, qdd))
                    .collect()
            }
            Numeric::Floating(robot) => {
                let base = Pose::identity();
                let mut blocks = vec![robot.standard_regressor_of_base(&base, qd, qdd)];
                blocks.extend(robot.standard_regressor(&base, q, qd, qdd));
                blocks.extend(robot.standard_regressor_of_followers(&base, q, qd, qdd));
                blocks
            }
        }
    }

    /// V at these velocities.
    pub(super) fn coriolis_vector(&self, q: &DVector<f64>, qd: &DVector<f64>) -> DVector<f64> {
        match self {
            Numeric::Standing(arm) => arm.coriolis_vector(q, qd),
            Numeric::Floating(robot) => robot.coriolis_vector(q, qd),
        }
    }
}
