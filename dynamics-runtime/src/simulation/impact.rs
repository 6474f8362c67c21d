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

use nalgebra::{SMatrix, SVector};

use super::error::Cause;
use super::limits::{AtLimit, End};
use super::motion::Motion;
use super::torque::TorqueLaw;
use crate::EquationsOfMotion;
use crate::integrate::{Lu, Phase};

/// The phase after the impacts of all joints that hit their stops; `None` where none does.
///
/// A joint that leaves its stop may be driven back into it by the impact of another one: impacts follow
/// each other until none is left.
pub(super) fn thrown_back<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    t: f64,
    before: &Phase<N>,
) -> Result<Option<Phase<N>>, Cause>
where
    R: EquationsOfMotion<N>,
    L: TorqueLaw<N>,
{
    let AtLimit::Rebounds { restitution } = motion.limits().kind else {
        return Ok(None);
    };
    let ends: [Option<End>; N] = core::array::from_fn(|i| motion.limits().end(i, before.q[i]));
    let inwards = |phase: &Phase<N>, i: usize| ends[i].map(|end| end.inwards * phase.qd[i]);
    let hits = |phase: &Phase<N>| (0..N).find(|i| inwards(phase, *i).is_some_and(|v| v < 0.0));
    let Some(mut joint) = hits(before) else {
        return Ok(None);
    };
    let mut phase = *before;
    for i in 0..N {
        // Those that move inwards are on their way already.
        if let Some(end) = ends[i].filter(|end| end.inwards * phase.qd[i] <= 0.0) {
            phase.q[i] = end.at;
        }
    }
    let at_ends = ends.map(|end| end.is_some());
    let tau = motion.torques(t, &phase)?;
    let (qdd, responses) = motion.responses(&phase, &tau, &at_ends)?;
    for _ in 0..MOST_IMPACTS {
        let wanted = core::array::from_fn(|i| {
            let end = ends[i]?;
            let v = end.inwards * phase.qd[i];
            let velocity = rebound(&end, -restitution * v, end.inwards * qdd[i]);
            let inwards = end.inwards;
            (v <= 0.0).then_some(Wanted { inwards, velocity })
        });
        let after = after(&phase.qd, &wanted, &responses);
        phase.qd = after.ok_or(Cause::Chatter { joint })?;
        match hits(&phase) {
            Some(next) => joint = next,
            None => return Ok(Some(phase)),
        }
    }
    Err(Cause::Chatter { joint })
}

/// Impacts that follow each other at one time are as many as that in no arm that was tried.
const MOST_IMPACTS: usize = 10_000;

/// The velocity of a rebound under an acceleration, both counted inwards: none where the joint would rise
/// by less than what tells its position from that of the stop. So bounces that die out come to an end, and
/// the joint leans on its stop.
fn rebound(end: &End, velocity: f64, acceleration: f64) -> f64 {
    let falls = -acceleration > 0.0;
    match falls && 0.5 * velocity * velocity <= -acceleration * end.resolution() {
        true => 0.0,
        // Without the sign of a zero.
        false => velocity + 0.0,
    }
}

/// What an impact asks of a joint at a stop.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wanted {
    /// The way into the range, 1 or -1.
    inwards: f64,
    /// The least velocity after it, inwards.
    velocity: f64,
}

/// The velocities after impulses that let each of the joints at a stop have at least its wanted velocity,
/// where `responses` holds their columns of M^-1.
///
/// Which joints feel an impulse is a linear complementarity problem with a positive definite matrix, which
/// has one solution: pivots of least index find it (K. G. Murty, *Note on a Bard-type scheme for solving
/// the complementarity problem*, Opsearch 11 (1974)). `None` where rounding keeps it from ending.
fn after<const N: usize>(
    qd: &SVector<f64, N>,
    wanted: &[Option<Wanted>; N],
    responses: &SMatrix<f64, N, N>,
) -> Option<SVector<f64, N>> {
    let mut pushed = [false; N];
    for _ in 0..MOST_PIVOTS {
        let impulses = impulses(qd, wanted, responses, &pushed);
        let after = qd + responses * impulses;
        let wrong = (0..N).find(|i| match wanted[*i] {
            None => false,
            Some(at) if pushed[*i] => at.inwards * impulses[*i] < 0.0,
            Some(at) => at.inwards * after[*i] < at.velocity,
        });
        match wrong {
            Some(i) => pushed[i] = !pushed[i],
            None => return Some(exactly(after, wanted, &pushed)),
        }
    }
    None
}

/// Pivots of 16 joints at their stops at worst.
const MOST_PIVOTS: usize = 1 << 16;

/// The impulses that give those who are pushed their wanted velocity.
fn impulses<const N: usize>(
    qd: &SVector<f64, N>,
    wanted: &[Option<Wanted>; N],
    responses: &SMatrix<f64, N, N>,
    pushed: &[bool; N],
) -> SVector<f64, N> {
    // The rows and columns of the other joints are those of the unit matrix.
    let mut matrix = SMatrix::<f64, N, N>::identity();
    let mut change = SVector::zeros();
    for i in (0..N).filter(|i| pushed[*i]) {
        for j in (0..N).filter(|j| pushed[*j]) {
            matrix[(i, j)] = responses[(i, j)];
        }
        change[i] = wanted[i].map_or(0.0, |at| at.inwards * at.velocity - qd[i]);
    }
    Lu::new(matrix).solve(change)
}

/// Without the rounding of the velocities that are known.
fn exactly<const N: usize>(
    mut after: SVector<f64, N>,
    wanted: &[Option<Wanted>; N],
    pushed: &[bool; N],
) -> SVector<f64, N> {
    for i in 0..N {
        if let Some(at) = wanted[i].filter(|_| pushed[i]) {
            after[i] = at.inwards * at.velocity;
        }
    }
    after
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::{Wanted, after};

    /// Of an arm, symmetric and positive definite.
    const INVERSE: Matrix3<f64> = Matrix3::new(2.0, -1.5, 0.3, -1.5, 3.0, -0.4, 0.3, -0.4, 1.0);

    fn lower(velocity: f64) -> Option<Wanted> {
        let inwards = 1.0;
        Some(Wanted { inwards, velocity })
    }

    fn energy(qd: &Vector3<f64>) -> f64 {
        0.5 * qd.dot(&(INVERSE.try_inverse().unwrap() * qd))
    }

    #[test]
    fn one_joint_hits_by_the_formula() {
        let qd = Vector3::new(-2.0, 0.5, 1.0);
        let e = 0.7;
        let found = after(&qd, &[lower(2.0 * e), None, None], &INVERSE).unwrap();
        let column: Vector3<f64> = INVERSE.column(0).into();
        let expected = qd - column * ((1.0 + e) * qd[0] / INVERSE[(0, 0)]);
        assert!((found - expected).amax() < 1e-15, "{found}");
    }

    /// The blow on joint 1 pushes joint 2 into its stop, which holds it; and the other way about lets it go.
    #[test]
    fn a_joint_that_leans_on_its_stop_feels_the_blow() {
        let qd = Vector3::new(-2.0, 0.0, 1.0);
        let held = after(&qd, &[lower(1.0), lower(0.0), None], &INVERSE).unwrap();
        assert_eq!((held[0], held[1]), (1.0, 0.0));
        let upper = Some(Wanted {
            inwards: -1.0,
            velocity: 0.0,
        });
        let leaves = after(&qd, &[lower(1.0), upper, None], &INVERSE).unwrap();
        assert!(leaves[0] == 1.0 && leaves[1] < -1.0, "{leaves}");
    }

    #[test]
    fn elastic_impacts_keep_the_energy_and_others_lose_some() {
        for k in 0..200 {
            let at = |i: usize| (f64::from(k) * 1.7 + i as f64 * 2.3).sin() - 0.6;
            let qd = Vector3::from_fn(|i, _| at(i));
            for e in [0.0, 0.4, 1.0] {
                let wanted = [0, 1, 2].map(|i| lower(-e * qd[i]).filter(|_| qd[i] <= 0.0));
                let found = after(&qd, &wanted, &INVERSE).unwrap();
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
