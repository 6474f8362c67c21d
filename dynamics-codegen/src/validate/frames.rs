//! Gravity, where the base and the tool are, and the tool's body.

use dynamics_symbolic::robot::{Placement, Tool, Value};

use super::body::body;
use super::scope::{Scope, norm};
use crate::description::{self, Vector};
use crate::mistake::entry as mistake;

/// Magnitudes of gravity, m/s^2: the Moon has 1.6, Jupiter 24.8.
const USUAL: core::ops::RangeInclusive<f64> = 1.0..=30.0;

/// The components of gravity, `None` where one is in error; a magnitude that is found nowhere is reported.
pub(super) fn gravity(vector: &Vector, scope: &mut Scope) -> Option<[Value; 3]> {
    let components = scope.vector(vector)?;
    if let (Some(magnitude), [Some(first), _, Some(last)]) = (norm(&components), vector)
        && magnitude != 0.0
        && !USUAL.contains(&magnitude)
        && !scope.allowed().odd_gravity
    {
        let place = first.place.to(last.place);
        scope.error(place, mistake::odd_gravity(magnitude));
    }
    Some(components)
}

/// The place of a frame; `None` where it is in error.
pub(super) fn placement(
    placement: &description::Placement,
    scope: &mut Scope,
) -> Option<Placement> {
    let xyz = scope.given_vector(&placement.xyz);
    let rpy = scope.angles(&placement.rpy);
    Some(Placement {
        xyz: xyz?,
        rpy: rpy?,
    })
}

/// The tool; `None` where it is in error.
pub(super) fn tool(tool: &description::Tool, scope: &mut Scope) -> Option<Tool> {
    scope.within(&tool.body.allow, "tool", |scope| {
        let placement = placement(&tool.placement, scope);
        let (mass, com, inertia) = body(&tool.body, scope)?;
        Some(Tool {
            placement: placement?,
            mass,
            com,
            inertia,
        })
    })
}
