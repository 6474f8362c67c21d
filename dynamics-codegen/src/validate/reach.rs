//! Centres of mass that are far from their links: millimetres, or a point of another frame.

use dynamics_symbolic::robot::{Base, JointType, Row, Value};

use super::Parts;
use super::known::{norm, number};
use super::scope::Scope;
use crate::description::{Body, Table};
use crate::mistake::joint as mistake;

/// A centre of mass may be so many times further from its frame than the arm's longest part is long.
const FARTHEST: f64 = 10.0;

/// Reports them, where all lengths are known; whether there is one. An arm without any length is not judged: a pendulum
/// has none but that of its centre of mass.
pub(super) fn report(parts: &Parts, table: &Table, scope: &Scope) -> bool {
    let Some(longest) = longest(parts, table).filter(|longest| *longest > 0.0) else {
        return false;
    };
    let mut is_far = false;
    let mut far = |com: &[Value; 3], body: &Body, place| {
        if let (Some(distance), Some([Some(first), _, Some(last)])) = (norm(com), body.com.value())
            && distance > FARTHEST * longest
            && !scope.with(&body.allow).odd_com
        {
            let place_of_com = first.place.to(last.place);
            scope.error(place_of_com, mistake::far_com(distance, longest, place));
            is_far = true;
        }
    };
    for (row, written) in parts.rows.iter().flatten().zip(table.rows()) {
        if let Some(row) = row {
            far(&row.com, &written.body, "row");
        }
    }
    if let (Some(Some(tool)), Some(written)) = (&parts.tool, table.tool()) {
        far(&tool.body.com, &written.body, "tool");
    }
    if let (Some(Some(Base::Floating(body))), Some((_, written))) = (&parts.base, table.floating())
    {
        far(&body.com, written, "base");
    }
    for (frame, written) in parts.frames(table) {
        if let Some(body) = frame.and_then(|frame| frame.body.as_ref()) {
            far(&body.com, &written.body, "frame");
        }
    }
    is_far
}

/// The longest of `a`, `d`, the places of rows on the links that carry them, the range of joints that slide, and the
/// ways to the tool and to frames. None where one of them is not known: a joint that slides without limits may slide as far as its links are
/// long.
pub(super) fn longest(parts: &Parts, table: &Table) -> Option<f64> {
    let mut longest = 0.0_f64;
    for row in parts.rows.iter().flatten() {
        longest = longest.max(length(row.as_ref()?)?);
    }
    if let Some(tool) = &parts.tool {
        longest = longest.max(norm(&tool.as_ref()?.placement.xyz)?);
    }
    for (frame, _) in parts.frames(table) {
        for place in &frame?.places {
            longest = longest.max(norm(&place.xyz)?);
        }
    }
    Some(longest)
}

fn length(row: &Row) -> Option<f64> {
    let limits: &[Value] = match (row.joint_type, &row.limits) {
        (JointType::Prismatic, None) => return None,
        (JointType::Prismatic, Some(limits)) => limits,
        (JointType::Revolute, _) => &[],
    };
    let tip = row.tip().into_iter().flatten();
    let steps = row.at.iter().chain(tip);
    [&row.a, &row.d]
        .into_iter()
        .chain(limits)
        .chain(steps.flat_map(|step| &step.xyz))
        .try_fold(0.0_f64, |longest, length| {
            Some(longest.max(number(length)?.abs()))
        })
}
