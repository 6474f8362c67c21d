//! The functions that are requested: each once, and each method with a name of its own.

use std::collections::BTreeMap;

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::center_of_mass::is_massless;
use dynamics_symbolic::function::{Freedoms, INVERSE_KINEMATICS, Part, Request};
use dynamics_symbolic::robot::{Frame, Robot, Row};

use super::named::read_masses;
use super::scope::Scope;
use crate::description::{Asked, Masses, Name, Table, Wanted};
use crate::diagnose::Diagnostics;
use crate::keys::word_list;
use crate::limits::{MOST_OPERATIONS, OPERATIONS_OF_A_PART};
use crate::mistake::{entry as mistake, link, size, value};
use crate::place::Place;
use crate::words;

/// Names that an item of the struct has in any case, and the methods that come with its derives.
pub(crate) const RESERVED: &[&str] = word_list![
    default table formulas DOF JOINT_NAMES JOINT_LIMITS TORQUE_LIMITS VELOCITY_LIMITS OPERATIONS ROUNDING BASE_PARAMETERS BASE_PARAMETER_NAMES evaluate momenta
    energies clone eq
];

/// The functions that are requested, each with its place; those of the default set have none.
pub(super) fn requests(asked: Option<&[Asked]>, robot: &Robot) -> Vec<(Request, Option<Place>)> {
    let default_set = Function::default_set(has_friction(robot)).into_iter();
    let default_set: Vec<_> = default_set.map(|f| (f.into(), None)).collect();
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
            Asked::One(wanted) if wanted.is_inverse => {}
            Asked::One(wanted) => {
                let request = (one(wanted, &robot.frames), Some(wanted.place));
                // Whoever names a function need not know whether the set has it.
                if !(has_default && is_default(&request)) {
                    requests.push(request);
                }
            }
            Asked::Fused(name, parts) => {
                requests.push((fused(name, parts, &robot.frames), Some(name.into())));
            }
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

/// The method of one function, of a robot with these frames.
pub(crate) fn one(wanted: &Wanted, frames: &[Frame]) -> Request {
    let Part { function, frame } = part(wanted, frames);
    let named = frame.zip(wanted.frame.as_ref());
    named.map_or(function.into(), |(index, name)| {
        Request::of_frame(function, index, name.plain())
    })
}

/// The method of that name with those parts.
pub(crate) fn fused(name: &Name, parts: &[Wanted], frames: &[Frame]) -> Request {
    let parts = parts.iter().map(|wanted| part(wanted, frames));
    Request::fused(name.to_string(), parts)
}

/// A function and the place of its frame; 0 if there is none of that name, for a method without a body.
fn part(wanted: &Wanted, frames: &[Frame]) -> Part {
    let place = |name: &Name| frames.iter().position(|frame| frame.name == name.plain());
    Part {
        function: wanted.function,
        frame: wanted.frame.as_ref().map(|name| place(name).unwrap_or(0)),
    }
}

/// Inverse kinematics: the frame among those of the robot, or the tip, and where they are requested.
pub(super) fn inverses(asked: Option<&[Asked]>, frames: &[Frame]) -> Vec<(Option<usize>, Place)> {
    let wanted = asked
        .unwrap_or_default()
        .iter()
        .filter_map(|asked| match asked {
            Asked::One(wanted) if wanted.is_inverse => Some(wanted),
            _ => None,
        });
    wanted
        .map(|wanted| (part(wanted, frames).frame, wanted.place))
        .collect()
}

/// Whether the arm has a mass, where a function divides by it; all of these are requested by name.
pub(super) fn have_mass(
    requests: &[(Request, Option<Place>)],
    robot: &Robot,
    diagnostics: &Diagnostics,
) -> bool {
    let divides = |(request, place): &(Request, Option<Place>)| {
        let function = request
            .functions()
            .find(|function| function.divides_by_mass())?;
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

/// Whether anything has inertia, where a function depends on it. `odd_mass` accepts an arm without any, too. The needs
/// of a base that moves are checked elsewhere.
pub(super) fn have_inertia(robot: &Robot, table: &Table, diagnostics: &Diagnostics) -> bool {
    let allow = table.allow();
    let is_allowed =
        allow.no_inertia || allow.odd_mass || !read_masses(table) || has_inertia(robot);
    let is_allowed = is_allowed || robot.floating().is_some() || table.masses == Masses::IfAny;
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
    let rows = robot.rows.iter().enumerate();
    let of_rows = rows.map(|(i, row)| (Some(i), row.body()));
    let tool = robot.tool.iter();
    let of_tool = tool.map(|tool| (robot.tip_row(), tool.body.clone()));
    let frames = robot.frames.iter();
    let of_frames = frames.flat_map(|frame| Some(frame.on).zip(frame.body.clone()));
    let mut carry = vec![false; robot.rows.len()];
    for (on, body) in of_rows.chain(of_tool).chain(of_frames) {
        let mut link = on.filter(|_| !body.is_massless());
        while let Some(row) = link {
            carry[row] = true;
            link = robot.parent(row);
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
    let mut functions = requests.iter().flat_map(|(request, _)| request.functions());
    let solving = functions.find(|function| function.row().refuses)?;
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

/// Reports what is requested twice, names that mean something else, and tuples that are none.
pub(super) fn report(asked: &[Asked], table: &Table, scope: &Scope) {
    let mut seen = BTreeMap::new();
    for asked in asked {
        let (method, shown, place) = match asked {
            Asked::Default(place) => ("default".to_owned(), "default".to_owned(), *place),
            Asked::One(wanted) => (wanted.method(), wanted.to_string(), wanted.place),
            Asked::Fused(name, _) => (
                name.plain().to_owned(),
                name.plain().to_owned(),
                name.into(),
            ),
            Asked::Unreadable => continue,
        };
        let other = seen.insert(method.clone(), shown.clone());
        match asked {
            Asked::One(wanted) if wanted.frame.is_some() && other.as_ref() != Some(&shown) => {
                let other = other.map(|other| format!("`{other}` too"));
                if let Some(other) = other.or_else(|| meaning(&method)) {
                    scope.error(place, link::method_taken(wanted, &method, &other));
                }
            }
            _ if other.is_some() => scope.error(place, mistake::function_twice(&shown)),
            _ => {}
        }
        if let Asked::Fused(name, parts) = asked {
            report_name(name, table, scope);
            report_parts(name, parts, scope);
        }
    }
}

/// The meaning of a method's name that no function of a frame may have.
fn meaning(method: &str) -> Option<String> {
    let function = method.strip_suffix("_batch").unwrap_or(method);
    Function::from_name(function).map(|_| match method == function {
        true => "a function of its own".to_owned(),
        false => format!("`{function}` of many states"),
    })
}

fn report_name(name: &Name, table: &Table, scope: &Scope) {
    let word = name.plain();
    if Function::from_name(word).is_some() || word == INVERSE_KINEMATICS {
        scope.error(name, mistake::tuple_named_as_function(word));
    } else if RESERVED.contains(&word) {
        scope.error(name, value::reserved("tuple", word));
    } else if table.fields.iter().any(|field| field.plain() == word) {
        scope.error(name, value::field_twice(word));
    }
}

fn report_parts(name: &Name, parts: &[Wanted], scope: &Scope) {
    match parts {
        [] => scope.error(name, mistake::no_parts(name)),
        [wanted] => scope.error(wanted.place, mistake::one_part(name, wanted)),
        _ => {}
    }
    for (number, wanted) in parts.iter().enumerate() {
        let mut before = parts[..number].iter();
        let shown = wanted.to_string();
        if before.any(|other| other.to_string() == shown) {
            scope.error(wanted.place, mistake::part_twice(name, &shown));
        }
        if wanted.is_inverse || !wanted.function.can_be_fused() {
            scope.error(wanted.place, mistake::never_a_part(&shown));
        }
    }
}

/// Reports functions that have too many operations with so many joints: each by itself, or the first that has too many
/// besides those before it. Nothing is written where the default set is not requested by its word.
pub(super) fn report_long(
    asked: Option<&[Asked]>,
    freedoms: Freedoms,
    unwritten: Option<Place>,
    scope: &Scope,
) {
    let default = unwritten.map(Asked::Default);
    let asked = asked.unwrap_or(default.as_slice()).iter();
    let lengths = asked.filter_map(|asked| length(asked, freedoms.all()));
    let mut are_short = true;
    for (name, operations, place) in lengths.clone() {
        if operations > MOST_OPERATIONS {
            scope.error(place, size::long_function(&name, operations, freedoms));
            are_short = false;
        }
    }
    let (mut names, mut operations) = (Vec::new(), 0);
    for (name, own, place) in lengths.filter(|_| are_short) {
        operations += own;
        if operations > MOST_OPERATIONS {
            let mistake = size::long_functions(&name, &names, operations, freedoms);
            return scope.error(place, mistake);
        }
        names.push(name);
    }
}

/// The word of a request, its operations with so many joints, and its place. Inverse kinematics is short.
fn length(asked: &Asked, joints: usize) -> Option<(String, usize, Place)> {
    let of = |function: Function| function.row().growth.operations(joints);
    match asked {
        Asked::Default(place) => {
            let set = Function::default_set(true).into_iter();
            Some(("default".to_owned(), set.map(of).sum(), *place))
        }
        Asked::One(wanted) => Some((wanted.to_string(), of(wanted.function), wanted.place)),
        Asked::Fused(name, parts) => {
            let of_part = |part: &Wanted| of(part.function) + OPERATIONS_OF_A_PART * joints;
            let operations = parts.iter().map(of_part).sum();
            Some((name.plain().to_owned(), operations, name.into()))
        }
        Asked::Unreadable => None,
    }
}
