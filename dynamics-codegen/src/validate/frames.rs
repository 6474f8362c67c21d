//! Where the base and the tool are, and the tool's body.

use dynamics_symbolic::robot::{Placement, Tool};

use super::body::{self, Body};
use super::scope::{Scope, all};
use crate::description;

/// The place of a frame; `None` where it is in error.
pub(super) fn placement(
    placement: &description::Placement,
    scope: &mut Scope,
) -> Option<Placement> {
    let xyz = scope.given_vector(&placement.xyz);
    let rpy = scope.angles(&placement.rpy);
    Some(Placement {
        xyz: all(xyz)?,
        rpy: all(rpy)?,
    })
}

/// The tool; `None` where it is in error.
pub(super) fn tool(tool: &description::Tool, scope: &mut Scope) -> Option<Tool> {
    scope.within(&tool.allow, "tool", |scope| placed_body(tool, scope))
}

fn placed_body(tool: &description::Tool, scope: &mut Scope) -> Option<Tool> {
    let placement = placement(&tool.placement, scope);
    let body = body::body(
        &Body {
            mass: &tool.mass,
            com: &tool.com,
            inertia: &tool.inertia,
            inertia_at_origin: &tool.inertia_at_origin,
            place: "tool",
        },
        scope,
    );
    let (mass, com, inertia) = body?;
    Some(Tool {
        placement: placement?,
        mass,
        com,
        inertia,
    })
}
