//! When a target is reached.

use super::ending::Residual;
use super::target::{Missing, length};

/// How far a frame may be from its target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    position: f64,
    rotation: f64,
    /// 2 sin(rotation / 2), as errors of rotations are.
    chord: f64,
}

impl Tolerance {
    pub(super) fn new(position: f64, rotation: f64) -> Self {
        let half_turn = core::f64::consts::PI;
        Tolerance {
            position,
            rotation,
            chord: 2.0 * libm::sin(rotation.min(half_turn) / 2.0),
        }
    }

    pub(super) fn is_possible(&self) -> bool {
        let is_length = |x: f64| x > 0.0 && x.is_finite();
        is_length(self.position) && is_length(self.rotation)
    }

    /// The tolerance of positions, m.
    pub(super) fn of_positions(&self) -> f64 {
        self.position
    }

    /// Whether nothing is missing beyond it. NaN is.
    #[inline(always)]
    pub(super) fn holds(&self, missing: &Missing) -> bool {
        let position = missing.position.map_or(0.0, |error| error.norm_squared());
        let rotation = missing.rotation.map_or(0.0, |error| error.norm_squared());
        position <= self.position * self.position && rotation <= self.chord * self.chord
    }
}

impl Residual {
    /// The larger of both, and what is missing of one more target.
    pub(super) fn and(self, missing: &Missing) -> Self {
        let position = missing.position.map_or(0.0, |error| length(&error));
        let chord = missing.rotation.map_or(0.0, |error| error.norm());
        Residual {
            position: larger(self.position, position),
            rotation: larger(self.rotation, 2.0 * libm::asin((chord / 2.0).min(1.0))),
        }
    }
}

/// NaN, if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}
