//! The joints between two links, and the bodies that they move.

use std::collections::BTreeMap;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType, Mount, Placement, Value};

use super::document::{Inertial, Joint, Kind, Link, Tree};
use crate::description::{
    Allow, Coulomb, Entry, Expr, ExprKind, Friction, Given, Inertia, Joints, Name, Operator, Part,
    Positioned, Row,
};
use crate::diagnose::Diagnostics;
use crate::files::Request;
use crate::geometry::{Mass, Transform, number, tidy};
use crate::mistake::{Mistake, urdf as mistake};
use crate::place::Place;
use crate::validate::refusal;
use crate::words;

/// The rows of the chain between two links, and how their joints move.
pub(super) fn entries<'a>(
    tree: &'a Tree,
    ends: &'a [Name; 2],
    request: &'a Request,
    used: &'a mut Vec<String>,
    diagnostics: &'a Diagnostics,
) -> Option<Vec<Entry>> {
    let mut chain = Chain {
        tree,
        request,
        used,
        diagnostics,
        inward: BTreeMap::new(),
        outward: BTreeMap::new(),
        on_chain: Vec::new(),
        coupled: Vec::new(),
        locked: Vec::new(),
        moving: Vec::new(),
    };
    chain.index();
    chain.report_names();
    chain.find(ends)?;
    if !chain.moves() {
        let [first, last] = ends;
        chain.error(last, mistake::nothing_moves(first.plain(), last.plain()));
        return None;
    }
    let joints = chain.rows(&ends[0]);
    // What is wrong with the rest of the rows is said beside links without inertia.
    let is_readable = diagnostics.is_empty();
    chain.report_without_inertia();
    let start = Place::File { line: 1, column: 1 };
    let mut entries = vec![
        Entry::Convention(Some(Convention::Modified)),
        Entry::Joints(start, Some(joints)),
    ];
    if !chain.locked.is_empty() {
        entries.push(Entry::Lock(Some(chain.locked)));
    }
    if !chain.coupled.is_empty() {
        entries.push(Entry::Couple(Some(chain.coupled)));
    }
    is_readable.then_some(entries)
}

pub(super) struct Chain<'a> {
    pub(super) tree: &'a Tree,
    pub(super) request: &'a Request,
    /// Locked joints that are not on the chain.
    pub(super) used: &'a mut Vec<String>,
    diagnostics: &'a Diagnostics,
    /// The joint whose child a link is.
    inward: BTreeMap<&'a str, usize>,
    /// The joints whose parent a link is.
    outward: BTreeMap<&'a str, Vec<usize>>,
    /// The joints of the chain, from the base outwards.
    pub(super) on_chain: Vec<usize>,
    /// The joints of the chain that follow others of it.
    pub(super) coupled: Vec<Positioned>,
    /// The joints of the chain that follow joints which stand still beside it.
    pub(super) locked: Vec<Positioned>,
    /// The joints of the chain that move, with what moves with each.
    moving: Vec<Moving<'a>>,
}

/// The word for all joints beside the chain that are not named. Where a joint has this name it is that joint.
const REST: &str = "rest";

/// A joint of the chain that moves.
struct Moving<'a> {
    joint: &'a Joint,
    /// Where its link is.
    place: Place,
    /// Whether the inertia is known of its link or of something that is fixed to it.
    is_known: bool,
}

/// A body and whether anything was said about it.
struct Gathered {
    mass: Mass,
    is_known: bool,
    place: Place,
}

impl<'a> Chain<'a> {
    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) {
        self.diagnostics.error(at, mistake);
    }

    fn index(&mut self) {
        for (index, joint) in self.tree.joints.iter().enumerate() {
            if self.inward.insert(&joint.child, index).is_some() {
                self.error(joint.place, mistake::two_parents(&joint.child));
            }
            self.outward.entry(&joint.parent).or_default().push(index);
        }
    }

    /// Names in `ignore` that no joint has, and `rest` in both lists.
    fn report_names(&mut self) {
        let known: Vec<&str> = self.tree.joints.iter().map(|j| j.name.as_str()).collect();
        if let Some((name, position)) = self.rest_locked() {
            self.used.push(REST.to_owned());
            if position.is_none() {
                self.error(name, mistake::rest_with_names());
            }
            if self.is_rest_ignored() {
                self.error(name, mistake::rest_twice());
            }
        }
        for name in &self.request.ignore {
            if !known.contains(&name.plain()) && name.plain() != REST {
                let meant = words::nearest(name.plain(), &known);
                let mistake = crate::mistake::unknown("joint", name.plain(), meant, &known);
                self.error(name, mistake);
            }
        }
    }

    fn link(&self, name: &str) -> Option<&'a Link> {
        self.tree.links.iter().find(|link| link.name == name)
    }

    /// Finds the joints between the two links.
    fn find(&mut self, [first, last]: &[Name; 2]) -> Option<()> {
        let known: Vec<&str> = self
            .tree
            .links
            .iter()
            .map(|link| link.name.as_str())
            .collect();
        let mut good = true;
        for end in [first, last] {
            if !known.contains(&end.plain()) {
                let meant = words::nearest(end.plain(), &known);
                self.error(
                    end,
                    crate::mistake::unknown("link", end.plain(), meant, &known),
                );
                good = false;
            }
        }
        if !good {
            return None;
        }
        let mut link = last.plain();
        while link != first.plain() {
            let joint = self.inward.get(link).copied();
            // More joints than there are lead around a circle.
            let is_circle = self.on_chain.len() > self.tree.joints.len();
            let Some(joint) = joint.filter(|_| !is_circle) else {
                let mistake = mistake::no_path(first.plain(), last.plain(), link);
                self.error(last, mistake);
                return None;
            };
            self.on_chain.push(joint);
            link = &self.tree.joints[joint].parent;
        }
        self.on_chain.reverse();
        Some(())
    }

    /// Whether a joint is left out, by its name or as one of the rest.
    fn is_ignored(&self, joint: &'a Joint) -> bool {
        let is_of_rest = || {
            let moves = joint.kind != Kind::Fixed && self.is_rest_ignored();
            moves && !self.is_on_chain(joint) && !self.stands_still(joint)
        };
        self.is_ignored_by_name(joint) || is_of_rest()
    }

    pub(super) fn is_ignored_by_name(&self, joint: &Joint) -> bool {
        let mut ignored = self.request.ignore.iter();
        ignored.any(|name| name.plain() == joint.name)
    }

    fn is_rest_ignored(&self) -> bool {
        let mut ignored = self.request.ignore.iter();
        ignored.any(|name| name.plain() == REST) && self.named(REST).is_none()
    }

    /// Where the joints beside the chain stand still that are not named.
    pub(super) fn rest_locked(&self) -> Option<&'a (Name, Option<Value>)> {
        let mut locked = self.request.lock.iter();
        let rest = locked.find(|(name, _)| name.plain() == REST);
        rest.filter(|_| self.named(REST).is_none())
    }

    /// Whether a joint of the chain is none that is fixed.
    fn moves(&self) -> bool {
        let mut joints = self.on_chain.iter().map(|joint| &self.tree.joints[*joint]);
        joints.any(|joint| joint.kind != Kind::Fixed)
    }

    fn rows(&mut self, first: &'a Name) -> Joints {
        // Joints on the base link do not move the chain, but must be said to stand still.
        self.gather(first.plain(), &Transform::identity(), "");
        let mut rows: Vec<Row> = Vec::new();
        let mut places = Vec::new();
        let mut body: Option<(&'a Joint, Gathered)> = None;
        let mut frame = Transform::identity();
        for index in self.on_chain.clone() {
            let tree = self.tree;
            let joint = &tree.joints[index];
            if self.is_ignored(joint) {
                self.error(joint.place, mistake::ignored_on_chain(&joint.name));
            }
            places.push(placement(joint));
            match joint.kind {
                Kind::Fixed => {
                    frame = frame.then(&origin(joint));
                    let carrier = body.as_ref().map_or("", |(joint, _)| &joint.name);
                    let gathered = self.gather(&joint.child, &frame, carrier);
                    if let Some((_, body)) = &mut body {
                        body.mass.add(&gathered.mass);
                        body.is_known |= gathered.is_known;
                    }
                    continue;
                }
                Kind::Other(kind) => {
                    self.error(joint.place, mistake::unsupported(&joint.name, kind));
                    continue;
                }
                Kind::Revolute | Kind::Prismatic => self.follow(joint),
            }
            self.finish(&mut rows, body.take());
            frame = Transform::identity();
            let gathered = self.gather(&joint.child, &frame, &joint.name);
            body = Some((joint, gathered));
            rows.push(row(joint, core::mem::take(&mut places)));
        }
        self.finish(&mut rows, body);
        if let Some(mount) = rows.last_mut().and_then(|row| row.mount.as_mut()) {
            mount.tip = places;
        }
        Joints {
            rows,
            complete: true,
        }
    }

    /// Reports the links that move without anything being said of their inertia, all of them.
    fn report_without_inertia(&self) {
        let last = self.moving.iter().rposition(|moving| moving.is_known);
        let without = self.moving.iter().enumerate();
        for (index, moving) in
            without.filter(|(_, moving)| !moving.is_known && !self.request.no_inertia)
        {
            // A joint that others follow may carry theirs.
            let is_beyond = self.coupled.is_empty() && last.is_none_or(|last| index > last);
            let without_mass = is_beyond.then_some(moving.joint.name.as_str());
            let mistake = mistake::no_inertial(&moving.joint.child, without_mass);
            self.error(moving.place, mistake);
        }
    }

    /// Puts the body of a link in its row.
    fn finish(&mut self, rows: &mut [Row], body: Option<(&'a Joint, Gathered)>) {
        let (Some((joint, body)), Some(row)) = (body, rows.last_mut()) else {
            return;
        };
        let place = body.place;
        match (self.stands_still(joint), self.moving.last_mut()) {
            // It is a part of the link before it, or of the base.
            (true, Some(before)) => before.is_known |= body.is_known,
            (true, None) => {}
            (false, _) => self.moving.push(Moving {
                joint,
                place,
                is_known: body.is_known,
            }),
        }
        let number = |x: Rational| Expr::signed(tidy(x), place);
        let whole = body.mass.body();
        row.body.mass = Given::As(number(whole.mass));
        row.body.com = Given::As(whole.com.map(|x| Some(number(x))));
        let values = whole.inertia.map(|x| Given::As(number(x)));
        row.body.inertia = Given::As(Inertia::Tensor(Box::new(Part { place, values })));
        // Each of the bodies was judged where it stands, and angles are taken as they were written.
        row.body.allow = Given::As(Allow {
            odd_gear_ratio: false,
            odd_limits: false,
            odd_mass: false,
            ..Allow::EVERYTHING
        });
    }

    /// The body of a link and of all that hangs on it by joints that do not move, off the chain. `carrier` is the joint that
    /// moves them.
    fn gather(&mut self, link: &'a str, frame: &Transform, carrier: &str) -> Gathered {
        let place = self
            .link(link)
            .map_or(Place::File { line: 1, column: 1 }, |link| link.place);
        let mut gathered = Gathered {
            mass: Mass::none(),
            is_known: false,
            place,
        };
        let mut open = vec![(link, frame.clone())];
        while let Some((name, frame)) = open.pop() {
            let inertial = self.link(name).and_then(|link| link.inertial.as_ref());
            if let Some(inertial) = inertial {
                self.judge(inertial, carrier);
                let frame = frame.then(&inertial.frame);
                gathered
                    .mass
                    .add(&Mass::new(&inertial.mass, &inertial.tensor, &frame));
                gathered.is_known = true;
            }
            for index in self.outward.get(name).cloned().unwrap_or_default() {
                let tree = self.tree;
                let joint = &tree.joints[index];
                if self.on_chain.contains(&index) || self.is_ignored(joint) {
                    continue;
                }
                if let Some(moved) = self.moved(joint) {
                    open.push((&joint.child, frame.then(&origin(joint)).then(&moved)));
                }
            }
        }
        gathered
    }

    fn judge(&self, inertial: &Inertial, carrier: &str) {
        if inertial.mass < Rational::ZERO {
            self.error(inertial.place, mistake::negative_mass());
        }
        let tensor = inertial.tensor.each_ref().map(|entry| Some(entry.clone()));
        if let (Some(reason), false) = (
            refusal(&tensor),
            self.request.allowed(carrier).unphysical_inertia,
        ) {
            self.error(inertial.place, mistake::no_body(reason));
        }
    }

    /// The displacement by a joint off the chain, which stands still.
    fn moved(&mut self, joint: &'a Joint) -> Option<Transform> {
        if let Kind::Other(kind) = joint.kind {
            self.error(joint.place, mistake::unsupported(&joint.name, kind));
            return None;
        }
        if joint.kind == Kind::Fixed {
            return Some(Transform::identity());
        }
        let (position, lock) = self.position_beside(joint)?;
        self.report_out_of_limits(joint, &position, lock);
        let [azimuth, polar] = &joint.axis;
        let zero = || [Rational::ZERO; 3];
        let turn = |roll, pitch, yaw| Transform::new(&zero(), &[roll, pitch, yaw]);
        let axis = turn(Value::zero(), polar.clone(), azimuth.clone())?;
        let back = turn(Value::zero(), -polar.clone(), Value::zero())?;
        let back = back.then(&turn(Value::zero(), Value::zero(), -azimuth.clone())?);
        let along = match joint.kind {
            Kind::Prismatic => {
                let slide = [Rational::ZERO, Rational::ZERO, number(&position)?];
                Transform::new(&slide, &[0; 3].map(Value::integer))?
            }
            _ => turn(Value::zero(), Value::zero(), position)?,
        };
        Some(axis.then(&along).then(&back))
    }
}

fn origin(joint: &Joint) -> Transform {
    Transform::new(&joint.xyz, &joint.rpy).unwrap_or_else(Transform::identity)
}

fn placement(joint: &Joint) -> Placement {
    Placement {
        xyz: joint.xyz.clone().map(Value::Rational),
        rpy: joint.rpy.clone(),
    }
}

fn row(joint: &Joint, places: Vec<Placement>) -> Row {
    let number = |(x, place): &(Rational, Place)| Given::As(Expr::signed(x.clone(), *place));
    let given = |x: &Option<(Rational, Place)>| x.as_ref().map_or(Given::Absent, number);
    let friction = Friction {
        viscous: given(&joint.damping),
        coulomb: match &joint.friction {
            Some(friction) => Given::As(Coulomb::Both(number(friction))),
            None => Given::Absent,
        },
        ..Friction::default()
    };
    let limits = joint.limits.as_ref();
    Row {
        name: Some(Name::new(&joint.name, joint.place)),
        joint_type: Some(match joint.kind {
            Kind::Prismatic => JointType::Prismatic,
            _ => JointType::Revolute,
        }),
        friction: Given::As(friction),
        limits: limits.map_or(Given::Absent, |(limits, place)| {
            Given::As(
                limits
                    .each_ref()
                    .map(|x| Some(Expr::signed(x.clone(), *place))),
            )
        }),
        limits_of_urdf: true,
        torque_limit: given(&joint.effort),
        velocity_limit: given(&joint.velocity),
        places,
        mount: Some(Mount {
            axis: joint.axis.clone(),
            tip: Vec::new(),
        }),
        ..Row::default()
    }
}

/// A constant as an expression.
pub(super) fn expression(value: &Value, place: Place) -> Expr {
    let part = |value: &Value| Box::new(expression(value, place));
    let kind = match value {
        Value::Rational(x) => return Expr::signed(x.clone(), place),
        Value::Pi => ExprKind::Name("PI".to_owned()),
        Value::Field(index) => ExprKind::Name(index.to_string()),
        Value::Neg(a) => ExprKind::Minus(part(a)),
        Value::Add(a, b) => ExprKind::Binary(Operator::Add, part(a), part(b)),
        Value::Mul(a, b) => ExprKind::Binary(Operator::Mul, part(a), part(b)),
        Value::Div(a, b) => ExprKind::Binary(Operator::Div, part(a), part(b)),
    };
    Expr { kind, place }
}
