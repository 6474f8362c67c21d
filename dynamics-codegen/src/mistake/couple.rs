//! Mistakes in joints that follow others.

use super::{Mistake, hint};
use crate::words::{all, quoted, shortened};

mistakes! {
    none() "no joint follows another one: name one, `[follower = factor * leader + offset]`, or leave `couple` out";
    twice(name: &str) "`{name}` follows twice: a joint follows one other joint";
    itself(name: &str) "`{name}` follows itself: name the joint that moves it";
    locked(name: &str) "`{name}` is locked, and follows another joint: leave it out of `lock` or of `couple`";
    limits(name: &str, leader: &str) "`{name}` follows `{leader}`, and so do its limits: write them at `{leader}`";
    /// A position in which no joint is named.
    no_leader(name: &str) [lock: lock(name, "position")]
        "no joint is named that `{name}` follows: write `{name} = factor * leader + offset`, or {lock} where it \
         stands still";
    two_leaders(name: &str, leaders: &[&str] => all)
        "`{name}` would follow two joints, {leaders}: a joint follows one other joint";
    not_linear(name: &str, leader: &str)
        "`{name}` follows `{leader}` by a factor and an offset: write `factor * {leader} + offset`";
    factor_zero(name: &str, leader: &str) [lock: lock(name, "position")]
        "the factor of `{leader}` is zero: where `{name}` stands still, write {lock}";
    /// Joints that follow one another: the names, the first one again at the end.
    circle(names: &[&str]) {first: names[0], chain: quoted(&names[1..], ", which follows ")}
        "`{first}` follows {chain}: one of them has to move by itself";
    /// A name in a position that is neither a joint nor a value.
    unknown_leader(word: &str => shortened, meant: Option<&str>, joints: &[&str])
        {hint: hint(meant, joints, "the joints are")} "unknown name `{word}`: {hint}";
}
