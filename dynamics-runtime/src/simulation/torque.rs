//! The laws that move an arm: the torques of its motors, and the force at its tool.

use core::cell::RefCell;

use super::error::{Cause, InvalidSetting};
use super::law::ForceLaw;
use super::tool_wrench::ToolWrench;
use crate::integrate::{Phase, first_non_finite};
use crate::size::{JointVector, Size};
use crate::stand::{Stand, Velocities};
use crate::table::Arm;

/// The forces that act on the joints from outside of the arm's own equations.
pub(super) trait TorqueLaw<D: Size> {
    /// The torques of the motors at a time in a finite phase, N m or N. They may be infinite or NaN.
    fn motors(&self, t: f64, phase: &Phase<D>) -> D::Vector;

    /// Torques with those of the force at the tool.
    fn with_tool(&self, tau: D::Vector, t: f64, phase: &Phase<D>) -> Result<D::Vector, Cause>;

    /// The period of laws that are sampled and held.
    fn period(&self) -> Option<f64> {
        None
    }

    /// Begins a period: calls the laws that are sampled.
    fn sample(&self, _t: f64, _phase: &Phase<D>) -> Result<(), Cause> {
        Ok(())
    }

    /// All of the torques.
    #[inline]
    fn torque(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, Cause> {
        self.with_tool(finite(self.motors(t, phase))?, t, phase)
    }
}

/// The greatest torques of a table, infinite where it has none.
pub(super) fn greatest<D: Size>(arm: Arm<'_>) -> D::Vector {
    let limit = |i: usize| arm.rows[i].torque_limit;
    let of_freedom = |k| arm.joint_of(k).and_then(limit).unwrap_or(f64::INFINITY);
    D::from_usize(arm.freedoms()).vector_of(of_freedom)
}

/// Refuses greatest torques that make no sense.
pub(super) fn validate<V: JointVector>(greatest: Option<&V>) -> Result<(), InvalidSetting> {
    let is_none = |limit: &f64| limit.is_nan() || *limit <= 0.0;
    match greatest.and_then(|limits| limits.entries().iter().position(is_none)) {
        Some(joint) => Err(InvalidSetting::TorqueLimit { joint }),
        None => Ok(()),
    }
}

/// Torques, of which those beyond the greatest ones are these, if there are some. Numbers that are none stay.
fn saturated<V: JointVector>(tau: V, greatest: Option<&V>) -> V {
    let Some(greatest) = greatest else {
        return tau;
    };
    let (tau, greatest) = (tau.entries(), greatest.entries());
    V::from_entries(tau.len(), |i| {
        if tau[i].abs() > greatest[i] {
            greatest[i].copysign(tau[i])
        } else {
            tau[i]
        }
    })
}

/// The torques of the motors, a function of t in s, of the place and of the velocities, and the force at the tool.
pub(super) struct Laws<'a, R, L, W, K: Stand> {
    pub(super) robot: &'a R,
    pub(super) charts: &'a K::Charts,
    pub(super) torque: &'a L,
    pub(super) tool_wrench: &'a W,
    /// The greatest torques, where motors saturate.
    pub(super) greatest: Option<&'a Velocities<K>>,
}

impl<'a, R, L, W, K: Stand> TorqueLaw<K::Freedoms> for Laws<'a, R, L, W, K>
where
    &'a L: ForceLaw<K>,
    W: ToolWrench<R, K>,
{
    #[inline]
    fn motors(&self, t: f64, Phase { q, qd }: &Phase<K::Freedoms>) -> Velocities<K> {
        let mut law = self.torque;
        let tau = K::seen(self.charts, q, |place| law.forces(t, place, qd));
        saturated(tau, self.greatest)
    }

    #[inline]
    fn with_tool(
        &self,
        tau: Velocities<K>,
        t: f64,
        Phase { q, qd }: &Phase<K::Freedoms>,
    ) -> Result<Velocities<K>, Cause> {
        K::seen(self.charts, q, |place| {
            self.tool_wrench.added_to(tau, self.robot, (t, place, qd))
        })
    }
}

/// Torques of the motors that are sampled and held, and the force at the tool, which may be.
pub(super) struct SampledLaws<'a, R, L, W, K: Stand> {
    robot: &'a R,
    charts: &'a K::Charts,
    /// The time between two calls; `None` for one call at the start.
    period: Option<f64>,
    torque: RefCell<&'a mut L>,
    tool_wrench: RefCell<&'a mut W>,
    held: RefCell<Velocities<K>>,
    /// The greatest torques, where motors saturate.
    greatest: Option<&'a Velocities<K>>,
}

impl<'a, R, L, W, K: Stand> SampledLaws<'a, R, L, W, K> {
    pub(super) fn new(
        size: K::Freedoms,
        (robot, charts): (&'a R, &'a K::Charts),
        period: Option<f64>,
        torque: &'a mut L,
        tool_wrench: &'a mut W,
        greatest: Option<&'a Velocities<K>>,
    ) -> Self {
        SampledLaws {
            robot,
            charts,
            period,
            torque: RefCell::new(torque),
            tool_wrench: RefCell::new(tool_wrench),
            held: RefCell::new(size.vector()),
            greatest,
        }
    }

    /// The torques since the last call.
    pub(super) fn held(&self) -> Velocities<K> {
        self.held.borrow().clone()
    }
}

impl<R, L, W, K: Stand> TorqueLaw<K::Freedoms> for SampledLaws<'_, R, L, W, K>
where
    L: ForceLaw<K>,
    W: ToolWrench<R, K>,
{
    #[inline]
    fn motors(&self, _t: f64, _phase: &Phase<K::Freedoms>) -> Velocities<K> {
        self.held()
    }

    #[inline]
    fn with_tool(
        &self,
        tau: Velocities<K>,
        t: f64,
        Phase { q, qd }: &Phase<K::Freedoms>,
    ) -> Result<Velocities<K>, Cause> {
        let tool = self.tool_wrench.borrow();
        K::seen(self.charts, q, |place| {
            tool.added_to(tau, self.robot, (t, place, qd))
        })
    }

    fn period(&self) -> Option<f64> {
        self.period
    }

    fn sample(&self, t: f64, Phase { q, qd }: &Phase<K::Freedoms>) -> Result<(), Cause> {
        K::seen(self.charts, q, |place| {
            let tau = self.torque.borrow_mut().forces(t, place, qd);
            let tau = saturated(tau, self.greatest);
            *self.held.borrow_mut() = tau.clone();
            finite(tau)?;
            self.tool_wrench
                .borrow_mut()
                .sample(self.robot, (t, place, qd))
        })
    }
}

/// Torques that a law returned, where they are numbers.
pub(super) fn finite<V: JointVector>(tau: V) -> Result<V, Cause> {
    match first_non_finite(tau.entries()) {
        Some(joint) => Err(Cause::NonFiniteTorque { joint }),
        None => Ok(tau),
    }
}
