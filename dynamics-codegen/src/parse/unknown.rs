//! Unknown words.

use crate::mistake::{self, Mistake};
use crate::words;

/// The mistake of an unknown word, and the word that was probably meant.
pub(crate) struct Wrong {
    pub(crate) mistake: Mistake,
    pub(crate) meant: Option<&'static str>,
}

/// A word that is not in `known`: the message names the nearest known word if one is near, otherwise all of them.
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
