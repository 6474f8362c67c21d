//! The equations of the motion that a method of integration follows.

use dynamics_runtime::Size;

use super::Phase;

/// Equations of motion q'' = a(t, q, q').
pub(crate) trait Equations<D: Size> {
    /// Why there is no acceleration.
    type Refusal;

    /// The acceleration at a time in a phase.
    fn acceleration(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, Self::Refusal>;

    /// How the positions move: as the velocities say, unless they are coordinates in a chart.
    #[inline]
    fn position_rates(&self, phase: &Phase<D>) -> D::Vector {
        phase.qd.clone()
    }

    /// How the phase moves.
    #[inline]
    fn rate(&self, t: f64, phase: &Phase<D>) -> Result<Phase<D>, Self::Refusal> {
        let qd = self.acceleration(t, phase)?;
        let q = self.position_rates(phase);
        Ok(Phase { q, qd })
    }

    /// The coordinates in a chart around a phase, where the motion from then on is followed; `None` where there are no
    /// charts.
    #[inline]
    fn recentred(&self, _phase: &Phase<D>) -> Option<D::Vector> {
        None
    }
}

impl<F: Fn(f64, &Phase<D>) -> Result<D::Vector, E>, E, D: Size> Equations<D> for F {
    type Refusal = E;

    #[inline]
    fn acceleration(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, E> {
        self(t, phase)
    }
}
