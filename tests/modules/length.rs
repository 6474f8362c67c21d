//! Functions of the product are short.

/// The functions of a formatted source that have more lines than `longest`, each with its number of lines. Modules of tests
/// are left out.
pub(crate) fn long_functions(text: &str, longest: usize) -> Vec<(String, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    let mut i = 0;
    while i < lines.len() {
        let end = end_of_block(&lines, i);
        if lines[i].trim() == "#[cfg(test)]" {
            i = end_of_block(&lines, i + 1);
        } else if let Some(name) = function(lines[i])
            && end - i >= longest
        {
            found.push((name.to_owned(), end - i + 1));
        }
        i += 1;
    }
    found
}

/// The last line of an item that begins here: the first one that closes a block or a signature at the same depth.
fn end_of_block(lines: &[&str], start: usize) -> usize {
    let Some(first) = lines.get(start) else {
        return start;
    };
    if first.ends_with([';', '}']) {
        return start;
    }
    let depth = first.len() - first.trim_start().len();
    let closes = |line: &&str| {
        line.split_at_checked(depth).is_some_and(|(before, rest)| {
            before.trim().is_empty()
                && (rest == "}" || rest.starts_with(')') && rest.ends_with(';'))
        })
    };
    let length = lines[start..].iter().position(closes);
    start + length.unwrap_or(0)
}

/// The name of the function that begins in a line.
fn function(line: &str) -> Option<&str> {
    let (before, after) = line.split_once("fn ")?;
    let is_qualifier =
        |word: &str| ["const", "async", "unsafe"].contains(&word) || word.starts_with("pub");
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    before
        .split_whitespace()
        .all(is_qualifier)
        .then(|| after.split(|c| !is_name(c)).next())
        .flatten()
        .filter(|name| !name.is_empty())
}

/// Or the test of the product would pass whatever it holds.
#[test]
fn long_functions_are_found() {
    let text = "\
impl A {
    pub(crate) const fn long(
        a: usize,
    ) -> usize {
        a
    }

    fn short() {}
}
trait B {
    fn declared(
        a: usize,
    ) -> usize;
}
#[cfg(test)]
mod tests {
    fn of_tests() {
        let a = 1;
        let b = 2;
        let c = 3;
        a + b + c;
    }
}
";
    assert_eq!(long_functions(text, 4), [("long".to_owned(), 5)]);
    assert_eq!(long_functions(text, 5), []);
}
