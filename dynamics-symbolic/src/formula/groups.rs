//! Groups of joints with parallel axes.

use super::atom::Run;
use crate::mechanism::{Law, Mechanism};
use crate::robot::{Angle, Value};
use crate::spatial::AxisMotion;

/// Revolute joints with parallel axes, group by group: each carries the next one, with prismatic joints between them
/// or none. Where joints on one link would go on with the same group, the first of them does.
pub(super) struct Groups(Vec<Vec<Member>>);

/// A joint of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Member {
    /// The joint, counted from 0.
    pub(super) joint: usize,
    /// Whether its axis points the other way than that of the first joint.
    pub(super) is_reversed: bool,
}

/// A group, as a link knows it whose z axis is parallel to the axes of the group.
#[derive(Clone, Copy)]
struct Parallel {
    group: usize,
    /// How many joints of the group carry the link.
    carriers: usize,
    is_reversed: bool,
}

impl Groups {
    /// The groups of an arm.
    pub(super) fn new(arm: &Mechanism) -> Self {
        let mut groups: Vec<Vec<Member>> = Vec::new();
        arm.tree.outward(None, |i, before: &Option<Parallel>| {
            let joint = &arm.joints[i];
            let turns = joint.aligned.before.iter();
            let across = turns.flat_map(|placement| &placement.rpy[..2]);
            let parallel = across.fold(*before, |parallel, angle| follow(angle, parallel?));
            match joint.law {
                Law::Free { number } if joint.axis_motion == AxisMotion::Turns => {
                    let is_last = |of: &Parallel| of.carriers == groups[of.group].len();
                    let mut parallel = parallel.filter(is_last).unwrap_or(Parallel {
                        group: groups.len(),
                        carriers: 0,
                        is_reversed: false,
                    });
                    if parallel.group == groups.len() {
                        groups.push(Vec::new());
                    }
                    parallel.carriers += 1;
                    groups[parallel.group].push(Member {
                        joint: number,
                        is_reversed: parallel.is_reversed,
                    });
                    Some(parallel)
                }
                Law::Following { .. } | Law::Base { .. } => None,
                Law::Free { .. } | Law::Standing { .. } => parallel,
            }
        });
        Groups(groups)
    }

    /// The joints of each group, with the group's index.
    pub(super) fn members_of_all(&self) -> impl Iterator<Item = (usize, &Vec<Member>)> {
        self.0.iter().enumerate()
    }

    /// The run of one revolute joint; `None` of one that follows another.
    pub(super) fn run_of(&self, joint: usize) -> Option<Run> {
        let mut groups = self.0.iter().enumerate();
        groups.find_map(|(group, members)| {
            let first = members.iter().position(|member| member.joint == joint)?;
            let last = first;
            Some(Run { group, first, last })
        })
    }

    /// The joints of a run, with whether they are subtracted.
    pub(super) fn members(&self, run: Run) -> impl Iterator<Item = Member> {
        let members = &self.0[run.group][run.first..=run.last];
        let first = members[0].is_reversed;
        members.iter().map(move |member| Member {
            joint: member.joint,
            is_reversed: member.is_reversed != first,
        })
    }
}

/// Passes over a turn across an axis: axes on both sides of it are parallel where it is 0 or half a turn.
fn follow(alpha: &Value, parallel: Parallel) -> Option<Parallel> {
    let angle = Angle::new(alpha);
    match (angle.rest, angle.quarter_turns) {
        (None, 0) => Some(parallel),
        (None, 2) => Some(Parallel {
            is_reversed: !parallel.is_reversed,
            ..parallel
        }),
        _ => None,
    }
}
