//! Notes on angles near a multiple of a quarter turn: on those that are taken for it, and on the others if base parameters
//! are asked for.
//!
//! Let an angle e be left beside a quarter turn. Base parameters that are one parameter at e = 0 are several then, and
//! their columns of the regressor differ by terms of e alone. The regressor's condition grows as 1/e. Which angles do this is
//! found by the definition: an angle counts if there are more base parameters with it than with its quarter turn.

use core::f64::consts::FRAC_PI_2;

use dynamics_symbolic::derive::base::observed;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Angle, Quantity, Robot, Value};

use super::Model;
use crate::description::Table;
use crate::finding::{Finding, Severity};
use crate::limits::MOST_LISTED;
use crate::rounded::{NEARLY, Rounded};

/// The notes on a model.
pub(super) fn notes(model: &Model, table: &Table) -> Vec<Finding> {
    let robot = &model.robot;
    let remedy = |is_of_urdf: bool, within: f64| match is_of_urdf {
        // The power of ten above it.
        true => format!("`round_angles: 1e{:.0}`", within.log10().ceil()),
        false => "A multiple of `PI/2`".to_owned(),
    };
    let mut rounded = table.rounded.clone();
    let mut nearly = Vec::new();
    with_angles(robot, &mut |at, angle| {
        match Near::of(at, angle) {
            Some(near) if near.is_taken => rounded.add(near.radians, near.apart),
            Some(near) => nearly.push(near),
            None => {}
        }
        angle.clone()
    });
    let is_of_file = table.rounded != Rounded::default();
    let meant = format!("{} says that this is meant.", remedy(is_of_file, 1e-9));
    let rounded = rounded.note(&meant);
    let rounded =
        rounded.map(|text| Finding::of_all("digits_of_quarter_turns", Severity::Note, text));
    let mut notes: Vec<Finding> = rounded.into_iter().collect();
    let requests = model.requests.iter().map(|(request, _)| request);
    let is_asked = requests.into_iter().any(|of| of.is_about_base_parameters())
        || table.needed.iter().any(|of| of.is_about_base_parameters());
    if is_asked && !nearly.is_empty() {
        notes.extend(hardly_apart(robot, nearly).map(|(counts, angles)| {
            let within = angles.iter().map(|near| near.apart);
            let is_of_urdf = robot.rows.iter().any(|row| row.mount.is_some());
            let remedy = remedy(is_of_urdf, within.fold(0.0, f64::max));
            let text = told(counts, &angles, &remedy);
            Finding::of_all("parameters_hardly_apart", Severity::Warning, text)
        }));
    }
    notes
}

/// An angle near a multiple of a quarter turn.
struct Near {
    /// The joint or frame.
    at: String,
    radians: f64,
    quarters: f64,
    apart: f64,
    /// Whether the engine takes it for that multiple.
    is_taken: bool,
}

impl Near {
    fn of(at: &str, angle: &Value) -> Option<Near> {
        let radians = angle.is_number().then(|| angle.to_f64(&[]))?;
        let quarters = (radians / FRAC_PI_2).round();
        let apart = (radians - quarters * FRAC_PI_2).abs();
        (apart > 0.0 && apart <= NEARLY).then(|| Near {
            at: at.to_owned(),
            radians,
            quarters,
            apart,
            is_taken: Angle::new(angle).rest.is_none(),
        })
    }

    fn multiple(&self) -> Value {
        let half = Rational::from_parts_signed((self.quarters as i64).into(), 2_u8.into());
        Value::Pi * Value::Rational(half)
    }
}

/// The robot with other angles. Each is given with the name of its joint or frame.
fn with_angles(robot: &Robot, angle: &mut impl FnMut(&str, &Value) -> Value) -> Robot {
    let mut of = |at: &str, value: &Value, quantity| match quantity {
        Quantity::Angle => angle(at, value),
        Quantity::Number => value.clone(),
    };
    let mut robot = robot.clone();
    robot.base = robot
        .base
        .map(|base| base.map(&mut |x, of_x| of("base", x, of_x)));
    for row in &mut robot.rows {
        *row = row.map(&mut |x, of_x| of(&row.name, x, of_x));
    }
    robot.tool = robot
        .tool
        .map(|tool| tool.map(&mut |x, of_x| of("tool", x, of_x)));
    for frame in &mut robot.frames {
        *frame = frame.map(&mut |x, of_x| of(&frame.name, x, of_x));
    }
    robot
}

/// The angles because of which there are more base parameters than with their multiples, and both numbers.
fn hardly_apart(robot: &Robot, nearly: Vec<Near>) -> Option<([usize; 2], Vec<Near>)> {
    let count_with = |kept: Option<usize>| {
        let mut index = 0;
        let rounded = with_angles(robot, &mut |at, angle| match Near::of(at, angle) {
            Some(near) if !near.is_taken => {
                index += 1;
                match kept == Some(index - 1) {
                    true => angle.clone(),
                    false => near.multiple(),
                }
            }
            _ => angle.clone(),
        });
        observed(&rounded).len()
    };
    let [all, few] = [observed(robot).len(), count_with(None)];
    if all <= few {
        return None;
    }
    let is_cause = |index: &usize| count_with(Some(*index)) > few;
    let causes: Vec<usize> = (0..nearly.len()).filter(is_cause).collect();
    let angles = nearly.into_iter().enumerate();
    // If no angle is a cause alone, all of them are one together.
    let angles = angles.filter(|(index, _)| causes.is_empty() || causes.contains(index));
    Some(([all, few], angles.map(|(_, angle)| angle).collect()))
}

fn told([all, few]: [usize; 2], angles: &[Near], remedy: &str) -> String {
    let listed = angles.iter().take(MOST_LISTED);
    let listed = listed.map(|near| format!("{:?} at `{}`", near.radians, near.at));
    let listed: Vec<_> = listed.collect();
    let rest = match angles.len().saturating_sub(MOST_LISTED) {
        0 => String::new(),
        rest => format!(" and {rest} more"),
    };
    format!(
        " Torques hardly tell {} of the {all} base parameters apart from others, because angles are nearly quarter turns: \
         {}{rest}. Values that are fitted to torques are far off. {remedy} leaves {few} base parameters.",
        all - few,
        listed.join(", ")
    )
}
