//! The options of the command line about a file, as entries beside it.

use std::path::Path;

use dynamics_codegen::description::Masses;
use dynamics_codegen::files::{Format, joint_names, names_in_values, number};
use dynamics_evaluation::{ReadOptions, read_text, text_of_joints};

use crate::arguments::{FileOptions, RobotOptions};
use crate::failure::Failure;

/// Options about a file, as it is read.
pub(crate) struct Beside<'a> {
    pub(crate) path: &'a Path,
    pub(crate) options: ReadOptions,
    /// The options for which the lines of entries stand, in their order.
    pub(crate) lines: Vec<String>,
    /// Whether fields may be left without a value.
    pub(crate) keeps_names: bool,
    /// The name of the robot, if it is not that of the file.
    pub(crate) name: Option<String>,
}

impl Beside<'_> {
    /// Whether the command reads masses.
    pub(crate) fn masses(mut self, masses: Masses) -> Self {
        self.options = self.options.masses(masses);
        self
    }
}

/// Entries in the words of a file, and the option of each line.
#[derive(Default)]
struct Entries {
    text: String,
    lines: Vec<String>,
}

impl Entries {
    /// Adds a line that stands for an option.
    fn add(&mut self, line: &str, option: String) {
        self.text.push_str(line);
        self.text.push('\n');
        self.lines.push(option);
    }
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

/// A file that the command line names, and what it says of it.
pub(crate) struct Source<'a> {
    given: &'a FileOptions,
    functions: &'a [String],
    path: &'a Path,
    /// The other file, if there are two: joints that only that one has are left out.
    other: Option<&'a Path>,
    /// The option that names the links, and these.
    chain: (&'static str, &'a [String]),
}

impl<'a> Source<'a> {
    /// The file of a robot, of which functions are requested.
    pub(crate) fn new(given: &'a FileOptions, functions: &'a [String]) -> Self {
        Source {
            given,
            functions,
            path: &given.path,
            other: None,
            chain: ("chain", &given.chain),
        }
    }

    /// The file and another one, whose links may have other names, with the same settings.
    pub(crate) fn both(given: &'a RobotOptions, other: &'a Path, chain: &'a [String]) -> [Self; 2] {
        let source = || Source::new(&given.file, &given.functions);
        let [mut one, mut two] = [source(), source()];
        one.other = Some(other);
        (two.path, two.other) = (other, Some(one.path));
        if !chain.is_empty() {
            two.chain = ("against-chain", chain);
        }
        [one, two]
    }

    /// The options about the file, with the names of `--field` bound to their values.
    pub(crate) fn with_values(&self) -> Result<Beside<'a>, Failure> {
        self.report_tables()?;
        let mut entries = self.entries()?;
        self.bind_values(&mut entries)?;
        self.beside(entries)
    }

    /// The same, the names of `--field` being fields of the robot.
    pub(crate) fn with_fields(&self) -> Result<Beside<'a>, Failure> {
        self.report_tables()?;
        let names = fields(&self.given.field)?.into_iter().map(|(name, _)| name);
        let mut beside = self.beside(self.entries()?)?;
        beside.options = beside.options.fields(names);
        beside.keeps_names = true;
        Ok(beside)
    }

    /// As [`Source::with_values`], where names that nothing binds are fields of the robot.
    pub(crate) fn with_names(&self) -> Result<Beside<'a>, Failure> {
        let mut beside = self.with_values()?;
        beside.options = beside.options.names_are_fields();
        beside.keeps_names = true;
        Ok(beside)
    }

    /// Binds the names of `--field` to their values, as a file does. A name must occur in the file, or in the other one if
    /// there are two; only those of the file itself are bound.
    fn bind_values(&self, entries: &mut Entries) -> Result<(), Failure> {
        for (name, value) in assignments(&self.given.field, FIELD)? {
            let option = format!("--field {name}={value}");
            if has_name(self.path, &name) {
                entries.add(&format!("let.{name:?} = {value:?}"), option);
            } else if !self.other.is_some_and(|other| has_name(other, &name)) {
                let message = format!(
                    "`{option}`: no value in {} has the name `{name}`",
                    self.path.display()
                );
                return Err(Failure::of_the_command_line(message));
            }
        }
        Ok(())
    }

    /// Whether a joint is one of the file: if there is another file, not one that only that has.
    fn is_meant(&self) -> impl Fn(&str) -> bool + use<> {
        let elsewhere = self
            .other
            .map(|other| (joints_of(self.path), joints_of(other)));
        // A table has no joints beside a chain, of which `rest` would be all.
        let is_table = !has_links(self.path);
        move |joint| match &elsewhere {
            Some((here, there)) => {
                let has = |names: &[String]| names.iter().any(|name| name == joint);
                has(here) || !(has(there) || joint == "rest" && is_table)
            }
            None => true,
        }
    }

    /// The options about the file beside some entries.
    fn beside(&self, entries: Entries) -> Result<Beside<'a>, Failure> {
        let is_meant = self.is_meant();
        let ignored = self.given.ignore.iter().filter(|joint| is_meant(joint));
        self.report_missing()?;
        let mut options = ReadOptions::new().entries(&format!("\n{}", entries.text));
        let (option, links) = self.chain;
        if links.iter().any(String::is_empty) {
            let message = format!("`--{option} {}`: expected BASE,TIP", links.join(","));
            return Err(Failure::of_the_command_line(message));
        }
        if !links.is_empty() {
            options = options.chain(links);
        }
        if let Some(within) = self.given.round_angles {
            options = options.round_angles(within);
        }
        Ok(Beside {
            path: self.path,
            options: options.ignore(ignored),
            lines: entries.lines,
            keeps_names: false,
            name: self.given.name.clone(),
        })
    }

    /// Reports options that are about trees of links where no file is one.
    fn report_tables(&self) -> Result<(), Failure> {
        let is_tree = |path: &Path| Format::of(path).is_none() || has_links(path);
        let given = self.given;
        let options = [
            ("chain", !given.chain.is_empty()),
            ("ignore", !given.ignore.is_empty()),
            ("round-angles", given.round_angles.is_some()),
            ("base", given.base.is_some()),
        ];
        match options.iter().find(|(_, is_given)| *is_given) {
            Some((option, _)) if !is_tree(self.path) && !self.other.is_some_and(is_tree) => {
                Err(Failure::of_the_command_line(format!(
                    "`--{option}` is about a URDF file, a tree of links: {} is a table",
                    self.path.display()
                )))
            }
            _ => Ok(()),
        }
    }

    /// Reports that a URDF file is without gravity. A file without joints has a mistake of its own, which is reported when
    /// it is read.
    fn report_missing(&self) -> Result<(), Failure> {
        let is_urdf = Format::of(self.path) == Some(Format::Urdf);
        if !is_urdf || !self.given.gravity.is_empty() || joints_of(self.path).is_empty() {
            return Ok(());
        }
        Err(Failure::of_the_command_line(format!(
            "{} is a tree of links: expected `--gravity X,Y,Z`, such as `--gravity 0,0,-9.81` where z of the first link \
             points up",
            self.path.display()
        )))
    }

    /// The entries that take the place of those of the file, in its words.
    fn entries(&self) -> Result<Entries, Failure> {
        let mut entries = Entries::default();
        let given = self.given;
        let lists = [
            ("gravity", &given.gravity[..]),
            ("functions", self.functions),
            ("allow", &given.allow),
        ];
        for (key, words) in lists.into_iter().filter(|(_, words)| !words.is_empty()) {
            let option = format!("--{key} {}", words.join(","));
            let is_vector = key != "gravity" || words.len() == 3;
            if !is_vector || words.contains(&String::new()) {
                let expected = match key {
                    "gravity" => "X,Y,Z, three numbers between commas, for example 0,0,-9.81",
                    _ => "names between commas",
                };
                let message = format!("`{option}`: expected {expected}");
                return Err(Failure::of_the_command_line(message));
            }
            entries.add(&format!("{key} = {words:?}"), option);
        }
        if let Some(base) = &given.base {
            entries.add(&format!("base = {base:?}"), format!("--base {base}"));
        }
        if let Some(bounds) = &given.bounds {
            entries.add(
                &format!("bounds = {bounds:?}"),
                format!("--bounds {bounds}"),
            );
        }
        let is_meant = self.is_meant();
        for (joint, position) in assignments(&given.lock, LOCK)? {
            if is_meant(&joint) {
                let option = format!("--lock {joint}={position}");
                entries.add(&format!("lock.{joint:?} = {position:?}"), option);
            }
        }
        Ok(entries)
    }
}

/// Whether a value of the file uses the name. A file that cannot be read, which is reported elsewhere, counts as using it.
fn has_name(path: &Path, name: &str) -> bool {
    match (read_text(path), Format::of(path)) {
        (Ok(text), Some(format)) => names_in_values(&text, format).contains(name),
        _ => true,
    }
}

/// The fields of `--field NAME=VALUE` with their values as numbers.
pub(crate) fn fields(given: &[String]) -> Result<Vec<(String, f64)>, Failure> {
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
fn assignments(given: &[String], what: Assigning) -> Result<Vec<(String, String)>, Failure> {
    let mut read: Vec<(String, String)> = Vec::new();
    for word in given {
        let parts = word
            .split_once('=')
            .ok_or_else(|| no_assignment(what, word))?;
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
