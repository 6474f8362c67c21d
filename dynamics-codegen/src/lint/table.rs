//! Bodies, gravity and convention of a table.

use dynamics_symbolic::robot::{Convention, JointType, Placement, Robot, Row, Value};

use super::body::{self, Body};
use super::space::{Point, norm, placed};
use super::{rule, sides};
use crate::description::{self, Given, Inertia, Table};
use crate::finding::Finding;
use crate::place::Place;

/// A centre of mass is beside its link if it is further away than this share of its way from the frame.
const BESIDE: f64 = 0.25;

/// All that is doubtful about a table and its robot.
pub(super) fn findings(table: &Table, robot: &Robot) -> Vec<Finding> {
    let bodies = |convention| -> Vec<Body> {
        let rows = table.rows().iter().enumerate();
        rows.filter_map(|(index, written)| body(index, written, robot, convention, table))
            .collect()
    };
    let own = bodies(robot.convention);
    let ways = own.iter().filter_map(|body| body.joints.as_ref()).flatten();
    let ways: Vec<f64> = ways.map(|point| norm(*point)).collect();
    let mut found = body::findings(&own, &ways);
    found.extend(sides::findings(&own));
    found.extend(gravity(table, robot));
    let other = match robot.convention {
        Convention::Standard => Convention::Modified,
        Convention::Modified => Convention::Standard,
    };
    if is_other_convention(&own, &bodies(other)) {
        let words = [robot.convention, other].map(|convention| match convention {
            Convention::Standard => "standard",
            Convention::Modified => "modified",
        });
        found.push(rule::other_convention(
            place_of_key(table, "convention"),
            words[0],
            words[1],
        ));
    }
    found
}

fn place_of_key(table: &Table, key: &str) -> Place {
    let mut keys = table.keys.iter();
    keys.find(|(known, _)| *known == key)
        .map_or(Place::START, |(_, place)| *place)
}

fn number(value: &Value) -> Option<f64> {
    value.is_number().then(|| value.to_f64(&[]))
}

fn numbers<const N: usize>(values: &[Value; N]) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = values.iter().map(number).collect();
    numbers?.try_into().ok()
}

/// The body of a row, if its numbers are known.
fn body(
    index: usize,
    written: &description::Row,
    robot: &Robot,
    convention: Convention,
    table: &Table,
) -> Option<Body> {
    let row = robot.rows.get(index)?;
    let start = written.name.as_ref().map_or(Place::START, Place::from);
    let com = written.body.com.value().and_then(|com| com[0].as_ref());
    let tensor = match (&written.body.inertia, &written.body.inertia_at_origin) {
        (Given::As(Inertia::Tensor(tensor)), _) | (_, Given::As(tensor)) => tensor.place,
        (Given::As(Inertia::Solid(place, ..)), _) => *place,
        _ => start,
    };
    let allow = written
        .body
        .allow
        .value()
        .copied()
        .unwrap_or_default()
        .or(table.allow());
    Some(Body {
        name: row.name.clone(),
        place: start,
        mass: (
            number(&row.mass)?,
            written.body.mass.value().map_or(start, |mass| mass.place),
        ),
        com: (numbers(&row.com)?, com.map_or(start, |com| com.place)),
        tensor: (numbers(&row.inertia)?, tensor),
        joints: joints(index, row, robot, convention),
        geometry: Vec::new(),
        is_allowed: allow.odd_com || allow.odd_mass || allow.odd_length || allow.unphysical_inertia,
    })
}

/// Where joints, frames and the tool are on the link of a row, in its frame; none where a joint slides along it, or a place is
/// not known.
fn joints(index: usize, row: &Row, robot: &Robot, convention: Convention) -> Option<Vec<Point>> {
    let mut points = vec![[0.0; 3]];
    if convention == Convention::Standard {
        // The joint's own frame is at -(a, d sin alpha, d cos alpha) in that of its link, which is at the next joint.
        let [a, along, across] = offset(row)?;
        points.push([-a, across, -along]);
    }
    for (number, carried) in robot.rows.iter().enumerate() {
        if carried.on.parent(number) == Some(index) {
            let [a, along, across] = match convention {
                Convention::Standard => [0.0; 3],
                Convention::Modified => offset(carried)?,
            };
            points.push(through(&carried.at, [a, across, along])?);
        }
    }
    let on_link = robot.frames.iter().filter(|frame| frame.on == Some(index));
    for frame in on_link {
        points.push(through(&frame.places, [0.0; 3])?);
    }
    if let Some(tool) = robot
        .tool
        .as_ref()
        .filter(|_| robot.tip_row() == Some(index))
    {
        points.push(numbers(&tool.placement.xyz)?);
    }
    Some(points)
}

/// a, d cos alpha and -d sin alpha of a row that turns.
fn offset(row: &Row) -> Option<[f64; 3]> {
    let (sin, cos) = number(&row.alpha)?.sin_cos();
    let d = number(&row.d).filter(|_| row.joint_type == JointType::Revolute)?;
    Some([number(&row.a)?, d * cos, -d * sin])
}

/// A point in the last of some frames, each placed in the one before it.
fn through(places: &[Placement], point: Point) -> Option<Point> {
    let mut places = places.iter().rev();
    places.try_fold(point, |point, place| {
        Some(placed(numbers(&place.xyz)?, numbers(&place.rpy)?, point))
    })
}

/// Gravity upwards: along z, or in the plane of an arm whose axes are parallel.
fn gravity(table: &Table, robot: &Robot) -> Option<Finding> {
    let [x, y, z] = numbers(&robot.gravity)?;
    let place = place_of_key(table, "gravity");
    let is_largest = |size: f64| size > 0.0 && size >= x.abs().max(y.abs()).max(z.abs());
    let is_parallel = |row: &Row| row.at.is_empty() && number(&row.alpha) == Some(0.0);
    let is_planar = robot.rows.iter().all(is_parallel) && robot.base.is_none();
    if table.allow().odd_gravity || robot.floating().is_some() {
        None
    } else if is_largest(z) {
        Some(rule::gravity_along_z(place, z))
    } else {
        (is_largest(y) && is_planar).then(|| rule::falls_upwards(place, y))
    }
}

/// Whether by the convention of the table all centres of mass are beside their links, and by the other one on them.
fn is_other_convention(own: &[Body], others: &[Body]) -> bool {
    let pairs = own.iter().zip(others);
    let judged = pairs.filter(|(body, _)| body.mass.0 > 0.0 && norm(body.com.0) > 0.0);
    let shares = judged.filter_map(|(body, other)| {
        let way = norm(body.com.0);
        Some([body.outside()? / way, other.outside()? / way])
    });
    let shares: Vec<_> = shares.collect();
    shares.len() >= 2
        && shares
            .iter()
            .all(|[own, other]| *own > BESIDE && *other < BESIDE / 10.0)
}
