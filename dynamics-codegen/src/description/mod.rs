//! The description of a robot before it is validated: plain data with places, read from the tokens of a call or from
//! a file.

mod allow;
mod asked;
mod body;
mod row;
mod value;

use std::collections::BTreeSet;

use dynamics_symbolic::Function;
use dynamics_symbolic::robot::{Bounds, Convention};

use crate::audience::Audience;
use crate::finding::Finding;
use crate::rounded::Rounded;

pub use crate::place::Place;
pub use allow::Allow;
pub use asked::{Asked, Wanted};
pub use body::{Axis, Base, Body, Frame, Inertia, Link, Placement, Solid, Tensor, Tool};
pub use row::{Coulomb, Friction, Joints, Limits, Positioned, Row};
pub use value::{Elementary, Expr, ExprKind, Given, Name, Operator, Part, Vector};

/// All that is said about a robot.
#[derive(Debug, Default)]
pub struct Table {
    /// The robot's name; none where it could not be read.
    pub name: Option<Name>,
    /// Symbolic parameters.
    pub fields: Vec<Name>,
    /// Whether `fields` holds all of them, or some could not be read.
    pub has_all_fields: bool,
    /// Whether names in the values of a file that nothing binds are symbolic parameters, unless the file lists these.
    pub names_are_fields: bool,
    /// The entries, in the order in which they were written.
    pub entries: Vec<Entry>,
    /// Further remarks for the struct's documentation.
    pub notes: Vec<String>,
    /// Angles of a URDF file that are taken as multiples of a quarter turn.
    pub rounded: Rounded,
    /// Findings that the reader of a file is told besides.
    pub warnings: Vec<Finding>,
    /// The keys that were written, and where.
    pub keys: Vec<(&'static str, Place)>,
    /// Every name in the text of the entries, including those entries that could not be read.
    pub mentions: BTreeSet<String>,
    /// Whether all links of a URDF file are frames, and not only those that a function names.
    pub keeps_links: bool,
    /// The reader of messages.
    pub audience: Audience,
    /// Functions that are derived besides those that the entries request: the table has to say what they read.
    pub needed: Vec<Function>,
    /// Whether masses are read.
    pub masses: Masses,
}

/// Whether whoever reads a table reads its masses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Masses {
    /// If a function that is requested or needed does.
    #[default]
    AsRequested,
    /// Likewise, but a table in which nothing has any, which is one of geometry, is served too.
    IfAny,
    /// Not at all.
    Never,
}

impl Table {
    /// The symbolic parameters that it lists itself, where it does; none of a list that could not be read.
    pub(crate) fn listed_fields(&self) -> Option<&[Name]> {
        self.entries.iter().find_map(|entry| match entry {
            Entry::Fields(names) => Some(names.as_deref().unwrap_or_default()),
            _ => None,
        })
    }

    /// The joints, where they could be read.
    pub(crate) fn joints(&self) -> Option<&Joints> {
        self.entries.iter().find_map(|entry| match entry {
            Entry::Joints(_, joints) => joints.as_ref(),
            _ => None,
        })
    }

    /// The rows of the joints.
    pub(crate) fn rows(&self) -> &[Row] {
        self.joints().map_or(&[], |joints| &joints.rows)
    }

    /// The functions that are requested, where some are; none inside of a list that could not be read.
    pub(crate) fn functions(&self) -> Option<Option<&[Asked]>> {
        self.entries.iter().find_map(|entry| match entry {
            Entry::Functions(functions) => Some(functions.as_deref()),
            _ => None,
        })
    }

    /// The tool, where one is written that could be read.
    pub(crate) fn tool(&self) -> Option<&Tool> {
        self.entries.iter().find_map(|entry| match entry {
            Entry::Tool(_, tool) => tool.as_deref(),
            _ => None,
        })
    }

    /// The body of a base that moves, and where that is said.
    pub(crate) fn floating(&self) -> Option<(Place, &Body)> {
        self.entries.iter().find_map(|entry| match entry {
            Entry::Base(Some(base)) => base.floating(),
            _ => None,
        })
    }

    /// Where something of a base that moves is allowed: a URDF file, whose links are frames, has no `allow` of its own.
    pub(crate) fn place_of_base(&self) -> &'static str {
        if self.frames().any(|frame| frame.is_link) {
            "in the call"
        } else {
            "on the base"
        }
    }

    /// The frames of all entries, as far as they could be read.
    pub(crate) fn frames(&self) -> impl Iterator<Item = &Frame> {
        let frames = self.entries.iter().filter_map(|entry| match entry {
            Entry::Frames(_, frames) => frames.as_ref(),
            _ => None,
        });
        frames.flatten()
    }

    /// Their names, as far as they could be read.
    pub(crate) fn frame_names(&self) -> impl Iterator<Item = &Name> {
        self.frames().filter_map(|frame| frame.name.as_ref())
    }

    /// The allowances of the whole table.
    pub(crate) fn allow(&self) -> Allow {
        let allowed = self.entries.iter().filter_map(|entry| match entry {
            Entry::Allow(allow) => Some(allow.unwrap_or(Allow::EVERYTHING)),
            _ => None,
        });
        allowed.fold(Allow::default(), Allow::or)
    }
}

/// An entry of the table. `None` stands for what could not be read: the error
/// has been reported.
#[derive(Debug)]
pub enum Entry {
    /// `let name = value;`
    Let(Name, Option<Expr>),
    /// `convention: modified`
    Convention(Option<Convention>),
    /// `gravity: [0, 0, -9.81]`
    Gravity(Option<Vector>),
    /// `base: { xyz: [0, 0, 0.8] }`, or `base: floating { mass: 3 }`
    Base(Option<Box<Base>>),
    /// `joints: [...]`
    Joints(Place, Option<Joints>),
    /// `joints: { elbow: { friction: { viscous: 0.1 } } }`, cells of the joints of a file.
    Beside(Place, Option<Vec<Row>>),
    /// `links: { hand: { mass: load } }`, cells of the links of a file.
    Links(Place, Option<Vec<(Name, Body)>>),
    /// `tool: { xyz: [0, 0, 0.1], mass: 2 }`
    Tool(Place, Option<Box<Tool>>),
    /// `frames: { left_hand: { on: left_elbow, xyz: [0.3, 0, 0] } }`
    Frames(Place, Option<Vec<Frame>>),
    /// `functions: [...]`
    Functions(Option<Vec<Asked>>),
    /// `lock: [elbow = 0.3]`
    Lock(Option<Vec<Positioned>>),
    /// `couple: [finger_2 = -finger_1 + 0.02]`
    Couple(Option<Vec<Positioned>>),
    /// `fields = ["m1", "l1"]` in a file: its symbolic parameters.
    Fields(Option<Vec<Name>>),
    /// `neglect: 1%`
    Neglect(Option<Share>),
    /// `bounds: tight`
    Bounds(Option<Bounds>),
    /// `tests: true`
    Tests(Place, Option<bool>),
    /// `file: "robots/arm.urdf"`
    File(Option<FileName>),
    /// `chain: ["base_link", "tool0"]`: the link at which the robot begins, and its tips.
    Chain(Option<Vec<Name>>),
    /// `ignore: [finger]`
    Ignore(Option<Vec<Name>>),
    /// `round_angles: 1e-4`
    RoundAngles(Option<Expr>),
    /// `allow: [odd_angle]` of the whole table, `allow: [unphysical_inertia]` of a whole URDF file.
    Allow(Option<Allow>),
}

/// The name of a file, as it is written.
#[derive(Clone, Debug)]
pub struct FileName {
    /// The path, from the folder of the crate's Cargo.toml on.
    pub path: String,
    /// Where it is written.
    pub place: Place,
}

/// `1%`, or a number without `%`.
#[derive(Clone, Debug)]
pub struct Share {
    /// The number in front of `%`, or the number.
    pub number: Expr,
    /// Whether `%` follows it.
    pub percent: bool,
    /// Where it stands.
    pub place: Place,
}
