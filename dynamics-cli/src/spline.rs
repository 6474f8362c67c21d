//! Smooth curves through points.

/// Polynomials between points that have the positions and slopes of both ends, and their second derivatives where these
/// are given: of third degree, or of fifth.
pub(crate) struct Spline<'t> {
    pub(crate) times: &'t [f64],
    pub(crate) positions: Vec<f64>,
    pub(crate) slopes: Vec<f64>,
    pub(crate) second_derivatives: Option<Vec<f64>>,
}

impl<'t> Spline<'t> {
    /// The cubic spline through positions at growing times, two or more, with the slopes of both ends: its second
    /// derivative is continuous (de Boor, A Practical Guide to Splines, 1978, chapter IV).
    pub(crate) fn cubic(times: &'t [f64], positions: Vec<f64>, ends: [f64; 2]) -> Self {
        let n = times.len();
        let (mut upper, mut slopes) = (vec![0.0; n], vec![0.0; n]);
        (slopes[0], slopes[n - 1]) = (ends[0], ends[1]);
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
            second_derivatives: None,
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
        // p + s u + b u^2 + c u^3 + d u^4 + f u^5, u from 0 to 1: the squares of long and short times are no numbers.
        let [b, c, d, f] = match &self.second_derivatives {
            None => [3.0 * rise - 2.0 * s - e, s + e - 2.0 * rise, 0.0, 0.0],
            Some(given) => {
                let [b, end] = [given[i], given[i + 1]].map(|x| 0.5 * x * h * h);
                let (r, v, w) = (rise - s - b, e - s - 2.0 * b, end - b);
                let c = 10.0 * r - 4.0 * v + w;
                [b, c, 7.0 * v - 15.0 * r - 2.0 * w, 6.0 * r - 3.0 * v + w]
            }
        };
        let rate = 2.0 * b + u * (3.0 * c + u * (4.0 * d + u * 5.0 * f));
        let second = 2.0 * b + u * (6.0 * c + u * (12.0 * d + u * 20.0 * f));
        [
            p[i] + u * (s + u * (b + u * (c + u * (d + u * f)))),
            (s + u * rate) / h,
            second / h / h,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::Spline;

    /// A polynomial of fifth degree is the one through its values.
    #[test]
    fn motions_are_followed_between_their_samples() {
        let motion = |t: f64| {
            [
                t.powi(5) - t * t,
                5.0 * t.powi(4) - 2.0 * t,
                20.0 * t.powi(3) - 2.0,
            ]
        };
        let times = [-1.0, 0.5, 1.5];
        let list = |k: usize| times.map(|t| motion(t)[k]).to_vec();
        let spline = Spline {
            times: &times,
            positions: list(0),
            slopes: list(1),
            second_derivatives: Some(list(2)),
        };
        for t in [-1.0, -0.3, 0.4, 0.5, 1.1, 1.5] {
            for (found, expected) in spline.at(t).iter().zip(motion(t)) {
                assert!((found - expected).abs() < 1e-12, "{t}: {found} {expected}");
            }
        }
    }

    /// Positions are met, ends have their slopes, and no derivative up to the second jumps.
    #[test]
    fn splines_are_smooth() {
        let times = [0.0, 0.5, 1.5, 2.0, 4.0];
        let positions = [0.0, 1.0, -0.5, 0.25, 2.0];
        let spline = Spline::cubic(&times, positions.to_vec(), [0.5, -2.0]);
        for (t, q) in times.iter().zip(positions) {
            let (before, here, after) = (spline.at(t - 1e-9), spline.at(*t), spline.at(t + 1e-9));
            assert!((here[0] - q).abs() < 1e-12);
            if *t > 0.0 && *t < 4.0 {
                let jump = |k: usize| (before[k] - after[k]).abs();
                assert!(jump(0) < 1e-7 && jump(1) < 1e-6 && jump(2) < 1e-6, "{t}");
            }
        }
        let [start, end] = [0.0, 4.0].map(|t| spline.at(t)[1]);
        assert!((start - 0.5).abs() < 1e-12 && (end + 2.0).abs() < 1e-12);
    }
}
