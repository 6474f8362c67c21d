//! The acceleration of gravity.

use dynamics_symbolic::robot::Value;

use super::scope::{Scope, norm};
use crate::description::Vector;
use crate::mistake::entry as mistake;
use crate::place::Place;

/// Magnitudes of gravity, m/s^2: the Moon has 1.6, Jupiter 24.8.
const USUAL: core::ops::RangeInclusive<f64> = 1.0..=30.0;

/// The components; a magnitude that is found nowhere is reported.
pub(super) fn gravity(vector: Option<&Vector>, scope: &mut Scope) -> [Option<Value>; 3] {
    let components = scope.vector(vector);
    let magnitude = norm(components.each_ref().map(Option::as_ref));
    if let (Some(magnitude), Some([Some(first), _, Some(last)])) = (magnitude, vector)
        && magnitude != 0.0
        && !USUAL.contains(&magnitude)
        && !scope.allowed().odd_gravity
    {
        let place = Place::to(first.place, last.place);
        scope.error(place, mistake::odd_gravity(magnitude));
    }
    components
}
