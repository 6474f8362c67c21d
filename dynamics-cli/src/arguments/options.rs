//! Options that several subcommands have.

use std::path::PathBuf;

use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, Command, value_parser};
use dynamics_codegen::description::Allow;
use dynamics_codegen::files::number as number_of;

/// A subcommand about a robot file, with the options that say what the file does not.
pub(super) fn of_a_file(name: &'static str, about: &'static str) -> Command {
    const OF_THE_FILE: &str = "About the file";
    Command::new(name)
        .about(about)
        .arg(
            path("file", "The robot: a file in TOML, JSON or URDF")
                .required(true)
                .value_name("FILE"),
        )
        .next_help_heading(OF_THE_FILE)
        .arg(
            Arg::new("name")
                .long("name")
                .value_name("NAME")
                .value_parser(robot_name)
                .help("The name of the robot, of its struct, of the files and functions that are written; that of the file where this is left out"),
        )
        .arg(words("chain", "BASE,TIP").help("The link of a URDF file at which the robot begins, and its tips; without tips all that the link carries. The whole tree of the file where this is left out"))
        .arg(
            words("gravity", "X,Y,Z")
                .allow_hyphen_values(true)
                .help("Acceleration of gravity, m/s^2, in place of the file's; a URDF file has none"),
        )
        .arg(
            choice("base", "BASE", ["floating"])
                .help("The base moves: the root link of a URDF file is its body. All but `reach` know such robots"),
        )
        .arg(
            several("field", "NAME=VALUE")
                .help("The value of a name in the file's cells, such as load=2.5; may be given several times. `show` and `generate` keep names without a value"),
        )
        .arg(
            words("lock", "JOINT=POSITION")
                .action(ArgAction::Append)
                .help("Joints that stand still, rad or m, beside those that the file locks; `rest` as for --ignore"),
        )
        .arg(words("ignore", "JOINT").action(ArgAction::Append).help(
            "Joints of a URDF file that are left out, with all that hangs on them; `rest` is all beside the chain that are not named",
        ))
        .arg(
            Arg::new("round-angles")
                .long("round-angles")
                .value_name("RAD")
                .value_parser(small_angle)
                .help("The largest distance at which an angle or axis of a URDF file is taken for a multiple of a quarter turn, such as 1e-4"),
        )
        .arg(
            words("allow", "WORD")
                .action(ArgAction::Append)
                .value_parser(PossibleValuesParser::new(Allow::WORDS))
                .help("Accept what is refused otherwise, anywhere in the file"),
        )
        .next_help_heading(None::<&str>)
}

/// The functions that are requested.
pub(super) fn functions() -> Arg {
    words("functions", "A,B,C").action(ArgAction::Append).help(
        "The functions, in place of the file's; `default` is the set of a file that names none",
    )
}

/// Words between commas.
pub(super) fn words(name: &'static str, shown: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(shown)
        .value_delimiter(',')
        .num_args(1)
}

/// An option that may be given several times.
pub(super) fn several(name: &'static str, shown: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(shown)
        .action(ArgAction::Append)
}

/// A name in letters of which names in generated text can be made.
fn robot_name(text: &str) -> Result<String, String> {
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

fn small_angle(text: &str) -> Result<f64, String> {
    within(text, "an angle from 0 to 0.1 rad, such as 1e-4", |angle| {
        (0.0..=0.1).contains(&angle)
    })
}

/// A word of several.
pub(super) fn choice<const N: usize>(
    name: &'static str,
    shown: &'static str,
    words: [&'static str; N],
) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(shown)
        .value_parser(PossibleValuesParser::new(words))
}

/// A path.
pub(super) fn path(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .value_name("PATH")
        .value_parser(value_parser!(PathBuf))
        .help(help)
}

/// The file that a subcommand writes.
pub(super) fn out() -> Arg {
    path(
        "out",
        "The file that is written; standard output where this is left out",
    )
    .long("out")
}

/// The figure that a subcommand draws besides.
pub(super) fn plot() -> Arg {
    path(
        "plot",
        "Draw the motion as curves over time into this file too, as SVG",
    )
    .long("plot")
    .value_parser(PathBufValueParser::new().try_map(of_svg))
}

/// The path of a figure, whose ending is that of its format.
fn of_svg(path: PathBuf) -> Result<PathBuf, &'static str> {
    match path.extension() {
        Some(ending) if !ending.eq_ignore_ascii_case("svg") => {
            Err("the figure is in SVG: expected a file that ends in `.svg`")
        }
        _ => Ok(path),
    }
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
fn positive(text: &str) -> Result<f64, String> {
    within(text, "a number above zero", |x| x > 0.0)
}

/// A number above zero.
pub(super) fn number(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name("NUMBER")
        .allow_hyphen_values(true)
        .value_parser(positive)
        .help(help)
}

/// A number from `least` to `most`.
pub(super) fn number_between(name: &'static str, least: f64, most: f64, help: &'static str) -> Arg {
    number(name, help).value_parser(move |text: &str| {
        let expected = format!("a number from {least:e} to {most}");
        within(text, &expected, |x| (least..=most).contains(&x))
    })
}

/// A whole number from `least` on.
pub(super) fn count(
    name: &'static str,
    default: &'static str,
    least: u32,
    most: u32,
    help: &'static str,
) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name("COUNT")
        .default_value(default)
        .allow_hyphen_values(true)
        .value_parser(move |text: &str| match text.trim().parse::<u32>() {
            Ok(count) if (least..=most).contains(&count) => Ok(count),
            _ => Err(format!("expected a whole number from {least} to {most}")),
        })
        .help(help)
}

/// A number for each joint that moves.
pub(super) fn vector(name: &'static str, help: &'static str) -> Arg {
    words(name, "X,Y,...")
        .allow_hyphen_values(true)
        .value_parser(finite)
        .help(help)
}

/// Where a base that moves is.
pub(super) fn pose(help: &'static str) -> Arg {
    vector("pose", help)
}

/// Torques and forces at the joints.
pub(super) fn torque() -> Arg {
    let help = "Torques and forces at the joints, N m or N; zeros where this is left out";
    vector("torque", help)
}
