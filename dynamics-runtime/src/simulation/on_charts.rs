//! A robot on a base that moves, as equations of motion in charts.

use crate::size::Size;
use crate::stand::{Charted, Charts, OnBase};
use crate::{EquationsOfMotion, Pose, Responses, SingularMassMatrix};

/// A robot, and the charts in which its base is followed.
pub(super) struct OnCharts<'a, R, D: Size, V: Size> {
    pub(super) robot: &'a R,
    pub(super) charts: &'a Charts<D, V>,
}

impl<R, D: Size, V: Size> OnCharts<'_, R, D, V> {
    fn place(&self, positions: &V::Vector) -> (Pose<f64>, D::Vector) {
        (self.charts.pose(positions), self.charts.joints(positions))
    }
}

impl<R, D: Size, V: Size> EquationsOfMotion<V> for OnCharts<'_, R, D, V>
where
    R: EquationsOfMotion<OnBase<D, V>>,
{
    fn size(&self) -> V {
        self.robot.size()
    }

    fn accelerations(
        &self,
        positions: &V::Vector,
        v: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        let (base, q) = self.place(positions);
        self.robot.accelerations((&base, &q), v, tau)
    }

    fn accelerations_and_responses(
        &self,
        positions: &V::Vector,
        v: &V::Vector,
        tau: &V::Vector,
        freedoms: &V::Each<bool>,
    ) -> Result<Responses<V>, SingularMassMatrix> {
        let (base, q) = self.place(positions);
        self.robot
            .accelerations_and_responses((&base, &q), v, tau, freedoms)
    }

    fn charts(&self) -> Option<&dyn Charted<V>> {
        Some(self.charts)
    }
}
