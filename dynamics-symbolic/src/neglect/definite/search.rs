//! The search for numbers that make matrices positive definite which depend on them linearly.
//!
//! The largest s is sought for which all G_b(x) - s are positive semidefinite, by Newton's method on
//! the barrier -t s - sum log det (G_b(x) - s), t growing (Boyd and Vandenberghe 2004, 11.3 and 11.4).
//! Logarithms are not evaluated: the step is damped by 1 / (1 + lambda), which keeps to the inside
//! (Nesterov and Nemirovskii 1994).

use super::matrix::{Matrix, combined, product, transpose};

/// G(x) = constant + sum x_k slope_k.
pub(super) struct Affine {
    pub(super) constant: Matrix<f64>,
    /// The slopes that are not zero, with k.
    pub(super) slopes: Vec<(usize, Matrix<f64>)>,
}

/// How far the numbers may go: where some do not matter, all of the search would be theirs.
const FARTHEST: f64 = 1e4;

/// Steps of Newton's method.
const MOST_STEPS: usize = 150;

/// The factor by which t grows.
const GROWTH: f64 = 8.0;

/// `count` numbers at which all G_b are positive definite, as far as `accept` says so.
pub(super) fn search(
    forms: &[Affine],
    count: usize,
    accept: impl Fn(&[f64]) -> bool,
) -> Option<Vec<f64>> {
    let mut point = start(forms, count)?;
    let logarithms = forms.iter().map(|form| form.constant.len()).sum::<usize>() + 2 * count;
    let mut t = 1.0;
    for _ in 0..MOST_STEPS {
        let decrement;
        (point, decrement) = point.step(forms, t)?;
        let (s, x) = point.numbers.split_last()?;
        if *s > 0.0 && accept(x) {
            return Some(x.to_vec());
        }
        if decrement < 0.5 {
            // The largest s is nearer than that.
            if s + 2.0 * logarithms as f64 / t < 0.0 {
                return None;
            }
            t *= GROWTH;
        }
    }
    None
}

/// x and s, and the inverses of G_b(x) - s, which are positive definite.
struct Point {
    numbers: Vec<f64>,
    inverses: Vec<Matrix<f64>>,
}

/// x = 0, and s so that this is inside.
fn start(forms: &[Affine], count: usize) -> Option<Point> {
    let from = |s| {
        let mut numbers = vec![0.0; count + 1];
        numbers[count] = s;
        Point::new(forms, numbers)
    };
    (0..20).find_map(|k| from(-((1_u64 << (2 * k)) as f64)))
}

impl Point {
    /// `None` where that is not inside.
    fn new(forms: &[Affine], numbers: Vec<f64>) -> Option<Self> {
        let inverses = inverses(forms, &numbers)?;
        Some(Point { numbers, inverses })
    }

    /// One step of Newton's method, and how far it would go in the measure of the barrier.
    fn step(self, forms: &[Affine], t: f64) -> Option<(Self, f64)> {
        let (gradient, hessian) = derivatives(forms, &self, t);
        let step = solve(hessian, gradient.iter().map(|g| -g).collect())?;
        let square: f64 = gradient.iter().zip(&step).map(|(g, d)| -g * d).sum();
        let decrement = square.max(0.0).sqrt();
        let mut factor = if decrement > 0.25 {
            1.0 / (1.0 + decrement)
        } else {
            1.0
        };
        for _ in 0..30 {
            let along = self.numbers.iter().zip(&step);
            let moved = along.map(|(x, d)| x + factor * d).collect();
            if let Some(moved) = Point::new(forms, moved) {
                return Some((moved, decrement));
            }
            // Not inside by rounding alone.
            factor *= 0.5;
        }
        None
    }
}

/// The inverses of G_b(x) - s, where all of them are positive definite and no number is too far.
fn inverses(forms: &[Affine], numbers: &[f64]) -> Option<Vec<Matrix<f64>>> {
    let (s, x) = numbers.split_last()?;
    if x.iter().any(|x| x.abs() >= FARTHEST) {
        return None;
    }
    let inverse = |form: &Affine| {
        let mut g = form.constant.clone();
        for (k, slope) in &form.slopes {
            g = combined(g, slope, |g, slope| g + x[*k] * slope);
        }
        for (i, row) in g.iter_mut().enumerate() {
            row[i] -= s;
        }
        invert(g)
    };
    forms.iter().map(inverse).collect()
}

/// The gradient of the barrier, and its second derivatives.
fn derivatives(forms: &[Affine], point: &Point, t: f64) -> (Vec<f64>, Matrix<f64>) {
    let n = point.numbers.len();
    let (mut gradient, mut hessian) = (vec![0.0; n], vec![vec![0.0; n]; n]);
    gradient[n - 1] = -t;
    for (form, inverse) in forms.iter().zip(&point.inverses) {
        // G^-1 dG/dx_k; that of s is -G^-1.
        let of_s = inverse.iter().map(|row| row.iter().map(|x| -x).collect());
        let slopes = form.slopes.iter();
        let rates = slopes.map(|(k, slope)| (*k, product(inverse, slope)));
        let rates: Vec<(usize, Matrix<f64>)> = rates.chain([(n - 1, of_s.collect())]).collect();
        // tr(A B) is the sum of the products of the entries of A and those of the transpose of B.
        let rows: Vec<Vec<f64>> = rates.iter().map(|(_, rate)| rate.concat()).collect();
        let columns = rates.iter().map(|(_, rate)| transpose(rate).concat());
        let columns: Vec<Vec<f64>> = columns.collect();
        for (i, (k, rate)) in rates.iter().enumerate() {
            gradient[*k] -= (0..rate.len()).map(|i| rate[i][i]).sum::<f64>();
            for ((l, _), column) in rates[..=i].iter().zip(&columns) {
                let mut trace = 0.0;
                for (a, b) in rows[i].iter().zip(column) {
                    trace += a * b;
                }
                hessian[*k][*l] += trace;
                if k != l {
                    hessian[*l][*k] += trace;
                }
            }
        }
    }
    for (k, x) in point.numbers[..n - 1].iter().enumerate() {
        let (above, below) = (1.0 / (FARTHEST - x), 1.0 / (FARTHEST + x));
        gradient[k] += above - below;
        hessian[k][k] += above * above + below * below;
    }
    (gradient, hessian)
}

/// L with A = L L^T; `None` where A is not positive definite.
fn cholesky(mut a: Matrix<f64>) -> Option<Matrix<f64>> {
    let n = a.len();
    for j in 0..n {
        let below: f64 = a[j][..j].iter().map(|x| x * x).sum();
        let pivot = a[j][j] - below;
        let is_positive = pivot > 1e-14 * a[j][j].abs();
        if !is_positive {
            return None;
        }
        a[j][j] = pivot.sqrt();
        for i in j + 1..n {
            let known: f64 = (0..j).map(|k| a[i][k] * a[j][k]).sum();
            a[i][j] = (a[i][j] - known) / a[j][j];
        }
    }
    Some(a)
}

/// The solution of A x = b, A positive definite.
fn solve(a: Matrix<f64>, b: Vec<f64>) -> Option<Vec<f64>> {
    cholesky(a).map(|l| substitute(&l, b))
}

/// The solution of L L^T x = b.
fn substitute(l: &Matrix<f64>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for i in 0..n {
        let known: f64 = (0..i).map(|k| l[i][k] * b[k]).sum();
        b[i] = (b[i] - known) / l[i][i];
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| l[k][i] * b[k]).sum();
        b[i] = (b[i] - known) / l[i][i];
    }
    b
}

fn invert(a: Matrix<f64>) -> Option<Matrix<f64>> {
    let n = a.len();
    let l = cholesky(a)?;
    let column = |k| {
        let mut unit = vec![0.0; n];
        unit[k] = 1.0;
        substitute(&l, unit)
    };
    Some((0..n).map(column).collect())
}
