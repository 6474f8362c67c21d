//! A robot and its laws as one equation of motion.

use core::cell::{Cell, Ref, RefCell};
use core::fmt::Debug;
use core::ops::Range;

use dynamics_runtime::{JointVector, Pose, Scalar, SingularMassMatrix, Size, SizedMomenta};

use super::complementarity::block;
use super::error::Cause;
use super::friction::{Contact, Friction, Law};
use super::limits::Limits;
use super::placed::InCoordinates;
use super::recorder::{Recorder, Taken};
use super::sampling::before;
use super::torque::{self, TorqueLaw};
use crate::integrate::{Canonical, Equations, Phase, Point, Stepper, first_non_finite};

/// Robot and laws are values: each method of integration is compiled once for all robots of as many freedoms.
pub(super) struct Motion<'a, D: Size> {
    pub(super) size: D,
    robot: &'a dyn InCoordinates<D>,
    /// Whether the base moves.
    pub(super) moves: bool,
    pub(super) torque: &'a dyn TorqueLaw<D>,
    pub(super) friction: Law<D>,
    pub(super) limits: Limits<D>,
    /// The contacts under which a method integrates; without meaning in a motion without events.
    contacts: RefCell<Contacts<D>>,
    /// How often the equations of motion were evaluated.
    pub(super) evaluations: Cell<u64>,
    /// The least rise of a bounce where there are bounces without end, relative to the position and to 1 rad or 1 m; else 0.
    pub(super) coarse: Cell<f64>,
}

/// The contact of each joint.
pub(super) type Contacts<D> = <D as Size>::Each<Contact>;

/// Accelerations, and the forces that hold the joints that stick or lean on a stop.
#[derive(Clone, Debug)]
pub(super) struct Held<D: Size> {
    pub(super) qdd: D::Vector,
    pub(super) forces: D::Vector,
}

impl<'a, D: Size> Motion<'a, D> {
    pub(super) fn new(
        robot: &'a dyn InCoordinates<D>,
        torque: &'a dyn TorqueLaw<D>,
        friction: Law<D>,
        limits: Limits<D>,
    ) -> Self {
        let size = robot.size();
        Motion {
            size,
            robot,
            moves: robot.base(&size.vector()).is_some(),
            torque,
            friction,
            limits,
            contacts: RefCell::new(size.each(|_| Contact::Slides(0.0))),
            evaluations: Cell::new(0),
            coarse: Cell::new(0.0),
        }
    }

    /// The pose of a base that moves.
    pub(super) fn base(&self, positions: &D::Vector) -> Option<Pose<f64>> {
        self.robot.base(positions)
    }

    /// The joints, counted from 0.
    pub(super) fn joints(&self) -> Range<usize> {
        self.size.joints()
    }

    /// A list with an entry for each joint.
    pub(super) fn each<X: Clone + Debug>(&self, entry: impl FnMut(usize) -> X) -> D::Each<X> {
        self.size.each(entry)
    }

    /// Counts evaluations of the equations of motion.
    pub(super) fn count(&self, evaluations: u64) {
        self.evaluations.set(self.evaluations.get() + evaluations);
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

    /// The contacts under which a method integrates.
    pub(super) fn contacts(&self) -> Ref<'_, Contacts<D>> {
        self.contacts.borrow()
    }

    /// Goes on under other contacts.
    pub(super) fn go_on_under(&self, contacts: Contacts<D>) {
        *self.contacts.borrow_mut() = contacts;
    }

    /// Which joints are held where they are, where any is.
    pub(super) fn still(&self, contacts: &Contacts<D>) -> Option<D::Each<bool>> {
        if !self.has_events() {
            return None;
        }
        let still = self.each(|i| contacts[i].holds());
        still.as_ref().contains(&true).then_some(still)
    }
}

impl<D: Size> Motion<'_, D> {
    /// The torques at a time in a phase, where both are finite. In place of the friction that the
    /// forward dynamics takes off, a multiple of sign(qd), they have that of the simulation.
    pub(super) fn torques(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Result<D::Vector, Cause> {
        Ok(self.with_friction(contacts, phase, self.torques_of_laws(t, phase)?))
    }

    /// The torques of the laws alone.
    #[inline]
    fn torques_of_laws(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, Cause> {
        match phase.first_non_finite() {
            Some(joint) => Err(Cause::NonFiniteState { joint }),
            None => self.torque.torque(t, phase),
        }
    }

    #[inline]
    fn with_friction(&self, contacts: &Contacts<D>, phase: &Phase<D>, tau: D::Vector) -> D::Vector {
        match self.friction.kind {
            Friction::Sign => tau,
            _ => tau + self.instead_of_sign(contacts, &phase.qd),
        }
    }

    /// The difference of the friction of the forward dynamics, magnitude times sign of the velocity, from that of the
    /// simulation, which has another factor in place of the sign.
    // Apart from the path without it, which is to be inlined in every stage.
    #[cold]
    #[inline(never)]
    fn instead_of_sign(&self, contacts: &Contacts<D>, qd: &D::Vector) -> D::Vector {
        let law = |i: usize| match (self.friction.kind, contacts[i]) {
            (Friction::Sign, _) => Scalar::sign(qd[i]),
            (Friction::Regularised { speed }, _) => (qd[i] / speed).tanh(),
            (Friction::Sticking, Contact::Slides(way)) => way,
            (Friction::Sticking, Contact::Sticks | Contact::Leans(_)) => 0.0,
        };
        self.size.vector_of(|i| {
            let (dry, law) = (&self.friction.dry[i], law(i));
            dry.force(qd[i]) - law * dry.magnitude(law, qd[i])
        })
    }
}

impl<D: Size> Motion<'_, D> {
    /// The accelerations, and the forces that keep those of the joints that are held at zero.
    pub(super) fn held(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Result<Held<D>, Cause> {
        let tau = self.torques(contacts, t, phase)?;
        self.held_under(contacts, phase, &tau)
    }

    fn held_under(
        &self,
        contacts: &Contacts<D>,
        phase: &Phase<D>,
        tau: &D::Vector,
    ) -> Result<Held<D>, Cause> {
        match self.still(contacts) {
            Some(still) => self.hold(phase, tau, &still),
            None => Ok(Held {
                qdd: self.free(phase, tau)?,
                forces: self.size.vector(),
            }),
        }
    }

    #[inline]
    fn free(&self, phase: &Phase<D>, tau: &D::Vector) -> Result<D::Vector, Cause> {
        self.count(1);
        let qdd = self.robot.accelerations(phase, tau)?;
        finite(qdd)
    }

    /// The acceleration under contacts and torques of the laws.
    // Apart from the path without contacts, which is inlined in each stage.
    #[inline(never)]
    fn acceleration_under(
        &self,
        contacts: &Contacts<D>,
        phase: &Phase<D>,
        tau: D::Vector,
    ) -> Result<D::Vector, Cause> {
        let tau = self.with_friction(contacts, phase, tau);
        match self.still(contacts) {
            Some(still) => Ok(self.hold(phase, &tau, &still)?.qdd),
            None => self.free(phase, &tau),
        }
    }

    /// `qdd = a + W f` with a the accelerations without the holding forces f, and W = M^-1: those of
    /// the joints that are held are zero where `W_ss f_s = -a_s`.
    #[cold]
    #[inline(never)]
    fn hold(
        &self,
        phase: &Phase<D>,
        tau: &D::Vector,
        still: &D::Each<bool>,
    ) -> Result<Held<D>, Cause> {
        let (free, columns) = self.responses(phase, tau, still)?;
        let wanted = self
            .size
            .vector_of(|i| if still[i] { -free[i] } else { 0.0 });
        let forces = block(self.size, &columns, still).solve_vector(&wanted);
        let mut qdd = free;
        for j in self.joints() {
            for i in self.joints() {
                qdd[i] += columns[(i, j)] * forces[j];
            }
        }
        for i in self.joints().filter(|i| still[*i]) {
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
        phase: &Phase<D>,
        tau: &D::Vector,
        joints: &D::Each<bool>,
    ) -> Result<(D::Vector, D::Matrix), Cause> {
        let columns = joints.as_ref().iter().filter(|joint| **joint).count();
        self.count(columns.max(1) as u64);
        let (qdd, columns) = self.robot.responses(phase, tau, joints)?;
        Ok((finite(qdd)?, columns))
    }
}

impl<D: Size> Motion<'_, D> {
    /// A sample. Its accelerations are NaN where the laws or the equations refuse, which ends no run.
    pub(super) fn sample_at(&self, t: f64, phase: Phase<D>) -> Taken<D> {
        let (evaluations, tau) = (self.evaluations.get(), self.torque.motors(t, &phase));
        let law = torque::finite(tau.clone()).and_then(|tau| self.torque.with_tool(tau, t, &phase));
        let contacts = self.contacts();
        let held = law.and_then(|tau| {
            let tau = self.with_friction(&contacts, &phase, tau);
            self.held_under(&contacts, &phase, &tau)
        });
        self.evaluations.set(evaluations);
        let unknown = |_| self.size.vector_of(|_| f64::NAN);
        let (qdd, Phase { q, qd }) = (held.map_or_else(unknown, |held| held.qdd), phase);
        Taken {
            t,
            base: self.base(&q),
            q,
            qd,
            qdd,
            tau,
        }
    }

    /// Takes the samples that lie within the last step; whether there were any.
    pub(super) fn take_within<S>(
        &self,
        system: &S,
        stepper: &mut (impl Stepper<S, Cause, D> + ?Sized),
        recorder: &mut Recorder<D>,
    ) -> Result<bool, Cause> {
        let (end, mut taken) = (stepper.t(), false);
        while let Some(t) = recorder.next_sample().filter(|t| before(*t, end)) {
            recorder.push(self.sample_at(t, stepper.at(system, t)?));
            taken = true;
        }
        Ok(taken)
    }

    /// Takes the samples where the recorder is: one or none, or more where they are nearer to each other than
    /// the rounding of the time. Whether there were any.
    pub(super) fn take_here(&self, recorder: &mut Recorder<D>) -> bool {
        let (reached, phase, mut taken) = (recorder.t, recorder.phase.clone(), false);
        while let Some(t) = recorder.next_sample().filter(|t| !before(reached, *t)) {
            recorder.push(self.sample_at(t, phase.clone()));
            taken = true;
        }
        taken
    }
}

impl<D: Size> Motion<'_, D> {
    /// Goes on in a chart around the phase reached, where there are charts.
    pub(super) fn recentre<S>(
        &self,
        system: &S,
        stepper: &mut (impl Stepper<S, Cause, D> + ?Sized),
        recorder: &mut Recorder<D>,
    ) {
        if self.moves {
            stepper.recentre(system);
            // Velocities are the same in each chart.
            recorder.phase.q.clone_from(&stepper.phase().q);
        }
    }
}

fn finite<V: JointVector>(qdd: V) -> Result<V, Cause> {
    match first_non_finite(qdd.entries()) {
        Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
        None => Ok(qdd),
    }
}

impl<D: Size> Equations<D> for Motion<'_, D> {
    type Refusal = Cause;

    /// qdd, where everything on the way to it is finite.
    // One copy for all stages of all methods: inlined, a program of forward dynamics would be compiled some forty
    // times, and be no faster.
    #[inline(never)]
    fn acceleration(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, Cause> {
        let tau = self.torques_of_laws(t, phase)?;
        if self.friction.kind == Friction::Sign && !self.limits.matter() {
            return self.free(phase, &tau);
        }
        self.acceleration_under(&self.contacts(), phase, tau)
    }

    #[inline]
    fn position_rates(&self, phase: &Phase<D>) -> D::Vector {
        if self.moves {
            self.robot.rates(phase)
        } else {
            phase.qd.clone()
        }
    }

    #[inline]
    fn recentred(&self, phase: &Phase<D>) -> Option<D::Vector> {
        self.moves.then(|| self.robot.recentre(&phase.q))
    }
}

/// A motion in positions and momenta.
pub(super) struct InMomenta<'a, D: Size> {
    motion: &'a Motion<'a, D>,
    arm: &'a dyn SizedMomenta<D>,
}

impl<'a, D: Size> InMomenta<'a, D> {
    /// `None` where the arm is not known in momenta.
    pub(super) fn new(motion: &'a Motion<'a, D>) -> Option<Self> {
        let arm = motion.robot.in_momenta()?;
        Some(InMomenta { motion, arm })
    }

    /// Joints that are held have no velocity, whatever their momenta: those of the others are the
    /// momenta of the arm that is left.
    #[inline]
    fn phase_beside(
        &self,
        still: Option<&D::Each<bool>>,
        at: &Point<D>,
    ) -> Result<Phase<D>, Cause> {
        if let Some(joint) = at.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        let qd = match still {
            None => self.arm.velocity(&at.q, &at.p),
            Some(still) => self.arm.velocity_beside(still, &at.q, &at.p),
        };
        let qd = qd.map_err(|error| self.named(error, &at.q))?;
        Ok(Phase {
            q: at.q.clone(),
            qd,
        })
    }

    /// The error as the forward dynamics of the arm has it, which knows the names of the joints.
    #[cold]
    fn named(&self, error: SingularMassMatrix, q: &D::Vector) -> SingularMassMatrix {
        let rest = self.motion.size.vector();
        let phase = Phase {
            q: q.clone(),
            qd: rest.clone(),
        };
        match self.motion.robot.accelerations(&phase, &rest) {
            Err(named) if named.joint == error.joint => named,
            _ => error,
        }
    }
}

impl<D: Size> Canonical<D> for InMomenta<'_, D> {
    type Refusal = Cause;

    fn momentum(&self, phase: &Phase<D>) -> Result<D::Vector, Cause> {
        Ok(self.arm.momentum(&phase.q, &phase.qd))
    }

    fn phase(&self, at: &Point<D>) -> Result<Phase<D>, Cause> {
        let still = self.motion.still(&self.motion.contacts());
        self.phase_beside(still.as_ref(), at)
    }

    fn rate(&self, t: f64, at: &Point<D>) -> Result<Point<D>, Cause> {
        let contacts = self.motion.contacts();
        let still = self.motion.still(&contacts);
        let phase = self.phase_beside(still.as_ref(), at)?;
        let tau = self.motion.torques(&contacts, t, &phase)?;
        self.motion.count(1);
        let mut p = finite(self.arm.force(&phase.q, &phase.qd, &tau))?;
        // The forces that hold a joint act on its momentum alone, which nothing reads.
        for (i, still) in still.iter().flat_map(AsRef::as_ref).enumerate() {
            if *still {
                p[i] = 0.0;
            }
        }
        Ok(Point { q: phase.qd, p })
    }
}
