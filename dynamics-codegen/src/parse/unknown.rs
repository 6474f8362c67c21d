//! Words that are none of the right ones.

use crate::mistake::{self, Mistake};
use crate::words;

/// What to say about a word that is none of the right ones, and which one was meant.
pub(crate) struct Wrong {
    pub(crate) mistake: Mistake,
    pub(crate) meant: Option<&'static str>,
}

/// A word that is none of `known`: the message names the nearest right word where one
/// is near, all of them elsewhere.
pub(crate) fn unknown(what: &str, word: &str, known: &[&'static str]) -> Wrong {
    let meant = words::meant(word, known);
    Wrong {
        mistake: mistake::unknown(what, word, meant, known),
        meant,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_names_the_right_words() {
        let wrong = unknown("key", "foo", &["gravity", "joints"]);
        assert_eq!(
            wrong.mistake.to_string(),
            "unknown key `foo`: expected `gravity` or `joints`"
        );
        assert_eq!(wrong.meant, None);
        let wrong = unknown("key", "gravty", &["gravity", "joints"]);
        assert_eq!(
            wrong.mistake.to_string(),
            "unknown key `gravty`: did you mean `gravity`?"
        );
        assert_eq!(wrong.meant, Some("gravity"));
    }
}
