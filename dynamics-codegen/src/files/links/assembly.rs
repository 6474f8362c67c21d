//! All that is gathered of a tree: rows, frames of links, followers and locks.

use std::collections::{BTreeMap, BTreeSet};

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, Value};

use super::tree::{Joint, Link, Tree};
use crate::description::{
    Allow, Base, Body, Entry, Expr, Frame, Given, Inertia, Joints, Part, Positioned, Row,
};
use crate::diagnose::Diagnostics;
use crate::files::Request;
use crate::geometry::{Mass, tidy};
use crate::mistake::Mistake;
use crate::place::Place;

/// All that is gathered of the tree that is requested.
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
    pub(super) moved: Vec<Moved<'a>>,
    /// The bodies that move with the base, if that moves and one of them is known.
    pub(super) base: Option<Mass>,
    /// The frames of all links that are read, each with the row whose link carries it.
    pub(super) frames: Vec<(Option<usize>, Frame)>,
    /// The frames among them of links that carry no other.
    pub(super) ends: BTreeSet<usize>,
}

/// A joint with a row.
pub(super) struct Moved<'a> {
    pub(super) joint: &'a Joint,
    /// The row whose link carries it.
    pub(super) parent: Option<usize>,
    /// Whether it stands still.
    pub(super) is_locked: bool,
    pub(super) row: Row,
    /// Where its link is.
    pub(super) place: Place,
    /// The bodies of its link and of all that is fixed to it, if one of them is known.
    pub(super) carried: Option<Mass>,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(
        tree: &'a Tree,
        request: &'a Request,
        used: &'a mut Vec<String>,
        diagnostics: &'a Diagnostics,
    ) -> Self {
        Assembly {
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
            base: None,
            frames: Vec::new(),
            ends: BTreeSet::new(),
        }
    }

    /// The rows of the tree that is requested, how their joints move, and the frames of its links.
    pub(super) fn into_entries(self) -> Vec<Entry> {
        let place_of_base = self.place_of(self.first);
        let row = |moved: Moved| Row {
            body: body(moved.carried, moved.place),
            ..moved.row
        };
        let joints = Joints {
            rows: self.moved.into_iter().map(row).collect(),
            complete: true,
        };
        let frames = self.frames.into_iter().map(|(_, frame)| frame);
        let mut entries = vec![
            Entry::Convention(Some(Convention::Modified)),
            Entry::Joints(Place::START, Some(joints)),
            Entry::Frames(Place::START, Some(frames.collect())),
        ];
        if self.request.base.is_some() {
            let body = body(self.base, place_of_base);
            let base = Base::Floating(place_of_base, body);
            entries.push(Entry::Base(Some(Box::new(base))));
        }
        if !self.locked.is_empty() {
            entries.push(Entry::Lock(Some(self.locked)));
        }
        if !self.coupled.is_empty() {
            entries.push(Entry::Couple(Some(self.coupled)));
        }
        entries
    }

    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) {
        self.diagnostics.error(at, mistake);
    }

    /// Reports a mistake of the whole `chain`, or of the file where there is none.
    pub(super) fn at_chain(&self, mistake: Mistake) {
        let links = self.request.chain.as_deref().unwrap_or_default();
        self.error(links.last().map_or(Place::START, Place::from), mistake);
    }

    pub(super) fn link(&self, name: &str) -> Option<&'a Link> {
        self.tree.links.iter().find(|link| link.name == name)
    }

    pub(super) fn place_of(&self, link: &str) -> Place {
        self.link(link).map_or(Place::START, |link| link.place)
    }

    pub(super) fn named(&self, name: &str) -> Option<&'a Joint> {
        self.tree.joints.iter().find(|joint| joint.name == name)
    }

    pub(super) fn is_on_tree(&self, joint: &Joint) -> bool {
        let inward = self.inward.get(joint.child.as_str());
        inward.is_some_and(|index| self.on_tree.contains(index))
    }
}

/// A body, whose numbers are at one place.
pub(super) fn body(mass: Option<Mass>, place: Place) -> Body {
    let number = |x: Rational| Expr::known(Value::Rational(tidy(x)), place);
    let whole = mass.unwrap_or_else(Mass::none).body();
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
