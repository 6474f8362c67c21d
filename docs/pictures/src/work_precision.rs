//! The work of methods of integration against their precision, of `docs/accuracy/integrators.md`.

use std::path::Path;

use measuring::drawing::{At, Drawing, Letters};

use crate::table::Table;
use crate::{Picture, read};

const SIZE: [f64; 2] = [880.0, 590.0];
/// The upper left corner of each chart, and the size of all.
const CORNERS: [At; 4] = [[70.0, 104.0], [500.0, 104.0], [70.0, 352.0], [500.0, 352.0]];
const CHART: At = [350.0, 176.0];

const MOTIONS: [&str; 4] = [
    "One link, 10 s",
    "Two links, 10 s",
    "PUMA 560, 2 s",
    "Stiff arm, 0.2 s",
];

/// Six of the methods of the tables: those that reach small errors, and differ.
const METHODS: [&str; 6] = [
    "RK4",
    "Gauss-Legendre 6",
    "Dormand-Prince 5(4)",
    "DOP853",
    "Radau IIA 5",
    "Taylor",
];

const ERRORS: [(f64, &str); 4] = [
    (1e-4, "1e-4"),
    (1e-8, "1e-8"),
    (1e-10, "1e-10"),
    (1e-12, "1e-12"),
];

/// Powers of ten in us, between which all times are.
const TIMES: [f64; 4] = [10.0, 100.0, 1_000.0, 10_000.0];

pub(crate) fn picture(root: &Path) -> Picture {
    let document = read(root, "docs/accuracy/integrators.md");
    let title = "Work against precision: time of a run for an error";
    let mut drawing = Drawing::new(title, SIZE);
    drawing.text([20.0, 28.0], Letters::PLAIN.bold().size(15.0), title);
    legend(&mut drawing);
    let mut alternative = "Work against precision of six methods on four motions, a chart each: the time of a run in \
                           us for an error of 1e-4, 1e-8, 1e-10 and 1e-12; - where no run reached the error."
        .to_owned();
    for (motion, corner) in MOTIONS.into_iter().zip(CORNERS) {
        let table = Table::below(&document, &format!("{motion}: work for an error"));
        axes(&mut drawing, motion, corner);
        let mut said = Vec::new();
        for (number, method) in METHODS.into_iter().enumerate() {
            let times = ERRORS.map(|(_, error)| table.cell(method, &format!("{error}: us")));
            curve(&mut drawing, number, corner, times);
            said.push(format!("{method} {}", times.join(", ")));
        }
        alternative += &format!(" {motion}: {}.", said.join("; "));
    }
    Picture {
        name: "work_precision",
        drawing,
        alternative,
        documents: &["docs/guide/src/integration.md", "docs/ACCURACY.md"],
    }
}

fn legend(drawing: &mut Drawing) {
    let mut x = 28.0;
    for (number, method) in METHODS.into_iter().enumerate() {
        drawing.stroke(
            &format!("m{number}"),
            1.5,
            &[[x - 12.0, 54.0], [x + 12.0, 54.0]],
        );
        drawing.mark(number, [x, 54.0]);
        drawing.text([x + 18.0, 58.5], Letters::PLAIN, method);
        x += 60.0 + 7.6 * method.len() as f64;
    }
}

/// Where an error and a time are in a chart: small errors to the right, long times above.
fn place([left, top]: At, error: f64, time: f64) -> At {
    let share = |value: f64, [low, high]: [f64; 2]| (value / low).ln() / (high / low).ln();
    let right = share(error, [3e-4, 3e-13]);
    let up = share(time, [TIMES[0], TIMES[3]]);
    [left + CHART[0] * right, top + CHART[1] * (1.0 - up)]
}

fn axes(drawing: &mut Drawing, motion: &str, [left, top]: At) {
    let [right, bottom] = [left + CHART[0], top + CHART[1]];
    drawing.text([left, top - 10.0], Letters::PLAIN.bold(), motion);
    for time in TIMES {
        let [_, y] = place([left, top], 1e-4, time);
        drawing.line([left, y], [right, y]);
        let letters = Letters::PLAIN.left().size(12.0);
        drawing.text([left - 8.0, y + 4.0], letters, &format!("{time}"));
    }
    drawing.text(
        [left - 8.0, top - 10.0],
        Letters::PLAIN.left().size(12.0),
        "us",
    );
    for (error, name) in ERRORS {
        let [x, _] = place([left, top], error, TIMES[0]);
        drawing.line([x, top], [x, bottom]);
        drawing.text(
            [x, bottom + 18.0],
            Letters::PLAIN.centred().size(12.0),
            name,
        );
    }
    let letters = Letters::PLAIN.centred().size(12.0).ink("faint");
    drawing.text(
        [left + 0.5 * CHART[0], bottom + 36.0],
        letters,
        "error at the end: smaller to the right",
    );
}

/// The times of a method: a mark for each error that it reaches.
fn curve(drawing: &mut Drawing, number: usize, corner: At, times: [&str; 4]) {
    let reached = ERRORS.iter().zip(times).filter(|(_, time)| *time != "-");
    let places: Vec<At> = reached
        .map(|((error, _), time)| place(corner, *error, time.parse().expect("a time")))
        .collect();
    drawing.stroke(&format!("m{number}"), 1.5, &places);
    for at in places {
        drawing.mark(number, at);
    }
}
