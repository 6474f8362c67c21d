//! What friction and stops do to each joint: what they hold, what they let go, and how far that is away.

use super::complementarity::{Balance, Place, balanced};
use super::error::{Cause, JointSet};
use super::friction::Contact;
use super::limits::AtLimit;
use super::motion::{Held, Motion};
use super::torque::TorqueLaw;
use crate::integrate::Phase;
use crate::simulation::EquationsOfMotion;
use crate::size::Size;

/// What friction and stops do to joints in a phase, as far as they hold.
pub(super) fn classified<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    phase: &Phase<D>,
) -> D::Each<Contact> {
    motion.each(|i| {
        let moves = phase.qd[i] != 0.0;
        match leaning_place(motion, i, phase) {
            Some(inwards) => Contact::Leans(inwards),
            None if !motion.may_stick(i) => Contact::Slides(0.0),
            None if moves => Contact::Slides(phase.qd[i].signum()),
            None => Contact::Sticks,
        }
    })
}

/// The way into its range of joint `i`, where it is at rest at a stop.
fn leaning_place<R, L, D: Size>(
    motion: &Motion<R, L, D>,
    i: usize,
    phase: &Phase<D>,
) -> Option<f64> {
    let rebounds = matches!(motion.limits().kind, AtLimit::Rebounds { .. });
    let end = motion.limits().end(i, phase.q[i])?;
    (rebounds && phase.qd[i] == 0.0).then_some(end.inwards)
}

/// Lets go of joints that nothing holds, and that have somewhere to go; holds those at rest that would
/// pass a stop.
pub(super) fn settle<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    t: f64,
    phase: &Phase<D>,
) -> Result<Held<D>, Cause> {
    let held = balance(motion, t, phase)?;
    match driven_back(motion, t, phase, &held)? {
        Some(joint) => Err(Cause::Chatter { joint }),
        None => Ok(held),
    }
}

/// The contacts of joints at rest, and the forces there. They stay as they are if they hold; else they are those of
/// the one balance that there is.
fn balance<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    t: f64,
    phase: &Phase<D>,
) -> Result<Held<D>, Cause> {
    let held = motion.held(t, phase)?;
    let contacts = motion.contacts();
    if motion
        .joints()
        .all(|i| is_balanced(motion, i, phase, &held))
    {
        return Ok(held);
    }
    let start = motion.each(|i| match contacts[i] {
        Contact::Slides(way) if way > 0.0 => Place::Low,
        Contact::Slides(way) if way < 0.0 => Place::High,
        _ => Place::Between,
    });
    let at_rest = classified(motion, phase);
    let before = motion.each(|i| {
        if phase.qd[i] == 0.0 {
            at_rest[i]
        } else {
            contacts[i]
        }
    });
    motion.set_contacts(before.clone());
    let balance = balance_at_rest(motion, t, phase, start)?;
    motion.set_contacts(motion.each(|i| match (before[i], balance.places[i]) {
        (contact @ Contact::Slides(_), _) | (contact, Place::Between) => contact,
        (Contact::Leans(inwards), _) => let_in(motion, i, inwards),
        (Contact::Sticks, Place::Low) => Contact::Slides(1.0),
        (Contact::Sticks, Place::High) => Contact::Slides(-1.0),
    }));
    motion.held(t, phase)
}

/// Whether joint `i` does what its contact says: the force that holds it is possible, or it moves that way.
fn is_balanced<R, L, D: Size>(
    motion: &Motion<R, L, D>,
    i: usize,
    phase: &Phase<D>,
    held: &Held<D>,
) -> bool {
    match motion.contact(i) {
        Contact::Leans(inwards) => hold_of_stop(motion, i, inwards, held) >= 0.0,
        Contact::Sticks => held.forces[i].abs() <= motion.breakaway(i, way_out(held, i)),
        Contact::Slides(_) if phase.qd[i] != 0.0 => true,
        Contact::Slides(way) => {
            let way = leaning_place(motion, i, phase).unwrap_or(way);
            way * held.qdd[i] >= 0.0
        }
    }
}

/// The balance of the forces of stops and friction at the joints that lean or stick.
///
/// A stop has a force inwards of any size, and dry friction at rest one either way, up to its greatest value. The search
/// begins at `start`, or between the bounds where that one is infinite.
pub(super) fn balance_at_rest<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    t: f64,
    phase: &Phase<D>,
    start: D::Each<Place>,
) -> Result<Balance<D>, Cause> {
    let contacts = motion.contacts();
    let bounds = motion.each(|i| {
        let [negative, positive] = [-1.0, 1.0].map(|way| motion.breakaway(i, way));
        match contacts[i] {
            Contact::Slides(_) => None,
            Contact::Sticks => Some([-positive, negative]),
            Contact::Leans(inwards) if inwards > 0.0 => Some([-positive, f64::INFINITY]),
            Contact::Leans(_) => Some([f64::NEG_INFINITY, negative]),
        }
    });
    let start = motion.each(|i| match (bounds[i], start[i]) {
        (Some([low, _]), Place::Low) if low.is_finite() => Place::Low,
        (Some([_, high]), Place::High) if high.is_finite() => Place::High,
        _ => Place::Between,
    });
    let held = motion.each(|i| contacts[i].holds());
    let (qdd, responses) = motion.responses(phase, &motion.torques(t, phase)?, &held)?;
    let joints = motion.joints().filter(|i| held[*i]).collect::<JointSet>();
    balanced::<D>(&qdd, &responses, &bounds, start).ok_or(Cause::Impacts { joints })
}

/// A joint that leaves its stop.
pub(super) fn let_in<R, L, D: Size>(motion: &Motion<R, L, D>, i: usize, inwards: f64) -> Contact {
    Contact::Slides(if motion.may_stick(i) { inwards } else { 0.0 })
}

/// How much the force of the stop that joint `i` leans on, and the friction there, are beyond what lets it
/// go.
fn hold_of_stop<R, L, D: Size>(
    motion: &Motion<R, L, D>,
    i: usize,
    inwards: f64,
    held: &Held<D>,
) -> f64 {
    inwards * held.forces[i] + motion.breakaway(i, inwards)
}

/// The way that joint `i` goes where it is let go: against the force that holds it.
pub(super) fn way_out<D: Size>(held: &Held<D>, i: usize) -> f64 {
    -held.forces[i].signum()
}

/// How far joint `i` is from its next event: the velocity of one that slides, and its way to a limit; the
/// friction left of one that sticks; the force on the stop of one that leans on it.
pub(super) fn margin<R, L, D: Size>(
    motion: &Motion<R, L, D>,
    i: usize,
    phase: &Phase<D>,
    held: &Held<D>,
) -> f64 {
    let limits = motion.limits();
    let to_ends = limits.ends(i).map(|end| limits.margin(&end, phase.q[i]));
    match motion.contact(i) {
        Contact::Slides(0.0) => to_ends.fold(f64::INFINITY, f64::min),
        Contact::Slides(way) => to_ends.fold(way * phase.qd[i], f64::min),
        Contact::Sticks => motion.breakaway(i, way_out(held, i)) - held.forces[i].abs(),
        Contact::Leans(inwards) => hold_of_stop(motion, i, inwards, held),
    }
}

pub(super) fn least_margin<R, L, D: Size>(
    motion: &Motion<R, L, D>,
    phase: &Phase<D>,
    held: &Held<D>,
) -> f64 {
    let margins = motion.joints().map(|i| margin(motion, i, phase, held));
    margins.fold(f64::INFINITY, f64::min)
}

/// The joint at rest that is let go one way, and driven back as soon as it moves that way, by a
/// torque law that jumps between the two: it neither stays nor goes.
fn driven_back<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    t: f64,
    phase: &Phase<D>,
    held: &Held<D>,
) -> Result<Option<usize>, Cause> {
    let contacts = motion.contacts();
    let way = |i: usize| match contacts[i] {
        Contact::Slides(way) if phase.qd[i] == 0.0 => way,
        _ => 0.0,
    };
    if motion.joints().all(|i| way(i) == 0.0) {
        return Ok(None);
    }
    // So slow that a law without a jump at rest has the same digits there.
    let mut moves = phase.clone();
    for i in motion.joints() {
        moves.qd[i] += way(i) * f64::MIN_POSITIVE;
    }
    let after = motion.held(t, &moves)?;
    let back = motion
        .joints()
        .find(|i| way(*i) * held.qdd[*i] >= 0.0 && way(*i) * after.qdd[*i] < 0.0);
    Ok(back.filter(|_| motion.law(t, phase) != motion.law(t, &moves)))
}

/// The joint that would stop next, and chatter there. A step across that place fails by whatever is
/// first to notice that there is no motion beyond it.
pub(super) fn stops_and_chatters<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    t: f64,
    phase: &Phase<D>,
    within: f64,
) -> Option<usize> {
    let held = motion.held(t, phase).ok()?;
    let contacts = motion.contacts();
    let time_left = |i: usize| match contacts[i] {
        Contact::Slides(way) if way * held.qdd[i] < 0.0 => -phase.qd[i] / held.qdd[i],
        _ => f64::INFINITY,
    };
    let next = motion
        .joints()
        .min_by(|i, j| time_left(*i).total_cmp(&time_left(*j)))?;
    if time_left(next) > within {
        return None;
    }
    let mut stopped = phase.clone();
    stopped.qd[next] = 0.0;
    let mut then = contacts.clone();
    then[next] = Contact::Sticks;
    motion.set_contacts(then);
    let settled = settle(motion, t, &stopped);
    motion.set_contacts(contacts);
    match settled {
        Err(Cause::Chatter { joint }) => Some(joint),
        _ => None,
    }
}
