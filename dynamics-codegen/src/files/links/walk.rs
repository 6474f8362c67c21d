//! The way outwards: each link where it is, and a row for each joint of the tree that moves.

use std::rc::Rc;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{JointType, Mount, Placement, Value};

use super::assembly::{Assembly, Moved, body};
use super::tree::{Inertial, Joint, Kind, Number};
use crate::description::{Body, Coulomb, Expr, Frame, Friction, Given, Link, Name, Row};
use crate::geometry::{Mass, Transform, number};
use crate::limits::MOST_PLACES;
use crate::mistake::{links as mistake, size};
use crate::place::Place;

/// A link on the way outwards.
struct Spot<'a> {
    link: &'a str,
    /// The number of its frame, where it has been reached.
    index: usize,
    /// The row whose link carries it.
    row: Option<usize>,
    /// Where it is in the frame of that link, each place in the one before it.
    places: Vec<Placement>,
    /// The same as one.
    frame: Transform,
}

impl<'a> Spot<'a> {
    /// A link that is a row's own, or the first one.
    fn new(link: &'a str, row: Option<usize>) -> Self {
        let (places, frame) = (Vec::new(), Transform::identity());
        Spot {
            link,
            index: 0,
            row,
            places,
            frame,
        }
    }

    /// A link that is fixed to this one.
    fn then(&self, link: &'a str, steps: Vec<Placement>) -> Option<Self> {
        let mut frame = self.frame.clone();
        for step in &steps {
            let [x, y, z] = step.xyz.each_ref().map(number);
            frame = frame.then(&Transform::new(&[x?, y?, z?], &step.rpy)?);
        }
        let places = [self.places.clone(), steps].concat();
        Some(Spot {
            link,
            index: 0,
            row: self.row,
            places,
            frame,
        })
    }
}

impl<'a> Assembly<'a> {
    /// Goes from the first link outwards, depth first and from a link to its children in the order of their joints.
    pub(super) fn walk(&mut self) {
        let mut open = self.arrive(Spot::new(self.first, None));
        let mut places = 0;
        while let Some((joint, spot)) = open.pop() {
            let tree = self.tree;
            let Some(next) = self.cross(&tree.joints[joint], &spot) else {
                continue;
            };
            self.ends.remove(&spot.index);
            places += next.places.len();
            if places > MOST_PLACES {
                self.error(Place::START, size::places());
                return;
            }
            open.extend(self.arrive(next));
        }
    }

    /// Takes the body and the frame of a link. Returns its joints, the first one last.
    fn arrive(&mut self, mut spot: Spot<'a>) -> Vec<(usize, Rc<Spot<'a>>)> {
        let link = self.link(spot.link);
        let inertial = link.and_then(|link| link.inertial.as_ref());
        let body = self.body_of(&spot, inertial);
        spot.index = self.frames.len();
        self.ends.insert(spot.index);
        let frame = Frame {
            name: link.map(|link| Name::new(spot.link, link.place)),
            on: Given::As(Link::Row(spot.row)),
            places: spot.places.clone(),
            is_link: true,
            body,
            ..Frame::default()
        };
        self.frames.push((spot.row, frame));
        let joints = self.outward.get(spot.link).into_iter().flatten();
        let spot = Rc::new(spot);
        joints.rev().map(|&joint| (joint, spot.clone())).collect()
    }

    /// Takes the body of a link to those that it moves with, unless it stands by itself: that is returned.
    fn body_of(&mut self, spot: &Spot<'a>, inertial: Option<&Inertial>) -> Body {
        let body_in = |frame: &Transform| {
            let mass = |inertial: &Inertial| {
                Mass::new(
                    &inertial.mass,
                    &inertial.tensor,
                    &frame.then(&inertial.frame),
                )
            };
            inertial.map(mass)
        };
        let is_apart = |name: &Name| name.plain() == spot.link;
        if self.request.links.iter().any(is_apart) {
            self.carry(spot.row, &Mass::none());
            return body(body_in(&Transform::identity()), self.place_of(spot.link));
        }
        if let Some(inertial) = inertial {
            let carrier = spot.row.map(|row| self.moved[row].joint.name.as_str());
            self.judge(inertial, carrier);
        }
        if let Some(mass) = body_in(&spot.frame) {
            self.carry(spot.row, &mass);
        }
        Body::default()
    }

    /// Adds a body to those that move with a row, or with a base that moves.
    fn carry(&mut self, row: Option<usize>, mass: &Mass) {
        let carried = match row {
            Some(row) => &mut self.moved[row].carried,
            None if self.request.base.is_some() => &mut self.base,
            None => return,
        };
        carried.get_or_insert_with(Mass::none).add(mass);
    }

    /// The link behind a joint, unless the joint is left out.
    fn cross(&mut self, joint: &'a Joint, spot: &Spot<'a>) -> Option<Spot<'a>> {
        let is_on_tree = self.is_on_tree(joint);
        if self.is_ignored(joint) {
            if !is_on_tree {
                return None;
            }
            self.error(joint.place, mistake::ignored_on_chain(&joint.name));
        }
        if joint.child == self.first {
            self.report_circle(joint);
            return None;
        }
        let mut steps = vec![joint.origin.clone()];
        match joint.kind {
            Kind::Fixed => {}
            Kind::Other(kind) => {
                self.report_unsupported(joint, kind);
                if !is_on_tree {
                    return None;
                }
            }
            Kind::Moves(joint_type) if is_on_tree => {
                let places = [spot.places.clone(), steps].concat();
                let row = row(joint, joint_type, places);
                return Some(self.row_of(joint, spot.row, row));
            }
            Kind::Moves(_) => steps.extend(self.displacement(joint)?),
        }
        spot.then(&joint.child, steps)
    }

    /// Adds the row of a joint. Returns its link.
    fn row_of(&mut self, joint: &'a Joint, parent: Option<usize>, row: Row) -> Spot<'a> {
        self.follow(joint);
        let number = self.moved.len();
        let on = if parent == number.checked_sub(1) {
            Given::Absent
        } else {
            Given::As(Link::Row(parent))
        };
        self.moved.push(Moved {
            joint,
            parent,
            is_locked: self.stands_still(joint),
            row: Row { on, ..row },
            place: self.place_of(&joint.child),
            carried: None,
        });
        Spot::new(&joint.child, Some(number))
    }

    /// Reports a joint that is neither fixed nor moves along one axis, and how the tree is read without it.
    fn report_unsupported(&self, joint: &'a Joint, kind: &str) {
        let behind = self.carried(&joint.child, |_| true);
        let is_behind = |link: &str| {
            let inward = self.inward.get(link);
            link == joint.child || inward.is_some_and(|joint| behind.contains(joint))
        };
        let moves = |joint: &usize| self.tree.joints[*joint].moves();
        let is_robot = self.is_on_tree(joint) && behind.iter().any(moves);
        let tips = self.tips().iter().map(Name::plain);
        let tips = tips.filter(|tip| *tip != joint.child && is_behind(tip));
        let links = is_robot.then(|| [joint.child.as_str()].into_iter().chain(tips).collect());
        let is_beside = |other: &usize| !behind.contains(other) && moves(other);
        let is_needed = self.is_on_tree(joint)
            && !(self.tips().is_empty() && self.on_tree.iter().any(is_beside));
        let links: Vec<&str> = links.unwrap_or_default();
        let mistake = mistake::unsupported(&joint.name, kind, &links, is_needed);
        self.error(joint.place, mistake);
    }
}

/// The row of a joint that moves.
fn row(joint: &Joint, joint_type: JointType, places: Vec<Placement>) -> Row {
    let known = |x: &Rational, place| Expr::known(Value::Rational(x.clone()), place);
    let number = |(x, place): &Number| Given::As(known(x, *place));
    let given = |x: &Option<Number>| x.as_ref().map_or(Given::Absent, number);
    let coulomb = joint.coulomb.as_ref();
    let friction = Friction {
        viscous: given(&joint.viscous),
        coulomb: coulomb.map_or(Given::Absent, |x| Given::As(Coulomb::Both(number(x)))),
        ..Friction::default()
    };
    let limits = joint.limits.as_ref();
    Row {
        name: Some(Name::new(&joint.name, joint.place)),
        joint_type: Some(joint_type),
        places,
        friction: Given::As(friction),
        limits: limits.map_or(Given::Absent, |(limits, place)| {
            Given::As(limits.each_ref().map(|x| Some(known(x, *place))))
        }),
        limits_of_file: true,
        torque_limit: given(&joint.effort),
        velocity_limit: given(&joint.velocity),
        mount: Some(Mount {
            axis: joint.axis.clone(),
            tip: None,
        }),
        ..Row::default()
    }
}
