//! Generated values printed beside printed formulas; a difference beyond rounding stops the example.

/// The heading of a comparison.
pub(crate) fn heading(title: &str) {
    println!("\n{title}");
    println!(
        "  {:<58} {:>14} {:>14} {:>10}",
        "", "generated", "formula", "difference"
    );
}

/// One line of a comparison: what the generated function gives, and what the formula gives.
///
/// # Panics
///
/// Where they differ by more than the rounding of a short formula, 1e-14 of the larger of the
/// value and one.
pub(crate) fn row(formula: &str, generated: f64, expected: f64) {
    let difference = (generated - expected).abs();
    println!("  {formula:<58} {generated:>14.9} {expected:>14.9} {difference:>10.0e}");
    assert!(
        difference <= 1e-14 * expected.abs().max(1.0),
        "{formula}: {generated} is not {expected}"
    );
}
