//! Numbers in columns.

/// A number with so many significant digits, without zeros at its end.
pub(crate) fn significant(x: f64, digits: usize) -> String {
    // Zero has no sign here.
    let x = if x == 0.0 { 0.0 } else { x };
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    match exponent.parse::<i32>() {
        Ok(power @ -4..=16) if power < digits.max(6) as i32 => {
            let decimals = (digits as i32 - 1 - power).max(0) as usize;
            trimmed(&format!("{x:.decimals$}"))
        }
        _ => format!("{}e{exponent}", trimmed(mantissa)),
    }
}

/// Rows with columns of one width: the first to the left where it has names, all others to the right.
pub(crate) fn aligned(rows: &[Vec<String>], has_names: bool) -> Vec<String> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).enumerate();
        let cells = cells.map(|(column, (cell, width))| {
            if column == 0 && has_names {
                format!("{cell:<width$}")
            } else {
                format!("{cell:>width$}")
            }
        });
        cells.collect::<Vec<_>>().join("  ")
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn numbers_have_their_digits() {
        for (x, digits, expected) in [
            (0.0, 6, "0"),
            (-0.0, 6, "0"),
            (-0.5, 6, "-0.5"),
            (1.0 / 3.0, 6, "0.333333"),
            (123_456.7, 6, "123457"),
            (100.0, 1, "100"),
            (1.5e-7, 6, "1.5e-7"),
            (9.81e12, 6, "9.81e12"),
            (0.1, 17, "0.10000000000000001"),
            (0.99999999, 3, "1"),
        ] {
            assert_eq!(significant(x, digits), expected);
        }
    }
}
