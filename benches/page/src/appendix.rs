//! The tables that were measured, as the appendices have them.

use std::fs;
use std::path::Path;

/// All appendices that the page is written from.
pub(crate) struct Appendices {
    pub(crate) arms: Appendix,
    pub(crate) trees: Appendix,
    pub(crate) inverse_kinematics: Appendix,
    pub(crate) c: Appendix,
    pub(crate) optimal_control: Appendix,
    pub(crate) generators: Appendix,
    pub(crate) goals: Appendix,
}

impl Appendices {
    pub(crate) fn read(root: &Path) -> Self {
        let read = |path: &str| {
            let text = fs::read_to_string(root.join("docs").join(path));
            Appendix::new(path, text.unwrap_or_else(|error| panic!("{path}: {error}")))
        };
        Appendices {
            arms: read("performance/arms.md"),
            trees: read("performance/trees.md"),
            inverse_kinematics: read("performance/inverse_kinematics.md"),
            c: read("performance/c.md"),
            optimal_control: read("performance/optimal_control.md"),
            generators: read("performance/generators.md"),
            goals: read("contributing/goals/README.md"),
        }
    }
}

/// A document with regions that programs write: between `<!-- NAME -->` and `<!-- end -->`.
pub(crate) struct Appendix {
    /// From the folder `docs`.
    pub(crate) path: String,
    text: String,
}

impl Appendix {
    pub(crate) fn new(path: &str, text: String) -> Self {
        let path = path.to_owned();
        Appendix { path, text }
    }

    /// The command that writes the document: the first words in code.
    pub(crate) fn command(&self) -> &str {
        let command = self.text.split('`').nth(1);
        command.unwrap_or_else(|| panic!("{} names its command", self.path))
    }

    /// # Panics
    ///
    /// Where there is no such region.
    pub(crate) fn region(&self, name: &str) -> Region {
        let behind = self.text.split_once(&format!("<!-- {name} -->\n"));
        let region = behind.and_then(|(_, behind)| behind.split_once("<!-- end -->"));
        let (region, _) = region.unwrap_or_else(|| panic!("{} has no `{name}`", self.path));
        Region::new(region)
    }
}

/// A region that a program has written.
pub(crate) struct Region {
    /// The first line: processor, compilers and date.
    pub(crate) conditions: String,
    /// Tables, and the headings above them.
    tables: Vec<(String, Rows)>,
}

impl Region {
    fn new(text: &str) -> Self {
        let (mut heading, mut tables) = (String::new(), Vec::new());
        let mut is_in_table = false;
        for line in text.lines() {
            let Some(cells) = line.strip_prefix("| ") else {
                if line.starts_with('#') {
                    heading = line.trim_start_matches('#').trim().to_owned();
                }
                is_in_table &= line.starts_with("|--");
                continue;
            };
            let cells = cells.strip_suffix('|').unwrap_or(cells);
            let cells: Vec<String> = cells.split('|').map(|cell| cell.trim().into()).collect();
            match tables.last_mut() {
                Some((_, Rows { rows, .. })) if is_in_table => rows.push(cells),
                _ => tables.push((
                    heading.clone(),
                    Rows {
                        heads: cells,
                        rows: Vec::new(),
                    },
                )),
            }
            is_in_table = true;
        }
        let conditions = text.lines().next().unwrap_or_default();
        Region {
            conditions: conditions.trim_end_matches('.').to_owned(),
            tables,
        }
    }

    /// The first table.
    pub(crate) fn table(&self) -> &Rows {
        &self.tables.first().expect("the region has a table").1
    }

    /// The first table below a heading.
    pub(crate) fn below(&self, heading: &str) -> &Rows {
        let found = self.tables.iter().find(|(above, _)| above == heading);
        &found
            .unwrap_or_else(|| panic!("a table below `{heading}`"))
            .1
    }
}

/// A table.
pub(crate) struct Rows {
    pub(crate) heads: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Rows {
    /// The place of the first column with this head.
    fn column(&self, head: &str) -> usize {
        let place = self.heads.iter().position(|known| known == head);
        place.unwrap_or_else(|| panic!("no column `{head}` in {:?}", self.heads))
    }

    /// The cells of the first column with this head.
    pub(crate) fn cells(&self, head: &str) -> Vec<&str> {
        let column = self.column(head);
        self.rows.iter().map(|row| row[column].as_str()).collect()
    }

    /// The cell of a column in the first row that begins with some words.
    pub(crate) fn cell(&self, begin: &[&str], head: &str) -> &str {
        let column = self.column(head);
        let row = self
            .rows
            .iter()
            .find(|row| row.iter().zip(begin).all(|(a, b)| a == b));
        &row.unwrap_or_else(|| panic!("no row {begin:?} in {:?}", self.heads))[column]
    }

    /// The number in such a cell; nothing where it is empty.
    pub(crate) fn number(&self, begin: &[&str], head: &str) -> Option<f64> {
        let cell = self.cell(begin, head);
        (!cell.is_empty()).then(|| number(cell))
    }

    /// The distinct cells of the first column, in their order.
    pub(crate) fn firsts(&self) -> Vec<&str> {
        let mut firsts: Vec<&str> = Vec::new();
        for row in &self.rows {
            if firsts.last() != Some(&row[0].as_str()) {
                firsts.push(&row[0]);
            }
        }
        firsts
    }
}

pub(crate) fn number(cell: &str) -> f64 {
    cell.parse()
        .unwrap_or_else(|error| panic!("`{cell}`: {error}"))
}
