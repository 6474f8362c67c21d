//! The contacts of joints with friction and stops: those that hold, those that let go, and the margins to both.

use dynamics_runtime::Size;

use super::complementarity::{Balance, Place, balanced};
use super::error::Cause;
use super::friction::Contact;
use super::joint_set::JointSet;
use super::limits::AtLimit;
use super::motion::{Contacts, Held, Motion};
use crate::integrate::Phase;

impl<D: Size> Held<D> {
    /// The way that joint `i` goes where it is let go: against the force that holds it.
    pub(super) fn way_out(&self, i: usize) -> f64 {
        -self.forces[i].signum()
    }
}

impl<D: Size> Motion<'_, D> {
    /// The contacts of joints in a phase, as far as they hold.
    pub(super) fn classified(&self, phase: &Phase<D>) -> Contacts<D> {
        self.each(|i| {
            let moves = phase.qd[i] != 0.0;
            match self.leaning_place(i, phase) {
                Some(inwards) => Contact::Leans(inwards),
                None if !self.may_stick(i) => Contact::Slides(0.0),
                None if moves => Contact::Slides(phase.qd[i].signum()),
                None => Contact::Sticks,
            }
        })
    }

    /// The way into its range of joint `i`, where it is at rest at a stop.
    fn leaning_place(&self, i: usize, phase: &Phase<D>) -> Option<f64> {
        let rebounds = matches!(self.limits.kind, AtLimit::Rebounds { .. });
        let end = self.limits.end(i, phase.q[i])?;
        (rebounds && phase.qd[i] == 0.0).then_some(end.inwards)
    }

    /// Whether joint `i` does what its contact says: the force that holds it is possible, or it moves that way.
    fn is_balanced(
        &self,
        contacts: &Contacts<D>,
        i: usize,
        phase: &Phase<D>,
        held: &Held<D>,
    ) -> bool {
        match contacts[i] {
            Contact::Slides(_) if phase.qd[i] != 0.0 => true,
            Contact::Slides(way) => {
                let inwards = self.leaning_place(i, phase);
                inwards.unwrap_or(way) * held.qdd[i] >= 0.0
            }
            Contact::Sticks => held.forces[i].abs() <= self.breakaway(i, held.way_out(i)),
            Contact::Leans(inwards) => self.hold_of_stop(i, inwards, held) >= 0.0,
        }
    }

    /// A joint that leaves its stop.
    pub(super) fn let_in(&self, i: usize, inwards: f64) -> Contact {
        Contact::Slides(if self.may_stick(i) { inwards } else { 0.0 })
    }

    /// The force by which the stop that joint `i` leans on, and the friction there, exceed what lets it go.
    fn hold_of_stop(&self, i: usize, inwards: f64, held: &Held<D>) -> f64 {
        inwards * held.forces[i] + self.breakaway(i, inwards)
    }

    /// The margin of joint `i` to its next event. If it slides, that is the lesser of velocity and way to a limit; if
    /// it sticks, the friction left; if it leans on a stop, the force there.
    pub(super) fn margin(
        &self,
        contact: Contact,
        i: usize,
        phase: &Phase<D>,
        held: &Held<D>,
    ) -> f64 {
        let limits = &self.limits;
        let to_ends = limits.ends(i).map(|end| limits.margin(&end, phase.q[i]));
        match contact {
            Contact::Slides(0.0) => to_ends.fold(f64::INFINITY, f64::min),
            Contact::Slides(way) => to_ends.fold(way * phase.qd[i], f64::min),
            Contact::Sticks => self.breakaway(i, held.way_out(i)) - held.forces[i].abs(),
            Contact::Leans(inwards) => self.hold_of_stop(i, inwards, held),
        }
    }

    /// The least margin of all joints.
    pub(super) fn least_margin(
        &self,
        contacts: &Contacts<D>,
        phase: &Phase<D>,
        held: &Held<D>,
    ) -> f64 {
        let margin = |i| self.margin(contacts[i], i, phase, held);
        let margins = self.joints().map(margin);
        margins.fold(f64::INFINITY, f64::min)
    }
}

impl<D: Size> Motion<'_, D> {
    /// Lets go of joints that nothing holds, and that have somewhere to go; holds those at rest that would
    /// pass a stop.
    pub(super) fn settle(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Result<(Contacts<D>, Held<D>), Cause> {
        let (contacts, held) = self.balanced_contacts(contacts, t, phase)?;
        match self.driven_back(&contacts, t, phase, &held)? {
            Some(joint) => Err(Cause::Chatter { joint }),
            None => Ok((contacts, held)),
        }
    }

    /// The contacts of joints at rest, and the forces there. They stay as they are if they hold; else they are those of
    /// the one balance that there is.
    fn balanced_contacts(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Result<(Contacts<D>, Held<D>), Cause> {
        let held = self.held(contacts, t, phase)?;
        let balanced = |i| self.is_balanced(contacts, i, phase, &held);
        if self.joints().all(balanced) {
            return Ok((contacts.clone(), held));
        }
        let start = self.each(|i| match contacts[i] {
            Contact::Slides(way) if way > 0.0 => Place::Low,
            Contact::Slides(way) if way < 0.0 => Place::High,
            _ => Place::Between,
        });
        let mut before = self.classified(phase);
        for i in self.joints().filter(|i| phase.qd[*i] != 0.0) {
            before[i] = contacts[i];
        }
        let balance = self.balance_at_rest(&before, t, phase, start)?;
        let after = self.each(|i| match (before[i], balance.places[i]) {
            (contact @ Contact::Slides(_), _) | (contact, Place::Between) => contact,
            (Contact::Leans(inwards), _) => self.let_in(i, inwards),
            (Contact::Sticks, Place::Low) => Contact::Slides(1.0),
            (Contact::Sticks, Place::High) => Contact::Slides(-1.0),
        });
        let held = self.held(&after, t, phase)?;
        Ok((after, held))
    }

    /// The balance of the forces of stops and friction at the joints that lean or stick.
    ///
    /// A stop has a force inwards of any size, and dry friction at rest one either way, up to its greatest value. The
    /// search begins at `start`, or between the bounds where that one is infinite.
    pub(super) fn balance_at_rest(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        phase: &Phase<D>,
        start: D::Each<Place>,
    ) -> Result<Balance<D>, Cause> {
        let bounds = self.each(|i| {
            let [negative, positive] = [-1.0, 1.0].map(|way| self.breakaway(i, way));
            match contacts[i] {
                Contact::Slides(_) => None,
                Contact::Sticks => Some([-positive, negative]),
                Contact::Leans(inwards) if inwards > 0.0 => Some([-positive, f64::INFINITY]),
                Contact::Leans(_) => Some([f64::NEG_INFINITY, negative]),
            }
        });
        let finite_start = self.each(|i| match (bounds[i], start[i]) {
            (Some([low, _]), Place::Low) if low.is_finite() => Place::Low,
            (Some([_, high]), Place::High) if high.is_finite() => Place::High,
            _ => Place::Between,
        });
        let held = self.each(|i| contacts[i].holds());
        let tau = self.torques(contacts, t, phase)?;
        let (qdd, responses) = self.responses(phase, &tau, &held)?;
        let joints = self.joints().filter(|i| held[*i]).collect::<JointSet>();
        balanced::<D>(&qdd, &responses, &bounds, finite_start).ok_or(Cause::Impacts { joints })
    }

    /// The joint at rest that is let go one way, and driven back as soon as it moves that way: a torque law jumps
    /// between the two.
    fn driven_back(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        phase: &Phase<D>,
        held: &Held<D>,
    ) -> Result<Option<usize>, Cause> {
        let way = |i: usize| match contacts[i] {
            Contact::Slides(way) if phase.qd[i] == 0.0 => way,
            _ => 0.0,
        };
        if self.joints().all(|i| way(i) == 0.0) {
            return Ok(None);
        }
        // So slow that a law without a jump at rest has the same digits there.
        let mut moves = phase.clone();
        for i in self.joints() {
            moves.qd[i] += way(i) * f64::MIN_POSITIVE;
        }
        let after = self.held(contacts, t, &moves)?;
        let turns_back = |i: &usize| way(*i) * held.qdd[*i] >= 0.0 && way(*i) * after.qdd[*i] < 0.0;
        let back = self.joints().find(turns_back);
        Ok(back.filter(|_| self.torque.torque(t, phase) != self.torque.torque(t, &moves)))
    }

    /// The joint that would stop next, within a time in s, and chatter there. A step across that place fails by
    /// whatever is first to notice that there is no motion beyond it.
    pub(super) fn stops_and_chatters(
        &self,
        t: f64,
        phase: &Phase<D>,
        within: f64,
    ) -> Option<usize> {
        let contacts = self.contacts();
        let held = self.held(&contacts, t, phase).ok()?;
        let time_left = |i: &usize| match contacts[*i] {
            Contact::Slides(way) if way * held.qdd[*i] < 0.0 => -phase.qd[*i] / held.qdd[*i],
            _ => f64::INFINITY,
        };
        let by_time = |i: &usize, j: &usize| time_left(i).total_cmp(&time_left(j));
        let next = self.joints().min_by(by_time)?;
        if time_left(&next) > within {
            return None;
        }
        let (mut stopped, mut then) = (phase.clone(), contacts.clone());
        stopped.qd[next] = 0.0;
        then[next] = Contact::Sticks;
        match self.settle(&then, t, &stopped) {
            Err(Cause::Chatter { joint }) => Some(joint),
            _ => None,
        }
    }
}
