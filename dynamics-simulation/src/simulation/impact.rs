//! Impacts of joints on the stops at the ends of their ranges.
//!
//! An impact changes velocities at once: M (qd+ - qd-) = P, with an impulse P at the joints that hit a
//! stop. By Newton's law of restitution a joint i that hits alone comes back with -e qd_i-, so that
//!
//! `qd+ = qd- - (1 + e) M^-1 e_i qd_i- / (M^-1)_ii`,
//!
//! and the other joints change theirs through M^-1. Where several joints hit or lean on their stops, no
//! stop pulls and none is passed (J. J. Moreau, *Unilateral contact and dry friction in finite freedom
//! dynamics*, 1988): with velocities v and impulses p counted inwards,
//!
//! `0 <= p`, `v+ + e v- >= 0`, and for each joint one of the two is zero.
//!
//! With one e for all of them the energy changes by (1 - e) p.v- / 2, which is never positive, and zero for
//! e = 1.
//!
//! Bounces that die out are infinitely many in a finite time. They end where no position would tell them from
//! rest: with restitution 0, and for all joints at their stops together. One joint that is set to rest alone throws off
//! those that lean, which come back and throw it off in turn, for ever. Joints are set to rest that would fall back from
//! a rise below the resolution (`resting`). Impulses of either sign take their velocities, and no other joint passes its
//! stop. The result is the nearest to the velocities before, as measured by the kinetic energy, of all velocities with
//! `v = 0` for these joints and `v >= 0` for others at their stops. They form a cone, so that the energy does not rise.

use dynamics_runtime::{JointMatrix as _, JointVector as _, Size};

use super::complementarity::{Place, balanced};
use super::error::Cause;
use super::joint_set::JointSet;
use super::limits::{AtLimit, End};
use super::motion::{Contacts, Motion};
use crate::integrate::Phase;

/// Impacts of joints on their stops, and their result.
#[derive(Clone, Debug)]
pub(super) struct Impact<D: Size> {
    /// The phase after it.
    pub(super) after: Phase<D>,
    /// The contacts behind it.
    pub(super) contacts: Contacts<D>,
    /// The joints that hit.
    pub(super) joints: JointSet,
}

impl<D: Size> Motion<'_, D> {
    /// Begins a motion: joints that hit a stop are thrown back, and joints at rest stick or lean on a stop, if they are
    /// held. Returns the phase after that.
    pub(super) fn settle_at_start(&self, phase: &Phase<D>) -> Result<Phase<D>, Cause> {
        // The first sample is taken under the last contacts that there are, also if a law refuses.
        self.go_on_under(self.classified(phase));
        let impact = self.thrown_back(&self.contacts(), 0.0, phase)?;
        let after = impact.map_or_else(|| phase.clone(), |impact| impact.after);
        self.go_on_under(self.classified(&after));
        let (contacts, _) = self.settle(&self.contacts(), 0.0, &after)?;
        self.go_on_under(contacts);
        Ok(after)
    }

    /// The impacts of all joints that hit their stops; `None` where none does.
    ///
    /// The impact of one joint may drive another back into its stop: impacts follow each other until none is left. The
    /// contacts of the motion are those after them.
    pub(super) fn thrown_back(
        &self,
        contacts: &Contacts<D>,
        t: f64,
        before: &Phase<D>,
    ) -> Result<Option<Impact<D>>, Cause> {
        let AtLimit::Rebounds { restitution } = self.limits.kind else {
            return Ok(None);
        };
        let ends: Ends<D> = self.each(|i| self.limits.end(i, before.q[i]));
        if self.joints().all(|i| !hits::<D>(&ends, &before.qd, i)) {
            return Ok(None);
        }
        let mut phase = before.clone();
        for i in self.joints() {
            // Joints that move inwards are on their way already.
            if let Some(end) = ends[i].filter(|end| end.inwards * phase.qd[i] <= 0.0) {
                phase.q[i] = end.at;
            }
        }
        let tau = self.torques(contacts, t, &phase)?;
        let at_end = self.each(|i| ends[i].is_some());
        let (_, responses) = self.responses(&phase, &tau, &at_end)?;
        let mut joints = JointSet::default();
        let rebound = rebounds::<D>(phase.qd, &ends, &responses, restitution, &mut joints);
        phase.qd = rebound.ok_or(Cause::Impacts { joints })?;
        let after = self.at_rest(t, phase, &ends, &responses)?;
        let after = after.ok_or(Cause::Impacts { joints })?;
        Ok(Some(Impact {
            contacts: self.classified(&after),
            after,
            joints,
        }))
    }

    /// The phase in which joints that bounce no more are at rest, those at their stops together.
    fn at_rest(
        &self,
        t: f64,
        mut phase: Phase<D>,
        ends: &Ends<D>,
        responses: &D::Matrix,
    ) -> Result<Option<Phase<D>>, Cause> {
        loop {
            let rest = self.resting(t, &phase, ends, responses)?;
            for i in self.joints().filter(|i| rest[*i]) {
                phase.q[i] = ends[i].map_or(phase.q[i], |end| end.at);
            }
            // Joints at rest stay so: each time there are more of them.
            if self.joints().all(|i| !rest[i] || phase.qd[i] == 0.0) {
                return Ok(Some(phase));
            }
            let wanted = self.each(|i| {
                let least = Wanted::least(ends[i]?.inwards, 0.0);
                Some(if rest[i] { Wanted::REST } else { least })
            });
            match after::<D>(&phase.qd, &wanted, responses) {
                Some(qd) => phase.qd = qd,
                None => return Ok(None),
            }
        }
    }

    /// The joints at their stops that are at rest, or move inwards so slowly that they are set to rest.
    ///
    /// With all of them at rest, the stop and dry friction hold joint i with a force f_i, and it alone would fall back
    /// with the acceleration f_i / m ([`inertia`](super::complementarity::Balance::inertia)) from a rise of
    /// `v^2 m / (2 f_i)`. The joint of the greatest energy v^2 / W_ii that rises by more, or that nothing holds, is left
    /// out, and the others are asked again.
    fn resting(
        &self,
        t: f64,
        phase: &Phase<D>,
        ends: &Ends<D>,
        responses: &D::Matrix,
    ) -> Result<D::Each<bool>, Cause> {
        let mut rest = self.each(|i| ends[i].is_some());
        while self.joints().any(|i| rest[i] && phase.qd[i] != 0.0) {
            let mut still = phase.clone();
            for i in self.joints().filter(|i| rest[*i]) {
                still.qd[i] = 0.0;
                still.q[i] = ends[i].map_or(phase.q[i], |end| end.at);
            }
            let (contacts, start) = (self.classified(&still), self.each(|_| Place::Between));
            let balance = self.balance_at_rest(&contacts, t, &still, start)?;
            let rises = |i: usize| {
                let Some(end) = ends[i].filter(|_| balance.places[i] == Place::Between) else {
                    return true;
                };
                let hold = end.inwards * balance.forces[i] + self.breakaway(i, end.inwards);
                let mass = balance.inertia(i);
                let coarse = self.coarse.get() * (1.0 + end.at.abs());
                let least = self.limits.least_rise(&end, hold / mass).max(coarse);
                0.5 * mass * phase.qd[i].powi(2) > hold * least
            };
            let energy = |i: &usize| phase.qd[*i].powi(2) / responses[(*i, *i)];
            let moving = |i: &usize| rest[*i] && phase.qd[*i] != 0.0 && rises(*i);
            let by_energy = |i: &usize, j: &usize| energy(i).total_cmp(&energy(j));
            match self.joints().filter(moving).max_by(by_energy) {
                Some(i) => rest[i] = false,
                None => break,
            }
        }
        Ok(rest)
    }
}

/// The ends of their ranges where joints are.
type Ends<D> = <D as Size>::Each<Option<End>>;

fn hits<D: Size>(ends: &Ends<D>, qd: &D::Vector, i: usize) -> bool {
    ends[i].is_some_and(|end| end.inwards * qd[i] < 0.0)
}

/// The velocities after the impacts that follow each other at one time. `joints` gets those that hit.
fn rebounds<D: Size>(
    mut qd: D::Vector,
    ends: &Ends<D>,
    responses: &D::Matrix,
    restitution: f64,
    joints: &mut JointSet,
) -> Option<D::Vector> {
    let (mut impacts, size) = (0, D::of(&qd));
    while size.joints().any(|i| hits::<D>(ends, &qd, i)) {
        joints.extend(size.joints().filter(|i| hits::<D>(ends, &qd, *i)));
        if impacts == 2 * MOST_IMPACTS {
            return None;
        }
        // Without restitution one impact is the last, except for rounding.
        let is_elastic = impacts < MOST_IMPACTS;
        let e = if is_elastic { restitution } else { 0.0 };
        let wanted = size.each(|i| {
            let end = ends[i]?;
            let rebound = -e * end.inwards * qd[i];
            // Without the sign of a zero.
            let wanted = Wanted::least(end.inwards, rebound + 0.0);
            (rebound >= 0.0 || e == 0.0).then_some(wanted)
        });
        qd = after::<D>(&qd, &wanted, responses)?;
        impacts += 1;
    }
    Some(qd)
}

/// The most impacts at one time that are made with restitution, and without.
const MOST_IMPACTS: usize = 10_000;

/// The demand of an impact on a joint at a stop.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wanted {
    /// The velocity after it, or the least one inwards.
    velocity: f64,
    /// The bounds of the impulse.
    bounds: [f64; 2],
}

impl Wanted {
    /// At least a velocity inwards, with an impulse inwards, where `inwards` is the way into the range, 1 or -1.
    fn least(inwards: f64, velocity: f64) -> Self {
        let bounds = if inwards > 0.0 {
            [0.0, f64::INFINITY]
        } else {
            [f64::NEG_INFINITY, 0.0]
        };
        Wanted {
            velocity: inwards * velocity,
            bounds,
        }
    }

    /// No velocity, with any impulse.
    const REST: Wanted = Wanted {
        velocity: 0.0,
        bounds: [f64::NEG_INFINITY, f64::INFINITY],
    };

    /// The place where the search for the impulse begins: at none, if none is possible.
    fn start(&self) -> Place {
        match self.bounds {
            [0.0, _] => Place::Low,
            [_, 0.0] => Place::High,
            _ => Place::Between,
        }
    }
}

/// The velocities after impulses that let each of the joints at a stop have at least its wanted velocity,
/// where `responses` holds their columns of M^-1. `None` where rounding keeps them from being found.
fn after<D: Size>(
    qd: &D::Vector,
    wanted: &D::Each<Option<Wanted>>,
    responses: &D::Matrix,
) -> Option<D::Vector> {
    let size = D::of(qd);
    let missing = size.vector_of(|i| qd[i] - wanted[i].map_or(0.0, |at| at.velocity));
    let start = size.each(|i| wanted[i].map_or(Place::Low, |at| at.start()));
    let bounds = size.each(|i| wanted[i].map(|at| at.bounds));
    let balance = balanced::<D>(&missing, responses, &bounds, start)?;
    let changed = qd.plus(1.0, &responses.times(&balance.forces));
    Some(size.vector_of(|i| match (wanted[i], balance.places[i]) {
        (None, _) => changed[i],
        // Without the rounding of the velocities that are known.
        (Some(at), Place::Between) => at.velocity,
        (Some(at), Place::Low) => changed[i].max(at.velocity),
        (Some(at), Place::High) => changed[i].min(at.velocity),
    }))
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, Matrix3, Vector3};

    use super::{Wanted, after};

    /// The inverse mass matrix of an arm, symmetric and positive definite.
    const INVERSE: Matrix3<f64> = Matrix3::new(2.0, -1.5, 0.3, -1.5, 3.0, -0.4, 0.3, -0.4, 1.0);

    fn lower(velocity: f64) -> Option<Wanted> {
        Some(Wanted::least(1.0, velocity))
    }

    fn energy(qd: &Vector3<f64>) -> f64 {
        0.5 * qd.dot(&(INVERSE.try_inverse().unwrap() * qd))
    }

    #[test]
    fn one_joint_hits_by_the_formula() {
        let qd = Vector3::new(-2.0, 0.5, 1.0);
        let e = 0.7;
        let found = after::<Const<3>>(&qd, &[lower(2.0 * e), None, None], &INVERSE).unwrap();
        let column: Vector3<f64> = INVERSE.column(0).into();
        let expected = qd - column * ((1.0 + e) * qd[0] / INVERSE[(0, 0)]);
        assert!((found - expected).amax() < 1e-15, "{found}");
    }

    /// The blow on joint 1 pushes joint 2 into its stop, which holds it; and the other way about lets it go.
    #[test]
    fn a_joint_that_leans_on_its_stop_feels_the_blow() {
        let qd = Vector3::new(-2.0, 0.0, 1.0);
        let held = after::<Const<3>>(&qd, &[lower(1.0), lower(0.0), None], &INVERSE).unwrap();
        assert_eq!((held[0], held[1]), (1.0, 0.0));
        let upper = Some(Wanted::least(-1.0, 0.0));
        let leaves = after::<Const<3>>(&qd, &[lower(1.0), upper, None], &INVERSE).unwrap();
        assert!(leaves[0] == 1.0 && leaves[1] < -1.0, "{leaves}");
    }

    #[test]
    fn elastic_impacts_keep_the_energy_and_others_lose_some() {
        for k in 0..200 {
            let at = |i: usize| (f64::from(k) * 1.7 + i as f64 * 2.3).sin() - 0.6;
            let qd = Vector3::from_fn(|i, _| at(i));
            for e in [0.0, 0.4, 1.0] {
                let wanted = [0, 1, 2].map(|i| lower(-e * qd[i]).filter(|_| qd[i] <= 0.0));
                let found = after::<Const<3>>(&qd, &wanted, &INVERSE).unwrap();
                let change = energy(&found) - energy(&qd);
                match e {
                    1.0 => assert!(change.abs() < 1e-14, "{k}: {change:e}"),
                    _ => assert!(change < 1e-15, "{k}: {change:e}"),
                }
                let within = |i: usize| wanted[i].is_none_or(|at| found[i] >= at.velocity);
                assert!((0..3).all(within), "{k}: {found}");
            }
        }
    }
}
