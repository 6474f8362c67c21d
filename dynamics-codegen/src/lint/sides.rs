//! Left and right sides that differ by one digit.

use std::collections::BTreeMap;

use super::body::Body;
use super::rule;
use crate::finding::Finding;

/// So many numbers other than zero have to agree.
const AGREE: usize = 3;

/// The words of both sides, in front of any others.
const WORDS: [[&str; 2]; 3] = [["left", "right"], ["Left", "Right"], ["LEFT", "RIGHT"]];

/// Letters of both sides, alone or beside one other letter, `l_arm` and `lf_foot`, or the first of a name, `larm`.
const LETTERS: [[&str; 2]; 2] = [["l", "r"], ["L", "R"]];

/// Pairs of links, each told at the second one.
pub(super) fn findings(bodies: &[Body]) -> Vec<Finding> {
    let named = bodies
        .iter()
        .enumerate()
        .map(|(index, body)| (&*body.name, index));
    let named: BTreeMap<&str, usize> = named.collect();
    let pairs = bodies.iter().enumerate().flat_map(|(index, body)| {
        let others = right_of(&body.name);
        let others = others.into_iter().filter_map(|name| named.get(&*name));
        others.map(move |other| [index.min(*other), index.max(*other)])
    });
    pairs
        .filter_map(|[first, second]| differing(&bodies[second], &bodies[first]))
        .collect()
}

/// The names that the right one of something may have whose left one has this name.
fn right_of(name: &str) -> Vec<String> {
    let mut names = Vec::new();
    for (at, _) in name.char_indices() {
        let (before, rest) = name.split_at(at);
        let replaced =
            |[left, right]: &[&str; 2]| Some([before, right, rest.strip_prefix(left)?].concat());
        names.extend(WORDS.iter().find_map(replaced));
        let letters =
            |word: &mut dyn Iterator<Item = char>| word.take_while(|c| c.is_alphabetic()).count();
        let beside = letters(&mut before.chars().rev()) + letters(&mut rest.chars().skip(1));
        if beside <= 1 || at == 0 {
            names.extend(LETTERS.iter().find_map(replaced));
        }
    }
    names
}

/// The finding if all numbers but one agree up to their signs, and that one by all but a digit.
fn differing(body: &Body, other: &Body) -> Option<Finding> {
    const NUMBERS: [&str; 10] = [
        "the mass",
        "x of its centre",
        "y of its centre",
        "z of its centre",
        "ixx",
        "iyy",
        "izz",
        "ixy",
        "iyz",
        "ixz",
    ];
    let [ours, theirs] = [body, other].map(numbers);
    let agree = |i: &usize| (ours[*i] - theirs[*i]).abs() <= 1e-9 * ours[*i].max(theirs[*i]);
    let mut differ = (0..NUMBERS.len()).filter(|i| !agree(i));
    let (only, None) = (differ.next()?, differ.next()) else {
        return None;
    };
    let agreeing = (0..NUMBERS.len())
        .filter(|i| agree(i) && ours[*i] > 0.0)
        .count();
    let digits = [ours[only], theirs[only]].map(|number| number.to_string());
    let is_slip = agreeing >= AGREE && strsim::osa_distance(&digits[0], &digits[1]) == 1;
    let place_of = |body: &Body| match only {
        0 => body.mass.1,
        1..4 => body.com.1,
        _ => body.tensor.1,
    };
    let (line, _) = place_of(other).position();
    is_slip.then(|| {
        let (own, others) = (ours[only], theirs[only]);
        rule::left_and_right_differ(
            place_of(body),
            &body.name,
            &other.name,
            NUMBERS[only],
            own,
            line,
            others,
        )
    })
}

/// Sizes alone: the other side is a mirror's.
fn numbers(body: &Body) -> [f64; 10] {
    let (mass, com, tensor) = (body.mass.0, body.com.0, body.tensor.0);
    let mut numbers = [mass, com[0], com[1], com[2], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    numbers[4..].copy_from_slice(&tensor);
    numbers.map(f64::abs)
}

#[cfg(test)]
mod tests {
    use super::right_of;

    #[test]
    fn names_of_both_sides_are_known() {
        for [left, right] in [
            ["left_arm", "right_arm"],
            ["arm_left_2", "arm_right_2"],
            ["LeftArm", "RightArm"],
            ["l_elbow", "r_elbow"],
            ["elbow_L", "elbow_R"],
            ["lf_foot", "rf_foot"],
            ["FL_calf", "FR_calf"],
            ["LElbow", "RElbow"],
            ["larm_link1", "rarm_link1"],
        ] {
            assert!(right_of(left).iter().any(|name| name == right), "{left}");
        }
        for none in ["ball", "shoulder", "hull_2", "", "arm"] {
            assert_eq!(right_of(none), [""; 0], "{none}");
        }
    }
}
