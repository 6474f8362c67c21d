//! The options of the command line about a file, as entries beside it.

use std::path::Path;

use clap::ArgMatches;
use dynamics_codegen::description::Masses;
use dynamics_codegen::files::{Format, joint_names, names_in_values, number};
use dynamics_evaluation::{FileMistake, ReadOptions, read_text, text_of_joints};

use crate::failure::Failure;

/// Options about a file, and the option for which each line of their entries stands.
pub(crate) struct Beside {
    pub(crate) options: ReadOptions,
    pub(crate) lines: Lines,
    /// Whether fields may be left without a value.
    pub(crate) keeps_names: bool,
    /// The name of the robot, if it is not that of the file.
    pub(crate) name: Option<String>,
}

impl Beside {
    /// Whether the command reads masses.
    pub(crate) fn masses(mut self, masses: Masses) -> Self {
        self.options = self.options.masses(masses);
        self
    }
}

/// The options for which the lines of entries stand, in their order.
#[derive(Default)]
pub(crate) struct Lines(Vec<String>);

impl Lines {
    /// The message of a mistake in the options: behind the option that it is about.
    pub(crate) fn message(&self, mistake: &FileMistake) -> String {
        // Chains and joints that are left out are reported at the first line, which is empty.
        let line = mistake.line.checked_sub(2);
        match line.and_then(|line| self.0.get(line)) {
            Some(option) => format!("`{option}`: {}", mistake.message),
            None => mistake.message.clone(),
        }
    }
}

/// Entries in the words of a file, and the option of each line.
#[derive(Default)]
struct Entries {
    text: String,
    lines: Lines,
}

impl Entries {
    /// Adds a line that stands for an option.
    fn add(&mut self, line: &str, option: String) {
        self.text.push_str(line);
        self.text.push('\n');
        self.lines.0.push(option);
    }
}

/// The words of an option.
fn words(given: &ArgMatches, option: &str) -> Vec<String> {
    let words = given.try_get_many::<String>(option).ok().flatten();
    let trimmed = words.into_iter().flatten().map(|word| word.trim());
    trimmed.map(str::to_owned).collect()
}

/// Names of the joints in a file, or in the one that it names; empty if it cannot be read, which is reported elsewhere.
fn joints_of(path: &Path) -> Vec<String> {
    text_of_joints(path).map_or(Vec::new(), |(text, format)| joint_names(&text, format))
}

/// Whether a robot is a tree of links: that of a URDF file, which a table may name.
pub(crate) fn has_links(path: &Path) -> bool {
    match text_of_joints(path) {
        Some((_, format)) => format == Format::Urdf,
        None => Format::of(path) == Some(Format::Urdf),
    }
}

/// The options of the command line about a file, with the names of `--field` bound to their values. If there are two
/// files, joints that only the other one has are left out; `chain` is the option that names the links.
pub(crate) fn with_values(
    given: &ArgMatches,
    path: &Path,
    other: Option<&Path>,
    chain: &str,
) -> Result<Beside, Failure> {
    let mut entries = entries(given, is_meant(path, other))?;
    bind_values(given, path, other, &mut entries)?;
    beside(given, path, other, chain, entries)
}

/// The same of one file, the names of `--field` being fields of the robot.
pub(crate) fn with_fields(given: &ArgMatches, path: &Path) -> Result<Beside, Failure> {
    let names = fields(given)?.into_iter().map(|(name, _)| name);
    let entries = entries(given, is_meant(path, None))?;
    let mut beside = beside(given, path, None, "chain", entries)?;
    beside.options = beside.options.fields(names);
    beside.keeps_names = true;
    Ok(beside)
}

/// As [`with_values`] of one file, where names that nothing binds are fields of the robot.
pub(crate) fn with_names(given: &ArgMatches, path: &Path) -> Result<Beside, Failure> {
    let mut beside = with_values(given, path, None, "chain")?;
    beside.options = beside.options.names_are_fields();
    beside.keeps_names = true;
    Ok(beside)
}

/// Binds the names of `--field` to their values, as a file does. A name must occur in the file, or in the other one if
/// there are two; only those of the file itself are bound.
fn bind_values(
    given: &ArgMatches,
    path: &Path,
    other: Option<&Path>,
    entries: &mut Entries,
) -> Result<(), Failure> {
    for (name, value) in assignments(given, FIELD)? {
        let option = format!("--field {name}={value}");
        if has_name(path, &name) {
            entries.add(&format!("let.{name:?} = {value:?}"), option);
        } else if !other.is_some_and(|other| has_name(other, &name)) {
            let message = format!(
                "`{option}`: no value in {} has the name `{name}`",
                path.display()
            );
            return Err(Failure::of_the_command_line(message));
        }
    }
    Ok(())
}

/// Whether a value of the file uses the name. A file that cannot be read, which is reported elsewhere, counts as using it.
fn has_name(path: &Path, name: &str) -> bool {
    match (read_text(path), Format::of(path)) {
        (Ok(text), Some(format)) => names_in_values(&text, format).contains(name),
        _ => true,
    }
}

/// Whether a joint is one of the file: if there is another file, not one that only that has.
fn is_meant(path: &Path, other: Option<&Path>) -> impl Fn(&str) -> bool {
    let elsewhere = other.map(|other| (joints_of(path), joints_of(other)));
    // A table has no joints beside a chain, of which `rest` would be all.
    let is_table = !has_links(path);
    move |joint| match &elsewhere {
        Some((here, there)) => {
            let has = |names: &[String]| names.iter().any(|name| name == joint);
            has(here) || !(has(there) || joint == "rest" && is_table)
        }
        None => true,
    }
}

/// The options about a file beside some entries.
fn beside(
    given: &ArgMatches,
    path: &Path,
    other: Option<&Path>,
    chain: &str,
    entries: Entries,
) -> Result<Beside, Failure> {
    let is_meant = is_meant(path, other);
    let mut ignore = words(given, "ignore");
    ignore.retain(|joint| is_meant(joint));
    report_missing(given, path)?;
    let mut options = ReadOptions::new().entries(&format!("\n{}", entries.text));
    if let Some(links) = self::chain(given, chain)? {
        options = options.chain(links);
    }
    if let Ok(Some(within)) = given.try_get_one::<f64>("round-angles") {
        options = options.round_angles(*within);
    }
    Ok(Beside {
        options: options.ignore(ignore),
        lines: entries.lines,
        keeps_names: false,
        name: given.get_one("name").cloned(),
    })
}

/// Reports that a URDF file is without gravity. A file without joints has a mistake of its own, which is reported when it
/// is read.
fn report_missing(given: &ArgMatches, path: &Path) -> Result<(), Failure> {
    let is_urdf = Format::of(path) == Some(Format::Urdf);
    if !is_urdf || !words(given, "gravity").is_empty() || joints_of(path).is_empty() {
        return Ok(());
    }
    Err(Failure::of_the_command_line(format!(
        "{} is a tree of links: expected `--gravity X,Y,Z`, such as `--gravity 0,0,-9.81` where z of the first link \
         points up",
        path.display()
    )))
}

/// The fields of `--field NAME=VALUE` with their values as numbers.
pub(crate) fn fields(given: &ArgMatches) -> Result<Vec<(String, f64)>, Failure> {
    let number = |(name, value): (String, String)| match number(&value) {
        Ok(number) => Ok((name, number)),
        Err(mistake) => Err(no_number(FIELD, &format!("{name}={value}"), &mistake)),
    };
    assignments(given, FIELD)?.into_iter().map(number).collect()
}

/// An option that gives something to a name, and what is expected of it.
type Assigning = (&'static str, &'static str);
const FIELD: Assigning = ("field", "NAME=NUMBER, for example load=2.5");
const LOCK: Assigning = (
    "lock",
    "JOINT=POSITION, for example elbow=0.3 or elbow=deg(30)",
);

/// The names and values of such an option, each name once.
fn assignments(given: &ArgMatches, what: Assigning) -> Result<Vec<(String, String)>, Failure> {
    let mut read: Vec<(String, String)> = Vec::new();
    for word in words(given, what.0) {
        let parts = word
            .split_once('=')
            .ok_or_else(|| no_assignment(what, &word))?;
        let (name, value) = (parts.0.trim(), parts.1.trim());
        if read.iter().any(|(other, _)| other == name) {
            let message = format!("`--{} {word}`: `{name}` has a value already", what.0);
            return Err(Failure::of_the_command_line(message));
        }
        read.push((name.to_owned(), value.to_owned()));
    }
    Ok(read)
}

fn no_assignment((option, expected): Assigning, found: &str) -> Failure {
    Failure::of_the_command_line(format!("`--{option} {found}`: expected {expected}"))
}

/// The same where the mistake in what stands behind `=` is known.
fn no_number((option, expected): Assigning, found: &str, mistake: &str) -> Failure {
    let message = format!("`--{option} {found}`: expected {expected}: {mistake}");
    Failure::of_the_command_line(message)
}

/// The link at which the robot begins and its tips, where an option names them.
fn chain(given: &ArgMatches, option: &str) -> Result<Option<Vec<String>>, Failure> {
    let links = words(given, option);
    if links.contains(&String::new()) {
        let message = format!("`--{option} {}`: expected BASE,TIP", links.join(","));
        return Err(Failure::of_the_command_line(message));
    }
    Ok((!links.is_empty()).then_some(links))
}

/// The entries that take the place of those of the file, in its words.
fn entries(given: &ArgMatches, is_meant: impl Fn(&str) -> bool) -> Result<Entries, Failure> {
    let mut entries = Entries::default();
    for key in ["gravity", "functions", "allow"] {
        let words = words(given, key);
        let is_vector = key != "gravity" || words.len() == 3;
        if !words.is_empty() && (!is_vector || words.contains(&String::new())) {
            let expected = match key {
                "gravity" => "X,Y,Z, three numbers between commas, for example 0,0,-9.81",
                _ => "names between commas",
            };
            let message = format!("`--{key} {}`: expected {expected}", words.join(","));
            return Err(Failure::of_the_command_line(message));
        }
        if !words.is_empty() {
            let quoted: Vec<_> = words.iter().map(|word| format!("{word:?}")).collect();
            let option = format!("--{key} {}", words.join(","));
            entries.add(&format!("{key} = [{}]", quoted.join(", ")), option);
        }
    }
    if let Ok(Some(base)) = given.try_get_one::<String>("base") {
        entries.add(&format!("base = {base:?}"), format!("--base {base}"));
    }
    for (joint, position) in assignments(given, LOCK)? {
        if is_meant(&joint) {
            let option = format!("--lock {joint}={position}");
            entries.add(&format!("lock.{joint:?} = {position:?}"), option);
        }
    }
    Ok(entries)
}
