//! Mistakes in a file, each with the line that it is in.

use std::ops::Range;

use ariadne::{Color, Config, Label, Report, ReportKind, Source};
use dynamics_codegen::visible;
use dynamics_evaluation::{FileMistake, read_text};

/// The mistakes as a person reads them: `FILE:LINE:COLUMN: what is wrong`, and below it the place in the file.
/// If the file cannot be read any more, the place is left out.
pub(crate) fn with_excerpts(mistakes: &[FileMistake], is_coloured: bool) -> String {
    let mut shown = Vec::with_capacity(mistakes.len());
    for of_one_file in mistakes.chunk_by(|a, b| a.file == b.file) {
        let file = of_one_file[0].file.as_deref();
        let text = file.and_then(|file| read_text(file).ok());
        let text = text.map(|text| without_controls(&text));
        shown.extend(of_one_file.iter().map(|mistake| {
            let text = text.as_deref();
            let excerpt = text.and_then(|text| excerpt_of(mistake, text, is_coloured));
            excerpt.unwrap_or_else(|| message(mistake))
        }));
    }
    shown.join("\n")
}

/// The message of a mistake without its place in the file. It may quote words of the file.
fn message(mistake: &FileMistake) -> String {
    without_controls(&mistake.to_string())
}

/// The text with a visible character for each one that would act on the terminal: control characters, except for the
/// end of a line and the tab, and those that change the direction of writing. It has as many characters as before, so
/// that places in it stay what they are.
pub(crate) fn without_controls(text: &str) -> String {
    let mut rest = text.chars().peekable();
    let mut shown = String::with_capacity(text.len());
    while let Some(c) = rest.next() {
        shown.push(match c {
            '\n' | '\t' => c,
            '\r' if rest.peek() == Some(&'\n') => c,
            _ => visible(c),
        });
    }
    shown
}

fn excerpt_of(mistake: &FileMistake, text: &str, is_coloured: bool) -> Option<String> {
    let file = without_controls(&mistake.file.as_ref()?.display().to_string());
    let span = (file.clone(), word(mistake, text)?);
    let mut report = Vec::new();
    Report::build(ReportKind::Error, span.clone())
        .with_config(Config::default().with_color(is_coloured))
        .with_label(Label::new(span).with_message("here").with_color(Color::Red))
        .finish()
        .write((file, Source::from(text)), &mut report)
        .ok()?;
    // The report's own first line is for a message without a place.
    let report = String::from_utf8_lossy(&report);
    let (_, place) = report.trim_end().split_once('\n')?;
    Some(format!("{}\n{place}", message(mistake)))
}

/// Which characters of the text are the word that a mistake begins at.
fn word(mistake: &FileMistake, text: &str) -> Option<Range<usize>> {
    let line = mistake.line.checked_sub(1)?;
    let before: usize = text
        .split_inclusive('\n')
        .take(line)
        .map(|l| l.chars().count())
        .sum();
    let line = text.lines().nth(line)?;
    let column = mistake.column.checked_sub(1)?;
    let is_of_a_word = |c: &char| c.is_alphanumeric() || "_.-+".contains(*c);
    let length = line.chars().skip(column).take_while(is_of_a_word).count();
    let start = before + column.min(line.chars().count());
    Some(start..start + length.max(1))
}

#[cfg(test)]
mod tests {
    use super::{excerpt_of, with_excerpts, without_controls};
    use dynamics_evaluation::FileMistake;

    fn mistake(file: &str, line: usize, column: usize) -> FileMistake {
        let mut mistake = FileMistake::default();
        mistake.file = Some(file.into());
        (mistake.line, mistake.column) = (line, column);
        mistake.message = "unknown cell `mas`: did you mean `mass`?".to_owned();
        mistake
    }

    #[test]
    fn the_word_is_marked_below_the_message() {
        let text = "# L\u{e9}ger, \u{f6} and \u{fc}\n[[joint]]\n  mas = 2\n";
        let told = excerpt_of(&mistake("two.toml", 3, 3), text, false).expect("an excerpt");
        let lines: Vec<_> = told.lines().collect();
        assert_eq!(
            lines[0],
            "two.toml:3:3: unknown cell `mas`: did you mean `mass`?"
        );
        let marked = lines
            .iter()
            .position(|line| line.contains("mas = 2"))
            .expect("the line");
        let column = |line: &str, what: &str| line.find(what).map(|at| line[..at].chars().count());
        let below = lines[marked + 1];
        assert_eq!(
            column(below, "\u{2500}"),
            column(lines[marked], "mas"),
            "{told}"
        );
        assert!(
            below.trim_end().ends_with(" \u{2500}\u{252c}\u{2500}"),
            "{told}"
        );
    }

    /// A file may hold what would colour, move or rename the terminal, or write from right to left.
    #[test]
    fn what_would_act_on_a_terminal_is_shown() {
        let text = "a = 1 # \u{1b}[31m\u{9b}2J\u{7f}\u{202e}\r\nmas\t= 2\u{0}\r# \u{c}\n";
        let shown = without_controls(text);
        assert_eq!(
            shown,
            "a = 1 # \u{241b}[31m\u{fffd}2J\u{2421}\u{fffd}\r\nmas\t= 2\u{2400}\u{240d}# \u{240c}\n"
        );
        assert_eq!(shown.chars().count(), text.chars().count());
        let name = "mas\u{1b}]0;x\u{7}.toml";
        let folder = std::env::temp_dir().join(format!("excerpts_{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let file = folder.join(name);
        std::fs::write(&file, text).expect("a file");
        let mut mistake = mistake(&file.to_string_lossy(), 2, 1);
        mistake.message = "unknown cell `\u{1b}[5m`".to_owned();
        let told = with_excerpts(&[mistake], false);
        std::fs::remove_dir_all(&folder).expect("the folder");
        assert!(
            told.contains("mas") && told.contains("= 2\u{2400}\u{240d}#"),
            "{told:?}"
        );
        let acts = |c: char| c.is_control() && c != '\n';
        assert!(!told.contains(acts), "{told:?}");
    }

    /// At the end of a file, behind it, and in one that is not there.
    #[test]
    fn places_outside_of_a_text_are_told_all_the_same() {
        for (line, column) in [(1, 4), (1, 90), (7, 1), (0, 0)] {
            let mistake = mistake("nowhere/two.toml", line, column);
            let _ = excerpt_of(&mistake, "mas", false);
            assert_eq!(
                with_excerpts(std::slice::from_ref(&mistake), true),
                mistake.to_string()
            );
        }
    }
}
