//! Values of options: how they are read, and what is expected of them.

use std::convert::Infallible;
use std::path::PathBuf;

use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction};
use dynamics_codegen::files::number as number_of;

/// An option of a kind, as the functions below make it.
pub(super) trait Kind: Sized {
    fn kind(self, kind: impl FnOnce(Self) -> Self) -> Self {
        kind(self)
    }
}

impl Kind for Arg {}

/// Words between commas.
pub(super) fn words(action: ArgAction, shown: &'static str) -> impl FnOnce(Arg) -> Arg {
    move |option| {
        let option = option.value_name(shown).value_delimiter(',').num_args(1);
        option.action(action).value_parser(trimmed)
    }
}

/// Numbers between commas, of each joint that moves or of a pose.
pub(super) fn numbers(action: ArgAction, shown: &'static str) -> impl FnOnce(Arg) -> Arg {
    move |option| {
        let option = words(action, shown)(option).allow_hyphen_values(true);
        option.value_parser(finite)
    }
}

/// A whole number from `least` to `most`.
pub(super) fn count(default: &'static str, least: usize, most: usize) -> impl FnOnce(Arg) -> Arg {
    let count = move |text: &str| match text.trim().parse::<u32>() {
        Ok(count) if (least..=most).contains(&(count as usize)) => Ok(count as usize),
        _ => Err(format!("expected a whole number from {least} to {most}")),
    };
    move |option| {
        let option = option.value_name("COUNT").allow_hyphen_values(true);
        let option = option.required(false).default_value(default);
        option.value_parser(count)
    }
}

/// A word of several, each with what it stands for.
pub(super) fn choice<T: Clone + Send + Sync + 'static, const N: usize>(
    words: [(&'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    let parser = PossibleValuesParser::new(words.each_ref().map(|(word, _)| *word));
    parser.map(move |found| {
        let index = words.iter().position(|(word, _)| *word == found);
        words[index.unwrap_or(0)].1.clone()
    })
}

pub(super) fn trimmed(text: &str) -> Result<String, Infallible> {
    Ok(text.trim().to_owned())
}

/// A name in letters of which names in generated text can be made.
pub(super) fn robot_name(text: &str) -> Result<String, String> {
    const MOST_LETTERS: usize = 100;
    let is_letter = |letter: char| letter.is_ascii_alphanumeric() || "_-. ".contains(letter);
    let starts_well = text.starts_with(|letter: char| letter.is_ascii_alphabetic());
    if starts_well && text.chars().all(is_letter) && text.len() <= MOST_LETTERS {
        Ok(text.to_owned())
    } else {
        Err(format!(
            "expected at most {MOST_LETTERS} letters a-z, digits, `_`, `-`, `.` or spaces, a letter first"
        ))
    }
}

pub(super) fn small_angle(text: &str) -> Result<f64, String> {
    within(text, "an angle from 0 to 0.1 rad, such as 1e-4", |angle| {
        (0.0..=0.1).contains(&angle)
    })
}

/// The path of a figure, whose ending is that of its format.
pub(super) fn svg() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| match path.extension() {
        Some(ending) if !ending.eq_ignore_ascii_case("svg") => {
            Err("the figure is in SVG: expected a file that ends in `.svg`")
        }
        _ => Ok(path),
    })
}

/// A number as it is, or a value in the macro's words.
fn finite(text: &str) -> Result<f64, String> {
    number_of(text).map_err(|mistake| {
        format!("expected a number, or a value such as PI/2 or deg(90): {mistake}")
    })
}

/// A number among those that are good, which are what is expected.
fn within(text: &str, expected: &str, is_good: impl Fn(f64) -> bool) -> Result<f64, String> {
    match number_of(text) {
        Ok(x) if is_good(x) => Ok(x),
        Ok(_) => Err(format!("expected {expected}")),
        Err(mistake) => Err(format!("expected {expected}: {mistake}")),
    }
}

/// A number above zero.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    within(text, "a number above zero", |x| x > 0.0)
}

/// A number from `least` to `most`.
pub(super) fn between(
    least: f64,
    most: f64,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    move |text| {
        let expected = format!("a number from {least:e} to {most}");
        within(text, &expected, |x| (least..=most).contains(&x))
    }
}
