//! The rules of files alone: each has its severity, its text and its remedy here, and nowhere else.

use crate::finding::Finding;
use crate::finding::Severity::{self, Note, Warning};
use crate::place::Place;
use crate::words::{number, shortened, visible};

/// A rule.
#[derive(Debug)]
pub struct Rule {
    /// Its name.
    pub name: &'static str,
    /// The weight of what breaks it.
    pub severity: Severity,
    /// The kind of thing that breaks it.
    pub about: &'static str,
}

/// A finding of which nothing acts on a terminal, whatever words of a file it has.
fn found(place: Place, rule: &'static str, severity: Severity, texts: [String; 2]) -> Finding {
    let (line, column) = place.position();
    let [message, remedy] = texts.map(|text| text.chars().map(visible).collect());
    Finding {
        line,
        column,
        remedy: Some(remedy),
        ..Finding::of_all(rule, severity, message)
    }
}

/// Makes a function of each rule, of its name, its arguments (`=> shown` shows one by that function), the message and the
/// remedy, and the list of all.
macro_rules! rules {
    ($(
        #[doc = $about:literal]
        $severity:ident $name:ident($($given:ident: $type:ty $(=> $shown:ident)?),*) $message:literal, $remedy:literal;
    )*) => {
        /// All rules of files alone.
        pub const RULES: &[Rule] = &[$(Rule {
            name: stringify!($name),
            severity: $severity,
            about: $about,
        }),*];
        $(
            #[doc = $about]
            pub(super) fn $name(place: Place, $($given: $type),*) -> Finding {
                $($(let $given = $shown($given);)?)*
                let texts = [format!($message), format!($remedy)];
                found(place, stringify!($name), $severity, texts)
            }
        )*
    };
}

rules! {
    /// A joint that moves by itself, with a greatest effort or velocity of 0.
    Warning effort_zero(joint: &str => shortened, what: &str)
        "the joint `{joint}` moves, and has the greatest {what} 0",
        "write the greatest of the drive: with 0 a simulator holds the joint, or takes it as one without limit";
    /// A mass of 0 on a link that has a geometry.
    Warning no_mass_but_geometry(link: &str => shortened)
        "the link `{link}` has a geometry and the mass 0", "write its mass, or leave out `<inertial>` of a link that is a mark alone";
    /// An inertia of which no body inside the link's own geometry comes near.
    Warning inertia_far_from_geometry(link: &str => shortened, radius: f64 => short, extent: f64 => short, hint: String)
        "the inertia of `{link}` is that of a body whose mass is {radius} m from its centre, and its geometry reaches {extent} m",
        "compare mass and inertia with the geometry, kg m^2 and m{hint}";
    /// An inertia that a body of that mass hardly has: of more density than any metal, or far beyond the robot.
    Warning inertia_far_from_uniform(link: &str => shortened, radius: f64 => short, why: &str, hint: String)
        "the inertia of `{link}` is that of a body whose mass is {radius} m from its centre, {why}",
        "compare it with that of a uniform body of this mass, kg m^2{hint}";
    /// A centre of mass far away from the joints and the geometry of its own link.
    Warning centre_outside(link: &str => shortened, distance: f64 => short, extent: f64 => short, hint: String)
        "the centre of mass of `{link}` is {distance} m beside its link, in a robot whose longest part is {extent} m",
        "write it in the frame of the link, in m{hint}";
    /// The mass of a link that would be plausible in g or in mg.
    Warning mass_in_other_unit(link: &str => shortened, mass: f64 => number, longest: f64 => short, right: f64 => short, unit: &str)
        "the link `{link}` has {mass} kg, in a robot whose longest part is {longest} m",
        "masses are in kg: {mass} {unit} are {right} kg";
    /// A geometry that is thousands of times larger than the robot.
    Warning geometry_in_millimetres(link: &str => shortened, size: f64 => short, longest: f64 => short)
        "the geometry of `{link}` reaches {size} m, and the longest way between joints is {longest} m",
        "write sizes in m, as the places of the joints";
    /// A mass of the whole robot that is too large or too small for its length.
    Warning total_mass(total: f64 => short, longest: f64 => short)
        "all links together have {total} kg, and the robot is {longest} m long", "compare the sum with a scale, kg";
    /// Two sides of a robot of which one number differs by one digit.
    Warning left_and_right_differ(one: &str => shortened, other: &str => shortened, what: &str, own: f64 => number, line: usize, others: f64 => number)
        "`{one}` has {what} {own}, and `{other}` in line {line} {others}: the other numbers of their bodies agree",
        "correct the digit in one of the two";
    /// An angle that is a quarter turn in a few digits.
    Warning nearly_quarter_turns(joint: &str => shortened, angles: &str)
        "the joint `{joint}` has angles that are quarter turns in a few digits: {angles}",
        "write 1.5707963267948966 for a quarter turn and 3.141592653589793 for half of a turn, or read the file with \
         `--round-angles`";
    /// The axis of a joint, whose length is not 1.
    Warning axis_not_unit(joint: &str => shortened, length: f64 => short)
        "the axis of the joint `{joint}` has the length {length}",
        "write a direction of length 1: some programs take its length as a factor of the position";
    /// A name that other tools refuse.
    Warning name_of_no_other_tool(what: &str, name: &str => shortened, why: &str)
        "other tools refuse the {what} `{name}`: {why}", "write letters, digits, `_`, `-` and `.`";
    /// Gravity that points along the z axis, upwards in most books.
    Warning gravity_along_z(gravity: f64 => number)
        "gravity is {gravity} m/s^2 along +z: things fall upwards where z points up",
        "write [0, 0, -9.81], or say by `base` how the arm is mounted, if z of its base points down";
    /// A planar arm, drawn with y upwards, of which gravity points along y.
    Warning falls_upwards(gravity: f64 => number)
        "gravity is {gravity} m/s^2 along +y, in the plane of the arm: if it is stretched along x, it falls upwards where y \
         points up",
        "write [0, -9.81, 0]";
    /// A convention by which the centres of mass are beside the links, while they are on them by the other one.
    Warning other_convention(written: &str, other: &str)
        "by the convention `{written}` every centre of mass is beside its link, and by `{other}` on it",
        "write `{other}`, or the table again by the convention that is named";
    /// A base that moves, or alone could move.
    Note moving_base(options: &str)
        "the base of this robot moves", "other commands read the file with `{options}`";
}

/// A computed number in three digits.
fn short(x: f64) -> String {
    number(format!("{x:.2e}").parse().unwrap_or(x))
}
