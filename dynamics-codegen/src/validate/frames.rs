//! Gravity, where the base, the tool and the frames are, and the bodies there.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Frame, Tool, Value};

use super::body::body;
use super::known::norm;
use super::link::{self, placement};
use super::scope::Scope;
use crate::description::{self, Table, Vector};
use crate::mistake::{entry as mistake, link as wrong};

/// Magnitudes of gravity, m/s^2: the Moon has 1.6, Jupiter 24.8.
const USUAL: core::ops::RangeInclusive<f64> = 1.0..=30.0;

/// Magnitudes on Earth, m/s^2, rounded or not. An arm may hang along the diagonal of its axes: then its gravity has this
/// magnitude in all, and not along each axis.
const OF_EARTH: core::ops::RangeInclusive<f64> = 9.7..=10.05;

/// The components of gravity, `None` where one is in error; a magnitude that is found nowhere is reported.
pub(super) fn gravity(vector: &Vector, scope: &mut Scope) -> Option<[Value; 3]> {
    let components = scope.vector(vector)?;
    if let (Some(magnitude), [Some(first), _, Some(last)]) = (norm(&components), vector)
        && magnitude != 0.0
        && !scope.allowed().odd_gravity
    {
        let place = first.place.to(last.place);
        if !USUAL.contains(&magnitude) {
            scope.error(place, mistake::odd_gravity(magnitude));
        } else if is_same_along_all(&components) && !OF_EARTH.contains(&magnitude) {
            let component = components[0].to_f64(&[]);
            scope.error(place, mistake::gravity_along_all(component, magnitude));
        }
    }
    Some(components)
}

/// Whether the components are the same number, up to signs.
fn is_same_along_all([x, y, z]: &[Value; 3]) -> bool {
    let is_same = |other: &Value| other == x || *other == -x.clone();
    is_same(y) && is_same(z)
}

/// The tool; `None` where it is in error.
pub(super) fn tool(tool: &description::Tool, scope: &mut Scope) -> Option<Tool> {
    scope.within(&tool.body.allow, "tool", |scope| {
        let placement = placement(&tool.placement, scope);
        let body = body(&tool.body, scope)?;
        Some(Tool {
            placement: placement?,
            body,
        })
    })
}

/// Reports names that several frames have, or a frame and a joint. A file may name its links like its joints.
pub(super) fn report_names(table: &Table, scope: &Scope) {
    let mut seen = BTreeSet::new();
    let links = table.frames().filter(|frame| frame.is_link);
    let others = table.frames().filter(|frame| !frame.is_link);
    for frame in links.chain(others) {
        let Some(name) = &frame.name else {
            continue;
        };
        let word = name.plain();
        let is_joint = |row: &description::Row| row.word() == word;
        if !seen.insert(word) {
            scope.error(name, wrong::frame_twice(word));
        } else if !frame.is_link && word == link::BASE {
            scope.error(name, wrong::frame_named_base());
        } else if !frame.is_link && table.rows().iter().any(is_joint) {
            scope.error(name, wrong::frame_named_as_joint(word));
        }
    }
}

/// A frame; `None` where it is in error.
pub(super) fn frame(frame: &description::Frame, table: &Table, scope: &mut Scope) -> Option<Frame> {
    let name = frame.name.as_ref()?;
    scope.within(&frame.body.allow, "frame", |scope| {
        let on = link::of_frame(name, &frame.on, table, scope);
        let placement = placement(&frame.placement, scope);
        let has_body = frame.body.is_written();
        let body = body(&frame.body, scope)?;
        let (on, of_link) = on?;
        Some(Frame {
            name: name.plain().to_owned(),
            on,
            places: [of_link, &frame.places, &[placement?]].concat(),
            body: has_body.then_some(body),
        })
    })
}
