//! An arm as its couplings move it, and the energies of its base parameters.

use crate::derive::base::geometry::{Geometry, geometry};
use crate::derive::base::observe::{Energies, rotate_moments, unit_energies};
use crate::derive::place;
use crate::derive::rows::Moved;
use crate::derive::symbols::Symbols;
use crate::exact::{SplitMix64, circle_point, common_angles};
use crate::expr::{Expr, Fingerprint};
use crate::linear::{Matrix3, Ring, Vector3};
use crate::mechanism::Mechanism;
use crate::robot::{Grouping, Parameter};
use crate::spatial::{AxisMotion, Joint, Motion, Turn};

/// An arm and its base parameters without couplings.
pub(super) struct Arm<R> {
    geometry: Geometry<R>,
    gravity: Vector3<R>,
    links: Vec<Link<R>>,
    pub(super) columns: Vec<(usize, Parameter)>,
    /// How many joints move by themselves, and how many angles they and their followers have in common.
    pub(super) joints: usize,
    pub(super) angles: usize,
}

struct Link<R> {
    /// From the link's axes to those in which its first moments are written, where these are others.
    moments: Option<Matrix3<R>>,
    moved: Option<Moved<R>>,
    /// If the joint turns: of which of the angles that joints have in common its angle is the sum, and how often.
    angles: Vec<(usize, i64)>,
}

impl<'g> Arm<Expr<'g>> {
    pub(super) fn of(
        symbols: &mut Symbols<'g>,
        grouping: &Grouping,
        columns: Vec<(usize, Parameter)>,
    ) -> Self {
        let arm = symbols.arm();
        let geometry = geometry(symbols, arm);
        let moved = (0..arm.joints.len()).map(|i| Moved::of(symbols, arm, i));
        let moved: Vec<_> = moved.collect();
        let (count, angles) = number_angles(arm, &moved);
        let parts = moved.into_iter().zip(angles).zip(&grouping.links);
        let links = parts.enumerate().map(|(i, ((moved, angles), link))| Link {
            moments: geometry.rotation_of_moments(i, link.axes),
            moved,
            angles,
        });
        let links = links.collect();
        Arm {
            geometry,
            gravity: place::gravity(symbols, arm),
            links,
            columns,
            joints: arm.dof(),
            angles: count,
        }
    }

    /// The arm at the graph's random point.
    pub(super) fn values(&self) -> Arm<Fingerprint> {
        let value = |x: Expr<'g>| x.fingerprint();
        let links = self.links.iter().map(|link| Link {
            moments: link
                .moments
                .as_ref()
                .map(|rotation| Matrix3(rotation.0.map(|row| row.map(value)))),
            moved: link.moved.map(|moved| moved.map(value)),
            angles: link.angles.clone(),
        });
        Arm {
            geometry: self.geometry.map(value),
            gravity: Vector3(self.gravity.0.map(value)),
            links: links.collect(),
            columns: self.columns.clone(),
            joints: self.joints,
            angles: self.angles,
        }
    }
}

/// How many angles the joints that turn have in common, and of which of them, and how often, the angle of each joint
/// is the sum.
fn number_angles(
    arm: &Mechanism,
    moved: &[Option<Moved<Expr<'_>>>],
) -> (usize, Vec<Vec<(usize, i64)>>) {
    let mut count = 0;
    let mut angles = vec![Vec::new(); moved.len()];
    for free in 0..arm.dof() {
        let turns = |i: usize| arm.joints[i].axis_motion == AxisMotion::Turns;
        let by_free = |(i, moved): (usize, &Option<Moved<Expr<'_>>>)| {
            let moved = moved
                .as_ref()
                .filter(|moved| moved.joint == free && turns(i))?;
            Some((i, moved.factor.fingerprint()))
        };
        let turning: Vec<_> = moved.iter().enumerate().filter_map(by_free).collect();
        let factors: Vec<_> = turning.iter().map(|(_, factor)| *factor).collect();
        let common = common_angles(&factors);
        let own = common.first().map_or(0, Vec::len);
        for ((i, _), multiples) in turning.iter().zip(common) {
            let all = (count..).zip(multiples);
            angles[*i] = all.filter(|(_, multiple)| *multiple != 0).collect();
        }
        count += own;
    }
    (count, angles)
}

/// A state of an arm.
pub(super) struct State<R> {
    /// The angles that joints have in common.
    pub(super) angles: Vec<Turn<R>>,
    pub(super) q: Vec<R>,
    pub(super) qd: Vec<R>,
}

impl State<Fingerprint> {
    pub(super) fn random(arm: &Arm<Fingerprint>, random: &mut SplitMix64) -> Self {
        let angles = (0..arm.angles).map(|_| Turn::from(circle_point(random)));
        let angles = angles.collect();
        let mut numbers = || {
            (0..arm.joints)
                .map(|_| Fingerprint::random(random))
                .collect()
        };
        State {
            angles,
            q: numbers(),
            qd: numbers(),
        }
    }
}

impl<R: Ring> Arm<R> {
    /// 2 T and U of a unit of each base parameter.
    pub(super) fn energies(&self, state: &State<R>) -> [Vec<R>; 2] {
        let zero = self.geometry.zero;
        let base = (Motion::splat(zero), self.gravity, zero);
        let mut of_links = Vec::with_capacity(self.links.len());
        let tree = &self.geometry.tree;
        tree.outward(base, |i, &(motion, g, above)| {
            let (link, joint) = (&self.links[i], self.joint(i, state));
            let above = above + g.dot(joint.position());
            let g = joint.enter(g);
            let moved = link.moved;
            let qd = moved.map_or(zero, |m| m.factor * state.qd[m.joint]);
            let motion = motion.enter(&joint).with_joint(joint.axis_motion, qd);
            let Energies {
                mut kinetic,
                mut potential,
            } = unit_energies(motion, qd, g, above, zero);
            rotate_moments(&mut kinetic, link.moments.as_ref());
            rotate_moments(&mut potential, link.moments.as_ref());
            of_links.push([kinetic, potential]);
            (motion, g, above)
        });
        let pick = |kind: usize| {
            let columns = self.columns.iter();
            columns
                .map(|&(i, parameter)| of_links[i][kind][parameter.index()])
                .collect()
        };
        [pick(0), pick(1)]
    }

    fn joint(&self, i: usize, state: &State<R>) -> Joint<R> {
        let still = self.geometry.joint(i);
        let link = &self.links[i];
        let Some(moved) = &link.moved else {
            return still;
        };
        match still.axis_motion {
            AxisMotion::Turns => {
                let angles = link.angles.iter();
                let turns = angles.map(|&(angle, n)| self.times(state.angles[angle], n));
                let turned = turns.reduce(Turn::plus);
                Joint {
                    turn: turned.map_or(moved.turn, |turned| moved.turn.plus(turned)),
                    ..still
                }
            }
            AxisMotion::Slides => Joint {
                slide: moved.factor * state.q[moved.joint] + moved.offset,
                ..still
            },
        }
    }

    /// A turn several times, or backwards.
    fn times(&self, turn: Turn<R>, n: i64) -> Turn<R> {
        let mut power = Turn::none(self.geometry.zero, self.geometry.one);
        for bit in (0..64 - n.unsigned_abs().leading_zeros()).rev() {
            power = power.plus(power);
            if n.unsigned_abs() >> bit & 1 == 1 {
                power = power.plus(turn);
            }
        }
        if n < 0 {
            power.s = -power.s;
        }
        power
    }
}

/// a - b
pub(super) fn less<R: Ring>(a: Vec<R>, b: &[R]) -> Vec<R> {
    a.into_iter().zip(b).map(|(a, &b)| a - b).collect()
}
