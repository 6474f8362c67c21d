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
    file chain ignore round_angles convention gravity base joints links couple tool frames functions lock neglect bounds
    tests allow
];

/// The keys of entries in TOML beside a file.
const KEYS_BESIDE_A_FILE: &[&str] = word_list![
    convention gravity base joint couple tool frame functions lock neglect bounds tests allow let fields
    joints links
];

/// The keys of a file that names the file of its robot.
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) const KEYS_OF_PROJECTS: &[&str] = word_list![
    file chain ignore round_angles convention gravity base joint couple tool frame functions lock neglect bounds tests allow
    let fields joints links
];

/// The keys of a file.
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) const KEYS_OF_FILES: &[&str] =
    KEYS_BESIDE_A_FILE.split_at(KEYS_BESIDE_A_FILE.len() - 2).0;

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

pub(crate) const PROJECT: Part = Part {
    keys: KEYS_OF_PROJECTS,
    ..CALL
};

pub(crate) const ENTRIES_BESIDE_A_FILE: Part = Part {
    keys: KEYS_BESIDE_A_FILE,
    ..CALL
};

/// Makes a part of each name: the part and its items as messages name them, its words, and how a call writes it.
macro_rules! parts {
    ($($(#[$about:meta])* $part:ident: $name:literal, $item:literal, [$($word:ident)*], $shape:literal;)*) => {$(
        $(#[$about])*
        pub(crate) const $part: Part = Part {
            name: $name,
            item: $item,
            keys: word_list![$($word)*],
            shape: $shape,
        };
    )*};
}

parts! {
    /// A tensor, its entries in the engine's order.
    TENSOR: "an inertia", "tensor entry", [xx yy zz xy yz xz],
        "a tensor about the origin of the frame, of named entries: `{ xx, yy, zz, xy, yz, xz }`";
    MOTOR: "`motor`", "motor entry", [inertia gear_ratio], "`{ inertia: ..., gear_ratio: ... }`";
    FRICTION: "`friction`", "friction entry", [viscous coulomb stribeck], "`{ viscous: ..., coulomb: ... }`";
    /// Coulomb friction by the direction of motion.
    DIRECTIONS: "`coulomb`", "direction", [positive negative], "`{ positive: ..., negative: ... }`";
    STRIBECK: "`stribeck`", "stribeck entry", [static velocity], "`{ static: ..., velocity: ... }`";
    SPRING: "`spring`", "spring entry", [stiffness rest], "`{ stiffness: ..., rest: ... }`";
    /// The cells of a joint that may stand beside its file.
    BESIDE_A_FILE: "a joint of the file", "cell", [motor friction spring limits torque_limit velocity_limit allow],
        "`{ friction: { ... }, motor: { ... } }`";
    /// The cells of a link that may stand beside its file.
    LINK_BESIDE_A_FILE: "a link of the file", "cell", [mass com inertia], "`{ mass: ..., com: ..., inertia: ... }`";
    BASE: "`base`", "base entry", [xyz rpy], "`{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }`";
    /// The body of a base that moves.
    FLOATING: "`floating`", "base entry", [mass com inertia inertia_at_origin allow],
        "`{ mass: ..., com: ..., inertia: ... }`";
    /// The same in a file, where `floating` is one of the words.
    FLOATING_IN_FILE: "`base`", "base entry", [floating mass com inertia inertia_at_origin allow],
        "`{ mass: ..., com: ..., inertia: ... }`";
    AT: "`at`", "placement entry", [xyz rpy], "`{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }`";
    FRAME: "a frame", "frame entry", [on xyz rpy mass com inertia inertia_at_origin allow],
        "`{ on: joint, xyz: [x, y, z], rpy: [roll, pitch, yaw] }`";
    TOOL: "`tool`", "tool entry", [xyz rpy mass com inertia inertia_at_origin allow],
        "`{ xyz: [x, y, z], rpy: [roll, pitch, yaw], mass: ..., com: ..., inertia: ... }`";
}

/// The words of a row that only the file of a joint has.
pub(crate) const OF_A_FILE: &[&str] =
    word_list![name type a alpha d theta on at gamma b mass com inertia inertia_at_origin];

pub(crate) const JOINT_TYPES: &[&str] = word_list![revolute prismatic];

/// The allowances of a row or the tool.
pub(crate) const ALLOWANCES_OF_BODY: &[&str] =
    word_list![odd_angle odd_com odd_gear_ratio odd_mass unphysical_inertia];

/// The word for a base that moves.
pub(crate) const MOVING: &str = "floating";

/// The word for the default set of functions.
pub(crate) const DEFAULT: &str = "default";
