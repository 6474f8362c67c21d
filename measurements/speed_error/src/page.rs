//! The page: sections of text, tables and plots, in one file that needs no other. Beside it, the appendices of
//! `docs/ACCURACY.md`.

use std::path::Path;

use measuring::table::{Table, escaped};

/// Something of a section, in its order.
pub(crate) enum Part {
    Text(String),
    /// The text that explains the plots.
    Legend(&'static str),
    Table(Table),
    /// A table that is shown when it is asked for.
    Folded(Table),
    /// Lines as they are.
    Lines(String),
    /// A plot as SVG, and the name of its file.
    Plot(String, String),
}

/// A section of the report.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    /// The file of `docs/accuracy` that has its texts and tables, without `.md`.
    appendix: Option<&'static str>,
    pub(crate) parts: Vec<Part>,
}

impl Section {
    pub(crate) fn new(title: &'static str) -> Self {
        Section {
            title,
            appendix: None,
            parts: Vec::new(),
        }
    }

    /// A section that is an appendix of `docs/ACCURACY.md`, too.
    pub(crate) fn appendix(title: &'static str, file: &'static str) -> Self {
        Section {
            appendix: Some(file),
            ..Section::new(title)
        }
    }

    pub(crate) fn text(&mut self, text: impl Into<String>) {
        self.parts.push(Part::Text(text.into()));
    }

    /// The tables and texts, for a terminal.
    pub(crate) fn print(&self) {
        println!(
            "\n{}\n{}\n",
            self.title,
            "=".repeat(self.title.chars().count())
        );
        for part in &self.parts {
            match part {
                Part::Text(text) => println!("{text}\n"),
                Part::Legend(_) => {}
                Part::Lines(lines) => println!("{lines}"),
                Part::Table(table) | Part::Folded(table) => println!("{}", table.text()),
                Part::Plot(..) => {}
            }
        }
    }

    /// The texts and the tables that are shown, as a file of `docs/accuracy`.
    fn markdown(&self, command: &str, conditions: &Table) -> String {
        let parts = self.parts.iter().filter_map(|part| match part {
            Part::Text(text) => Some(format!("{text}\n\n")),
            Part::Table(table) => Some(format!("{}\n", table.markdown())),
            Part::Lines(lines) => Some(format!("```text\n{lines}```\n\n")),
            Part::Folded(_) | Part::Legend(_) | Part::Plot(..) => None,
        });
        format!(
            "# {}\n\nAn appendix of [Speed against error](../ACCURACY.md), written by `{command}`.\n\n{}\n{}",
            self.title,
            conditions.markdown_rows(),
            parts.collect::<String>().trim_end()
        ) + "\n"
    }

    fn html(&self) -> String {
        let parts = self.parts.iter().map(|part| match part {
            Part::Text(text) => format!("<p>{}</p>\n", escaped(text)),
            Part::Legend(text) => format!("<p>{}</p>\n", escaped(text)),
            Part::Table(table) => table.html(),
            Part::Folded(table) => {
                let title = escaped(&table.title);
                format!(
                    "<details><summary>{title}</summary>{}</details>\n",
                    table.html()
                )
            }
            Part::Lines(lines) => format!("<pre>{}</pre>\n", escaped(lines)),
            Part::Plot(_, svg) => format!("<figure>{svg}</figure>\n"),
        });
        format!(
            "<h2>{}</h2>\n{}",
            escaped(self.title),
            parts.collect::<String>()
        )
    }
}

/// The command that writes all of it anew, with the arguments of this run at its end.
fn command() -> String {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let separator = if arguments.is_empty() { "" } else { " -- " };
    format!(
        "taskset -c 1 cargo run --release -p speed_error --features long_arms{separator}{}",
        arguments.join(" ")
    )
}

const STYLE: &str = "body{font:16px/1.5 sans-serif;max-width:1000px;margin:2em auto;padding:0 1em}\
table{border-collapse:collapse;margin:1em 0;font-size:14px}\
td,th{padding:2px 9px;text-align:right;border-bottom:1px solid #ddd}\
td:first-child,th:first-child{text-align:left}caption{text-align:left;font-weight:bold}\
figure{margin:1em 0}svg{max-width:100%;height:auto}pre{font-size:12px;overflow-x:auto}summary{cursor:pointer}";

/// Writes the page, and beside it the appendices as Markdown and every plot as a file.
pub(crate) fn write(
    path: &Path,
    conditions: &[(&'static str, String)],
    sections: &[Section],
) -> std::io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)?;
    let mut table = Table::new("Conditions", &["condition", "value"]);
    for (name, value) in conditions {
        table.row([(*name).to_owned(), value.clone()]);
    }
    let body: String = sections.iter().map(Section::html).collect();
    let title = "Speed against error";
    std::fs::write(
        path,
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\
             <style>{STYLE}</style></head>\n<body><h1>{title}</h1>\n{}{body}</body></html>\n",
            table.html()
        ),
    )?;
    let command = command();
    for section in sections {
        if let Some(file) = section.appendix {
            let path = folder.join(file).with_extension("md");
            std::fs::write(path, section.markdown(&command, &table))?;
        }
    }
    for part in sections.iter().flat_map(|section| &section.parts) {
        if let Part::Plot(name, svg) = part {
            std::fs::write(folder.join(name).with_extension("svg"), svg)?;
        }
    }
    Ok(())
}
