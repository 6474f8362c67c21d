//! The links and joints that a file says, in whatever format.

use std::collections::BTreeSet;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{JointType, Placement, Value};

use super::rounding::Rounding;
use crate::diagnose::Diagnostics;
use crate::finding::Finding;
use crate::geometry::Transform;
use crate::mistake::links as mistake;
use crate::place::Place;
use crate::words;

/// The links and joints of a file.
pub(crate) struct Tree {
    pub(crate) links: Vec<Link>,
    pub(crate) joints: Vec<Joint>,
    /// The numbers that were taken as others.
    pub(crate) rounding: Rounding,
    /// Warnings of what is left out.
    pub(crate) warnings: Vec<Finding>,
    pub(crate) words: Words,
}

/// Names for the parts of a file in messages, in the words of its format.
#[derive(Clone, Copy)]
pub(crate) struct Words {
    /// The part that says that a joint follows another one.
    pub(crate) follower: &'static str,
    /// The part that says the body of a link.
    pub(crate) body: &'static str,
}

pub(crate) struct Link {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) inertial: Option<Inertial>,
}

pub(crate) struct Inertial {
    pub(crate) place: Place,
    pub(crate) mass: Rational,
    /// xx, yy, zz, xy, yz, xz about the centre of mass, in the axes of its frame.
    pub(crate) tensor: [Rational; 6],
    /// That frame in the link's.
    pub(crate) frame: Transform,
}

/// A number, and where it is.
pub(crate) type Number = (Rational, Place);

pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) kind: Kind,
    /// The link that carries it, and the one that it moves.
    pub(crate) parent: String,
    pub(crate) child: String,
    /// Where it is on the link that carries it.
    pub(crate) origin: Placement,
    /// The angles of its axis: see [`Mount`](dynamics_symbolic::robot::Mount).
    pub(crate) axis: [Value; 2],
    pub(crate) viscous: Option<Number>,
    pub(crate) coulomb: Option<Number>,
    pub(crate) limits: Option<([Rational; 2], Place)>,
    /// The greatest torque or force, and the greatest speed.
    pub(crate) effort: Option<Number>,
    pub(crate) velocity: Option<Number>,
    pub(crate) follows: Option<Follows>,
}

/// The joint is at factor * q + offset.
pub(crate) struct Follows {
    pub(crate) place: Place,
    /// The joint that leads, which is at q.
    pub(crate) leader: String,
    pub(crate) factor: Rational,
    pub(crate) offset: Value,
}

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Fixed,
    Moves(JointType),
    /// A joint that has no position of one number, by its name, which is refused where it matters.
    Other(&'static str),
}

impl Tree {
    /// The links to which no joint leads, and those from which none does.
    pub(super) fn ends(&self) -> (Vec<&str>, Vec<&str>) {
        let outside_of = |end: fn(&Joint) -> &str| {
            let taken: BTreeSet<&str> = self.joints.iter().map(end).collect();
            let names = self.links.iter().map(|link| link.name.as_str());
            names.filter(|name| !taken.contains(name)).collect()
        };
        (
            outside_of(|joint| &joint.child),
            outside_of(|joint| &joint.parent),
        )
    }

    /// The names of all links.
    pub(super) fn link_names(&self) -> Vec<&str> {
        self.links.iter().map(|link| link.name.as_str()).collect()
    }

    /// The names of all joints.
    pub(super) fn joint_names(&self) -> Vec<&str> {
        self.joints.iter().map(|j| j.name.as_str()).collect()
    }

    /// Reports names that stand twice, and the parents and children of joints that are no links of the file.
    pub(crate) fn report_names(&self, diagnostics: &Diagnostics) {
        let links = self.links.iter().map(|link| (&*link.name, link.place));
        report_repeated("link", links, diagnostics);
        let joints = self.joints.iter().map(|joint| (&*joint.name, joint.place));
        report_repeated("joint", joints, diagnostics);
        let known = self.link_names();
        for joint in &self.joints {
            for link in [&joint.parent, &joint.child] {
                // To look for what was meant takes long, and no more is shown.
                if !known.contains(&link.as_str()) && !diagnostics.is_full() {
                    let meant = words::nearest(link, &known);
                    let mistake = mistake::unknown_link_of(&joint.name, link, meant);
                    diagnostics.error(joint.place, mistake);
                }
            }
        }
    }
}

impl Joint {
    /// Whether it has a position, which is one number.
    pub(super) fn moves(&self) -> bool {
        matches!(self.kind, Kind::Moves(_))
    }
}

/// Reports each name that stands before it in the list already.
fn report_repeated<'a>(
    what: &str,
    names: impl Iterator<Item = (&'a str, Place)>,
    diagnostics: &Diagnostics,
) {
    let mut seen = BTreeSet::new();
    for (name, place) in names {
        if !seen.insert(name) {
            diagnostics.error(place, mistake::twice(what, name));
        }
    }
}
