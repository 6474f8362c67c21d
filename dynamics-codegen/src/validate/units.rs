//! Lengths in mm and masses in g: mistakes of the whole table, each reported once, at the largest of the numbers. A
//! table in which a field matters to the judgement is not judged.

use dynamics_symbolic::robot::{self, Base, Value};

use super::Parts;
use super::known::{norm, number};
use super::scope::Scope;
use crate::audience::AT_THE_END;
use crate::description::{Body, Expr, Given, Row, Table, Vector};
use crate::mistake::joint as mistake;
use crate::place::Place;

/// No rigid part of a machine is longer, m: jibs of tower cranes and booms of draglines have up to 100 m. The links of all
/// arms but the smallest are longer in mm.
const LONGEST: f64 = 100.0;

/// Shorter lengths are never taken for mm: links of less than a centimetre are rarer than booms of 10 m.
const LONG: f64 = 10.0;

/// A long part may be so many times longer than the way to any centre of mass and than any body: beside bodies in m, a
/// link in mm is a thousand times too long. Published arms are at most 1.5 times as long as their bodies.
const BESIDE_BODIES: f64 = 300.0;

/// The least mass of the heaviest body for each metre of a long part, kg/m: a steel wire of 2 mm has 0.025 kg/m.
const LIGHTEST: f64 = 0.02;

/// The greatest mass of a body for the cube of the arm's longest part, kg/m^3. Published arms have at most 300, an
/// excavator of 20 t with booms of 6 m has 93, and industrial robots for 2 t have about 1,000: in g, a thousand times
/// more.
const DENSEST: f64 = 1500.0;

/// Lighter bodies are not judged, kg: a camera on a small head, or a palm with short fingers, may be dense.
const HEAVY: f64 = 20.0;

/// The body of a row, of the tool, of a frame or of a base that moves.
struct Judged {
    mass: f64,
    /// The way to its centre of mass, or its own length, m: that of the slender rod with the greatest of its moments.
    extent: f64,
    /// Where its mass stands, and where it can be allowed; none where it is allowed.
    mass_at: Option<(Place, &'static str)>,
}

/// Reports the longest length, if it is in mm, or the heaviest body, if its mass is in g. `longest` is the longest part of
/// the arm, if it is known.
pub(super) fn report(parts: &Parts, longest: Option<f64>, table: &Table, scope: &Scope) {
    let bodies = bodies(parts, table, scope);
    let is_beside = |size| bodies.as_ref().is_some_and(|b| is_beside(size, b));
    // The first of several.
    let lengths = lengths(parts, table, scope).into_iter().rev();
    let longest_cell = lengths.max_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()));
    let odd = longest_cell.filter(|(length, _)| {
        let size = length.abs();
        size > LONGEST || (size > LONG && is_beside(size))
    });
    if let Some((length, place)) = odd {
        if !scope.allowed().odd_length {
            let row = table.rows().first();
            let place_of_allow = row.map_or(AT_THE_END, |row| allowed_at(row, AT_THE_END));
            let mistake = mistake::in_millimetres(length, length / 1000.0, place_of_allow);
            scope.error(place, mistake);
        }
    } else if let (Some(bodies), Some(longest)) = (bodies, longest) {
        report_grams(&bodies, longest, scope);
    }
}

/// Whether the bodies are too small or too light for the length, as far as they say anything.
fn is_beside(length: f64, bodies: &[Judged]) -> bool {
    let extent = greatest(bodies, |body| body.extent);
    let mass = greatest(bodies, |body| body.mass);
    (extent > 0.0 && length > BESIDE_BODIES * extent) || (mass > 0.0 && mass < LIGHTEST * length)
}

/// Reports the heaviest body whose mass is in g or mg. An arm without any length is not judged.
fn report_grams(bodies: &[Judged], longest: f64, scope: &Scope) {
    let longest = greatest(bodies, |body| body.extent).max(longest);
    let most = heaviest_of(longest);
    let odd = bodies.iter().rev().filter(|body| body.mass > most);
    let judged = odd.filter_map(|body| Some((body.mass, body.mass_at?)));
    let heaviest = judged.max_by(|(a, _), (b, _)| a.total_cmp(b));
    if let Some((mass, (place, place_of_allow))) = heaviest.filter(|_| longest > 0.0) {
        let (right, unit) = in_kilograms(mass, most).unwrap_or((mass / 1e3, "g"));
        let mistake = mistake::in_grams(mass, unit, right, longest, place_of_allow);
        scope.error(place, mistake);
    }
}

/// The greatest mass of a body in an arm whose longest part is so long, kg.
pub(crate) fn heaviest_of(longest: f64) -> f64 {
    HEAVY.max(DENSEST * longest.powi(3))
}

/// The least mass of the heaviest body of such an arm, kg.
#[cfg(feature = "files")]
pub(crate) fn lightest_of(longest: f64) -> f64 {
    LIGHTEST * longest
}

/// A mass that is too large, in kg, if it is no more than `most` as one in g or in mg; and that unit.
pub(crate) fn in_kilograms(mass: f64, most: f64) -> Option<(f64, &'static str)> {
    let units = [(mass / 1e3, "g"), (mass / 1e6, "mg")];
    units.into_iter().find(|(mass, _)| *mass <= most)
}

fn greatest(bodies: &[Judged], of: impl Fn(&Judged) -> f64) -> f64 {
    bodies.iter().map(of).fold(0.0, f64::max)
}

/// Where something of a row is allowed: a URDF file has no `allow` of its own.
fn allowed_at(row: &Row, place: &'static str) -> &'static str {
    row.mount.as_ref().map_or(place, |_| "in the call")
}

/// The bodies of the rows, of the tool, of frames and of a base that moves; none where one of them is not known.
fn bodies(parts: &Parts, table: &Table, scope: &Scope) -> Option<Vec<Judged>> {
    let mut bodies = Vec::new();
    let mut judge = |body: &robot::Body, written: &Body, place_of_allow| {
        bodies.push(judged(body, written, place_of_allow, scope)?);
        Some(())
    };
    for (row, written) in parts.rows.iter().flatten().zip(table.rows()) {
        let body = row.as_ref()?.body();
        judge(&body, &written.body, allowed_at(written, "on the row"))?;
    }
    for (tool, written) in parts.tool.iter().zip(table.tool()) {
        judge(&tool.as_ref()?.body, &written.body, "on the tool")?;
    }
    for (frame, written) in parts.frames(table) {
        if let Some(body) = &frame.as_ref()?.body {
            judge(body, &written.body, "on the frame")?;
        }
    }
    if let (Some(base), Some((_, written))) = (&parts.base, table.floating())
        && let Base::Floating(body) = base.as_ref()?
    {
        judge(body, written, table.place_of_base())?;
    }
    Some(bodies)
}

fn judged(
    robot::Body { mass, com, inertia }: &robot::Body,
    written: &Body,
    place_of_allow: &'static str,
    scope: &Scope,
) -> Option<Judged> {
    let mass = number(mass)?;
    let moments: Option<Vec<f64>> = inertia.iter().take(3).map(number).collect();
    let moment = moments?.into_iter().fold(0.0, f64::max);
    // A slender rod: J = m l^2 / 12. A body without mass has no such length.
    let length = Some((12.0 * moment / mass).sqrt()).filter(|_| mass > 0.0);
    let place = place_of(written.mass.value());
    let place = place.filter(|_| !scope.with(&written.allow).odd_mass);
    Some(Judged {
        mass,
        extent: norm(com)?.max(length.unwrap_or(0.0)),
        mass_at: place.map(|place| (place, place_of_allow)),
    })
}

/// The lengths that are known, m, and where they stand: those of the rows, of the tool and of frames. How far things on
/// a base that stands are away, and how far joints slide, says nothing about the size of an arm.
fn lengths(parts: &Parts, table: &Table, scope: &Scope) -> Vec<(f64, Place)> {
    // A centre of mass that may be far away is not judged here either.
    let is_near = |body: &Body| !scope.with(&body.allow).odd_com;
    let mut cells: Vec<(&Value, Option<Place>)> = Vec::new();
    let stands = table.floating().is_none();
    let rows = parts.rows.iter().flatten().zip(table.rows());
    for (index, (row, written)) in rows.enumerate() {
        let Some(row) = row else {
            continue;
        };
        cells.push((&row.a, place_of(written.a.value())));
        cells.push((&row.d, place_of(written.d.value())));
        if is_near(&written.body) {
            cells.extend(vector(&row.com, &written.body.com));
        }
        // Steps of a URDF file have no places of their own.
        let joint = written.name.as_ref().map(Place::from);
        let tip = row.tip().into_iter().flatten();
        let is_on_base = row.on.parent(index).is_none() && stands;
        let (of_file, at) = row.at.split_at(written.places.len());
        let steps = of_file.iter().filter(|_| !is_on_base).chain(tip);
        cells.extend(steps.flat_map(|step| &step.xyz).map(|x| (x, joint)));
        for place in at.iter().filter(|_| !is_on_base) {
            cells.push((&place.xyz[2], place_of(written.b.value())));
            let at = written.at.value().map(|at| vector(&place.xyz, &at.xyz));
            cells.extend(at.into_iter().flatten());
        }
    }
    for (frame, written) in parts.frames(table) {
        let Some(frame) = frame else {
            continue;
        };
        for place in frame
            .places
            .iter()
            .filter(|_| frame.on.is_some() || !stands)
        {
            cells.extend(vector(&place.xyz, &written.placement.xyz));
        }
        if let Some(body) = frame.body.as_ref().filter(|_| is_near(&written.body)) {
            cells.extend(vector(&body.com, &written.body.com));
        }
    }
    if let (Some(Some(tool)), Some(written)) = (&parts.tool, table.tool()) {
        cells.extend(vector(&tool.placement.xyz, &written.placement.xyz));
        if is_near(&written.body) {
            cells.extend(vector(&tool.body.com, &written.body.com));
        }
    }
    if let (Some(Some(Base::Floating(body))), Some((_, written))) = (&parts.base, table.floating())
        && is_near(written)
    {
        cells.extend(vector(&body.com, &written.com));
    }
    let known = |(value, place): (&Value, Option<Place>)| number(value).zip(place);
    cells.into_iter().filter_map(known).collect()
}

fn vector<'v>(values: &'v [Value; 3], written: &Given<Vector>) -> Vec<(&'v Value, Option<Place>)> {
    let written = written.value().into_iter().flatten();
    let places = written.map(|cell| place_of(cell.as_ref()));
    values.iter().zip(places).collect()
}

fn place_of(cell: Option<&Expr>) -> Option<Place> {
    cell.map(|cell| cell.place)
}
