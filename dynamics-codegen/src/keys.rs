//! The words of a table: its keys, and those of each part of it.

/// Words in a list.
macro_rules! word_list {
    ($($word:ident)*) => { &[$(stringify!($word)),*] };
}

pub(crate) use word_list;

/// A part of a table with words of its own.
pub(crate) struct Part {
    /// The part, as a message names it.
    pub(crate) name: &'static str,
    /// One of its items, as a message names it.
    pub(crate) item: &'static str,
    /// The words in front of its values.
    pub(crate) keys: &'static [&'static str],
    /// How a call writes it, in braces.
    pub(crate) shape: &'static str,
}

/// The keys of a call.
pub(crate) const KEYS: &[&str] = word_list![
    file chain ignore round_angles convention gravity base joints couple tool functions lock neglect tests
    allow
];

/// The keys of a file.
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) const KEYS_OF_FILES: &[&str] = word_list![
    convention gravity base joint couple tool functions lock neglect tests allow let
];

pub(crate) const CALL: Part = Part {
    name: "a robot",
    item: "key",
    keys: KEYS,
    shape: "`key: value, ...`",
};

pub(crate) const FILE: Part = Part {
    keys: KEYS_OF_FILES,
    ..CALL
};

/// A tensor, its entries in the engine's order.
pub(crate) const TENSOR: Part = Part {
    name: "an inertia",
    item: "tensor entry",
    keys: word_list![xx yy zz xy yz xz],
    shape: "a tensor about the origin of the frame, of named entries: `{ xx, yy, zz, xy, yz, xz }`",
};

pub(crate) const MOTOR: Part = Part {
    name: "`motor`",
    item: "motor entry",
    keys: word_list![inertia gear_ratio],
    shape: "`{ inertia: ..., gear_ratio: ... }`",
};

pub(crate) const FRICTION: Part = Part {
    name: "`friction`",
    item: "friction entry",
    keys: word_list![viscous coulomb stribeck],
    shape: "`{ viscous: ..., coulomb: ... }`",
};

/// Coulomb friction by the direction of motion.
pub(crate) const DIRECTIONS: Part = Part {
    name: "`coulomb`",
    item: "direction",
    keys: word_list![positive negative],
    shape: "`{ positive: ..., negative: ... }`",
};

pub(crate) const STRIBECK: Part = Part {
    name: "`stribeck`",
    item: "stribeck entry",
    keys: word_list![static velocity],
    shape: "`{ static: ..., velocity: ... }`",
};

pub(crate) const SPRING: Part = Part {
    name: "`spring`",
    item: "spring entry",
    keys: word_list![stiffness rest],
    shape: "`{ stiffness: ..., rest: ... }`",
};

pub(crate) const BASE: Part = Part {
    name: "`base`",
    item: "base entry",
    keys: word_list![xyz rpy],
    shape: "`{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }`",
};

pub(crate) const TOOL: Part = Part {
    name: "`tool`",
    item: "tool entry",
    keys: word_list![xyz rpy mass com inertia inertia_at_origin allow],
    shape: "`{ xyz: [x, y, z], rpy: [roll, pitch, yaw], mass: ..., com: ..., inertia: ... }`",
};

pub(crate) const JOINT_TYPES: &[&str] = word_list![revolute prismatic];

/// What a row or the tool may allow.
pub(crate) const ALLOWANCES_OF_BODY: &[&str] =
    word_list![odd_angle odd_com odd_mass unphysical_inertia];

/// The word for the default set of functions.
pub(crate) const DEFAULT: &str = "default";
