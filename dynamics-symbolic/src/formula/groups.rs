//! Groups of joints with parallel axes.

use super::atom::Run;
use crate::mechanism::{Law, Mechanism};
use crate::robot::{Angle, JointType, Value};

/// Revolute joints with parallel axes, group by group: joints that follow each other, with prismatic
/// joints between them or none.
pub(super) struct Groups(Vec<Vec<Member>>);

/// A joint of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Member {
    /// The joint, counted from 0.
    pub(super) joint: usize,
    /// Whether its axis points the other way than that of the first joint.
    pub(super) is_reversed: bool,
}

impl Groups {
    /// The groups of an arm.
    pub(super) fn new(arm: &Mechanism) -> Self {
        let mut groups: Vec<Vec<Member>> = Vec::new();
        let mut is_parallel = false;
        let mut is_reversed = false;
        for joint in &arm.joints {
            for placement in &joint.aligned.before {
                let [roll, pitch, _] = &placement.rpy;
                for angle in [roll, pitch] {
                    follow(angle, &mut is_parallel, &mut is_reversed);
                }
            }
            match joint.law {
                Law::Free { number } if joint.joint_type == JointType::Revolute => {
                    if !is_parallel {
                        groups.push(Vec::new());
                        is_reversed = false;
                    }
                    is_parallel = true;
                    let group = groups.last_mut().expect("one was begun");
                    group.push(Member {
                        joint: number,
                        is_reversed,
                    });
                }
                Law::Following { .. } => is_parallel = false,
                Law::Free { .. } | Law::Standing { .. } => {}
            }
        }
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
fn follow(alpha: &Value, is_parallel: &mut bool, is_reversed: &mut bool) {
    let angle = Angle::new(alpha);
    match (angle.rest, angle.quarter_turns) {
        (None, 0) => {}
        (None, 2) => *is_reversed = !*is_reversed,
        _ => *is_parallel = false,
    }
}
