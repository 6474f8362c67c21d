//! The phase within a step.

use dynamics_runtime::Size;

use super::tableau::C;
use crate::integrate::Phase;

/// The polynomial through the stages of a step that ends at `end`.
#[derive(Clone)]
pub(super) struct Polynomial<D: Size> {
    end: f64,
    h: f64,
    coefficients: [Phase<D>; 4],
}

impl<D: Size> Polynomial<D> {
    /// Newton's interpolation through the start and the stages, from the end backwards.
    pub(super) fn new(end: f64, h: f64, phase: &Phase<D>, [z1, z2, z3]: &[Phase<D>; 3]) -> Self {
        let [c1, c2, _] = C;
        let third = z2.minus(z3).scaled(1.0 / (c2 - 1.0));
        let second = z1.minus(z2).scaled(1.0 / (c1 - c2));
        let bend = second.minus(&third).scaled(1.0 / (c1 - 1.0));
        let first = second.minus(&z1.scaled(1.0 / c1)).scaled(1.0 / c2);
        Polynomial {
            end,
            h,
            coefficients: [phase.clone(), third, bend.clone(), bend.minus(&first)],
        }
    }

    /// y = r1 + s (r2 + (s + 1 - c2) (r3 + (s + 1 - c1) r4)), s from -1 to 0 over the step.
    pub(super) fn at(&self, t: f64) -> Phase<D> {
        let s = (t - self.end) / self.h;
        let [r1, r2, r3, r4] = &self.coefficients;
        let inner = r3.plus(s + 1.0 - C[0], r4);
        r1.plus(s, &r2.plus(s + 1.0 - C[1], &inner))
    }
}
