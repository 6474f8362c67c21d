//! Smooth curves through points.

/// A cubic spline with slopes of zero at both ends (de Boor, A Practical Guide to Splines, 1978,
/// chapter IV): on each piece a cubic that has the given positions and slopes at its ends, slopes such
/// that the second derivative is continuous.
pub(crate) struct Spline<'t> {
    times: &'t [f64],
    positions: Vec<f64>,
    slopes: Vec<f64>,
}

impl<'t> Spline<'t> {
    /// Through positions at growing times, two or more.
    pub(crate) fn new(times: &'t [f64], positions: Vec<f64>) -> Self {
        let n = times.len();
        let (mut upper, mut slopes) = (vec![0.0; n], vec![0.0; n]);
        // s[i-1] / h + 2 s[i] (1/h + 1/k) + s[i+1] / k = 3 (dp/h^2 + dp'/k^2), solved from the left.
        for i in 1..n - 1 {
            let (h, k) = (times[i] - times[i - 1], times[i + 1] - times[i]);
            let (before, after) = (
                positions[i] - positions[i - 1],
                positions[i + 1] - positions[i],
            );
            let right = 3.0 * (before / h / h + after / k / k);
            let pivot = 2.0 * (1.0 / h + 1.0 / k) - upper[i - 1] / h;
            upper[i] = 1.0 / (k * pivot);
            slopes[i] = (right - slopes[i - 1] / h) / pivot;
        }
        for i in (1..n - 1).rev() {
            slopes[i] -= upper[i] * slopes[i + 1];
        }
        Spline {
            times,
            positions,
            slopes,
        }
    }

    /// Position, velocity and acceleration.
    pub(crate) fn at(&self, t: f64) -> [f64; 3] {
        let last = self.times.len() - 2;
        let after = self.times.partition_point(|time| *time <= t);
        let i = after.saturating_sub(1).min(last);
        let h = self.times[i + 1] - self.times[i];
        let (u, p) = ((t - self.times[i]) / h, &self.positions);
        let (rise, s, e) = (p[i + 1] - p[i], self.slopes[i] * h, self.slopes[i + 1] * h);
        // p + s u + b u^2 + c u^3 with u from 0 to 1: the squares of long and short times are no numbers.
        let b = 3.0 * rise - 2.0 * s - e;
        let c = s + e - 2.0 * rise;
        [
            p[i] + u * (s + u * (b + u * c)),
            (s + u * (2.0 * b + u * 3.0 * c)) / h,
            (2.0 * b + u * 6.0 * c) / h / h,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::Spline;

    /// Positions are met, ends are at rest, and no derivative up to the second jumps.
    #[test]
    fn splines_are_smooth() {
        let times = [0.0, 0.5, 1.5, 2.0, 4.0];
        let positions = [0.0, 1.0, -0.5, 0.25, 2.0];
        let spline = Spline::new(&times, positions.to_vec());
        for (t, q) in times.iter().zip(positions) {
            let (before, here, after) = (spline.at(t - 1e-9), spline.at(*t), spline.at(t + 1e-9));
            assert!((here[0] - q).abs() < 1e-12);
            if *t > 0.0 && *t < 4.0 {
                let jump = |k: usize| (before[k] - after[k]).abs();
                assert!(jump(0) < 1e-7 && jump(1) < 1e-6 && jump(2) < 1e-6, "{t}");
            }
        }
        assert!(spline.at(0.0)[1].abs() < 1e-12 && spline.at(4.0)[1].abs() < 1e-12);
    }
}
