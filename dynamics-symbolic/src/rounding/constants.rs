//! Constants: evaluated exactly and rounded once, however they are written.

use super::{Bounded, UNIT};
use crate::exact::{Rational, sin_cos};
use crate::program::{Arithmetic, by_operators};
use crate::robot::{Symbol, Value};

/// Doubles with the error of computing in them, where symbols have these values. Most constants are known well enough by
/// that; the others are evaluated in high precision.
pub(super) struct Doubles<'a>(pub(super) &'a dyn Fn(&Symbol) -> Bounded);

/// A constant in doubles, where it is known to six digits: enough to count roundings with.
pub(super) fn certain(evaluated: Bounded) -> Option<f64> {
    let is_certain = evaluated.error <= 1e-6 * evaluated.value.abs();
    is_certain.then_some(evaluated.value)
}

/// Sine or cosine of a constant angle: the angle is rounded first.
fn turned(angle: &Value, pick: impl Fn((f64, f64)) -> f64) -> Bounded {
    let angle = angle.to_f64(&[]);
    Bounded {
        value: pick(sin_cos(angle)),
        error: 8.0 * UNIT * (1.0 + angle.abs()),
    }
}

/// Pi, or the sine or cosine of a constant angle.
pub(super) fn constant(symbol: &Symbol) -> Bounded {
    match symbol {
        Symbol::Pi => Bounded::rounded(core::f64::consts::PI),
        Symbol::AngleSine(angle) => turned(angle, |(sine, _)| sine),
        Symbol::AngleCosine(angle) => turned(angle, |(_, cosine)| cosine),
        other => unreachable!("{other:?} is no constant"),
    }
}

impl Arithmetic for Doubles<'_> {
    type Number = Bounded;

    fn rational(&mut self, x: &Rational) -> Bounded {
        Bounded::rounded(x.to_f64().value())
    }

    fn symbol(&mut self, symbol: &Symbol) -> Bounded {
        (self.0)(symbol)
    }

    by_operators!(Bounded);
}
