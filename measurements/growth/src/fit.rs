//! Powers of the number of joints.

/// The p of y = c x^p that is nearest to some points, by least squares on the logarithms, over
/// the upper half of the range of x, where the largest power shows. `None` where that has fewer
/// than three points.
pub(crate) fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let largest = points
        .iter()
        .fold(0.0, |largest: f64, point| largest.max(point.0));
    let upper = points.iter().filter(|point| 2.0 * point.0 >= largest);
    let logarithms: Vec<_> = upper.map(|point| (point.0.ln(), point.1.ln())).collect();
    if logarithms.len() < 3 {
        return None;
    }
    let count = logarithms.len() as f64;
    let (x, y) = logarithms
        .iter()
        .fold((0.0, 0.0), |sum, p| (sum.0 + p.0, sum.1 + p.1));
    let (x, y) = (x / count, y / count);
    let covariance: f64 = logarithms.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = logarithms.iter().map(|p| (p.0 - x).powi(2)).sum();
    Some(covariance / variance)
}
