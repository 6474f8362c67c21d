//! Left and right sides that differ by one digit.

use super::body::Body;
use super::rule::{self, Finding};

/// So many numbers other than zero have to agree.
const AGREE: usize = 3;

/// Parts of names that differ between two sides, the letters that they share left out.
const SIDES: [[&str; 2]; 3] = [["lef", "righ"], ["Lef", "Righ"], ["LEF", "RIGH"]];
const LETTERS: [[&str; 2]; 2] = [["l", "r"], ["L", "R"]];

/// Pairs of links, each told at the second one.
pub(super) fn findings(bodies: &[Body]) -> Vec<Finding> {
    let mut found = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let others = bodies[..index]
            .iter()
            .filter(|other| are_sides(&other.name, &body.name));
        found.extend(others.filter_map(|other| differing(body, other)));
    }
    found
}

/// The finding if all numbers but one agree up to their signs, and that one by all but a digit.
fn differing(body: &Body, other: &Body) -> Option<Finding> {
    const WORDS: [&str; 10] = [
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
    let mut differ = (0..WORDS.len()).filter(|i| !agree(i));
    let (only, None) = (differ.next()?, differ.next()) else {
        return None;
    };
    let agreeing = (0..WORDS.len())
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
            WORDS[only],
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

/// Whether two names are those of one thing on both sides: `left_arm` and `right_arm`, `l_arm`, `lf_foot`, `FL`.
fn are_sides(one: &str, other: &str) -> bool {
    let [a, b] = [one, other].map(|name| name.chars().collect::<Vec<char>>());
    let before = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
    let shared = a.len().min(b.len()) - before;
    let behind = a
        .iter()
        .rev()
        .zip(b.iter().rev())
        .take(shared)
        .take_while(|(a, b)| a == b)
        .count();
    let [left, right] =
        [&a, &b].map(|name| name[before..name.len() - behind].iter().collect::<String>());
    let is_one_of = |sides: &[[&str; 2]]| {
        sides
            .iter()
            .any(|[l, r]| (left == *l && right == *r) || (left == *r && right == *l))
    };
    // A letter alone, or one of two, `l_arm`, `lf_foot`, `FL`; or the first one of all, `larm`.
    let word = |letters: &mut dyn Iterator<Item = &char>| {
        letters.take_while(|c| c.is_alphabetic()).count()
    };
    let beside = word(&mut a[..before].iter().rev()) + word(&mut a[before..].iter().skip(1));
    is_one_of(&SIDES) || (is_one_of(&LETTERS) && (beside <= 1 || before == 0))
}

#[cfg(test)]
mod tests {
    use super::are_sides;

    #[test]
    fn names_of_both_sides_are_known() {
        for [one, other] in [
            ["left_arm", "right_arm"],
            ["arm_right_2", "arm_left_2"],
            ["LeftArm", "RightArm"],
            ["l_elbow", "r_elbow"],
            ["elbow_L", "elbow_R"],
            ["lf_foot", "rf_foot"],
            ["FL_calf", "FR_calf"],
            ["LElbow", "RElbow"],
            ["larm_link1", "rarm_link1"],
        ] {
            assert!(are_sides(one, other), "{one}");
        }
        for [one, other] in [
            ["ball", "barl"],
            ["left_arm", "left_arm"],
            ["left_arm", "right_leg"],
            ["link_1", "link_2"],
            ["", ""],
            ["l", "rr"],
        ] {
            assert!(!are_sides(one, other), "{one}");
        }
    }
}
