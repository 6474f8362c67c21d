//! Words that a message offers in place of a wrong one.

pub use dynamics_symbolic::emit::visible;
use proc_macro2::Ident;

use crate::keys::word_list;

/// The known word that was meant by an unknown one: a near one, one of which it is the first part, or one that other
/// books call so.
pub(crate) fn meant(word: &str, known: &[&'static str]) -> Option<&'static str> {
    nearest(word, known)
        .or_else(|| begun(word, known))
        .or_else(|| elsewhere(word, known))
}

/// Whether the identifier is a keyword of Rust in any edition, which names nothing.
pub(crate) fn is_keyword(ident: &Ident) -> bool {
    KEYWORDS.contains(&ident.to_string().as_str())
}

/// Whether a word of a file can be the name of something in Rust.
pub(crate) fn is_name(word: &str) -> bool {
    has_letters_of_name(word) && !KEYWORDS.contains(&word)
}

/// Whether a word of a file can be a name in Rust, behind `r#` if it is a keyword.
pub(crate) fn is_raw_name(word: &str) -> bool {
    has_letters_of_name(word) && !["_", "crate", "self", "super", "Self"].contains(&word)
}

fn has_letters_of_name(word: &str) -> bool {
    let mut letters = word.chars();
    letters
        .next()
        .is_some_and(|first| first.is_alphabetic() || first == '_')
        && letters.all(|c| c.is_alphabetic() || c.is_ascii_digit() || c == '_')
}

/// The Rust reference, "Keywords": strict and reserved.
const KEYWORDS: [&str; 53] = [
    "_", "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum",
    "extern", "false", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "match", "mod",
    "move", "mut", "pub", "ref", "return", "self", "Self", "static", "struct", "super", "trait",
    "true", "type", "unsafe", "use", "where", "while", "abstract", "become", "box", "do", "final",
    "macro", "override", "priv", "try", "typeof", "unsized", "virtual", "yield",
];

/// The words as a choice: "`a`, `b` or `c`".
pub(crate) fn either(words: &[&str]) -> String {
    listed(words, "or")
}

/// The words as a list: "`a`, `b` and `c`".
pub(crate) fn all(words: &[&str]) -> String {
    listed(words, "and")
}

fn listed(words: &[&str], link: &str) -> String {
    match words {
        [rest @ .., last] if !rest.is_empty() => {
            format!("{} {link} `{last}`", quoted(rest, ", "))
        }
        words => quoted(words, ""),
    }
}

/// The words, with that between them.
pub(crate) fn quoted(words: &[&str], between: &str) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    quoted.join(between)
}

/// Letters of a text that a message shows.
pub(crate) const LONGEST: usize = 40;

/// The text, cut where it would fill the screen.
pub(crate) fn shortened(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// A number as it is written shortest: `90`, `0.5`, `1e300`.
pub(crate) fn number(x: f64) -> String {
    let (decimal, scientific) = (x.to_string(), format!("{x:e}"));
    if decimal.len() <= scientific.len() + 2 {
        decimal
    } else {
        scientific
    }
}

/// The known word that `word` was most likely meant to be.
///
/// Case does not count; words of one or two letters must agree, longer ones may be off
/// by one edit, from six letters on by two, from nine by three.
pub fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    known
        .iter()
        .map(|right| (edits(&word, &right.to_lowercase()), *right))
        .filter(|(edits, right)| *edits <= tolerated(word.len().min(right.len())))
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, right)| right)
}

/// The first of the known words of which `word` is a part from the start: `gear` of
/// `gear_ratio`.
fn begun<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let begins = |right: &&&str| {
        let rest = right.strip_prefix(word);
        rest.is_some_and(|rest| rest.starts_with('_'))
    };
    known.iter().find(begins).copied()
}

/// The known word for what other books and programs call `word`.
fn elsewhere<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let ours = ELSEWHERE
        .iter()
        .filter(|(_, others)| others.contains(&word));
    ours.filter_map(|(ours, _)| known.iter().find(|right| *right == ours))
        .next()
        .copied()
}

/// How a constant of Rust's standard library is written here.
pub(crate) fn constant_of_std(name: &str) -> Option<&'static str> {
    let known = OF_STD.iter().find(|(theirs, _)| *theirs == name);
    known.map(|(_, ours)| *ours)
}

/// `std::f64::consts`, and ours.
const OF_STD: [(&str, &str); 6] = [
    ("FRAC_PI_2", "PI/2"),
    ("FRAC_PI_3", "PI/3"),
    ("FRAC_PI_4", "PI/4"),
    ("FRAC_PI_6", "PI/6"),
    ("FRAC_PI_8", "PI/8"),
    ("TAU", "2*PI"),
];

/// Our words, and those of other books and programs for the same.
const ELSEWHERE: &[(&str, &[&str])] = &[
    ("alpha", word_list![twist]),
    ("a", word_list![length]),
    ("d", word_list![offset]),
    ("theta", word_list![angle]),
    ("mass", word_list![m weight]),
    ("com", word_list![cog center_of_mass centre_of_mass]),
    ("inertia", word_list![tensor]),
    ("inertia_at_origin", word_list![inertia_about_origin]),
    ("motor", word_list![actuator]),
    ("friction", word_list![damping]),
    ("viscous", word_list![damping]),
    ("gear_ratio", word_list![ratio]),
    ("torque_limit", word_list![effort max_torque]),
    ("velocity_limit", word_list![max_velocity speed_limit]),
    ("spring", word_list![elasticity]),
    ("stiffness", word_list![k]),
    ("rest", word_list![neutral]),
    ("spring_vector", word_list![K]),
    ("revolute", word_list![R hinge rotary rotational continuous]),
    ("prismatic", word_list![P linear sliding]),
    (
        "standard",
        word_list![classic classical sdh paul spong distal],
    ),
    ("modified", word_list![craig mdh khalil proximal]),
    ("joints", word_list![rows table]),
    ("mass_matrix", word_list![M inertia_matrix crba]),
    ("coriolis_vector", word_list![V]),
    ("coriolis_matrix", word_list![C]),
    ("gravity_vector", word_list![G]),
    ("inverse_dynamics", word_list![tau rnea]),
    ("forward_dynamics", word_list![qdd aba]),
    ("forward_kinematics", word_list![fk]),
    ("jacobian", word_list![J]),
    (
        "jacobian_rate",
        word_list![jacobian_dot jacobian_derivative],
    ),
    (
        "operational_inertia_inverse",
        word_list![operational_space_inertia task_space_inertia],
    ),
    ("cuboid", word_list![box]),
    ("base", word_list![mount mounting world]),
    (
        "floating",
        word_list![float free free_flyer freeflyer free_floating moving mobile],
    ),
    ("tool", word_list![end_effector gripper payload load]),
    ("xyz", word_list![position translation]),
    ("rpy", word_list![orientation rotation euler]),
];

/// Edits within which two words count as near, the shorter having `length` letters.
fn tolerated(length: usize) -> usize {
    match length {
        0..=2 => 0,
        3..=5 => 1,
        _ => (length / 3).min(3),
    }
}

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn
/// `a` into `b` (optimal string alignment distance).
fn edits(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|word| word.chars().take(COMPARED).collect::<String>());
    strsim::osa_distance(&a, &b)
}

/// Letters that are compared: more than in any right word.
const COMPARED: usize = 64;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_counted() {
        assert_eq!(edits("mass", "mass"), 0);
        assert_eq!(edits("mas", "mass"), 1);
        assert_eq!(edits("masss", "mass"), 1);
        assert_eq!(edits("mess", "mass"), 1);
        assert_eq!(edits("aplha", "alpha"), 1);
        assert_eq!(edits("", "abc"), 3);
        assert_eq!(edits("kitten", "sitting"), 3);
    }

    #[test]
    fn a_slip_of_the_finger_is_near() {
        let cells = ["a", "alpha", "d", "theta", "mass", "com", "inertia"];
        assert_eq!(nearest("aplha", &cells), Some("alpha"));
        assert_eq!(nearest("Mass", &cells), Some("mass"));
        assert_eq!(nearest("intertia", &cells), Some("inertia"));
        assert_eq!(nearest("A", &cells), Some("a"));
    }

    #[test]
    fn another_word_is_not_near() {
        let cells = ["a", "alpha", "d", "theta", "mass", "com", "inertia"];
        for word in ["b", "ma", "offset", "length", "", "x"] {
            assert_eq!(nearest(word, &cells), None, "{word}");
        }
    }

    #[test]
    fn the_first_part_of_a_word_stands_for_it() {
        let functions = ["coriolis_vector", "gravity_vector", "coriolis_matrix"];
        assert_eq!(begun("coriolis", &functions), Some("coriolis_vector"));
        assert_eq!(begun("gravity", &functions), Some("gravity_vector"));
        for word in ["", "grav", "vector", "gravity_", "gravity_vector"] {
            assert_eq!(begun(word, &functions), None, "{word}");
        }
    }

    #[test]
    fn words_of_other_books_are_known() {
        let cells = ["a", "alpha", "d", "theta", "mass", "com", "inertia"];
        assert_eq!(elsewhere("twist", &cells), Some("alpha"));
        assert_eq!(elsewhere("M", &cells), None);
        assert_eq!(meant("offset", &cells), Some("d"));
        assert_eq!(meant("rotary", &["revolute"]), Some("revolute"));
    }

    #[test]
    fn choices_are_listed() {
        assert_eq!(either(&["a"]), "`a`");
        assert_eq!(either(&["a", "b", "c"]), "`a`, `b` or `c`");
        assert_eq!(all(&["a", "b"]), "`a` and `b`");
    }
}
