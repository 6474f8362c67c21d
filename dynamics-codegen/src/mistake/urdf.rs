//! Mistakes in URDF files, and in what a call says about one.

use super::Mistake;
use crate::audience::Audience;
use crate::words::{all, either, number, shortened};

mistakes! {
    no_robot(found: &str => shortened) "expected `<robot>`, found `<{found}>` ({EXPANDED})";
    /// An element or a text of xacro, where a link, a joint or a number is read.
    xacro(what: &str => shortened)
        "`{what}` is left of xacro, in a place that is read: {EXPANDED}; if that leaves it there, remove it or write \
         its value";
    attribute_missing(element: &str, name: &str) "`<{element}>` has no `{name}`";
    element_missing(element: &str, name: &str) "`<{element}>` has no `<{name}>`";
    three_numbers(name: &str, count: usize) "`{name}` has three numbers, found {count}";
    twice(what: &str, name: &str => shortened) "there is a {what} `{name}` already";
    /// Roll, pitch or yaw of many turns.
    in_degrees(radians: f64 => number) [allow: allow("odd_angle", "in the call")]
        "`rpy` is in radians, and {radians} rad are more than two turns ({allow} accepts it)";
    /// An element or attribute in whose place another one was meant.
    misspelled(element: &str, what: &str, word: &str => shortened, right: &str)
        "unknown {what} `{word}` of `<{element}>`: did you mean `{right}`?";
    axis_of_no_length() "an axis has a direction: its length is zero here";
    no_path(first: &str => shortened, last: &str => shortened, root: &str => shortened)
        "no joints lead from `{first}` outwards to `{last}`: seen from there inwards the first link is `{root}`";
    two_parents(link: &str => shortened) "the link `{link}` is the child of another joint already: a robot is a tree";
    /// A chain that nothing moves.
    nothing_moves(first: &str => shortened, last: &str => shortened)
        "no joint between `{first}` and `{last}` moves: an arm has one at least";
    unsupported(joint: &str => shortened, kind: &str)
        "the joint `{joint}` is {kind}: an arm has revolute, continuous, prismatic and fixed joints";
    /// Joints that follow one another and stand beside the chain.
    circle(joint: &str => shortened)
        "the joint `{joint}` follows itself, by way of others: one of them has to move by itself";
    /// `rest` in both lists.
    rest_twice() "`rest` is locked and ignored: remove one of the two";
    ignored_on_chain(joint: &str => shortened) "`{joint}` is on the chain, and cannot be left out";
    lock_with_names(joint: &str => shortened)
        "`{joint}` is not on the chain: its position is a sum, product or quotient of numbers and `PI`, without \
         fields and `let`";
    negative_mass() "a mass cannot be negative";
    no_body(reason: &str) [allow: allow("unphysical_inertia", "in the call")]
        "no body has this inertia tensor: {reason} (published data can be like that: {allow} accepts it)";
    round_angles() "expected an angle between 0 and 0.1 rad: `round_angles: 1e-4`, for example";
}

/// How a file in the language that URDF is written by becomes one in URDF.
const EXPANDED: &str = "a file in xacro is expanded first: `xacro arm.urdf.xacro > arm.urdf`, \
                        after `pip install xacro` where there is no ROS";

/// The second of two elements of which only one is read.
pub(crate) fn repeated(element: &str, word: &str, (line, column): (usize, usize)) -> Mistake {
    Mistake::new(format!(
        "a second `<{word}>` in one `<{element}>`, the first stands in line {line}, column {column}: remove one of them"
    ))
}

/// A joint whose parent or child is no link.
pub(crate) fn unknown_link_of(joint: &str, link: &str, meant: Option<&str>) -> Mistake {
    let hint = meant.map_or(String::new(), |right| format!(": did you mean `{right}`?"));
    Mistake::new(format!(
        "the joint `{}` names the link `{}`, which is not there{hint}",
        shortened(joint),
        shortened(link)
    ))
}

/// `chain` left out.
///
/// `first` are the links to which no joint leads, and `last` those from which none does.
pub(crate) fn chain_missing(first: &[&str], last: &[&str]) -> Mistake {
    let from = first.first().unwrap_or(&"base_link");
    let to = last.first().unwrap_or(&"tool0");
    Mistake::advice(|audience| {
        let chain = audience.chain(from, to);
        let others = match last {
            [] | [_] => String::new(),
            _ => format!(" (the links at the ends of the tree are {})", all(last)),
        };
        format!(
            "missing `chain`, the arm's first and last link: write {chain}, for example{others}"
        )
    })
}

pub(crate) fn unknown_link(word: &str, meant: Option<&str>, known: &[&str]) -> Mistake {
    let hint = match meant {
        Some(right) => format!("did you mean `{right}`?"),
        None => format!("expected {}", either(known)),
    };
    Mistake::new(format!("unknown link `{}`: {hint}", shortened(word)))
}

/// A joint that may be made to stand still.
#[derive(Clone, Copy)]
pub(crate) struct Still<'a> {
    pub(crate) joint: &'a str,
    /// Its limits, rad or m.
    pub(crate) limits: Option<[f64; 2]>,
}

impl Still<'_> {
    /// How it is locked: at zero, or at the limit that is nearest to it.
    fn lock(self, audience: Audience) -> String {
        let [lower, upper] = self.limits.unwrap_or([0.0, 0.0]);
        audience.lock(self.joint, &number(0.0_f64.clamp(lower, upper)))
    }
}

/// `<mimic>` of a joint that is not there; `meant` is perhaps the right one.
pub(crate) fn unknown_leader(meant: Option<&str>) -> String {
    let hint = meant.map_or(String::new(), |right| format!(" (did you mean `{right}`?)"));
    format!("which is not there{hint}")
}

/// `<mimic>` of a joint that has no position.
pub(crate) const WITHOUT_POSITION: &str =
    "which has no position (it is neither revolute nor prismatic)";

/// `<mimic>` of a joint that cannot lead, and why it cannot.
pub(crate) fn no_leader(joint: Still, is_beside: bool, leader: &str, why: &str) -> Mistake {
    Mistake::advice(|audience| {
        let way_out = match is_beside {
            true => locked_or_left_out(joint, audience),
            false => format!(
                "lock it where it stands still, {}, or take the `<mimic>` away for a joint of its own",
                joint.lock(audience)
            ),
        };
        format!(
            "the joint `{}` follows `{}`, {why}: {way_out}",
            shortened(joint.joint),
            shortened(leader)
        )
    })
}

/// A joint on the chain that follows one beside it, which moves.
pub(crate) fn leader_off_chain(joint: Still, leader: Still) -> Mistake {
    Mistake::advice(|audience| {
        format!(
            "the joint `{}` follows `{}` (`<mimic>`), which is not on the chain: lock that where it stands still, {}, \
             or lock this one, {}, or take the `<mimic>` away for a joint of its own",
            shortened(joint.joint),
            shortened(leader.joint),
            leader.lock(audience),
            joint.lock(audience),
        )
    })
}

/// A joint beside the chain that follows one on it.
pub(crate) fn follower_off_chain(joint: Still, leader: &str) -> Mistake {
    Mistake::advice(|audience| {
        format!(
            "the joint `{}` follows `{}` (`<mimic>`), which moves, and is not on the chain itself: {}",
            shortened(joint.joint),
            shortened(leader),
            locked_or_left_out(joint, audience)
        )
    })
}

/// A movable joint that is not on the chain.
pub(crate) fn off_chain(joint: Still) -> Mistake {
    Mistake::advice(|audience| {
        format!(
            "the joint `{}` moves, and is not on the chain: {}",
            shortened(joint.joint),
            locked_or_left_out(joint, audience)
        )
    })
}

/// What can be done about a joint beside the chain.
fn locked_or_left_out(joint: Still, audience: Audience) -> String {
    let (lock, ignore) = (joint.lock(audience), audience.ignore(joint.joint));
    format!(
        "lock it where it stands still, {lock}, or leave it out with all that hangs on it, {ignore} (`rest` as a name is \
         all such joints)"
    )
}

/// A joint that stands still beside the chain, by its own lock, as one of the rest, or because it follows another one.
pub(crate) fn still_out_of_limits(
    joint: Still,
    position: f64,
    [lower, upper]: [f64; 2],
) -> Mistake {
    let [position, lower, upper] = [position, lower, upper].map(number);
    Mistake::advice(|audience| {
        format!(
            "`{}` would stand still at {position}, outside of its limits, {lower} to {upper}: {} is within them",
            shortened(joint.joint),
            joint.lock(audience)
        )
    })
}

/// A link of which functions have to know the mass. `joint` is that which moves it, where nothing beyond has a mass.
pub(crate) fn no_inertial(link: &str, joint: Option<&str>) -> Mistake {
    Mistake::advice(|audience| {
        let allow = audience.allow("no_inertia", "in the call");
        let singular = joint.map_or(String::new(), |joint| {
            let joint = shortened(joint);
            format!(
                " (no mass moves with `{joint}` then, and `forward_dynamics` returns an error unless the `tool` has one)"
            )
        });
        format!(
            "the link `{}` moves and has no `<inertial>`, nor has anything that is fixed to it: {allow} takes it as \
             massless{singular}; functions of the geometry alone need none, {}",
            shortened(link),
            audience.functions("forward_kinematics", "jacobian")
        )
    })
}
