//! Powers of the number of joints.

use measuring::power;

/// The power that is nearest to the points in the upper half of the range of x, where the largest one shows. `None` if
/// that has fewer than three points.
pub(crate) fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let largest = points
        .iter()
        .fold(0.0_f64, |largest, point| largest.max(point.0));
    let upper = points.iter().filter(|point| 2.0 * point.0 >= largest);
    power(&upper.copied().collect::<Vec<_>>())
}
