//! Mistakes in the rows of the table.

use std::fmt::Display;

use super::Mistake;
use crate::audience::Audience;
use crate::words::number;

pub(crate) fn none() -> Mistake {
    Mistake::new("no joints: a robot has at least one")
}

pub(crate) fn twice(name: &str) -> Mistake {
    Mistake::new(format!("there is a joint `{name}` already"))
}

/// `name(...)`
pub(crate) fn in_parentheses() -> Mistake {
    Mistake::new("the cells of a joint stand in braces: `name: revolute { ... }`")
}

/// `_` in place of a name.
pub(crate) fn unnamed() -> Mistake {
    Mistake::new("a joint needs a name: `_` is none")
}

pub(crate) fn extra_word(name: &impl Display) -> Mistake {
    Mistake::new(format!(
        "no word stands in front of a joint's name: write `{name}: ...`"
    ))
}

/// `revolute { ... }`
pub(crate) fn without_name(joint_type: &impl Display) -> Mistake {
    Mistake::new(format!(
        "this joint has no name: write `name: {joint_type} {{ ... }}`"
    ))
}

/// `name { ... }`
pub(crate) fn without_type(name: &impl Display) -> Mistake {
    Mistake::new(format!(
        "joint `{name}` has no type: \
         write `{name}: revolute {{ ... }}` or `{name}: prismatic {{ ... }}`"
    ))
}

/// `fixed`
pub(crate) fn fixed(name: &impl Display) -> Mistake {
    Mistake::advice(|audience| {
        let lock = audience.lock(&name.to_string(), "0");
        let place = match audience {
            Audience::Call => " at the end of the table",
            Audience::File | Audience::Command => "",
        };
        format!(
            "a joint that stands still is `revolute` or `prismatic` and locked, {lock}{place}; a body fixed to the \
             last link is the `tool`"
        )
    })
}

/// A cell that belongs into another one.
pub(crate) fn cell_elsewhere(word: &str, home: &str) -> Mistake {
    Mistake::new(format!(
        "unknown cell `{word}`: it belongs in `{home}: {{ {word}: ... }}`"
    ))
}

/// An entry below the diagonal.
pub(crate) fn mirrored_entry(word: &str, entry: &str) -> Mistake {
    Mistake::new(format!(
        "unknown tensor entry `{word}`: the tensor is symmetric, write `{entry}`"
    ))
}

/// A decimal beyond a turn. `place` is where it can be allowed.
pub(crate) fn angle_in_degrees(angle: f64, place: &str) -> Mistake {
    let angle = number(angle);
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_angle", place);
        format!(
            "angles are in radians: write `deg({angle})` for degrees ({allow} accepts {angle} rad)"
        )
    })
}

/// Another angle beyond a turn, rad.
pub(crate) fn more_than_a_turn(radians: f64, place: &str) -> Mistake {
    let radians = number(radians);
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_angle", place);
        format!(
            "an angle of more than a turn, {radians} rad: leave the whole turns out ({allow} accepts it)"
        )
    })
}

/// `1.5708`: `right` is the multiple of a right angle that was meant.
pub(crate) fn nearly_right(right: &str, place: &str) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_angle", place);
        format!(
            "nearly a right angle: write `{right}`, which is exact and makes the functions shorter \
             ({allow} accepts it as it stands)"
        )
    })
}

/// `deg(1.5708)`
pub(crate) fn degrees_of_right_angle(right: &str, place: &str) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_angle", place);
        format!(
            "`deg` takes degrees, and this is `{right}` in radians: write `{right}`, without `deg` \
             ({allow} accepts it as it stands)"
        )
    })
}

/// `deg(PI/2)`
pub(crate) fn degrees_of_pi(place: &str) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_angle", place);
        format!(
            "`deg` takes degrees, and what is written with `PI` is in radians: write `PI/2` without `deg` \
             ({allow} accepts it as it stands)"
        )
    })
}

/// A centre of mass further from its frame, m, than anything in the arm is long. `place` is the row or the
/// tool.
pub(crate) fn far_com(distance: f64, longest: f64, place: &str) -> Mistake {
    let (distance, longest) = (number(distance), number(longest));
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_com", &format!("on the {place}"));
        format!(
            "a centre of mass {distance} m from its frame, in an arm whose longest part is {longest} m: lengths \
             are in m, `com` in the link frame ({allow} accepts it)"
        )
    })
}

/// A centre of mass and no mass.
pub(crate) fn com_without_mass(place: &str) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_mass", &format!("on the {place}"));
        format!(
            "a centre of mass without a mass: write the {place}'s `mass` \
             (`mass: 0` says that it has none, or {allow})"
        )
    })
}

/// A tensor and no mass.
pub(crate) fn tensor_without_mass(place: &str) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_mass", &format!("on the {place}"));
        format!(
            "a tensor without a mass: write the {place}'s `mass`; the moment about one axis alone needs none \
             (`mass: 0` says that there is none, or {allow})"
        )
    })
}

/// A mass, an inertia or a coefficient below zero.
pub(crate) fn negative(what: &str) -> Mistake {
    Mistake::new(format!("{what} cannot be negative"))
}

/// `place` is the row or the tool.
pub(crate) fn solid_without_mass(place: &str) -> Mistake {
    Mistake::new(format!("a solid's inertia needs the {place}'s `mass`"))
}

/// `place` is the row or the tool.
pub(crate) fn no_body(reason: &str, place: &str) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("unphysical_inertia", &format!("on the {place}"));
        format!(
            "no body has this inertia tensor: {reason} \
             (published data can be like that: {allow} accepts it)"
        )
    })
}

/// A tensor about the frame's origin beside one about the centre of mass.
pub(crate) fn two_inertias() -> Mistake {
    Mistake::new(
        "`inertia` is about the centre of mass, `inertia_at_origin` about the frame's origin: remove one of the two",
    )
}

/// `place` is the row or the tool; `what` is missing there.
pub(crate) fn cannot_be_moved(what: &str, place: &str) -> Mistake {
    Mistake::new(format!(
        "a tensor about the frame's origin is moved to the centre of mass: write the {place}'s `{what}`"
    ))
}

/// `rod(length = 2)`
pub(crate) fn named_size(solid: &str, word: &impl Display) -> Mistake {
    Mistake::new(format!(
        "the sizes of a solid have no names, found `{word} =`: only `axis = z` has one, in `{solid}` as \
         elsewhere"
    ))
}

/// `sphere(2, axis = z)`
pub(crate) fn without_axis(solid: &str) -> Mistake {
    Mistake::new(format!(
        "a {solid} has no axis: `rod` and `cylinder` have one"
    ))
}

pub(crate) fn gear_ratio_zero() -> Mistake {
    Mistake::new("a gear ratio of zero: a motor with inertia turns with its joint")
}

pub(crate) fn gear_ratio_missing() -> Mistake {
    Mistake::advice(|audience| {
        let direct = audience.cell("gear_ratio: 1");
        format!(
            "missing `gear_ratio`, motor speed over joint speed: write {direct} for a direct drive"
        )
    })
}

/// One direction of two.
pub(crate) fn direction_missing(word: &str) -> Mistake {
    Mistake::advice(|audience| {
        let coulomb = audience.cell("coulomb: { positive: 0.5, negative: 0.4 }");
        format!("missing `{word}`: write {coulomb}, for example")
    })
}

const STRIBECK: &str = "stribeck: { static: 0.8, velocity: 0.01 }";

pub(crate) fn static_missing() -> Mistake {
    Mistake::advice(|audience| {
        let stribeck = audience.cell(STRIBECK);
        format!(
            "missing `static`, the friction that holds the joint at rest: write {stribeck}, for example"
        )
    })
}

pub(crate) fn stribeck_velocity_missing() -> Mistake {
    Mistake::advice(|audience| {
        let stribeck = audience.cell(STRIBECK);
        format!(
            "missing `velocity`, over which static friction falls to Coulomb's: write {stribeck}, for example"
        )
    })
}

pub(crate) fn stribeck_velocity_not_positive() -> Mistake {
    Mistake::new("a Stribeck velocity is above zero")
}

pub(crate) fn static_below_coulomb(coulomb: f64) -> Mistake {
    Mistake::new(format!(
        "static friction is not below Coulomb friction, {}",
        number(coulomb)
    ))
}

pub(crate) fn stiffness_missing() -> Mistake {
    Mistake::new(
        "missing `stiffness`, the spring's torque or force for each rad or m: \
         write `spring: { stiffness: 200 }`, for example",
    )
}

pub(crate) fn limits_swapped() -> Mistake {
    Mistake::new("the lower limit comes first, and is below the upper one: `[lower, upper]`")
}

/// The same in a URDF file, of which somebody else may be the author.
pub(crate) fn limits_of_a_file_swapped() -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("odd_limits", "in the call");
        format!(
            "`lower` is above `upper` in this `<limit>`: exchange the two, or write {allow}, which takes the joint as one \
             without limits, as some programs do"
        )
    })
}

pub(crate) fn limit_with_field() -> Mistake {
    Mistake::new("a limit is a number: it does not depend on a field")
}

/// As [`position_of_many_turns`], in the words of URDF, which has neither `deg` nor `PI`.
pub(crate) fn limit_in_degrees(radians: f64) -> Mistake {
    let degrees = number(radians);
    Mistake::new(format!(
        "`<limit>` is in radians, and {degrees} rad are more than five turns: {degrees} degrees are {:.4} rad, and a \
         joint that turns so far is `continuous`",
        radians.to_radians()
    ))
}

/// A position of a revolute joint, rad.
pub(crate) fn position_of_many_turns(size: f64) -> Mistake {
    let size = number(size);
    Mistake::new(format!(
        "{size} rad are more than five turns: write `deg({size})` for degrees, or a multiple of \
         `PI` for a joint that turns so far"
    ))
}
