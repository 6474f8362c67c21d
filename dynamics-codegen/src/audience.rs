//! The reader of a message: where the mistake was made decides in which words advice is given.

use crate::words::shortened;

/// The reader of a message, in whose words it says what to write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Audience {
    /// The author of a call of the macro: `lock: [elbow = 0]`.
    Call,
    /// The author of a file, or of entries in the words of a file: `lock = { elbow = 0 }`.
    #[default]
    File,
    /// Somebody who typed a command line: `--lock elbow=0`.
    Command,
}

/// Where `allow` concerns the whole table.
pub(crate) const AT_THE_END: &str = "at the end of the table";

impl Audience {
    /// All of them.
    pub(crate) const ALL: [Audience; 3] = [Audience::Call, Audience::File, Audience::Command];

    /// A cell as the call has it, in the words of a file where there is one.
    pub(crate) fn cell(self, call: &str) -> String {
        match self {
            Audience::Call => format!("`{call}`"),
            Audience::File | Audience::Command => format!("`{}`", call.replace(": ", " = ")),
        }
    }

    /// A base that moves, with these cells of its body.
    pub(crate) fn floating(self, cells: &str) -> String {
        match self {
            Audience::Call => format!("`base: floating {{ {cells} }}`"),
            Audience::File | Audience::Command => {
                let cells = cells
                    .replace("sphere(0.2)", "\"sphere(0.2)\"")
                    .replace(": ", " = ");
                format!("`base = {{ floating = true, {cells} }}`")
            }
        }
    }

    /// A base that moves, whose body is said elsewhere.
    pub(crate) fn moving_base(self) -> &'static str {
        match self {
            Audience::Call => "`base: floating`",
            Audience::File => "`base = { floating = true }`",
            Audience::Command => "`--base floating`",
        }
    }

    /// A joint that is made to stand still.
    pub(crate) fn lock(self, joint: &str, position: &str) -> String {
        match self {
            Audience::Call => format!("`lock: [{} = {position}]`", quoted(joint)),
            Audience::File => format!("`lock = {{ {} = {position} }}`", quoted(joint)),
            Audience::Command => format!("`--lock {}`", argument(&format!("{joint}={position}"))),
        }
    }

    /// The acceleration of gravity, in a call or in a file.
    pub(crate) fn gravity(self, is_of_file: bool) -> &'static str {
        match (self, is_of_file) {
            (Audience::Call, false) => "write `gravity: [0, 0, -9.81]`",
            (Audience::Call, true) | (Audience::File, _) => "expected [0, 0, -9.81]",
            (Audience::Command, _) => "expected [0, 0, -9.81], or `--gravity 0,0,-9.81`",
        }
    }

    /// The place of an entry of the whole table, where a call has one.
    pub(crate) fn end_of_table(self) -> &'static str {
        match self {
            Audience::Call => " at the end of the table",
            Audience::File | Audience::Command => "",
        }
    }

    /// A joint of a URDF file that is left out with what hangs on it.
    #[cfg(feature = "files")]
    pub(crate) fn ignore(self, joint: &str) -> String {
        match self {
            Audience::Call => format!("`ignore: [{}]`", quoted(joint)),
            Audience::File => format!("`ignore` with `{}`", shortened(joint)),
            Audience::Command => format!("`--ignore {}`", argument(joint)),
        }
    }

    /// The link at which a robot begins, and its tips.
    #[cfg(feature = "files")]
    pub(crate) fn chain(self, links: &[&str]) -> String {
        let quoted = |link: &&str| format!("\"{}\"", shortened(link));
        let in_quotes = || links.iter().map(quoted).collect::<Vec<_>>().join(", ");
        match self {
            Audience::Call => format!("`chain: [{}]`", in_quotes()),
            Audience::File => format!("`chain = [{}]`", in_quotes()),
            Audience::Command => format!("`--chain {}`", argument(&links.join(","))),
        }
    }

    /// An entry that is an option of the command.
    #[cfg(feature = "files")]
    pub(crate) fn entry(self, key: &str) -> String {
        let dashes = if self == Audience::Command { "--" } else { "" };
        format!("`{dashes}{key}`")
    }

    /// A frame on the link of a joint.
    pub(crate) fn frame(self, name: &str, joint: &str) -> String {
        let (name, joint) = (quoted(name), shortened(joint));
        match self {
            Audience::Call => format!("`frames: {{ {name}: {{ on: {} }} }}`", quoted(&joint)),
            Audience::File | Audience::Command => {
                format!("`[frame.{name}]` with `on = \"{joint}\"`")
            }
        }
    }

    /// A function of a frame.
    pub(crate) fn function_of(self, function: &str, frame: &str) -> String {
        match self {
            Audience::Call => format!("`{function}({})`", quoted(frame)),
            Audience::File => format!("`\"{function}({})\"`", shortened(frame)),
            Audience::Command => format!(
                "`--functions {}`",
                argument(&format!("{function}({frame})"))
            ),
        }
    }

    /// A function, at a frame if it is about one.
    pub(crate) fn wanted(self, function: &str, frame: Option<&str>) -> String {
        frame.map_or(format!("`{function}`"), |frame| {
            self.function_of(function, frame)
        })
    }

    /// Two functions that are requested.
    pub(crate) fn functions(self, one: &str, other: &str) -> String {
        match self {
            Audience::Call => format!("`functions: [{one}, {other}]`"),
            Audience::File => format!("`functions = [\"{one}\", \"{other}\"]`"),
            Audience::Command => format!("`--functions {one},{other}`"),
        }
    }

    /// A word by which what is odd is accepted, and where it stands.
    pub(crate) fn allow(self, word: &str, place: &str) -> String {
        match self {
            Audience::Call => format!("`allow: [{word}]` {place}"),
            // Behind the rows of a file an entry would be one of the last row.
            Audience::File if place == AT_THE_END => {
                format!("`allow = [\"{word}\"]` at the top of the file")
            }
            Audience::File => format!("`allow = [\"{word}\"]` {place}"),
            Audience::Command => format!("`--allow {word}`"),
        }
    }
}

/// A name in a call or a file: in quotes where it is no word of Rust.
fn quoted(name: &str) -> String {
    let is_word = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    let name = shortened(name);
    if is_word && !name.starts_with(|c: char| c.is_ascii_digit()) {
        name
    } else {
        format!("\"{name}\"")
    }
}

/// A word of a command line: in quotes where a shell would take it apart.
fn argument(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_-.,=/+:@%".contains(c);
    let shown = shortened(word);
    if word.chars().all(is_plain) {
        shown
    } else {
        format!("'{shown}'")
    }
}
