//! Every message about a call, each in one place: what is wrong, what was expected, and what to write
//! instead where that is known.
//!
//! A [`Mistake`] can be made in this module alone, and nothing else can be reported.

/// The rule that a mistake of this module breaks, by the path of its function.
macro_rules! rule {
    ($name:ident) => {
        concat!(module_path!(), "::", stringify!($name))
    };
}

/// Makes a function of each mistake, of its name, its arguments (`=> shown` shows one by that function) and the text.
/// In braces stand values that follow from the arguments, in brackets the advice in words of the audience. With `if`
/// there are two texts, and the first is taken if that is true.
macro_rules! mistakes {
    ($(
        $(#[$about:meta])*
        $name:ident($($given:ident: $type:ty $(=> $shown:ident)?),*)
            $({$($part:ident: $value:expr),*})?
            $([$($advice:ident: $say:ident($($word:expr),*)),*])?
            $text:literal $(if $is_first:ident else $other:literal)?;
    )*) => {$(
        $(#[$about])*
        pub(crate) fn $name($($given: $type),*) -> Mistake {
            $($(let $given = $shown($given);)?)*
            $($(let $part = $value;)*)?
            Mistake::advice(rule!($name), |_audience| {
                $($(let $advice = _audience.$say($($word),*);)*)?
                $(if !$is_first {
                    return format!($other);
                })?
                format!($text)
            })
        }
    )*};
}

pub(crate) mod base;
pub(crate) mod couple;
pub(crate) mod entry;
pub(crate) mod expected;
// Mistakes in files are reported where files are read.
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) mod file;
pub(crate) mod joint;
pub(crate) mod link;
#[cfg(feature = "files")]
pub(crate) mod links;
pub(crate) mod number;
pub(crate) mod size;
pub(crate) mod structure;
#[cfg(feature = "files")]
pub(crate) mod urdf;
pub(crate) mod value;

use std::fmt;

use dynamics_symbolic::neglect::NotPositiveDefinite;

use crate::audience::Audience;
use crate::words::{either, shortened, visible};

/// A mistake, as it is shown to each [`Audience`].
#[derive(Clone, Debug)]
pub(crate) struct Mistake {
    rule: &'static str,
    texts: [String; Audience::ALL.len()],
}

impl Mistake {
    /// The same text for all.
    fn new(rule: &'static str, text: impl Into<String>) -> Mistake {
        let text = text.into();
        Mistake::advice(rule, |_| text.clone())
    }

    /// A text with words of the audience in it. It is one line, and nothing in it acts on a terminal, whatever words of
    /// a file it has.
    fn advice(rule: &'static str, text: impl Fn(Audience) -> String) -> Mistake {
        let texts = Audience::ALL.map(|audience| text(audience).chars().map(visible).collect());
        Mistake { rule, texts }
    }

    /// The rule that it breaks, by the module and the name of its function: `urdf::no_body`.
    pub(crate) fn rule(&self) -> &'static str {
        const HERE: &str = concat!(module_path!(), "::");
        self.rule.strip_prefix(HERE).unwrap_or(self.rule)
    }

    /// The last mistake that is shown.
    pub(crate) fn with_others(self) -> Mistake {
        let texts = self
            .texts
            .map(|text| text + " (more errors than are shown)");
        Mistake { texts, ..self }
    }

    /// The text for an audience.
    pub(crate) fn text_for(&self, audience: Audience) -> &str {
        let [call, file, command] = &self.texts;
        match audience {
            Audience::Call => call,
            Audience::File => file,
            Audience::Command => command,
        }
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.text_for(Audience::Call))
    }
}

mistakes! {
    /// A key, cell or entry that stands there already.
    given_twice(word: &str) "`{word}` is given twice";
    /// An attribute on an item of the table.
    attribute() "only doc comments are allowed here";
    /// `#` and no attribute.
    lonely_hash() "expected a name, found `#`";
    /// Too much is neglected.
    neglected_too_much(refused: &NotPositiveDefinite) "{refused}";
    /// The engine could not prove a function.
    not_proven(failure: &impl fmt::Display) "{failure}";
    /// A word that is not known; `meant` is the known word that was probably meant.
    unknown(what: &str, word: &str => shortened, meant: Option<&str>, known: &[&str])
        {hint: hint(meant, known, "expected")} "unknown {what} `{word}`: {hint}";
}

/// Something else stands where `what` was expected; nothing does where the tokens end.
pub(crate) fn instead(what: &expected::Expected, found: Option<&str>) -> Mistake {
    let text = match found {
        Some(found) => format!("expected {what}, found {found}"),
        None => format!("expected {what}"),
    };
    Mistake::new(rule!(instead), text)
}

/// The advice: the word that was probably meant, or those that are known.
fn hint(meant: Option<&str>, known: &[&str], which: &str) -> String {
    match meant {
        Some(right) => format!("did you mean `{right}`?"),
        None => format!("{which} {}", either(known)),
    }
}
