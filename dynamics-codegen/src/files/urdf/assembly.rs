//! The rows and frames of a tree of links, and the bodies that its joints move.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType, Mount, Placement, Value};

use super::document::{Inertial, Joint, Kind, Link, Tree};
use crate::description::{
    self, Allow, Base, Body, Coulomb, Entry, Expr, ExprKind, Frame, Friction, Given, Inertia,
    Joints, Name, Operator, Part, Positioned, Row,
};
use crate::diagnose::Diagnostics;
use crate::files::Request;
use crate::geometry::{Mass, Transform, number, tidy};
use crate::limits::MOST_PLACES;
use crate::mistake::{Mistake, size, urdf as mistake};
use crate::place::Place;
use crate::validate::refusal;
use crate::words;

/// The place of a mistake in the whole file.
pub(super) const START: Place = Place::File { line: 1, column: 1 };

/// The rows of the tree that is requested, how their joints move, and the frames of its links.
pub(super) fn entries<'a>(
    tree: &'a Tree,
    request: &'a Request,
    used: &'a mut Vec<String>,
    diagnostics: &'a Diagnostics,
) -> Option<Vec<Entry>> {
    let mut assembly = Assembly {
        tree,
        request,
        used,
        diagnostics,
        inward: BTreeMap::new(),
        outward: BTreeMap::new(),
        first: "",
        on_tree: BTreeSet::new(),
        coupled: Vec::new(),
        locked: Vec::new(),
        moved: Vec::new(),
        base: Carried::default(),
        frames: Vec::new(),
        ends: BTreeSet::new(),
    };
    let names = assembly.report_names();
    assembly.find().and(names)?;
    assembly.walk();
    // A mistake in the rest of the rows is reported beside links without inertia.
    let is_readable = diagnostics.is_empty();
    assembly.report_without_inertia();
    assembly.place_tip();
    let place_of_base = assembly.place_of(assembly.first);
    let joints = Joints {
        rows: assembly.moved.into_iter().map(Moved::row).collect(),
        complete: true,
    };
    let frames = assembly.frames.into_iter().map(LinkFrame::frame);
    let mut entries = vec![
        Entry::Convention(Some(Convention::Modified)),
        Entry::Joints(START, Some(joints)),
        Entry::Frames(START, Some(frames.collect())),
    ];
    if request.base.is_some() {
        let body = body(&assembly.base.mass, place_of_base);
        let base = Base::Floating(place_of_base, body);
        entries.push(Entry::Base(Some(Box::new(base))));
    }
    if !assembly.locked.is_empty() {
        entries.push(Entry::Lock(Some(assembly.locked)));
    }
    if !assembly.coupled.is_empty() {
        entries.push(Entry::Couple(Some(assembly.coupled)));
    }
    is_readable.then_some(entries)
}

pub(super) struct Assembly<'a> {
    pub(super) tree: &'a Tree,
    pub(super) request: &'a Request,
    /// Locked joints that are not on the tree.
    pub(super) used: &'a mut Vec<String>,
    diagnostics: &'a Diagnostics,
    /// The joint whose child a link is.
    pub(super) inward: BTreeMap<&'a str, usize>,
    /// The joints whose parent a link is.
    pub(super) outward: BTreeMap<&'a str, Vec<usize>>,
    /// The link in whose frame all others are placed.
    pub(super) first: &'a str,
    /// The joints of the tree: each of them that moves has a row.
    pub(super) on_tree: BTreeSet<usize>,
    /// The joints of the tree that follow others of it.
    pub(super) coupled: Vec<Positioned>,
    /// The joints of the tree that follow joints which stand still beside it.
    pub(super) locked: Vec<Positioned>,
    /// The joints of the rows, with what moves with each.
    moved: Vec<Moved<'a>>,
    /// The bodies that move with the base, if that moves.
    base: Carried,
    /// The frames of all links that are read.
    frames: Vec<LinkFrame>,
    /// The frames among them of links that carry no other.
    ends: BTreeSet<usize>,
}

/// The word for all joints beside the chain that are not named. Where a joint has this name it is that joint.
const REST: &str = "rest";

/// A joint with a row.
struct Moved<'a> {
    joint: &'a Joint,
    /// The row whose link carries it.
    parent: Option<usize>,
    /// Whether it stands still.
    is_locked: bool,
    row: Row,
    /// Where its link is.
    place: Place,
    /// The bodies of its link and of all that is fixed to it.
    carried: Carried,
}

/// The bodies of a link and of all that is fixed to it.
struct Carried {
    mass: Mass,
    /// Whether the inertia of one of them is known.
    is_known: bool,
}

impl Default for Carried {
    fn default() -> Self {
        Carried {
            mass: Mass::none(),
            is_known: false,
        }
    }
}

/// The frame of a link.
struct LinkFrame {
    name: Option<Name>,
    /// The row whose link carries it.
    row: Option<usize>,
    /// Where it is in the frame of that link, each place in the one before it.
    places: Vec<Placement>,
}

impl LinkFrame {
    fn frame(self) -> Frame {
        Frame {
            name: self.name,
            on: Given::As(description::Link::Row(self.row)),
            places: self.places,
            is_link: true,
            ..Frame::default()
        }
    }
}

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
    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) {
        self.diagnostics.error(at, mistake);
    }

    /// Reports a mistake of the whole `chain`, or of the file where there is none.
    pub(super) fn at_chain(&self, mistake: Mistake) {
        let links = self.request.chain.as_deref().unwrap_or_default();
        self.error(links.last().map_or(START, Place::from), mistake);
    }

    /// Names in `lock` and `ignore` that no joint has, and `rest` where it means nothing. Joints that a slip leaves out would
    /// be reported where they matter: `None` where there is one.
    fn report_names(&mut self) -> Option<()> {
        let known: Vec<&str> = self.tree.joints.iter().map(|j| j.name.as_str()).collect();
        if let Some((name, position)) = self.rest_locked() {
            self.used.push(REST.to_owned());
            if position.is_none() {
                self.error(name, mistake::rest_with_names());
            }
            if self.rest_ignored().is_some() {
                self.error(name, mistake::rest_twice());
            }
        }
        let locked = self.rest_locked().map(|(name, _)| name);
        if let Some(name) = locked.or(self.rest_ignored())
            && self.tips().is_empty()
        {
            let (first, last) = self.tree.ends();
            self.error(name, mistake::rest_of_nothing(&first, &last));
        }
        let before = self.diagnostics.count();
        let locked = self.request.lock.iter().map(|(name, _)| name);
        for name in locked.chain(&self.request.ignore) {
            if !known.contains(&name.plain()) && name.plain() != REST {
                let meant = words::nearest(name.plain(), &known);
                let mistake = crate::mistake::unknown("joint", name.plain(), meant, &known);
                self.error(name, mistake);
            }
        }
        (self.diagnostics.count() == before).then_some(())
    }

    fn link(&self, name: &str) -> Option<&'a Link> {
        self.tree.links.iter().find(|link| link.name == name)
    }

    pub(super) fn place_of(&self, link: &str) -> Place {
        self.link(link).map_or(START, |link| link.place)
    }

    /// Whether a joint is left out, by its name or as one of the rest.
    fn is_ignored(&self, joint: &'a Joint) -> bool {
        let is_of_rest = || {
            let moves = joint.kind != Kind::Fixed && self.rest_ignored().is_some();
            moves && !self.is_on_tree(joint) && !self.stands_still(joint)
        };
        self.is_ignored_by_name(joint) || is_of_rest()
    }

    pub(super) fn is_ignored_by_name(&self, joint: &Joint) -> bool {
        let mut ignored = self.request.ignore.iter();
        ignored.any(|name| name.plain() == joint.name)
    }

    fn rest_ignored(&self) -> Option<&'a Name> {
        let mut ignored = self.request.ignore.iter();
        let rest = ignored.find(|name| name.plain() == REST);
        rest.filter(|_| self.named(REST).is_none())
    }

    /// Where the joints beside the chain stand still that are not named.
    pub(super) fn rest_locked(&self) -> Option<&'a (Name, Option<Value>)> {
        let mut locked = self.request.lock.iter();
        let rest = locked.find(|(name, _)| name.plain() == REST);
        rest.filter(|_| self.named(REST).is_none())
    }

    /// Goes from the first link outwards, depth first and from a link to its children in the order of their joints.
    fn walk(&mut self) {
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
                self.error(START, size::places());
                return;
            }
            open.extend(self.arrive(next));
        }
    }

    /// Takes the body and the frame of a link. Returns its joints, the first one last.
    fn arrive(&mut self, mut spot: Spot<'a>) -> Vec<(usize, Rc<Spot<'a>>)> {
        let link = self.link(spot.link);
        if let Some(inertial) = link.and_then(|link| link.inertial.as_ref()) {
            let (carried, carrier) = match spot.row.map(|row| &mut self.moved[row]) {
                Some(moved) => (Some(&mut moved.carried), Some(moved.joint.name.as_str())),
                None => (self.request.base.is_some().then_some(&mut self.base), None),
            };
            if let Some(carried) = carried {
                let frame = spot.frame.then(&inertial.frame);
                let mass = Mass::new(&inertial.mass, &inertial.tensor, &frame);
                carried.mass.add(&mass);
                carried.is_known = true;
            }
            self.judge(inertial, carrier);
        }
        spot.index = self.frames.len();
        self.ends.insert(spot.index);
        self.frames.push(LinkFrame {
            name: link.map(|link| Name::new(spot.link, link.place)),
            row: spot.row,
            places: spot.places.clone(),
        });
        let joints = self.outward.get(spot.link).into_iter().flatten();
        let spot = Rc::new(spot);
        joints.rev().map(|&joint| (joint, spot.clone())).collect()
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
        let mut steps = vec![Placement {
            xyz: joint.xyz.clone().map(Value::Rational),
            rpy: joint.rpy.clone(),
        }];
        match joint.kind {
            Kind::Fixed => {}
            Kind::Other(kind) => {
                self.report_unsupported(joint, kind);
                if !is_on_tree {
                    return None;
                }
            }
            Kind::Revolute | Kind::Prismatic if is_on_tree => {
                let places = [spot.places.clone(), steps].concat();
                return Some(self.row_of(joint, spot.row, places));
            }
            Kind::Revolute | Kind::Prismatic => steps.extend(self.displacement(joint)?),
        }
        spot.then(&joint.child, steps)
    }

    /// Adds the row of a joint. Returns its link.
    fn row_of(
        &mut self,
        joint: &'a Joint,
        parent: Option<usize>,
        places: Vec<Placement>,
    ) -> Spot<'a> {
        self.follow(joint);
        let number = self.moved.len();
        let on = if parent == number.checked_sub(1) {
            Given::Absent
        } else {
            Given::As(description::Link::Row(parent))
        };
        self.moved.push(Moved {
            joint,
            parent,
            is_locked: self.stands_still(joint),
            row: Row {
                on,
                places,
                ..row(joint)
            },
            place: self.place_of(&joint.child),
            carried: Carried::default(),
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
        let moves = |joint: &usize| {
            matches!(
                self.tree.joints[*joint].kind,
                Kind::Revolute | Kind::Prismatic
            )
        };
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

    /// The nearest row that moves, of the one that carries something: what stands still is a part of its link, or of the
    /// base.
    fn moving(&self, mut row: Option<usize>) -> Option<usize> {
        while let Some(moved) = row.map(|row| &self.moved[row])
            && moved.is_locked
        {
            row = moved.parent;
        }
        row
    }

    /// Reports the links that move without anything being said of their inertia, all of them.
    fn report_without_inertia(&self) {
        if self.request.no_inertia {
            return;
        }
        let rows = 0..self.moved.len();
        let said = rows.clone().filter(|&row| self.moved[row].carried.is_known);
        let said: BTreeSet<_> = said.map(|row| self.moving(Some(row))).collect();
        let base_is_known = self.base.is_known || said.contains(&None);
        let mut links = Vec::new();
        if self.request.base.is_some() && !base_is_known {
            links.push((self.first, self.place_of(self.first)));
        }
        let known: BTreeSet<usize> = said.into_iter().flatten().collect();
        if self.request.may_be_geometry && self.request.base.is_none() && known.is_empty() {
            return;
        }
        // The rows that carry one whose inertia is known.
        let mut carrying = BTreeSet::new();
        for &row in &known {
            let mut row = Some(row);
            while let Some(at) = row.filter(|at| carrying.insert(*at)) {
                row = self.moved[at].parent;
            }
        }
        let mut joints = Vec::new();
        for row in rows {
            let Moved { joint, place, .. } = self.moved[row];
            if self.moved[row].is_locked || known.contains(&row) {
                continue;
            }
            links.push((&joint.child, place));
            // A joint that others follow may carry theirs.
            if self.coupled.is_empty() && !carrying.contains(&row) {
                joints.push(joint.name.as_str());
            }
        }
        let names: Vec<&str> = links.iter().map(|(name, _)| *name).collect();
        if let Some((_, place)) = links.first() {
            self.error(*place, mistake::no_inertial(&names, &joints));
        }
    }

    /// Puts the tip where it is, if there is one: in the second of two links of `chain`, or else in the only end of the
    /// tree on the only link that moves and carries no other that moves.
    fn place_tip(&mut self) {
        let tip = match self.tips() {
            [] => self.only_end(),
            [tip] => (0..self.frames.len()).find(|&frame| self.word(frame) == tip.plain()),
            _ => None,
        };
        let Some(LinkFrame { row, places, .. }) = tip.map(|frame| &self.frames[frame]) else {
            return;
        };
        let mount = row.and_then(|row| self.moved[row].row.mount.as_mut());
        if let Some(mount) = mount {
            mount.tip = Some(places.clone());
        }
    }

    fn only_end(&self) -> Option<usize> {
        let moving = (0..self.moved.len()).filter(|&row| !self.moved[row].is_locked);
        let carrying = moving
            .clone()
            .map(|row| self.moving(self.moved[row].parent));
        let carrying: BTreeSet<_> = carrying.collect();
        let last = only(moving.filter(|&row| !carrying.contains(&Some(row))))?;
        let is_last = |end: &usize| self.moving(self.frames[*end].row) == Some(last);
        only(self.ends.iter().copied().filter(is_last))
    }

    /// The name of the link that has a frame.
    fn word(&self, frame: usize) -> &str {
        self.frames[frame].name.as_ref().map_or("", Name::plain)
    }

    fn judge(&self, inertial: &Inertial, carrier: Option<&str>) {
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

    /// The displacement by a joint beside the tree, which stands still.
    fn displacement(&mut self, joint: &'a Joint) -> Option<[Placement; 4]> {
        let (position, lock) = self.position_beside(joint)?;
        self.report_out_of_limits(joint, &position, lock);
        let [azimuth, polar] = joint.axis.clone();
        let turn = |roll, pitch, yaw| Placement {
            xyz: [(); 3].map(|()| Value::zero()),
            rpy: [roll, pitch, yaw],
        };
        let zero = Value::zero;
        let along = match joint.kind {
            Kind::Prismatic => Placement {
                xyz: [zero(), zero(), position],
                ..turn(zero(), zero(), zero())
            },
            _ => turn(zero(), zero(), position),
        };
        Some([
            turn(zero(), polar.clone(), azimuth.clone()),
            along,
            turn(zero(), -polar, zero()),
            turn(zero(), zero(), -azimuth),
        ])
    }
}

impl Moved<'_> {
    /// The row, with the body of all that moves with it.
    fn row(self) -> Row {
        Row {
            body: body(&self.carried.mass, self.place),
            ..self.row
        }
    }
}

/// A body, whose numbers are at one place.
fn body(mass: &Mass, place: Place) -> Body {
    let number = |x: Rational| Expr::signed(tidy(x), place);
    let whole = mass.body();
    let values = whole.inertia.map(|x| Given::As(number(x)));
    Body {
        mass: Given::As(number(whole.mass)),
        com: Given::As(whole.com.map(|x| Some(number(x)))),
        inertia: Given::As(Inertia::Tensor(Box::new(Part { place, values }))),
        // Each of the bodies was judged where it stands, and angles are taken as they were written.
        allow: Given::As(Allow {
            odd_gear_ratio: false,
            odd_limits: false,
            odd_mass: false,
            ..Allow::EVERYTHING
        }),
        ..Body::default()
    }
}

/// The only one of some things.
fn only<T>(mut things: impl Iterator<Item = T>) -> Option<T> {
    let first = things.next();
    first.filter(|_| things.next().is_none())
}

/// The row of a joint, as far as its element has it.
fn row(joint: &Joint) -> Row {
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
        mount: Some(Mount {
            axis: joint.axis.clone(),
            tip: None,
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
