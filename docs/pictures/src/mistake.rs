//! A mistake in a table, as the compiler shows it in a terminal.

use std::path::Path;

use measuring::drawing::{At, Drawing, Letters};

use crate::{Picture, read};

/// The compiler's output, held by `tests/compile-fail`.
const MESSAGE: &str = "tests/compile-fail/cases/readme.stderr";

const SIZE: f64 = 12.5;
/// The width of a letter.
const LETTER: f64 = 0.6 * SIZE;
const LINE: f64 = 19.0;
/// The first letter of the first line.
const BEGIN: At = [18.0, 62.0];

pub(crate) fn picture(root: &Path) -> Picture {
    let message = shown(&read(root, MESSAGE));
    let lines: Vec<&str> = message.lines().collect();
    let longest = lines.iter().map(|line| line.chars().count()).max();
    let width = (2.0 * BEGIN[0] + LETTER * longest.unwrap_or(0) as f64).ceil();
    let height = BEGIN[1] + LINE * lines.len() as f64;
    let title = "A mistake in a table: the compiler's message";
    let mut drawing = Drawing::new(title, [width, height]);
    drawing.rectangle("band", [0.0, 0.0], [width, 32.0], 0.0);
    for dot in 0..3 {
        drawing.disc("faint", [20.0 + 18.0 * f64::from(dot), 16.0], 5.0);
    }
    let head = Letters::PLAIN.mono().centred().size(SIZE).ink("faint");
    drawing.text([0.5 * width, 20.5], head, "rustc");
    for (number, line) in lines.iter().enumerate() {
        draw(&mut drawing, BEGIN[1] + LINE * number as f64, line);
    }
    Picture {
        name: "mistake",
        drawing,
        alternative: alternative(&lines),
        documents: &["README.md", "docs/guide/src/five_minutes.md"],
    }
}

/// The first error, with the line's number in the file, for which the tests write `LL`.
fn shown(message: &str) -> String {
    let (first, _) = message.split_once("\n\n").expect("a second error");
    let (_, place) = first.split_once(".rs:").expect("a place");
    let (number, _) = place.split_once(':').expect("line and column");
    let (wide, narrow) = ("  ", " ".repeat(number.len()));
    let lines = first.lines().map(|line| match line.strip_prefix("LL") {
        Some(code) => format!("{number}{code}\n"),
        None => match line.strip_prefix(wide) {
            Some(rest) => format!("{narrow}{rest}\n"),
            None => format!("{line}\n"),
        },
    });
    lines.collect()
}

/// A line in the compiler's colours.
fn draw(drawing: &mut Drawing, y: f64, line: &str) {
    let plain = Letters::PLAIN.mono().size(SIZE);
    let (red, blue) = (plain.bold().ink("red"), plain.bold().ink("blue"));
    let parts = if let Some(words) = line.strip_prefix("error") {
        [("error", red), (words, plain.bold())]
    } else if let Some(arrow) = line.find("--> ") {
        let (arrow, place) = line.split_at(arrow + 4);
        [(arrow, blue), (place, plain)]
    } else {
        let bar = line.find('|').map_or(0, |bar| bar + 1);
        let (gutter, code) = line.split_at(bar);
        let code_is_caret = !code.is_empty() && code.trim_matches([' ', '^']).is_empty();
        [
            (gutter, blue),
            (code, if code_is_caret { red } else { plain }),
        ]
    };
    let mut x = BEGIN[0];
    for (part, letters) in parts {
        // Leading spaces are a distance.
        let words = part.trim_start();
        let before = part.chars().count() - words.chars().count();
        let at = [x + LETTER * before as f64, y];
        x += LETTER * part.chars().count() as f64;
        if !words.trim_end().is_empty() {
            drawing.text(at, letters, words.trim_end());
        }
    }
}

/// The message in words: the carets' place is the code above them.
fn alternative(lines: &[&str]) -> String {
    let error = lines[0].replace('`', "");
    let place = lines[1].trim_start_matches([' ', '-', '>']);
    let [code, carets] = [lines[3], lines[4]].map(|line| line.split_once('|').expect("code").1);
    let begin = carets.find('^').expect("carets");
    let marked = &code[begin..=carets.rfind('^').expect("carets")];
    format!(
        "A terminal. rustc prints: \"{}\". It names the place {place}, shows the line `{}`, and marks `{marked}` by \
         carets below it.",
        error.replace('[', "\\[").replace(']', "\\]"),
        code.trim()
    )
}
