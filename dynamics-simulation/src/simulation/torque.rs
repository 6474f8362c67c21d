//! The laws that move an arm: the torques of its motors, and the force at its tool.

use core::cell::RefCell;

use dynamics_runtime::internal::Velocities;
use dynamics_runtime::table::Arm;
use dynamics_runtime::{EquationsOfMotion, JointVector, Size, Sizes};

use super::error::{Cause, InvalidSetting};
use super::law::ForceLaw;
use super::placed::Placed;
use super::wrench::Wrenches;
use crate::integrate::{Phase, first_non_finite};

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

/// The laws of a robot: the torques of its motors, and the forces of the surroundings.
pub(super) struct Laws<'a, R, L, K: Sizes> {
    pub(super) placed: &'a Placed<'a, R, K>,
    pub(super) torque: L,
    pub(super) wrenches: &'a Wrenches<'a, R, K>,
    /// The greatest torques, where motors saturate.
    pub(super) greatest: Option<&'a Velocities<K>>,
}

impl<R: EquationsOfMotion<K>, L, K: Sizes> Laws<'_, R, L, K> {
    fn motors(
        &self,
        law: &mut impl ForceLaw<K>,
        t: f64,
        Phase { q, qd }: &Phase<K::Freedoms>,
    ) -> Velocities<K> {
        let tau = law.forces(t, &self.placed.place(q), qd);
        saturated(tau, self.greatest)
    }

    fn with_wrenches(
        &self,
        tau: Velocities<K>,
        t: f64,
        Phase { q, qd }: &Phase<K::Freedoms>,
    ) -> Result<Velocities<K>, Cause> {
        if self.wrenches.is_empty() {
            return Ok(tau);
        }
        let at = (t, &self.placed.place(q), qd);
        self.wrenches.added_to(tau, self.placed.robot, at)
    }
}

/// Laws that are functions of time and state.
impl<'a, R: EquationsOfMotion<K>, L, K: Sizes> TorqueLaw<K::Freedoms> for Laws<'a, R, &'a L, K>
where
    &'a L: ForceLaw<K>,
{
    #[inline]
    fn motors(&self, t: f64, phase: &Phase<K::Freedoms>) -> Velocities<K> {
        let mut law = self.torque;
        self.motors(&mut law, t, phase)
    }

    #[inline]
    fn with_tool(
        &self,
        tau: Velocities<K>,
        t: f64,
        phase: &Phase<K::Freedoms>,
    ) -> Result<Velocities<K>, Cause> {
        self.with_wrenches(tau, t, phase)
    }
}

/// Torques of the motors that are sampled and held.
pub(super) struct SampledLaw<'a, L, V> {
    /// The time between two calls; `None` for one call at the start.
    pub(super) period: Option<f64>,
    pub(super) law: RefCell<&'a mut L>,
    pub(super) held: RefCell<V>,
}

impl<R: EquationsOfMotion<K>, L: ForceLaw<K>, K: Sizes> TorqueLaw<K::Freedoms>
    for Laws<'_, R, SampledLaw<'_, L, Velocities<K>>, K>
{
    #[inline]
    fn motors(&self, _t: f64, _phase: &Phase<K::Freedoms>) -> Velocities<K> {
        self.torque.held.borrow().clone()
    }

    #[inline]
    fn with_tool(
        &self,
        tau: Velocities<K>,
        t: f64,
        phase: &Phase<K::Freedoms>,
    ) -> Result<Velocities<K>, Cause> {
        self.with_wrenches(tau, t, phase)
    }

    fn period(&self) -> Option<f64> {
        self.torque.period
    }

    fn sample(&self, t: f64, phase: &Phase<K::Freedoms>) -> Result<(), Cause> {
        let mut law = self.torque.law.borrow_mut();
        let tau = self.motors(&mut **law, t, phase);
        *self.torque.held.borrow_mut() = tau.clone();
        finite(tau)?;
        let at = (t, &self.placed.place(&phase.q), &phase.qd);
        self.wrenches.sample(self.placed.robot, at)
    }
}

/// Torques that a law returned, where they are numbers.
pub(super) fn finite<V: JointVector>(tau: V) -> Result<V, Cause> {
    match first_non_finite(tau.entries()) {
        Some(joint) => Err(Cause::NonFiniteTorque { joint }),
        None => Ok(tau),
    }
}
