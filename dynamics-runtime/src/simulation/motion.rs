//! An arm and its torque law as one equation of motion.

use core::cell::Cell;

use nalgebra::SVector;

use super::error::Cause;
use super::friction::{Contact, Friction, Law};
use super::torque::TorqueLaw;
use crate::dual::Dual;
use crate::friction::DryFriction;
use crate::integrate::{Canonical, Equations, Lu, Phase, Point, first_non_finite};
use crate::{ForwardDynamics, Momenta, Scalar, SingularMassMatrix};

pub(super) struct Motion<'a, R, L, const N: usize> {
    robot: &'a R,
    torque: &'a L,
    friction: Law<N>,
    /// What friction does to each joint; without meaning where it does not stick.
    contacts: Cell<[Contact; N]>,
    /// How often the equations of motion were evaluated.
    evaluations: Cell<u64>,
}

/// Accelerations, and the forces that hold the joints that stick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held<const N: usize> {
    pub(super) qdd: SVector<f64, N>,
    pub(super) forces: SVector<f64, N>,
}

impl<'a, R, L, const N: usize> Motion<'a, R, L, N> {
    pub(super) fn new(robot: &'a R, torque: &'a L, friction: Law<N>) -> Self {
        Motion {
            robot,
            torque,
            friction,
            contacts: Cell::new([Contact::Slides(0.0); N]),
            evaluations: Cell::new(0),
        }
    }

    pub(super) fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    fn count(&self) {
        self.evaluations.set(self.evaluations.get() + 1);
    }

    pub(super) fn dry(&self) -> &[DryFriction; N] {
        &self.friction.dry
    }

    /// Whether joints stop and stick.
    pub(super) fn sticks(&self) -> bool {
        self.friction.kind == Friction::Sticking
    }

    pub(super) fn contacts(&self) -> [Contact; N] {
        self.contacts.get()
    }

    pub(super) fn set_contacts(&self, contacts: [Contact; N]) {
        self.contacts.set(contacts);
    }

    /// Which joints stick, where any does.
    fn still(&self) -> Option<[bool; N]> {
        if !self.sticks() {
            return None;
        }
        let still = self
            .contacts
            .get()
            .map(|contact| contact == Contact::Sticks);
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
    fn torque(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        if let Some(joint) = phase.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        let tau = self.law(t, phase)?;
        match self.friction.kind {
            Friction::Sign => Ok(tau),
            _ => Ok(tau + self.instead_of_sign(&phase.qd)),
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
            (Friction::Sticking, Contact::Sticks) => 0.0,
        };
        SVector::from_fn(|i, _| {
            let (dry, law) = (&self.friction.dry[i], law(i));
            dry.force(qd[i]) - law * dry.magnitude(law, qd[i])
        })
    }
}

impl<R: ForwardDynamics<N>, L: TorqueLaw<N>, const N: usize> Motion<'_, R, L, N> {
    /// The accelerations, and the forces that keep those of the joints that stick at zero.
    pub(super) fn held(&self, t: f64, phase: &Phase<N>) -> Result<Held<N>, Cause> {
        let tau = self.torque(t, phase)?;
        if self.still().is_none() {
            let qdd = self.free(phase, &tau)?;
            let forces = SVector::zeros();
            return Ok(Held { qdd, forces });
        }
        self.hold(phase, &tau)
    }

    #[inline]
    fn free(&self, phase: &Phase<N>, tau: &SVector<f64, N>) -> Result<SVector<f64, N>, Cause> {
        self.count();
        let qdd = self.robot.forward_dynamics(&phase.q, &phase.qd, tau)?;
        finite(qdd)
    }

    /// `qdd = a + W f` with a the accelerations without the holding forces f, and W = M^-1: those of
    /// the joints that stick are zero where `W_ss f_s = -a_s`. A column of W is the derivative by a
    /// torque, which a dual number carries along.
    #[cold]
    #[inline(never)]
    fn hold(&self, phase: &Phase<N>, tau: &SVector<f64, N>) -> Result<Held<N>, Cause> {
        let contacts = self.contacts.get();
        let stuck = |i: usize| contacts[i] == Contact::Sticks;
        let [q, qd] = [phase.q, phase.qd].map(|x| x.map(Dual::from_f64));
        let mut free = SVector::zeros();
        let mut columns = [SVector::<f64, N>::zeros(); N];
        for j in (0..N).filter(|j| stuck(*j)) {
            let tau = SVector::from_fn(|i, _| Dual::new(tau[i], f64::from(u8::from(i == j))));
            self.count();
            let qdd = self.robot.forward_dynamics(&q, &qd, &tau)?;
            free = finite(qdd.map(|entry| entry.value))?;
            columns[j] = qdd.map(|entry| entry.slope);
        }
        // The rows and columns of the other joints are those of the unit matrix.
        let mut inverse = nalgebra::SMatrix::<f64, N, N>::identity();
        for i in (0..N).filter(|i| stuck(*i)) {
            for j in (0..N).filter(|j| stuck(*j)) {
                inverse[(i, j)] = columns[j][i];
            }
        }
        let wanted = SVector::from_fn(|i, _| if stuck(i) { -free[i] } else { 0.0 });
        let forces = Lu::new(inverse).solve(wanted);
        let mut qdd = (0..N).fold(free, |qdd, j| qdd + columns[j] * forces[j]);
        for i in (0..N).filter(|i| stuck(*i)) {
            qdd[i] = 0.0;
        }
        Ok(Held {
            qdd: finite(qdd)?,
            forces,
        })
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
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    type Refusal = Cause;

    /// qdd, where everything on the way to it is finite.
    // One copy for all stages of all methods: inlined, the code of a program of forward dynamics
    // stands there some forty times, and whether it runs faster or slower for it is chance.
    #[inline(never)]
    fn acceleration(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        let tau = self.torque(t, phase)?;
        if self.still().is_some() {
            return Ok(self.hold(phase, &tau)?.qdd);
        }
        self.free(phase, &tau)
    }
}

/// A motion in positions and momenta.
pub(super) struct InMomenta<'a, R, L, const N: usize> {
    motion: &'a Motion<'a, R, L, N>,
    arm: &'a dyn Momenta<N>,
}

impl<'a, R: ForwardDynamics<N>, L, const N: usize> InMomenta<'a, R, L, N> {
    /// `None` where the arm is not known in momenta.
    pub(super) fn new(motion: &'a Motion<'a, R, L, N>) -> Option<Self> {
        let arm = motion.robot.momenta()?;
        Some(InMomenta { motion, arm })
    }

    /// Joints that stick have no velocity, whatever their momenta: those of the others are the
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
        match self.motion.robot.forward_dynamics(q, &rest, &rest) {
            Err(named) if named.joint == error.joint => named,
            _ => error,
        }
    }
}

impl<R, L, const N: usize> Canonical<N> for InMomenta<'_, R, L, N>
where
    R: ForwardDynamics<N>,
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
        let tau = self.motion.torque(t, &phase)?;
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
