//! The page: text with a place for each table.

use crate::purposes::Purpose;

/// The one place of this text. Each `{NAME}` is a table.
const TEXT: &str = include_str!("page.txt");

/// # Panics
///
/// Where a table has no place, or a place no table.
pub(crate) fn page(purposes: &[Purpose]) -> String {
    let page = purposes.iter().fold(TEXT.to_owned(), |page, purpose| {
        let place = format!("{{{}}}\n", purpose.name);
        assert_eq!(page.matches(&place).count(), 1, "{place}");
        page.replace(&place, &purpose.text)
    });
    let left = page.lines().find(|line| line.starts_with('{'));
    assert!(left.is_none(), "nothing is at {left:?}");
    page
}
