//! The operations that `neglect` removes, and the error that it makes, of `docs/accuracy/pieces.md`.

use std::path::Path;

use measuring::drawing::{Drawing, Letters};

use crate::table::Table;
use crate::{Picture, read};

const SIZE: [f64; 2] = [880.0, 442.0];
const FUNCTIONS: [&str; 5] = [
    "inverse_dynamics",
    "mass_matrix",
    "coriolis_vector",
    "gravity_vector",
    "forward_dynamics",
];

/// The rows of the tables, what the picture calls them, and the class of their bars.
const ARMS: [(&str, &str, &str); 3] = [
    ("PUMA 560: nothing", "the complete arm", "bar-a"),
    ("PUMA 560: what is below 1 %", "neglect: 1%", "bar-b"),
    ("PUMA 560: what is below 5 %", "neglect: 5%", "bar-c"),
];

/// Where bars begin, and the length of an operation.
const LEFT: f64 = 170.0;
const OPERATION: f64 = 0.98;
const TOP: f64 = 84.0;
const GROUP: f64 = 72.0;
const BAR: f64 = 18.0;

pub(crate) fn picture(root: &Path) -> Picture {
    let document = read(root, "docs/accuracy/pieces.md");
    let title = "PUMA 560: operations of a call, and the error that neglect makes";
    let mut drawing = Drawing::new(title, SIZE);
    drawing.text([20.0, 28.0], Letters::PLAIN.bold().size(15.0), title);
    for (number, (_, name, class)) in ARMS.into_iter().enumerate() {
        let x = LEFT + 170.0 * number as f64;
        drawing.rectangle(class, [x, 46.0], [14.0, 14.0], 2.0);
        drawing.text([x + 22.0, 58.0], Letters::PLAIN, name);
    }
    let mut said = Vec::new();
    for (row, function) in FUNCTIONS.into_iter().enumerate() {
        let table = Table::below(&document, function);
        let top = TOP + GROUP * row as f64;
        let letters = Letters::PLAIN.left();
        drawing.text([LEFT - 12.0, top + 1.5 * BAR + 4.5], letters, function);
        let mut values = Vec::new();
        for (number, (arm, _, class)) in ARMS.into_iter().enumerate() {
            let operations = table.cell(arm, "operations");
            let length = OPERATION * operations.parse::<f64>().expect("a number");
            let y = top + BAR * number as f64;
            drawing.rectangle(class, [LEFT, y + 1.0], [length.round(), BAR - 2.0], 0.0);
            let words = match number {
                0 => operations.to_owned(),
                _ => format!("{operations}, error {}", percent(table.cell(arm, "error"))),
            };
            drawing.text([LEFT + length + 8.0, y + 13.5], Letters::PLAIN, &words);
            values.push(words);
        }
        let [complete, one, five] = &values[..] else {
            unreachable!("a value for each arm");
        };
        said.push(format!(
            "{function}: {complete}; at 1 % {one}; at 5 % {five}."
        ));
    }
    Picture {
        name: "neglect",
        drawing,
        alternative: format!(
            "Bars: operations of a call for the PUMA 560, complete, with neglect: 1% and with neglect: 5%, and the \
             largest error as a share of the largest value. {}",
            said.join(" ")
        ),
        documents: &["docs/guide/src/scene.md"],
    }
}

/// A share with two digits.
fn percent(share: &str) -> String {
    match share.parse::<f64>().expect("a number") * 100.0 {
        0.0 => "0".to_owned(),
        percent if percent < 1.0 => format!("{percent:.2} %"),
        percent => format!("{percent:.1} %"),
    }
}
