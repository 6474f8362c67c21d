//! Powers that are fitted to measured points.

/// The p of y = c x^p that is nearest to some points, by least squares on the logarithms; `None` for fewer than three.
pub fn power(points: &[(f64, f64)]) -> Option<f64> {
    if points.len() < 3 {
        return None;
    }
    let logarithms: Vec<_> = points.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let count = logarithms.len() as f64;
    let (x, y) = logarithms
        .iter()
        .fold((0.0, 0.0), |sum, p| (sum.0 + p.0, sum.1 + p.1));
    let (x, y) = (x / count, y / count);
    let covariance: f64 = logarithms.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = logarithms.iter().map(|p| (p.0 - x).powi(2)).sum();
    Some(covariance / variance)
}
