//! The functions that are asked for: each once, and each method with a name of its own.

use std::collections::BTreeSet;

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::center_of_mass::is_massless;
use dynamics_symbolic::function::{Fused, Growth, Request, Set};
use dynamics_symbolic::robot::{Robot, Row, Value};

use super::scope::Scope;
use crate::description::{Asked, Entry, Name, Table};
use crate::diagnose::Diagnostics;
use crate::keys::word_list;
use crate::limits::{
    MOST_JOINTS_OF_CUBIC_FUNCTIONS, MOST_JOINTS_OF_LONG_FUNCTIONS, MOST_LONG_FUNCTIONS, MOST_PARTS,
};
use crate::mistake::{entry as mistake, size, value};
use crate::place::Place;
use crate::words;

/// Names that an item of the struct has in any case, and the methods that come with its derives.
pub(crate) const RESERVED: &[&str] = word_list![
    default table formulas DOF JOINT_NAMES JOINT_LIMITS TORQUE_LIMITS VELOCITY_LIMITS OPERATIONS BASE_PARAMETERS BASE_PARAMETER_NAMES evaluate momenta
    energies clone eq
];

/// Every function that is named, parts of tuples too.
pub(super) fn named(asked: &[Asked]) -> impl Iterator<Item = (Function, Place)> + Clone {
    asked.iter().flat_map(|asked| match asked {
        Asked::Default(_) | Asked::Unreadable => Vec::new(),
        Asked::One(function, place) => vec![(*function, *place)],
        Asked::Fused(_, parts) => parts.clone(),
    })
}

/// The functions that are asked for, each with its place; those of the default set have none.
pub(super) fn requests(asked: Option<&[Asked]>, robot: &Robot) -> Vec<(Request, Option<Place>)> {
    let default_set = Function::default_set(has_friction(robot)).into_iter();
    let default_set: Vec<_> = default_set.map(|f| (Request::One(f), None)).collect();
    let Some(asked) = asked else {
        return default_set;
    };
    let is_default = |(request, _): &(Request, Option<Place>)| {
        default_set.iter().any(|(default, _)| default == request)
    };
    let mut requests = Vec::new();
    let has_default = asked.iter().any(|asked| matches!(asked, Asked::Default(_)));
    for asked in asked {
        match asked {
            Asked::Default(_) => requests.extend(default_set.clone()),
            Asked::One(function, place) => {
                let request = (Request::One(*function), Some(*place));
                // Friction is in the set where there is some; who asks for it need not know.
                if !(has_default && is_default(&request)) {
                    requests.push(request);
                }
            }
            Asked::Fused(name, parts) => requests.push((fused(name, parts), Some(name.into()))),
            Asked::Unreadable => {}
        }
    }
    requests
}

/// Whether there is friction at a joint that moves, by itself or with another one.
fn has_friction(robot: &Robot) -> bool {
    let mut moving = robot.rows.iter().filter(|row| row.locked.is_none());
    moving.any(Row::has_friction)
}

/// The method of that name with those parts.
pub(crate) fn fused(name: &Name, parts: &[(Function, Place)]) -> Request {
    Request::Fused(Fused {
        name: name.to_string(),
        parts: parts.iter().map(|(function, _)| *function).collect(),
    })
}

/// Whether the arm has a mass, where a function divides by it; all of these are asked for by name.
pub(super) fn have_mass(
    requests: &[(Request, Option<Place>)],
    robot: &Robot,
    diagnostics: &Diagnostics,
) -> bool {
    let divides = |(request, place): &(Request, Option<Place>)| {
        let mut functions = request.parts().iter();
        let function = functions.find(|function| function.divides_by_mass())?;
        Some((function.name(), (*place)?))
    };
    let Some((function, place)) = requests.iter().find_map(divides) else {
        return true;
    };
    let has_mass = !is_massless(robot);
    if !has_mass {
        diagnostics.error(place, mistake::no_mass(function));
    }
    has_mass
}

/// Whether a function that a table asks for, or that is needed besides, reads masses. The default set does.
pub(crate) fn read_masses(table: &Table) -> bool {
    let asked = table.entries.iter().find_map(|entry| match entry {
        Entry::Functions(asked) => Some(asked.as_deref().unwrap_or_default()),
        _ => None,
    });
    let is_default = |asked: &Asked| matches!(asked, Asked::Default(_));
    let has_default = asked.is_none_or(|asked| asked.iter().any(is_default));
    let named = named(asked.unwrap_or_default()).map(|(function, _)| function);
    let mut functions = named.chain(table.needed.iter().copied());
    has_default || functions.any(Function::reads_masses)
}

/// Whether anything has inertia, where a function depends on it. `odd_mass` accepts an arm without any, too.
pub(super) fn have_inertia(robot: &Robot, table: &Table, diagnostics: &Diagnostics) -> bool {
    let allow = table.allow();
    let is_allowed =
        allow.no_inertia || allow.odd_mass || !read_masses(table) || has_inertia(robot);
    if let (false, Some(name)) = (is_allowed, &table.name) {
        diagnostics.error(name, mistake::no_inertia());
    }
    is_allowed
}

/// Whether a mass, a tensor or a motor's inertia is something else than the number zero.
fn has_inertia(robot: &Robot) -> bool {
    let has_motor = |row: &Row| !row.motor_inertia.is_zero();
    carry_bodies(robot).contains(&true) || robot.rows.iter().any(has_motor)
}

/// For each row whether its link, or one that it carries, has a mass or a tensor, by itself or by the tool or a frame.
fn carry_bodies(robot: &Robot) -> Vec<bool> {
    let has_any = |mass: &Value, inertia: &[Value; 6]| {
        !mass.is_zero() || inertia.iter().any(|entry| !entry.is_zero())
    };
    let mut carry: Vec<bool> = robot
        .rows
        .iter()
        .map(|row| has_any(&row.mass, &row.inertia))
        .collect();
    if let Some(row) = robot.tip_row() {
        let tool = robot.tool.as_ref();
        carry[row] |= tool.is_some_and(|tool| has_any(&tool.mass, &tool.inertia));
    }
    for frame in &robot.frames {
        if let (Some(row), Some(body)) = (frame.on, &frame.body) {
            carry[row] |= has_any(&body.mass, &body.inertia);
        }
    }
    for row in (0..carry.len()).rev() {
        if let Some(carrier) = robot.parent(row) {
            carry[carrier] |= carry[row];
        }
    }
    carry
}

/// A note for the documentation on joints that move no mass, where a function solves with M. Joints that others follow
/// may move the mass of these.
pub(super) fn note_on_massless(
    robot: &Robot,
    requests: &[(Request, Option<Place>)],
) -> Option<String> {
    let mut parts = requests.iter().flat_map(|(request, _)| request.parts());
    let solving = parts.find(|function| function.row().refuses)?;
    let rows = robot.rows.iter().enumerate();
    let carry = carry_bodies(robot);
    let massless = rows.filter(|(index, row)| {
        let is_bare = !carry[*index] && row.motor_inertia.is_zero();
        is_bare && row.locked.is_none()
    });
    let names: Vec<&str> = massless.map(|(_, row)| row.name.as_str()).collect();
    let is_certain = !names.is_empty() && robot.followers().next().is_none();
    is_certain.then(|| {
        format!(
            " No mass moves with {}: M is singular at every position, and `{}` returns an error, until a link or a frame \
             behind the joint, or the `tool`, has a mass, or the joint a motor.",
            words::all(&names),
            solving.name()
        )
    })
}

/// Reports what is asked for twice, names that mean something else, and tuples that are none.
pub(super) fn report(asked: &[Asked], table: &Table, scope: &Scope) {
    let mut seen = BTreeSet::new();
    let has_default = asked.iter().any(|asked| matches!(asked, Asked::Default(_)));
    for asked in asked {
        let (word, place) = match asked {
            Asked::Default(place) => ("default".to_owned(), *place),
            Asked::One(function, place) => (function.name().to_owned(), *place),
            Asked::Fused(name, _) => (name.plain().to_owned(), name.into()),
            Asked::Unreadable => continue,
        };
        if !seen.insert(word.clone()) {
            scope.error(place, mistake::function_twice(&word));
        }
        match asked {
            Asked::One(function, _) if has_default && function.row().set == Set::Default => {
                scope.error(place, mistake::in_default_set(&word));
            }
            Asked::Fused(name, parts) => {
                report_name(name, table, scope);
                report_parts(name, parts, scope);
            }
            Asked::Default(_) | Asked::One(..) | Asked::Unreadable => {}
        }
    }
}

fn report_name(name: &Name, table: &Table, scope: &Scope) {
    let word = name.plain();
    if Function::from_name(word).is_some() {
        scope.error(name, mistake::tuple_named_as_function(word));
    } else if RESERVED.contains(&word) {
        scope.error(name, value::reserved("tuple", word));
    } else if table.fields.iter().any(|field| field.plain() == word) {
        scope.error(name, value::field_twice(word));
    }
}

fn report_parts(name: &Name, parts: &[(Function, Place)], scope: &Scope) {
    match parts {
        [] => scope.error(name, mistake::no_parts(name)),
        [(function, place)] => scope.error(*place, mistake::one_part(name, function.name())),
        _ => {}
    }
    for (number, (function, place)) in parts.iter().enumerate() {
        if parts[..number].iter().any(|(other, _)| other == function) {
            scope.error(*place, mistake::part_twice(name, function.name()));
        }
        if !function.can_be_fused() {
            scope.error(*place, mistake::never_a_part(function.name()));
        }
    }
}

/// Reports functions that would be too long, or take too long to find, for so many joints: each by itself, or all of
/// them together.
pub(super) fn report_long(asked: &[Asked], joints: usize, scope: &Scope) {
    report_long_functions(asked, joints, scope);
    let tuples = asked.iter().filter_map(|asked| match asked {
        Asked::Fused(name, parts) => Some((name, parts.len())),
        Asked::Default(_) | Asked::One(..) | Asked::Unreadable => None,
    });
    let mut parts = 0;
    for (name, count) in tuples {
        parts += count;
        if parts * joints > MOST_PARTS {
            scope.error(name, size::parts(joints));
            return;
        }
    }
}

fn report_long_functions(asked: &[Asked], joints: usize, scope: &Scope) {
    let most_joints = |function: Function| match function.row().growth {
        Growth::Moderate => None,
        Growth::Steep => Some(MOST_JOINTS_OF_LONG_FUNCTIONS),
        Growth::Cubic => Some(MOST_JOINTS_OF_CUBIC_FUNCTIONS),
    };
    let mut are_short = true;
    for (function, place) in named(asked) {
        if let Some(most) = most_joints(function).filter(|most| joints > *most) {
            scope.error(place, size::long_function(function.name(), most));
            are_short = false;
        }
    }
    if !are_short {
        return;
    }
    let long = named(asked).filter(|(function, _)| most_joints(*function).is_some());
    let most = MOST_LONG_FUNCTIONS / joints.pow(3).max(1);
    if let Some((function, place)) = long.clone().nth(most) {
        let names: Vec<&str> = long
            .map(|(function, _)| function.name())
            .take(most)
            .collect();
        let mistake = size::long_functions(function.name(), &names, joints);
        scope.error(place, mistake);
    }
}
