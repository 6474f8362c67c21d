//! Mistakes in joints that follow others.

use super::Mistake;
use crate::description::Name;
use crate::limits::MOST_FOLLOWERS;
use crate::words::{all, either, shortened};

pub(crate) fn none() -> Mistake {
    Mistake::new(
        "no joint follows another one: name one, `[follower = factor * leader + offset]`, or leave \
         `couple` out",
    )
}

/// `follower: leader`
pub(crate) fn by_colon(name: &Name) -> Mistake {
    Mistake::new(format!(
        "a joint follows another one by `=`: write `{name} = factor * leader + offset`"
    ))
}

pub(crate) fn twice(name: &str) -> Mistake {
    Mistake::new(format!(
        "`{name}` follows twice: a joint follows one other joint"
    ))
}

pub(crate) fn itself(name: &str) -> Mistake {
    Mistake::new(format!(
        "`{name}` follows itself: name the joint that moves it"
    ))
}

/// Joints that follow one another: the names, the first one again at the end.
pub(crate) fn circle(names: &[&str]) -> Mistake {
    let [first, others @ ..] = names else {
        return Mistake::new("joints follow one another in a circle");
    };
    let chain: Vec<String> = others.iter().map(|name| format!("`{name}`")).collect();
    Mistake::new(format!(
        "`{first}` follows {}: one of them has to move by itself",
        chain.join(", which follows ")
    ))
}

pub(crate) fn locked(name: &str) -> Mistake {
    Mistake::new(format!(
        "`{name}` is locked, and follows another joint: leave it out of `lock` or of `couple`"
    ))
}

pub(crate) fn limits(name: &str, leader: &str) -> Mistake {
    Mistake::new(format!(
        "`{name}` follows `{leader}`, and so do its limits: write them at `{leader}`"
    ))
}

/// A position in which no joint is named.
pub(crate) fn no_leader(name: &str) -> Mistake {
    Mistake::advice(|audience| {
        let lock = audience.lock(name, "position");
        format!(
            "no joint is named that `{name}` follows: write `{name} = factor * leader + offset`, or {lock} where it \
             stands still"
        )
    })
}

pub(crate) fn two_leaders(name: &str, leaders: [&str; 2]) -> Mistake {
    Mistake::new(format!(
        "`{name}` would follow two joints, {}: a joint follows one other joint",
        all(&leaders)
    ))
}

pub(crate) fn not_linear(name: &str, leader: &str) -> Mistake {
    Mistake::new(format!(
        "`{name}` follows `{leader}` by a factor and an offset: write `factor * {leader} + offset`"
    ))
}

pub(crate) fn factor_zero(name: &str, leader: &str) -> Mistake {
    Mistake::advice(|audience| {
        let lock = audience.lock(name, "position");
        format!("the factor of `{leader}` is zero: where `{name}` stands still, write {lock}")
    })
}

/// A name in a position that is neither a joint nor a value.
pub(crate) fn unknown_leader(word: &str, meant: Option<&str>, joints: &[&str]) -> Mistake {
    let hint = match meant {
        Some(right) => format!("did you mean `{right}`?"),
        None => format!("the joints are {}", either(joints)),
    };
    Mistake::new(format!("unknown name `{}`: {hint}", shortened(word)))
}

pub(crate) fn too_many() -> Mistake {
    Mistake::new(format!(
        "more joints follow others than an arm may have: at most {MOST_FOLLOWERS}"
    ))
}

pub(crate) fn too_many_rows(most: usize) -> Mistake {
    Mistake::new(format!(
        "too many joints for an arm in which some follow others: at most {most}, the followers included"
    ))
}
