//! Trees and bases that move, beside Pinocchio.

use measuring::table::Table;

use super::{FUNCTIONS, Purpose, robot, two_digits};
use crate::appendix::{Rows, number};
use crate::chart::{Chart, Series};

/// Robots beside Pinocchio: what the table of an appendix calls a time, and what the page calls it.
const COLUMNS: [(&str, &str); 4] = [
    ("ns", "one state"),
    ("batch, ns", "batch"),
    ("f32 batch, ns", "f32 batch"),
    ("Pinocchio, ns", "Pinocchio"),
];

pub(super) fn robots(name: &'static str, title: &'static str, rows: &Rows) -> Purpose {
    let columns = COLUMNS
        .iter()
        .filter(|(head, _)| rows.heads.iter().any(|known| known == head));
    let columns: Vec<_> = columns.copied().collect();
    let names = columns.iter().map(|(_, name)| *name);
    let heads = ["robot", "function"].into_iter().chain(names);
    let heads: Vec<&str> = heads.chain(["Pinocchio / one state"]).collect();
    let mut table = Table::new("", &heads);
    let [ours, theirs] = ["ns", "Pinocchio, ns"].map(|head| rows.cells(head));
    for (number_of_row, row) in rows.rows.iter().enumerate() {
        let cells = columns
            .iter()
            .map(|(head, _)| rows.cells(head)[number_of_row].to_owned());
        let ratio = match theirs[number_of_row] {
            "" => String::new(),
            theirs => two_digits(number(theirs) / number(ours[number_of_row])),
        };
        let names = [robot(&row[0]).to_owned(), format!("`{}`", row[1])];
        table.row(names.into_iter().chain(cells).chain([ratio]));
    }
    let series = columns.iter().map(|&(head, name)| Series {
        name,
        // Pinocchio's mark is the same with and without batches of `f32`.
        mark: COLUMNS
            .iter()
            .position(|column| column.0 == head)
            .unwrap_or(0),
        values: rows
            .cells(head)
            .iter()
            .map(|cell| (!cell.is_empty()).then(|| number(cell)))
            .collect(),
    });
    let symbol = |function: &str| {
        let known = FUNCTIONS.iter().find(|(name, _)| *name == function);
        known
            .map_or("derivatives of qdd", |(_, symbol)| symbol)
            .to_owned()
    };
    let labels = rows.rows.iter();
    let labels = labels.map(|row| format!("{}, {}", robot(&row[0]), symbol(&row[1])));
    Purpose {
        name,
        text: table.markdown_rows(),
        chart: Some(Chart {
            file: name,
            title,
            rows: labels.collect(),
            series: series.collect(),
        }),
    }
}
