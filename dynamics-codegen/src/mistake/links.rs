//! Mistakes in the tree of links of a file, and in what a call says about one.

use super::Mistake;
use crate::audience::Audience;
use crate::limits::MOST_LISTED;
use crate::words::{all, number, quoted, shortened};

/// The names of these rules begin with that of the format of which trees were read first.
macro_rules! rule {
    ($name:ident) => {
        concat!("urdf::", stringify!($name))
    };
}

mistakes! {
    /// A body beside a file, of which the first link is that of the base.
    body_beside()
        "the first link of the file is the body of the base: write `floating` alone, and its mass and inertia in the \
         file";
    twice(what: &str, name: &str => shortened) "there is a {what} `{name}` already";
    no_path(first: &str => shortened, last: &str => shortened, root: &str => shortened)
        "no joints lead from `{first}` outwards to `{last}`: seen from there inwards the first link is `{root}`";
    two_parents(link: &str => shortened) "the link `{link}` is the child of another joint already: a robot is a tree";
    /// A name that stands in `chain` twice.
    link_twice(link: &str => shortened) [chain: entry("chain")]
        "`{link}` is in {chain} twice: remove one of the two";
    /// A tip that the joints to another one pass.
    on_the_way(link: &str => shortened, tip: &str => shortened)
        "`{link}` is on the way to `{tip}`, and belongs to the robot without being named: remove it";
    /// Joints of which each one hangs on the next.
    circle_of_links(link: &str => shortened)
        "the joints lead in a circle, from `{link}` outwards to `{link}` again: a robot is a tree, and no joint leads to \
         the link at which it begins";
    /// Several links to which no joint leads; `largest` carries the most joints.
    several_trees(roots: &[&str] => all, largest: &str) [chain: chain(&[largest])]
        "the file has several trees, which begin at {roots}: name the link at which the robot begins, {chain} for example";
    /// A tree that nothing moves; `last` is one of its tips, if there are any.
    nothing_moves(first: &str => shortened, last: Option<&str>)
        {which: last.map_or(format!("that `{first}` carries"), |last| format!("between `{first}` and `{}`", shortened(last)))}
        [base: moving_base()]
        "no joint {which} moves: a robot has one at least, or a base that moves, {base}";
    /// A joint that has no position of one number. A robot may begin at the first of `links`, which are behind it, and
    /// lead to the others. Where the joint `is_needed` it cannot be left out: it is on the way to a tip, or nothing else moves.
    unsupported(joint: &str, kind: &str, links: &[&str], is_needed: bool)
        {name: shortened(joint), alike: joints_alike(kind), floats: kind == "floating"}
        [way_out: without(joint, links, is_needed, floats)]
        "the joint `{name}` is {kind}: a robot of a file has revolute, continuous, prismatic and fixed joints{alike}{way_out}";
    /// Joints that follow one another and stand beside the chain.
    circle(joint: &str => shortened)
        "the joint `{joint}` follows itself, by way of others: one of them has to move by itself";
    /// `rest` in both lists.
    rest_twice() "`rest` is locked and ignored: remove one of the two";
    ignored_on_chain(joint: &str => shortened) [chain: entry("chain")]
        "`{joint}` is on the way to a tip that {chain} names, and cannot be left out";
    lock_with_names(joint: &str => shortened)
        "`{joint}` is not on the chain: its position is a sum, product or quotient of numbers and `PI`, without \
         fields and `let`";
    /// The same of all joints beside the chain.
    rest_with_names()
        "`rest` is all joints beside the chain: their position is a sum, product or quotient of numbers and `PI`, \
         without fields and `let`";
    negative_mass() "a mass cannot be negative";
    no_body(reason: &str) [allow: allow("unphysical_inertia", "in the call")]
        "no body has this inertia tensor: {reason} (published data can be like that: {allow} accepts it)";
    /// A joint whose parent or child is no link.
    unknown_link_of(joint: &str => shortened, link: &str => shortened, meant: Option<&str>)
        {hint: meant.map_or(String::new(), |right| format!(": did you mean `{right}`?"))}
        "the joint `{joint}` names the link `{link}`, which is not there{hint}";
    /// `rest` without tips. `first` are the links to which no joint leads, and `last` those from which none does.
    rest_of_nothing(first: &[&str], last: &[&str])
        {from: first.first().unwrap_or(&"base_link"), to: last.first().unwrap_or(&"tool0"), others: other_ends(last)}
        [chain: chain(&[from, to])]
        "`rest` is all joints beside a chain, and nothing is beside a whole tree: name its first link and its tips, \
         {chain} for example{others}, or the joints that are meant";
    /// A joint that follows one which cannot lead, and why that cannot.
    no_leader(joint: Still, is_beside: bool, leader: &str => shortened, why: &str, follower: &str)
        {name: shortened(joint.joint)} [lock: lock_still(joint), way_out: lock_or_leave_out(joint)]
        "the joint `{name}` follows `{leader}`, {why}: {way_out}" if is_beside
        else "the joint `{name}` follows `{leader}`, {why}: lock it where it stands still, {lock}, or take the `{follower}` \
              away for a joint of its own";
    /// A joint on the chain that follows one beside it, which moves.
    leader_off_chain(joint: Still, leader: Still, follower: &str)
        {name: shortened(joint.joint), leader_name: shortened(leader.joint)}
        [one: lock_still(leader), other: lock_still(joint)]
        "the joint `{name}` follows `{leader_name}` (`{follower}`), which is not on the chain: lock that where it stands \
         still, {one}, or lock this one, {other}, or take the `{follower}` away for a joint of its own";
    /// A joint beside the chain that follows one on it.
    follower_off_chain(joint: Still, leader: &str => shortened, follower: &str)
        {name: shortened(joint.joint)} [way_out: lock_or_leave_out(joint)]
        "the joint `{name}` follows `{leader}` (`{follower}`), which moves, and is not on the chain itself: {way_out}";
    /// A movable joint that is not on the chain.
    off_chain(joint: Still) {name: shortened(joint.joint)} [chain: entry("chain"), way_out: lock_or_leave_out(joint)]
        "the joint `{name}` moves, and is not on the chain: name a tip behind it in {chain}, {way_out}";
    /// A joint that stands still beside the chain, by its own lock, as one of the rest, or because it follows another one.
    still_out_of_limits(joint: Still, position: f64 => number, limits: [f64; 2])
        {name: shortened(joint.joint), lower: number(limits[0]), upper: number(limits[1])} [lock: lock_still(joint)]
        "`{name}` would stand still at {position}, outside of its limits, {lower} to {upper}: {lock} is within them";
    /// Links of which functions have to know the mass. `joints` are those that move one where nothing beyond has a mass.
    no_inertial(links: &[&str], joints: &[&str], body: &str)
        {is_one: links.len() == 1, singular: singular(joints), names: listed(links)}
        [allow: allow("no_inertia", "in the call"), functions: functions("forward_kinematics", "jacobian")]
        "the link {names} moves and has no `{body}`, nor has anything that is fixed to it: {allow} takes it as \
         massless{singular}; functions of the geometry alone need none, {functions}" if is_one
        else "the links {names} move and have no `{body}`, nor has anything that is fixed to them: {allow} takes them \
         as massless{singular}; functions of the geometry alone need none, {functions}";
}

/// Joints of the known kinds that move a link as another kind does.
fn joints_alike(kind: &str) -> &'static str {
    match kind {
        "planar" => {
            ", of which two prismatic ones and a revolute one, with links without mass between them, move alike"
        }
        "spherical" | "ball" => {
            ", of which three revolute ones, with links without mass between them, move alike"
        }
        _ => "",
    }
}

/// The links at the ends of the tree, if there are several.
fn other_ends(last: &[&str]) -> String {
    match last {
        [] | [_] => String::new(),
        _ => format!(" (the links at the ends of the tree are {})", all(last)),
    }
}

fn singular(joints: &[&str]) -> String {
    if joints.is_empty() {
        return String::new();
    }
    format!(
        " (no mass moves with {} then, and `forward_dynamics` returns an error unless the `tool` has one)",
        listed(joints)
    )
}

/// The first of many names, and how many more there are.
fn listed(names: &[&str]) -> String {
    match names.len().saturating_sub(MOST_LISTED) {
        0 => all(names),
        more => format!("{} and {more} more", quoted(&names[..MOST_LISTED], ", ")),
    }
}

/// A joint that may be made to stand still.
#[derive(Clone, Copy)]
pub(crate) struct Still<'a> {
    pub(crate) joint: &'a str,
    /// Its limits, rad or m.
    pub(crate) limits: Option<[f64; 2]>,
}

impl Audience {
    /// How a joint is locked: at zero, or at the limit that is nearest to it.
    fn lock_still(self, Still { joint, limits }: Still) -> String {
        let [lower, upper] = limits.unwrap_or([0.0, 0.0]);
        self.lock(joint, &number(0.0_f64.clamp(lower, upper)))
    }

    /// The ways out for a joint that no robot of a file has, behind the words of the message.
    fn without(self, joint: &str, links: &[&str], is_needed: bool, floats: bool) -> String {
        let base = match floats {
            true => format!(", on a base that moves, {}", self.moving_base()),
            false => String::new(),
        };
        let begin = format!("begin behind it, {}{base}", self.chain(links));
        let begin = Some(begin).filter(|_| !links.is_empty());
        let ignore = format!(
            "leave it out with all that hangs on it, {}",
            self.ignore(joint)
        );
        match (begin, is_needed) {
            (Some(begin), true) => format!(": {begin}"),
            (None, true) => String::new(),
            (Some(begin), false) => format!(": {begin}, or {ignore}"),
            (None, false) => format!(": {ignore}"),
        }
    }

    /// The ways out for a joint beside the chain.
    fn lock_or_leave_out(self, joint: Still) -> String {
        let (lock, ignore) = (self.lock_still(joint), self.ignore(joint.joint));
        format!(
            "lock it where it stands still, {lock}, or leave it out with all that hangs on it, {ignore} (`rest` as a \
             name is all such joints)"
        )
    }
}

/// Why a joint cannot lead that is not there; `meant` is perhaps the right one.
pub(crate) fn unknown_leader(meant: Option<&str>) -> String {
    let hint = meant.map_or(String::new(), |right| format!(" (did you mean `{right}`?)"));
    format!("which is not there{hint}")
}

/// Why a joint cannot lead that has no position.
pub(crate) const WITHOUT_POSITION: &str =
    "which has no position (it is neither revolute nor prismatic)";
