//! The description of a robot before it is validated: plain data with places, read from the tokens of a call or from
//! a file.

use dynamics_symbolic::Function;
use dynamics_symbolic::function::{INVERSE_KINEMATICS, inverse_method, plain};
use dynamics_symbolic::robot::{self, Convention, JointType, Mount, Value};

use std::collections::BTreeSet;
use std::fmt;

use crate::audience::Audience;
use crate::finding::Finding;
use crate::rounded::Rounded;
use crate::words::shortened;

pub use crate::place::Place;

/// A name, and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    written: String,
    place: Place,
}

impl Name {
    /// A name as it is written, the `r#` of a raw identifier included.
    pub fn new(written: impl Into<String>, place: Place) -> Name {
        Name {
            written: written.into(),
            place,
        }
    }

    /// The name without the `r#` of a raw one.
    pub fn plain(&self) -> &str {
        plain(&self.written)
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.written)
    }
}

impl From<&Name> for Place {
    fn from(name: &Name) -> Place {
        name.place
    }
}

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
    /// How many frames the robot may have for links of a URDF file to be among them that no function names.
    pub room_for_links: usize,
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
        let mut entries = self.entries.iter();
        entries.find_map(|entry| match entry {
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

/// One entry of `functions`.
#[derive(Clone, Debug)]
pub enum Asked {
    /// `default`: the default set.
    Default(Place),
    /// `jacobian`, or `jacobian(left_hand)`
    One(Wanted),
    /// `control_terms = (mass_matrix, gravity_vector)`
    Fused(Name, Vec<Wanted>),
    /// An entry that could not be read: the error has been reported.
    Unreadable,
}

/// A function that is requested by its name.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The function, or the one that is inverted.
    pub function: Function,
    /// Whether it is `inverse_kinematics`, the inverse of `forward_kinematics`.
    pub is_inverse: bool,
    /// The frame that it is about; none for the tip, and for a function that is about no frame.
    pub frame: Option<Name>,
    /// Where it is written.
    pub place: Place,
}

impl Wanted {
    /// The word by which it is requested.
    pub fn name(&self) -> &'static str {
        if self.is_inverse {
            INVERSE_KINEMATICS
        } else {
            self.function.name()
        }
    }

    /// The name of its method.
    pub(crate) fn method(&self) -> String {
        let frame = self.frame.as_ref().map(Name::plain);
        match frame {
            frame if self.is_inverse => inverse_method(frame),
            Some(frame) => self.function.name_of_frame(frame),
            None => self.function.name().to_owned(),
        }
    }
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let name = self.name();
        match &self.frame {
            None => f.write_str(name),
            Some(frame) => write!(f, "{name}({})", shortened(frame.plain())),
        }
    }
}

/// `elbow = 0.3`, or `finger_2 = -finger_1 + 0.02` of a joint that follows another one.
#[derive(Debug)]
pub struct Positioned {
    /// The joint.
    pub name: Name,
    /// Where it is, rad or m, for a follower a linear function of the name of one other joint; none if that could not be
    /// read.
    pub position: Option<Expr>,
}

impl Positioned {
    /// `follower = factor * leader + offset`
    pub fn following(name: Name, factor: Expr, leader: &Name, offset: Expr) -> Positioned {
        let leader = Expr {
            kind: ExprKind::Name(leader.plain().to_owned()),
            place: leader.into(),
        };
        let binary = |operator, a: Expr, b: Expr| Expr {
            place: a.place.to(b.place),
            kind: ExprKind::Binary(operator, Box::new(a), Box::new(b)),
        };
        let moved = binary(Operator::Mul, factor, leader);
        Positioned {
            name,
            position: Some(binary(Operator::Add, moved, offset)),
        }
    }
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

/// `[x, y, z]`
pub type Vector = [Option<Expr>; 3];

/// `{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }`
#[derive(Debug, Default)]
pub struct Placement {
    /// The frame's origin, m.
    pub xyz: Given<Vector>,
    /// Its angles, rad.
    pub rpy: Given<Vector>,
}

/// The base of a robot.
#[derive(Debug)]
pub enum Base {
    /// `{ xyz, rpy }`: it stands there.
    Standing(Placement),
    /// `floating { mass, com, inertia }`: it moves with this body. The place is that of the word.
    Floating(Place, Body),
}

/// `{ xyz, rpy, mass, com, inertia }`
#[derive(Debug, Default)]
pub struct Tool {
    /// Its frame in the last link's.
    pub placement: Placement,
    /// The body that is fixed to it.
    pub body: Body,
}

/// The link that carries a joint or a frame.
#[derive(Clone, Debug)]
pub enum Link {
    /// As it is written: the row of that joint, or `base`.
    Named(Name),
    /// The link of the row of this index, or the base: a file knows which.
    Row(Option<usize>),
}

/// `left_hand: { on: left_elbow, xyz, rpy, mass, com, inertia }`
#[derive(Debug, Default)]
pub struct Frame {
    /// The frame's name; none if it could not be read.
    pub name: Option<Name>,
    /// The link that carries it.
    pub on: Given<Link>,
    /// The frame in that link frame.
    pub placement: Placement,
    /// Where a file has the frame in that link frame, before `placement`: each place in the one before it.
    pub places: Vec<robot::Placement>,
    /// The body that is fixed to it.
    pub body: Body,
    /// Whether it is a link of a file, which no function has to name.
    pub is_link: bool,
}

impl Frame {
    /// The frame's name; empty if it could not be read.
    pub(crate) fn word(&self) -> &str {
        self.name.as_ref().map_or("", Name::plain)
    }
}

/// The body of a link, of the tool or of a frame.
#[derive(Debug, Default)]
pub struct Body {
    /// Its mass, kg.
    pub mass: Given<Expr>,
    /// Its centre of mass in the frame of the link or tool, m.
    pub com: Given<Vector>,
    /// Its inertia about the centre of mass.
    pub inertia: Given<Inertia>,
    /// The same about the frame's origin, in place of `inertia`.
    pub inertia_at_origin: Given<Tensor>,
    /// Odd values that are accepted, there and in the rest of the row.
    pub allow: Given<Allow>,
}

impl Body {
    /// Whether anything of it is written.
    pub(crate) fn is_written(&self) -> bool {
        let has_tensor = !self.inertia.is_absent() || !self.inertia_at_origin.is_absent();
        has_tensor || !self.mass.is_absent() || !self.com.is_absent()
    }

    /// Makes a mass and a centre of mass that were left out unreadable.
    pub(crate) fn doubt(&mut self) {
        self.mass.doubt();
        self.com.doubt();
    }

    /// Where the first of its cells is, as far as they could be read; `allow` is none of them.
    #[cfg(feature = "files")]
    pub(crate) fn place(&self) -> Option<Place> {
        let com = self.com.value().and_then(|com| com.iter().flatten().next());
        let inertia = self.inertia.value().map(|inertia| match inertia {
            Inertia::Tensor(tensor) => tensor.place,
            Inertia::Solid(place, ..) => *place,
        });
        let at_origin = self.inertia_at_origin.value().map(|tensor| tensor.place);
        let mass = self.mass.value().map(|mass| mass.place);
        let com = com.map(|x| x.place);
        mass.or(com).or(inertia).or(at_origin)
    }
}

impl Base {
    /// The body of a base that moves, and where that is said.
    pub fn floating(&self) -> Option<(Place, &Body)> {
        match self {
            Base::Standing(_) => None,
            Base::Floating(place, body) => Some((*place, body)),
        }
    }
}

/// A thing that may be left out.
#[derive(Debug, Default)]
pub enum Given<T> {
    /// Left out.
    #[default]
    Absent,
    /// Written, but it could not be read: the error has been reported.
    Unreadable,
    /// Written.
    As(T),
}

impl<T> Given<T> {
    /// Makes a thing that was left out unreadable: what could not be read next to it may be this one.
    pub fn doubt(&mut self) {
        if self.is_absent() {
            *self = Given::Unreadable;
        }
    }

    /// Whether nothing was written.
    pub fn is_absent(&self) -> bool {
        matches!(self, Given::Absent)
    }

    /// The result of `read`, or `absent` if it was left out.
    pub(crate) fn read<U>(&self, absent: U, read: impl FnOnce(&T) -> Option<U>) -> Option<U> {
        match self {
            Given::Absent => Some(absent),
            Given::Unreadable => None,
            Given::As(value) => read(value),
        }
    }

    /// The value, if one was written that could be read.
    pub fn value(&self) -> Option<&T> {
        match self {
            Given::As(value) => Some(value),
            Given::Absent | Given::Unreadable => None,
        }
    }
}

/// `[name: revolute { cells }, ...]`
#[derive(Debug)]
pub struct Joints {
    /// The rows that could be recognised as rows.
    pub rows: Vec<Row>,
    /// Whether these are all rows.
    pub complete: bool,
}

/// `name: revolute { cells }`
#[derive(Debug, Default)]
pub struct Row {
    /// The joint's name.
    pub name: Option<Name>,
    /// Revolute or prismatic.
    pub joint_type: Option<JointType>,
    /// The link that carries the joint; left out, that of the row above.
    pub on: Given<Link>,
    /// Where the row begins on that link, `at: { xyz, rpy }`.
    pub at: Given<Placement>,
    /// Rotation about the z axis of the link that carries the joint, before the row of a modified table, rad.
    pub gamma: Given<Expr>,
    /// Displacement along that axis, m.
    pub b: Given<Expr>,
    /// Length of the common normal, m.
    pub a: Given<Expr>,
    /// Twist, rad.
    pub alpha: Given<Expr>,
    /// Offset along the axis, m.
    pub d: Given<Expr>,
    /// Angle about the axis, rad.
    pub theta: Given<Expr>,
    /// The body of the link.
    pub body: Body,
    /// The motor: inertia of its rotor, kg m^2, and its speed over that of the joint.
    pub motor: Given<Part<2>>,
    /// Friction of the joint.
    pub friction: Given<Friction>,
    /// The spring at the joint: its stiffness, and the position at which it is slack.
    pub spring: Given<Part<2>>,
    /// The range of the joint.
    pub limits: Given<Limits>,
    /// The greatest torque or force in either direction.
    pub torque_limit: Given<Expr>,
    /// The greatest speed in either direction.
    pub velocity_limit: Given<Expr>,
    /// Whether the range is that of a tree of links, in which many files have it wrong.
    pub limits_of_file: bool,
    /// Where a file begins the row on the link that carries it, each place in the one before it.
    pub places: Vec<robot::Placement>,
    /// The joint's axis, in a file that has no cells a, alpha, d and theta.
    pub mount: Option<Mount>,
}

impl Row {
    /// The joint's name; empty if it could not be read.
    pub(crate) fn word(&self) -> &str {
        self.name.as_ref().map_or("", Name::plain)
    }
}

/// Values for some words: `{ stiffness: 200, rest: 0.1 }`.
#[derive(Debug)]
pub struct Part<const N: usize> {
    /// Where they stand.
    pub place: Place,
    /// The values, in the order in which messages list their words.
    pub values: [Given<Expr>; N],
}

/// The entries xx, yy, zz, xy, yz, xz of a tensor.
pub type Tensor = Box<Part<6>>;

/// The value of the cell `inertia`.
#[derive(Debug)]
pub enum Inertia {
    /// `{ xx, yy, zz, xy, yz, xz }`
    Tensor(Tensor),
    /// `cuboid(x, y, z)` and the like, and where it stands.
    Solid(Place, Solid, Vec<Option<Expr>>),
}

/// A homogeneous solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// Edges x, y, z.
    Cuboid,
    /// Radius and length, along that axis.
    Cylinder(Axis),
    /// Length, along that axis; slender.
    Rod(Axis),
    /// Radius.
    Sphere,
}

/// An axis of a link's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
}

/// `friction: { viscous, coulomb, stribeck }`
#[derive(Debug, Default)]
pub struct Friction {
    /// Force or torque for each unit of speed.
    pub viscous: Given<Expr>,
    /// Force or torque against the motion, whatever its speed.
    pub coulomb: Given<Coulomb>,
    /// Static friction, and the velocity over which it falls to Coulomb's.
    pub stribeck: Given<Part<2>>,
}

/// A value, or `{ positive, negative }`.
#[derive(Debug)]
pub enum Coulomb {
    /// The same in both directions.
    Both(Given<Expr>),
    /// At positive velocities and at negative ones.
    ByDirection(Part<2>),
}

/// `limits: [lower, upper]`
pub type Limits = [Option<Expr>; 2];

/// Makes the description of `allow` out of its words, each with its meaning.
macro_rules! allowances {
    ($($(#[$meaning:meta])* $word:ident,)*) => {
        /// `allow: [unphysical_inertia]`: numbers that are accepted, odd as they are.
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Allow {
            $($(#[$meaning])* pub $word: bool,)*
        }

        impl Allow {
            /// The words that `allow` of the whole table may hold.
            pub const WORDS: [&'static str; [$(stringify!($word)),*].len()] =
                [$(stringify!($word)),*];

            /// All of it: what is meant to be allowed is not known.
            pub const EVERYTHING: Allow = Allow { $($word: true,)* };

            /// The allowances of this or the other one.
            pub fn or(self, other: Allow) -> Allow {
                Allow { $($word: self.$word || other.$word,)* }
            }

            /// Allows one of the words.
            pub(crate) fn note(&mut self, word: &str) {
                $(self.$word |= word == stringify!($word);)*
            }
        }
    };
}

allowances! {
    /// Links of a URDF file whose inertia is not given, and arms without any: they are massless.
    no_inertia,
    /// An angle of more than a turn or of four whole radians or more, or nearly a right one.
    odd_angle,
    /// A centre of mass far from everything.
    odd_com,
    /// A motor that turns more slowly than its joint.
    odd_gear_ratio,
    /// Gravity as it is nowhere, or the same along all axes.
    odd_gravity,
    /// Lengths in mm.
    odd_length,
    /// Limits whose lower one is above the upper one: the joint has none then.
    odd_limits,
    /// A centre of mass or a tensor without a mass, or a mass in g; an arm without any inertia, too.
    odd_mass,
    /// A tensor that no body has.
    unphysical_inertia,
}

/// A constant expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Its kind.
    pub kind: ExprKind,
    /// Where it stands.
    pub place: Place,
}

impl Expr {
    /// A value that is known, without fields.
    pub fn known(value: Value, place: Place) -> Expr {
        let kind = ExprKind::Value(value);
        Expr { kind, place }
    }

    /// Puts all of it at one place.
    #[cfg(feature = "files")]
    pub(crate) fn put(&mut self, place: Place) {
        self.place = place;
        match &mut self.kind {
            ExprKind::Value(_) | ExprKind::Name(_) => {}
            ExprKind::Degrees(value) | ExprKind::Function(_, value) | ExprKind::Minus(value) => {
                value.put(place);
            }
            ExprKind::Binary(_, left, right) => {
                left.put(place);
                right.put(place);
            }
        }
    }
}

/// The kinds of constant expression.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number literal, or what a file is known to say.
    Value(Value),
    /// `PI`, a field or a `let`.
    Name(String),
    /// `deg(x)`
    Degrees(Box<Expr>),
    /// `sqrt(x)` and the like.
    Function(Elementary, Box<Expr>),
    /// `-x`
    Minus(Box<Expr>),
    /// `x + y` and the like.
    Binary(Operator, Box<Expr>, Box<Expr>),
}

/// The functions of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Elementary {
    /// The square root.
    Sqrt,
    /// The sine.
    Sin,
    /// The cosine.
    Cos,
}

/// The operators of two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}
