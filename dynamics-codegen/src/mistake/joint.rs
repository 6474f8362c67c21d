//! Mistakes in the rows of the table.

use std::fmt::Display;

use super::Mistake;
use crate::words::number;

mistakes! {
    none() [base: moving_base()] "no joints: a robot has at least one, or a base that moves, {base}";
    twice(name: &str) "there is a joint `{name}` already";
    /// `name(...)`
    in_parentheses() "the cells of a joint are written in braces: `name: revolute {{ ... }}`";
    /// `_` in place of a name.
    unnamed() "a joint needs a name: `_` is none";
    extra_word(name: &impl Display) "no word comes before a joint's name: write `{name}: ...`";
    /// `revolute { ... }`
    without_name(joint_type: &impl Display) "this joint has no name: write `name: {joint_type} {{ ... }}`";
    /// `name { ... }`
    without_type(name: &impl Display)
        "joint `{name}` has no type: write `{name}: revolute {{ ... }}` or `{name}: prismatic {{ ... }}`";
    /// A cell that belongs in another one.
    cell_elsewhere(word: &str, home: &str) "unknown cell `{word}`: it belongs in `{home}: {{ {word}: ... }}`";
    /// An entry below the diagonal.
    mirrored_entry(word: &str, entry: &str) "unknown tensor entry `{word}`: the tensor is symmetric, write `{entry}`";
    /// A decimal beyond a turn. `place` is where it can be allowed.
    angle_in_degrees(angle: f64 => number, place: &str) [allow: allow("odd_angle", place)]
        "angles are in radians: write `deg({angle})` for degrees ({allow} accepts {angle} rad)";
    /// Another angle beyond a turn, rad.
    more_than_a_turn(radians: f64 => number, place: &str) [allow: allow("odd_angle", place)]
        "an angle of more than a turn, {radians} rad: leave the whole turns out ({allow} accepts it)";
    /// `1.5708`: `right` is the multiple of a right angle that was meant.
    nearly_right(right: &str, place: &str) [allow: allow("odd_angle", place)]
        "nearly a right angle: write `{right}`, which is exact and makes the functions shorter ({allow} accepts it \
         as it stands)";
    /// `deg(1.5708)`
    degrees_of_right_angle(right: &str, place: &str) [allow: allow("odd_angle", place)]
        "`deg` takes degrees, and this is `{right}` in radians: write `{right}`, without `deg` ({allow} accepts it \
         as it stands)";
    /// `deg(PI/2)`
    degrees_of_pi(place: &str) [allow: allow("odd_angle", place)]
        "`deg` takes degrees, and what is written with `PI` is in radians: write `PI/2` without `deg` ({allow} \
         accepts it as it stands)";
    /// A centre of mass further from its frame, m, than anything in the arm is long. `place` is the row or the
    /// tool.
    far_com(distance: f64 => number, longest: f64 => number, place: &str) [allow: allow("odd_com", &format!("on the {place}"))]
        "a centre of mass {distance} m from its frame, in an arm whose longest part is {longest} m: lengths are in \
         m, `com` in the link frame ({allow} accepts it)";
    /// A length in mm, and the same in m. `place` is where it can be allowed.
    in_millimetres(length: f64 => number, right: f64 => rounded, place: &str) [allow: allow("odd_length", place)]
        "a length of {length} m: lengths are in m, and {length} mm are `{right}`; correct all lengths alike ({allow} \
         accepts them)";
    /// The mass of a body, kg, what it is if it was meant in that unit, g or mg, and the longest part of the arm, m.
    in_grams(mass: f64 => number, unit: &str, right: f64 => rounded, longest: f64 => rounded, place: &str)
        [allow: allow("odd_mass", place)]
        "a mass of {mass} kg in an arm whose longest part is {longest} m: masses are in kg, and {mass} {unit} are \
         `{right}`; correct all masses alike ({allow} accepts it)";
    /// A centre of mass and no mass.
    com_without_mass(place: &str) [allow: allow("odd_mass", &format!("on the {place}"))]
        "a centre of mass without a mass: write the {place}'s `mass` (`mass: 0` says that it has none, or {allow})";
    /// A tensor and no mass.
    tensor_without_mass(place: &str) [allow: allow("odd_mass", &format!("on the {place}"))]
        "a tensor without a mass: write the {place}'s `mass`; the moment about one axis alone needs none (`mass: 0` \
         says that there is none, or {allow})";
    /// A mass, an inertia or a coefficient below zero.
    negative(what: &str)
        {hint: if what.contains("friction") { ": write its magnitude, or 0 if there is none" } else { "" }}
        "{what} cannot be negative{hint}";
    /// `place` is the row or the tool.
    solid_without_mass(place: &str) "a solid's inertia needs the {place}'s `mass`";
    /// `place` is the row or the tool.
    no_body(reason: &str, place: &str) [allow: allow("unphysical_inertia", &format!("on the {place}"))]
        "no body has this inertia tensor: {reason} (published data can be like that: {allow} accepts it)";
    /// A tensor about the frame's origin beside one about the centre of mass.
    two_inertias()
        "`inertia` is about the centre of mass, `inertia_at_origin` about the frame's origin: remove one of the two";
    /// `place` is the row or the tool; `what` is missing there.
    cannot_be_moved(what: &str, place: &str)
        "a tensor about the frame's origin is moved to the centre of mass: write the {place}'s `{what}`";
    /// `rod(length = 2)`
    named_size(solid: &str, word: &impl Display)
        "the sizes of a solid have no names, found `{word} =`: only `axis = z` has one, in `{solid}` as elsewhere";
    /// `sphere(2, axis = z)`
    without_axis(solid: &str) "a {solid} has no axis: `rod` and `cylinder` have one";
    gear_ratio_zero() "a gear ratio of zero: a motor with inertia turns with its joint";
    gear_ratio_missing() [direct: cell("gear_ratio: 1")]
        "missing `gear_ratio`, motor speed over joint speed: write {direct} for a direct drive";
    /// The motor's speed over the joint's, below 1. `place` is where it can be allowed.
    slow_motor(ratio: f64 => number, inverse: f64 => rounded, place: &str) [allow: allow("odd_gear_ratio", place)]
        "a gear ratio of {ratio} is below 1, and the motor slower than its joint: motor speed over joint speed, the \
         inverse, is `{inverse}` ({allow} accepts {ratio})";
    /// One direction of two.
    direction_missing(word: &str) [coulomb: cell("coulomb: { positive: 0.5, negative: 0.4 }")]
        "missing `{word}`: write {coulomb}, for example";
    static_missing() [stribeck: cell(STRIBECK)]
        "missing `static`, the friction that holds the joint at rest: write {stribeck}, for example";
    stribeck_velocity_missing() [stribeck: cell(STRIBECK)]
        "missing `velocity`, over which static friction falls to Coulomb's: write {stribeck}, for example";
    stribeck_velocity_not_positive() "a Stribeck velocity is above zero";
    static_below_coulomb(coulomb: f64 => number) "static friction is not below Coulomb friction, {coulomb}";
    stiffness_missing() [spring: cell("spring: { stiffness: 200 }")]
        "missing `stiffness`, the spring's torque or force for each rad or m: write {spring}, for example";
    limits_swapped() "the lower limit comes first, and is below the upper one: `[lower, upper]`";
    /// The same in a URDF file, of which somebody else may be the author.
    limits_of_a_file_swapped() [allow: allow("odd_limits", "in the call")]
        "`lower` is above `upper` in this `<limit>`: exchange the two, or write {allow}, which takes the joint as \
         one without limits, as some programs do";
    limit_with_field() "a limit is a number: it does not depend on a field";
    /// The greatest torque or speed of a joint.
    limit_not_positive() "the greatest torque or speed is above zero: leave it out where there is none";
    /// A position of a revolute joint, rad.
    position_of_many_turns(size: f64 => number)
        "{size} rad are more than five turns: write `deg({size})` for degrees, or a multiple of `PI` for a joint \
         that turns so far";
    /// `fixed`
    fixed(name: &impl Display) [lock: lock(&name.to_string(), "0"), place: end_of_table()]
        "a joint that stands still is `revolute` or `prismatic` and locked, {lock}{place}; a body fixed to the last \
         link is the `tool`";
    /// As [`position_of_many_turns`], in the words of URDF, which has neither `deg` nor `PI`.
    limit_in_degrees(radians: f64) {degrees: number(radians), right: radians.to_radians()}
        [allow: allow("odd_limits", "in the call")]
        "`<limit>` is in radians, and {degrees} rad are more than five turns: {degrees} degrees are {right:.4} rad, and \
         a joint that turns so far is `continuous`, as which {allow} takes it";
}

/// A computed number in twelve digits: 1 / 0.49 is 2.04081632653.
fn rounded(x: f64) -> String {
    number(format!("{x:.11e}").parse().unwrap_or(x))
}

const STRIBECK: &str = "stribeck: { static: 0.8, velocity: 0.01 }";
