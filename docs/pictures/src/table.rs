//! Tables of `docs/accuracy`.

/// A table in Markdown.
pub(crate) struct Table<'a> {
    heads: Vec<&'a str>,
    rows: Vec<Vec<&'a str>>,
}

impl<'a> Table<'a> {
    /// The table below the line `title:`.
    ///
    /// # Panics
    ///
    /// Where there is none.
    pub(crate) fn below(document: &'a str, title: &str) -> Self {
        let behind = document.split_once(&format!("\n{title}:\n\n"));
        let (_, behind) = behind.unwrap_or_else(|| panic!("no table `{title}`"));
        let mut lines = behind.lines().take_while(|line| line.starts_with('|'));
        let cells = |line: &'a str| -> Vec<&'a str> {
            let inner = line.trim_matches('|').split('|');
            inner.map(str::trim).collect()
        };
        let heads = cells(lines.next().expect("heads"));
        let rows = lines.skip(1).map(cells).collect();
        Table { heads, rows }
    }

    /// The cell of the row that begins so, in the column of this head.
    ///
    /// # Panics
    ///
    /// Where there is none.
    pub(crate) fn cell(&self, begin: &str, head: &str) -> &'a str {
        let column = self.heads.iter().position(|known| *known == head);
        let row = self.rows.iter().find(|row| row[0] == begin);
        match (row, column) {
            (Some(row), Some(column)) => row[column],
            _ => panic!("no cell `{begin}`, `{head}`"),
        }
    }
}
