//! An arm and its torque law as one equation of motion.

use core::cell::Cell;

use nalgebra::{SMatrix, SVector};

use super::complementarity::block;
use super::error::Cause;
use super::friction::{Contact, Friction, Law};
use super::limits::Limits;
use super::samples::Followed;
use super::torque::{self, TorqueLaw};
use super::trajectory::Forces;
use crate::integrate::{Canonical, Equations, Lu, Phase, Point, first_non_finite};
use crate::{EquationsOfMotion, Momenta, Scalar, SingularMassMatrix};

pub(super) struct Motion<'a, R, L, const N: usize> {
    robot: &'a R,
    torque: &'a L,
    friction: Law<N>,
    limits: Limits<N>,
    /// What friction and stops do to each joint; without meaning in a motion without events.
    contacts: Cell<[Contact; N]>,
    /// How often the equations of motion were evaluated.
    evaluations: Cell<u64>,
}

/// Accelerations, and the forces that hold the joints that stick or lean on a stop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held<const N: usize> {
    pub(super) qdd: SVector<f64, N>,
    pub(super) forces: SVector<f64, N>,
}

impl<'a, R, L, const N: usize> Motion<'a, R, L, N> {
    pub(super) fn new(robot: &'a R, torque: &'a L, friction: Law<N>, limits: Limits<N>) -> Self {
        Motion {
            robot,
            torque,
            friction,
            limits,
            contacts: Cell::new([Contact::Slides(0.0); N]),
            evaluations: Cell::new(0),
        }
    }

    pub(super) fn robot(&self) -> &R {
        self.robot
    }

    pub(super) fn torque_law(&self) -> &L {
        self.torque
    }

    pub(super) fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    fn count(&self) {
        self.evaluations.set(self.evaluations.get() + 1);
    }

    pub(super) fn limits(&self) -> &Limits<N> {
        &self.limits
    }

    /// Whether joints stop and stick.
    fn sticks(&self) -> bool {
        self.friction.kind == Friction::Sticking
    }

    /// Whether joint `i` stops and sticks.
    pub(super) fn may_stick(&self, i: usize) -> bool {
        self.sticks() && !self.friction.dry[i].is_none()
    }

    /// Whether there is more to the motion than its equations.
    pub(super) fn has_events(&self) -> bool {
        self.sticks() || self.limits.matter()
    }

    /// How great a force friction holds against, at joint `i` at rest, that would move it one way.
    pub(super) fn breakaway(&self, i: usize, way: f64) -> f64 {
        match self.friction.kind {
            Friction::Regularised { .. } => 0.0,
            Friction::Sign | Friction::Sticking => self.friction.dry[i].breakaway(way),
        }
    }

    pub(super) fn contacts(&self) -> [Contact; N] {
        self.contacts.get()
    }

    pub(super) fn set_contacts(&self, contacts: [Contact; N]) {
        self.contacts.set(contacts);
    }

    /// Which joints are held where they are, where any is.
    pub(super) fn still(&self) -> Option<[bool; N]> {
        if !self.has_events() {
            return None;
        }
        let still = self.contacts.get().map(Contact::holds);
        still.contains(&true).then_some(still)
    }
}

impl<R, L: TorqueLaw<N>, const N: usize> Motion<'_, R, L, N> {
    /// What the laws say.
    pub(super) fn law(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        self.torque.torque(t, phase)
    }

    /// The torques at a time in a phase, where both are finite. In place of the friction that the
    /// forward dynamics takes off, a multiple of sign(qd), they have that of the simulation.
    pub(super) fn torques(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        if let Some(joint) = phase.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        Ok(self.with_friction(phase, self.law(t, phase)?))
    }

    #[inline]
    fn with_friction(&self, phase: &Phase<N>, tau: SVector<f64, N>) -> SVector<f64, N> {
        match self.friction.kind {
            Friction::Sign => tau,
            _ => tau + self.instead_of_sign(&phase.qd),
        }
    }

    /// What makes the friction of the forward dynamics that of the simulation: the magnitude in its
    /// direction times the sign of the velocity, less that with what the law has in place of the sign.
    // Apart from the path of those who have none of it, which is to be inlined in every stage.
    #[cold]
    #[inline(never)]
    fn instead_of_sign(&self, qd: &SVector<f64, N>) -> SVector<f64, N> {
        let contacts = self.contacts.get();
        let law = |i: usize| match (self.friction.kind, contacts[i]) {
            (Friction::Sign, _) => Scalar::sign(qd[i]),
            (Friction::Regularised { speed }, _) => (qd[i] / speed).tanh(),
            (Friction::Sticking, Contact::Slides(way)) => way,
            (Friction::Sticking, Contact::Sticks | Contact::Leans(_)) => 0.0,
        };
        SVector::from_fn(|i, _| {
            let (dry, law) = (&self.friction.dry[i], law(i));
            dry.force(qd[i]) - law * dry.magnitude(law, qd[i])
        })
    }
}

impl<R: EquationsOfMotion<N>, L: TorqueLaw<N>, const N: usize> Motion<'_, R, L, N> {
    /// The accelerations, and the forces that keep those of the joints that are held at zero.
    pub(super) fn held(&self, t: f64, phase: &Phase<N>) -> Result<Held<N>, Cause> {
        self.held_under(phase, &self.torques(t, phase)?)
    }

    fn held_under(&self, phase: &Phase<N>, tau: &SVector<f64, N>) -> Result<Held<N>, Cause> {
        match self.still() {
            Some(still) => self.hold(phase, tau, &still),
            None => Ok(Held {
                qdd: self.free(phase, tau)?,
                forces: SVector::zeros(),
            }),
        }
    }

    #[inline]
    fn free(&self, phase: &Phase<N>, tau: &SVector<f64, N>) -> Result<SVector<f64, N>, Cause> {
        self.count();
        let qdd = self.robot.accelerations(&phase.q, &phase.qd, tau)?;
        finite(qdd)
    }

    /// `qdd = a + W f` with a the accelerations without the holding forces f, and W = M^-1: those of
    /// the joints that are held are zero where `W_ss f_s = -a_s`.
    #[cold]
    #[inline(never)]
    fn hold(
        &self,
        phase: &Phase<N>,
        tau: &SVector<f64, N>,
        still: &[bool; N],
    ) -> Result<Held<N>, Cause> {
        let (free, columns) = self.responses(phase, tau, still)?;
        let wanted = SVector::from_fn(|i, _| if still[i] { -free[i] } else { 0.0 });
        let forces = Lu::new(block(&columns, still)).solve(wanted);
        let mut qdd = (0..N).fold(free, |qdd, j| qdd + columns.column(j) * forces[j]);
        for i in (0..N).filter(|i| still[*i]) {
            qdd[i] = 0.0;
        }
        Ok(Held {
            qdd: finite(qdd)?,
            forces,
        })
    }

    /// The accelerations under some torques, and the columns of M^-1 that belong to some joints.
    pub(super) fn responses(
        &self,
        phase: &Phase<N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<(SVector<f64, N>, SMatrix<f64, N, N>), Cause> {
        let evaluations = joints.iter().filter(|joint| **joint).count().max(1);
        (0..evaluations).for_each(|_| self.count());
        let Phase { q, qd } = phase;
        let (qdd, columns) = self.robot.accelerations_and_responses(q, qd, tau, joints)?;
        Ok((finite(qdd)?, columns))
    }
}

impl<R: EquationsOfMotion<N>, L: TorqueLaw<N>, const N: usize> Followed<N> for Motion<'_, R, L, N> {
    /// Not a number where the laws or the equations refuse: what is recorded ends no run.
    fn forces(&self, t: f64, phase: &Phase<N>) -> Forces<N> {
        let (evaluations, tau) = (self.evaluations.get(), self.torque.motors(t, phase));
        let law = torque::finite(tau).and_then(|tau| self.torque.with_tool(tau, t, phase));
        let held = law.and_then(|tau| self.held_under(phase, &self.with_friction(phase, tau)));
        self.evaluations.set(evaluations);
        Forces {
            qdd: held.map_or(SVector::repeat(f64::NAN), |held| held.qdd),
            tau,
        }
    }

    fn period(&self) -> Option<f64> {
        self.torque.period()
    }

    fn sample(&self, t: f64, phase: &Phase<N>) -> Result<(), Cause> {
        self.torque.sample(t, phase)
    }
}

fn finite<const N: usize>(qdd: SVector<f64, N>) -> Result<SVector<f64, N>, Cause> {
    match first_non_finite(&qdd) {
        Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
        None => Ok(qdd),
    }
}

impl<R, L, const N: usize> Equations<N> for Motion<'_, R, L, N>
where
    R: EquationsOfMotion<N>,
    L: TorqueLaw<N>,
{
    type Refusal = Cause;

    /// qdd, where everything on the way to it is finite.
    // One copy for all stages of all methods: inlined, the code of a program of forward dynamics
    // stands there some forty times, and whether it runs faster or slower for it is chance.
    #[inline(never)]
    fn acceleration(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        let tau = self.torques(t, phase)?;
        match self.still() {
            Some(still) => Ok(self.hold(phase, &tau, &still)?.qdd),
            None => self.free(phase, &tau),
        }
    }
}

/// A motion in positions and momenta.
pub(super) struct InMomenta<'a, R, L, const N: usize> {
    motion: &'a Motion<'a, R, L, N>,
    arm: &'a dyn Momenta<N>,
}

impl<'a, R: EquationsOfMotion<N>, L, const N: usize> InMomenta<'a, R, L, N> {
    /// `None` where the arm is not known in momenta.
    pub(super) fn new(motion: &'a Motion<'a, R, L, N>) -> Option<Self> {
        let arm = motion.robot.in_momenta()?;
        Some(InMomenta { motion, arm })
    }

    /// Joints that are held have no velocity, whatever their momenta: those of the others are the
    /// momenta of the arm that is left.
    #[inline]
    fn phase_beside(&self, still: Option<[bool; N]>, at: &Point<N>) -> Result<Phase<N>, Cause> {
        if let Some(joint) = at.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        let qd = match still {
            None => self.arm.velocity(&at.q, &at.p),
            Some(still) => self.arm.velocity_beside(&still, &at.q, &at.p),
        };
        let qd = qd.map_err(|error| self.named(error, &at.q))?;
        Ok(Phase { q: at.q, qd })
    }

    /// The error as the forward dynamics of the arm has it, which knows the names of the joints.
    #[cold]
    fn named(&self, error: SingularMassMatrix, q: &SVector<f64, N>) -> SingularMassMatrix {
        let rest = SVector::zeros();
        match self.motion.robot.accelerations(q, &rest, &rest) {
            Err(named) if named.joint == error.joint => named,
            _ => error,
        }
    }
}

impl<R, L, const N: usize> Canonical<N> for InMomenta<'_, R, L, N>
where
    R: EquationsOfMotion<N>,
    L: TorqueLaw<N>,
{
    type Refusal = Cause;

    fn momentum(&self, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        Ok(self.arm.momentum(&phase.q, &phase.qd))
    }

    fn phase(&self, at: &Point<N>) -> Result<Phase<N>, Cause> {
        self.phase_beside(self.motion.still(), at)
    }

    fn rate(&self, t: f64, at: &Point<N>) -> Result<Point<N>, Cause> {
        let still = self.motion.still();
        let phase = self.phase_beside(still, at)?;
        let tau = self.motion.torques(t, &phase)?;
        self.motion.count();
        let mut p = finite(self.arm.force(&phase.q, &phase.qd, &tau))?;
        // The forces that hold a joint act on its momentum alone, which nothing reads.
        for (i, still) in still.iter().flatten().enumerate() {
            if *still {
                p[i] = 0.0;
            }
        }
        Ok(Point { q: phase.qd, p })
    }
}
