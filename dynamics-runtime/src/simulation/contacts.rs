//! What friction does to each joint: what it holds, what it lets go, and how far that is away.

use super::error::Cause;
use super::friction::Contact;
use super::motion::{Held, Motion};
use super::torque::TorqueLaw;
use crate::ForwardDynamics;
use crate::integrate::Phase;

/// Sets what friction does to each joint at the start: those at rest stick, if it holds them.
pub(super) fn settle_at_start<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    phase: &Phase<N>,
) -> Result<(), Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let dry = motion.dry();
    motion.set_contacts(core::array::from_fn(|i| {
        if dry[i].is_none() {
            Contact::Slides(0.0)
        } else if phase.qd[i] == 0.0 {
            Contact::Sticks
        } else {
            Contact::Slides(phase.qd[i].signum())
        }
    }));
    settle(motion, 0.0, phase).map(drop)
}

/// Lets go of joints that friction cannot hold, and that have somewhere to go.
pub(super) fn settle<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    t: f64,
    phase: &Phase<N>,
) -> Result<Held<N>, Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let held = let_go(motion, t, phase)?;
    match driven_back(motion, t, phase, &held)? {
        Some(joint) => Err(Cause::Chatter { joint }),
        None => Ok(held),
    }
}

/// Lets go of joints that friction cannot hold, the one that it holds least first.
fn let_go<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    t: f64,
    phase: &Phase<N>,
) -> Result<Held<N>, Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    loop {
        let held = motion.held(t, phase)?;
        let mut contacts = motion.contacts();
        let excess = |i: usize| match held.forces[i].abs() {
            // Nothing to hold, of a joint that has no friction that way either.
            0.0 => 0.0,
            force => force / breakaway(motion, i, &held),
        };
        let stuck = (0..N).filter(|i| contacts[*i] == Contact::Sticks);
        let worst = stuck.max_by(|i, j| excess(*i).total_cmp(&excess(*j)));
        match worst {
            Some(i) if excess(i) > 1.0 => {
                contacts[i] = Contact::Slides(way_out(&held, i));
                motion.set_contacts(contacts);
            }
            _ => return Ok(held),
        }
    }
}

/// The way that joint `i` goes where it is let go: against the force that holds it.
pub(super) fn way_out<const N: usize>(held: &Held<N>, i: usize) -> f64 {
    -held.forces[i].signum()
}

/// How great a force friction holds against, at joint `i` at rest.
fn breakaway<R, L, const N: usize>(motion: &Motion<R, L, N>, i: usize, held: &Held<N>) -> f64 {
    motion.dry()[i].breakaway(way_out(held, i))
}

/// How far joint `i` is from its next event: the velocity of one that slides, the friction left of
/// one that sticks.
pub(super) fn margin<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    i: usize,
    phase: &Phase<N>,
    held: &Held<N>,
) -> f64 {
    match motion.contacts()[i] {
        Contact::Slides(0.0) => f64::INFINITY,
        Contact::Slides(way) => way * phase.qd[i],
        Contact::Sticks => breakaway(motion, i, held) - held.forces[i].abs(),
    }
}

pub(super) fn least_margin<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    phase: &Phase<N>,
    held: &Held<N>,
) -> f64 {
    let margins = (0..N).map(|i| margin(motion, i, phase, held));
    margins.fold(f64::INFINITY, f64::min)
}

/// The joint at rest that is let go one way, and driven back as soon as it moves that way, by a
/// torque law that jumps between the two: it neither stays nor goes.
fn driven_back<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    t: f64,
    phase: &Phase<N>,
    held: &Held<N>,
) -> Result<Option<usize>, Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let contacts = motion.contacts();
    let way = |i: usize| match contacts[i] {
        Contact::Slides(way) if phase.qd[i] == 0.0 => way,
        _ => 0.0,
    };
    if (0..N).all(|i| way(i) == 0.0) {
        return Ok(None);
    }
    // So slow that a law without a jump at rest has the same digits there.
    let mut moves = *phase;
    for i in 0..N {
        moves.qd[i] += way(i) * f64::MIN_POSITIVE;
    }
    let after = motion.held(t, &moves)?;
    let back = (0..N).find(|i| way(*i) * held.qdd[*i] >= 0.0 && way(*i) * after.qdd[*i] < 0.0);
    Ok(back.filter(|_| motion.law(t, phase) != motion.law(t, &moves)))
}

/// The joint that would stop next, and chatter there. A step across that place fails by whatever is
/// first to notice that there is no motion beyond it.
pub(super) fn stops_and_chatters<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    t: f64,
    phase: &Phase<N>,
    within: f64,
) -> Option<usize>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let held = motion.held(t, phase).ok()?;
    let contacts = motion.contacts();
    let time_left = |i: usize| match contacts[i] {
        Contact::Slides(way) if way * held.qdd[i] < 0.0 => -phase.qd[i] / held.qdd[i],
        _ => f64::INFINITY,
    };
    let next = (0..N).min_by(|i, j| time_left(*i).total_cmp(&time_left(*j)))?;
    if time_left(next) > within {
        return None;
    }
    let mut stopped = *phase;
    stopped.qd[next] = 0.0;
    let mut then = contacts;
    then[next] = Contact::Sticks;
    motion.set_contacts(then);
    let settled = settle(motion, t, &stopped);
    motion.set_contacts(contacts);
    match settled {
        Err(Cause::Chatter { joint }) => Some(joint),
        _ => None,
    }
}
