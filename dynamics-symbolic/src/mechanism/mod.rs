//! The mechanism that a table or a file describes: joints that stand on links, and the links that they move.
//!
//! Rows of both conventions, mounts of files, locked joints and couplings are read into it (`read`). The derivations
//! know nothing else of an arm. The proof reads the table by itself.

mod aligned;
mod base;
mod forces;
mod groups;
mod read;
mod walk;

pub(crate) use aligned::Aligned;
pub(crate) use base::BaseRate;
pub(crate) use forces::Forces;
pub(crate) use walk::Tree;

use crate::function::Freedoms;
use crate::robot::{Body, Coupling, Neglected, Placement, Value};
use crate::spatial::AxisMotion;

/// A robot as the derivations know it. Joints and the links that they move are counted from the base outwards.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// How many symbolic parameters there are.
    pub(crate) fields: usize,
    /// Acceleration of gravity in the axes of the world.
    pub(crate) gravity: [Value; 3],
    /// Frame 0 in the world, where they are not the same.
    pub(crate) base: Option<Placement>,
    /// The joints, each with the link that it moves.
    pub(crate) joints: Vec<Joint>,
    /// Which link carries which joint.
    pub(crate) tree: Tree,
    /// The tip. If there is none, it is frame 0 here, and nothing that concerns a tip is proven.
    pub(crate) tip: Frame,
    /// The named frames.
    pub(crate) frames: Vec<Frame>,
    /// Bodies that are fixed to links: the tool at the tip, and the bodies of frames.
    pub(crate) fixed_bodies: Vec<FixedBody>,
    /// The base inertial parameters that are left out of the Lagrangian.
    pub(crate) neglected: Option<Neglected>,
}

/// A frame that is fixed to a link, or to the base.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    /// The link; `None` for the base.
    pub(crate) link: Option<usize>,
    /// In the frame of that link, or in frame 0: each placement in the one before it.
    pub(crate) places: Vec<Placement>,
}

/// A body that is fixed to a link.
#[derive(Clone, Debug)]
pub(crate) struct FixedBody {
    pub(crate) link: usize,
    /// In the frame of that link, each placement in the one before it.
    pub(crate) places: Vec<Placement>,
    pub(crate) body: Body,
}

/// A joint and the link that it moves.
///
/// The joint's own frame has its z axis on the joint's axis. In the joint's frame of the link that carries it, or in frame 0,
/// it is at `before` Rz(turn) Tz(d), and a position of the joint turns it about z or slides it along z.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) axis_motion: AxisMotion,
    /// The constant place of the axis in the joint's frame of the link that carries it, each placement in the one
    /// before it.
    pub(crate) before: Vec<Placement>,
    /// The constant angle about the axis, as the sum of these: each has a sine of its own. The offset of an angle that
    /// follows another is among them.
    pub(crate) turn: Vec<Value>,
    /// The constant step along the axis.
    pub(crate) d: Value,
    /// The same between frames that recursions are short in.
    pub(crate) aligned: Aligned,
    /// The point of the axis to which Jacobians refer.
    pub(crate) origin: Origin,
    /// How the joint moves.
    pub(crate) law: Law,
    /// Where the link frame is in the joint's frame, each placement in the one before it.
    pub(crate) link_frame: Vec<Placement>,
    /// The body of the link, in the link frame.
    pub(crate) body: Body,
    /// Friction, motor and spring: none at a joint that stands still.
    pub(crate) forces: Forces,
    /// The range of positions, where it is known.
    pub(crate) limits: Option<[Value; 2]>,
}

/// Where the origin of a joint's frame is on the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// After the offset d: at the common normal with the next axis.
    AfterOffset,
    /// Before the offset d: at the common normal with the previous axis.
    BeforeOffset,
}

/// How a joint moves.
#[derive(Clone, Debug)]
pub(crate) enum Law {
    /// By itself: the joint of that number among those that do.
    Free { number: usize },
    /// It is one of the six that carry a base that moves: it stands at zero and has a velocity, an acceleration and a force of
    /// that number. See `base`.
    Base { number: usize },
    /// It stands still at a position: its link is a part of the link before.
    Standing { at: Value },
    /// q = factor * q of another joint + offset. The number of its symbols comes after those of all free joints.
    Following { number: usize, coupling: Coupling },
}

impl Frame {
    /// The link and the places.
    pub(crate) fn place(&self) -> (Option<usize>, &[Placement]) {
        (self.link, &self.places)
    }
}

impl Mechanism {
    /// The frame of this place among the named ones, or the tip.
    pub(crate) fn frame(&self, named: Option<usize>) -> &Frame {
        named.map_or(&self.tip, |named| &self.frames[named])
    }

    /// The number of degrees of freedom.
    pub(crate) fn dof(&self) -> usize {
        self.free().count()
    }

    /// The degrees of freedom of the base, and those of the joints.
    pub(crate) fn freedoms(&self) -> Freedoms {
        let base = self
            .joints
            .iter()
            .filter(|joint| joint.is_of_base())
            .count();
        let joints = self.dof() - base;
        Freedoms { base, joints }
    }

    /// The joints that move by themselves.
    pub(crate) fn free(&self) -> impl Iterator<Item = usize> {
        let is_free = |&i: &usize| self.joints[i].is_free();
        (0..self.joints.len()).filter(is_free)
    }

    /// The most joints that move by themselves among those that carry one link: of a serial arm all.
    pub(crate) fn most_in_line(&self) -> usize {
        let is_free = |i: &usize| self.joints[*i].is_free();
        let in_line = |tip| self.tree.carriers(tip).filter(is_free).count();
        self.tree.tips().map(in_line).max().unwrap_or(0)
    }

    /// For every joint that moves by itself whether its row of M has no entry of a joint behind it: of a coupled
    /// arm that is the last one's, else that of each joint which carries no other one that moves.
    pub(crate) fn outermost(&self) -> Vec<bool> {
        let free: Vec<_> = self.free().collect();
        let is_coupled = self.is_coupled();
        let is_carried = |k: usize, i: usize| self.tree.carriers(k).skip(1).any(|j| j == i);
        let is_outermost = |(number, &i): (usize, &usize)| {
            let mut behind = free[number + 1..].iter();
            !behind.any(|&k| is_coupled || is_carried(k, i))
        };
        free.iter().enumerate().map(is_outermost).collect()
    }

    /// The joints that follow others.
    pub(crate) fn following(&self) -> impl Iterator<Item = usize> {
        let follows = |&i: &usize| matches!(self.joints[i].law, Law::Following { .. });
        (0..self.joints.len()).filter(follows)
    }

    /// Whether a joint follows another one.
    pub(crate) fn is_coupled(&self) -> bool {
        self.following().next().is_some()
    }

    /// Whether link i is a part of the base: all joints that carry it stand still.
    pub(crate) fn is_of_base(&self, i: usize) -> bool {
        self.tree.carriers(i).all(|i| self.joints[i].stands())
    }

    /// The number of the free joint by which joint i moves, and how it follows that one, if it does; `None` if it
    /// stands still.
    pub(crate) fn moved_by(&self, i: usize) -> Option<(usize, Option<&Coupling>)> {
        match &self.joints[i].law {
            Law::Free { number } | Law::Base { number } => Some((*number, None)),
            Law::Standing { .. } => None,
            Law::Following { coupling, .. } => {
                let (number, _) = self.moved_by(coupling.leader)?;
                Some((number, Some(coupling)))
            }
        }
    }

    /// The arm in which joints that follow others move by themselves, over the ranges in which they follow. It must be
    /// known in numbers.
    ///
    /// M of the coupled arm is S' M S of that one. The columns of S are independent, so that it is positive definite
    /// where that one is.
    pub(crate) fn uncoupled(&self) -> Mechanism {
        let mut free = self.clone();
        let moving = free.joints.iter_mut().filter(|joint| !joint.stands());
        for (number, joint) in moving.enumerate() {
            if joint.is_of_base() {
                continue;
            }
            if let Law::Following { coupling, .. } = &joint.law {
                let leader = self.joints[coupling.leader].range(&[]);
                joint.limits = Some(joint.range_of_follower(coupling, leader));
            }
            joint.law = Law::Free { number };
        }
        free
    }

    /// The joint behind the index of a [`Symbol`](crate::robot::Symbol).
    pub(crate) fn joint_of_symbol(&self, index: usize) -> &Joint {
        let mut joints = self.free().chain(self.following());
        &self.joints[joints.nth(index).expect("symbols are those of joints")]
    }

    /// Positions or velocities of the free joints, then those of the followers by their factors alone, in the
    /// order of the indices of [`Symbol`](crate::robot::Symbol); `fields` are the parameters' values.
    pub fn with_followers(&self, of_free: &[f64], fields: &[f64]) -> Vec<f64> {
        let followers = self.following().filter_map(|i| {
            let (number, coupling) = self.moved_by(i)?;
            Some(coupling?.factor.to_f64(fields) * of_free[number])
        });
        of_free.iter().copied().chain(followers).collect()
    }
}

impl Joint {
    pub(crate) fn stands(&self) -> bool {
        matches!(self.law, Law::Standing { .. })
    }

    /// Whether its velocity is one of the robot's own.
    fn is_free(&self) -> bool {
        matches!(self.law, Law::Free { .. } | Law::Base { .. })
    }

    /// Whether it carries a base that moves.
    pub(crate) fn is_of_base(&self) -> bool {
        matches!(self.law, Law::Base { .. })
    }

    /// Whether there is a motor: its reflected inertia is then a parameter of the arm, even where it is zero.
    pub(crate) fn has_motor(&self) -> bool {
        !self.forces.gear_ratio.is_zero()
    }

    /// The positions of a follower, less the offset that a joint that turns has among its constant turns.
    fn range_of_follower(&self, coupling: &Coupling, leader: [f64; 2]) -> [Value; 2] {
        let [first, last] = leader.map(|end| {
            let end = Value::from_f64(end).unwrap_or(Value::zero());
            let moved = coupling.factor.clone() * end;
            match self.axis_motion {
                AxisMotion::Turns => moved,
                AxisMotion::Slides => moved + coupling.offset.clone(),
            }
        });
        if coupling.factor.is_negative() {
            [last, first]
        } else {
            [first, last]
        }
    }

    /// The range over which the joint is sampled: revolute joints without limits turn once around, prismatic ones
    /// slide by a metre either way.
    pub(crate) fn range(&self, fields: &[f64]) -> [f64; 2] {
        match (&self.limits, self.axis_motion) {
            (Some(limits), _) => limits.each_ref().map(|limit| limit.to_f64(fields)),
            (None, AxisMotion::Turns) => [-core::f64::consts::PI, core::f64::consts::PI],
            (None, AxisMotion::Slides) => [-1.0, 1.0],
        }
    }
}
