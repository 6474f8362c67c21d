//! Mistakes about the base, mostly about one that moves.

use super::Mistake;
use crate::words::shortened;

mistakes! {
    /// A word for a base that stands.
    stands(word: &str) "`{word}` is not written: a base stands unless it is `floating`, and `{{ xyz, rpy }}` says where";
    /// `"floating"` in a call.
    in_quotes(word: &str) "`{word}` is a word of the table: write it without quotes";
    /// `floating = false`
    not_floating() "a base that stands is written without `floating`: remove it";
    /// The place of a base that moves.
    placed(word: &str => shortened)
        "`{word}` of a base that moves is no number of the table: its pose is the argument `base` of the functions";
    /// The body of a base that stands.
    body_of_standing(word: &str => shortened) [base: floating("mass: 3")]
        "`{word}` is of a base that moves, {base} for example: nothing depends on the body of a base that stands";
    /// `base: { floating: true }` in a call.
    word_in_braces() [base: floating("mass: 3")] "a base that moves is written {base}, for example";
    /// A base that has no body.
    without_mass(place: &str) [base: floating("mass: 3, inertia: sphere(0.2)"), allow: allow("odd_mass", place)]
        "nothing resists some motion of the base, and M is singular at every position: give the base a body, {base} for \
         example ({allow} accepts it)";
    /// The base has a mass and still turns freely about some axis.
    without_inertia(place: &str) [base: floating("mass: 3, inertia: sphere(0.2)"), allow: allow("odd_mass", place)]
        "nothing resists some turn of the base, and M is singular at every position: write its `inertia`, {base} for \
         example ({allow} accepts it)";
    missing_joints()
        "missing `joints`: write `joints: [name: revolute {{ ... }}, ...]`, or `joints: []` for the body of the base alone";
    /// A function whose values are arranged by joints alone.
    coefficients(function: &str)
        "`{function}` is of a robot whose base stands: `coriolis_matrix` and `coriolis_vector` are there for one that \
         moves";
    series(function: &str)
        "`{function}` is of a robot whose base stands: `forward_dynamics` is there for one that moves, and explicit \
         methods simulate it";
    inverse(function: &str)
        "`{function}` is of a robot whose base stands: one that moves reaches every pose, whatever the positions of its \
         joints";
    neglect()
        "`neglect` is for robots whose base stands, for it does not know how a base turns: leave it out";
    /// A function of the tip, where there are no joints.
    tip_without_joints(function: &str) [frames: frame("hand", "base"), asked: function_of(function, "hand")]
        "`{function}` is about the tip, and there are no joints: make a frame, {frames}, and request {asked}";
    /// A tool, where there are no joints.
    tool_without_joints() [frames: frame("tool", "base")]
        "a `tool` is at the tip, and there are no joints: write a frame in its place, {frames}";
}
