//! Mistakes in and about robot files.

use std::fmt::Display;

use super::Mistake;
use crate::words::{all, shortened};

mistakes! {
    /// A path at which nothing is.
    not_found(path: &str) "there is no file `{path}`: a path starts at the folder of the crate's Cargo.toml";
    /// A file that cannot be read.
    unreadable(path: &str, reason: &impl Display) "cannot read `{path}`: {reason}";
    /// A byte that belongs to no letter.
    no_text(byte: u8) "not UTF-8 text: the byte {byte:#04x} belongs to no letter: save the file as UTF-8";
    /// Letters of two bytes each.
    utf_16() "UTF-16 text, expected UTF-8: save the file as UTF-8";
    unknown_format(path: &str) "`{path}` has an unknown format: expected `.urdf`, `.toml` or `.json`";
    /// The crate was built without the readers.
    #[cfg(not(feature = "files"))]
    switched_off() "files are read where the feature `files` of the crate `robot-dynamics` is on";
    /// No text of that format.
    syntax(format: &str, message: &str) "not {format}: {message}";
    /// `[joint]` for the second time.
    single_brackets() "each joint stands under a line `[[joint]]`, with two brackets";
    no_name(what: &str, word: &str => shortened) "{what} is a word of letters, digits and `_`, found `{word}`";
    /// A number in place of a name.
    number_as_name(number: &str => shortened)
        "expected a name, found `{number}`: a name that is no word is written in quotes, `\"{number}\"`";
    /// A name that would act on a terminal.
    control_in_name(word: &str => shortened) "a name has no control characters, found `{word}`";
    nameless_joint() "this joint has no name: write `name = \"shoulder\"`, for example";
    /// A value that is written as text, and is none.
    no_value(text: &str => shortened) "expected a value, found `{text}`";
    /// An entry that the file has too.
    in_file_too(word: &str, path: &str) "`{word}` is in `{path}` too: remove one of the two";
    /// An entry in place of which the file stands.
    instead_of(word: &str, path: &str) "`{path}` stands in place of `{word}`: remove `{word}`";
    /// A table that is read by a call and names a file itself.
    file_of_a_file(path: &str)
        "a table that a call reads names no other file: write `file: \"{path}\"` in the call, with these entries beside it";
    /// An entry beside a file that no file leaves open.
    beside_a_file(word: &str) "`{word}` beside a file, which says it itself: remove `{word}`";
    /// `chain` and the like without a file, or beside a file of another format.
    only_with_urdf(word: &str) "`{word}` is about a URDF file: write it beside `file: \"robots/arm.urdf\"`";
    /// `chain: []`
    no_links()
        "`chain` names no link: name the link at which the robot begins, and the tips to which its joints lead, \
         `[\"base_link\", \"tool0\"]` for example; without `chain` the whole tree of the file is read";
    /// `joint_1.0 = 0` in TOML, where a dot leads into a table.
    dotted_name(first: &str, second: &str) {name: shortened(&format!("{first}.{second}"))}
        "expected a joint and a position: a name with a dot is written in quotes, `\"{name}\"`";
    /// A key of the table in the row of a joint, behind whose line it stands.
    of_the_whole_table(word: &str, is_json: bool, is_beside: bool)
        {line: if is_beside { "[joints.NAME]" } else { "[[joint]]" }}
        "`{word}` belongs to the whole table and to no joint: write it beside `joints`" if is_json
        else "`{word}` belongs to the whole table and to no joint: write it above the first line `{line}`";
    /// A cell of a joint that cannot be given beside its file.
    said_by_the_file(word: &str, known: &[&str] => all)
        "`{word}` of a joint comes from its file: the cells that can be written beside a file are {known}";
    /// `joints: { }` beside a file.
    no_joint_of_file()
        "no joint is named: give cells to one, `elbow: {{ friction: {{ viscous: 0.1 }} }}` for example, or leave \
         `joints` out";
    /// `links: { }` beside a file.
    no_link_of_file()
        "no link is named: give cells to one, `hand: {{ mass: 2 }}` for example, or leave `links` out";
    /// A link that does not belong to the part of the file that is read.
    not_of_the_robot(link: &str => shortened)
        "`{link}` is none of the robot's links, which are those of the part of the file that is read: cells would do \
         nothing there, remove them";
    /// Cells of the links of a file, where the file has no links.
    links_of_a_table()
        "`links` gives cells to the links of a URDF file: in a table, write them in the row of the joint that moves the \
         link, or in a frame of `frames`";
    /// `[joints.joint.1]` in TOML, where a dot leads into a table.
    dotted_joint(first: &str, second: &str) {name: shortened(&format!("{first}.{second}"))}
        "expected the cells of a joint: a name with a dot is written in quotes, `[joints.\"{name}\"]`";
    /// A joint that has no row.
    not_of_the_arm(joint: &str => shortened)
        "`{joint}` is none of the robot's joints, which are those of its tree that move: cells would do nothing there, \
         remove them";
    /// Cells of the joints of a file, where there is no file.
    without_a_file(is_of_file: bool)
        "`[joints.NAME]` adds cells to the joints of another file: in the file that has the joint, write them in its \
         `[[joint]]`" if is_of_file
        else "in braces, `joints` gives cells to the joints of a `file`: rows of a table are written in brackets, \
              `joints: [name: revolute {{ ... }}, ...]`";
    typeless_joint(is_json: bool) {word: if is_json { "\"type\":" } else { "type =" }}
        "this joint has no type: write `{word} \"revolute\"` or `{word} \"prismatic\"`";
}

/// The joints of a table.
pub(crate) fn joints(is_json: bool) -> &'static str {
    if is_json {
        "a list of joints, `[{ \"name\": \"shoulder\", \"type\": \"revolute\" }]` for example"
    } else {
        "joints, each under a line `[[joint]]`"
    }
}
