//! A table to a robot that the engine knows.
//!
//! What comes out is a robot that makes sense; every reason why one does not is
//! reported. A value that could not be read is unknown (`None`) from then on, so
//! that nothing is said about it twice.

mod angle;
mod body;
mod couple;
mod elementary;
mod fields;
mod frames;
mod friction;
pub(crate) mod functions;
mod gravity;
mod limits;
mod lock;
mod measured;
mod neglect;
mod reach;
mod row;
mod scope;
mod solid;

use dynamics_symbolic::Request;
use dynamics_symbolic::robot::{Convention, Placement, Robot, Row, Tool, Value};

use crate::description::{self, Asked, Entry, Joints, Name, Table};
use crate::diagnose::Diagnostics;
use crate::limits::MOST_JOINTS;
use crate::mistake::{entry, joint, size};
use crate::place::Place;
#[cfg(feature = "files")]
pub(crate) use body::refusal;
use couple::Couple;
use lock::Lock;
use scope::{Scope, all};

/// What is to be generated.
#[derive(Debug)]
pub struct Model {
    /// The robot.
    pub robot: Robot,
    /// The methods, each with the place where it was asked for by name.
    pub requests: Vec<(Request, Option<Place>)>,
    /// Whether a test is to be generated too.
    pub tests: bool,
    /// The share below which terms are neglected, and where it was written.
    pub neglect: Option<(Value, Place)>,
    /// What the struct's documentation says besides.
    pub notes: Vec<String>,
}

/// The model that the call describes, or `None` where an error was reported.
pub(crate) fn model(table: &Table, diagnostics: &Diagnostics) -> Option<Model> {
    let mut scope = Scope::new(table, diagnostics);
    let mut parts = Parts::read(table, &mut scope);
    if let Some(name) = &table.name {
        if !parts.has_unread_file {
            parts.report_missing(name, diagnostics);
        }
        parts.lock(table, &scope);
        parts.couple(table, &scope);
        reach::report(&parts, table, &scope);
        neglect::report(&parts, table, diagnostics);
        parts.report_incomparable(diagnostics);
        if parts.have_values() {
            fields::report_unused(table, &scope, diagnostics);
        }
    }
    match diagnostics.is_empty() {
        true => parts
            .model(table)
            .filter(|model| functions::have_mass(&model.requests, &model.robot, diagnostics))
            .filter(|model| functions::have_inertia(&model.robot, table, diagnostics))
            .map(|mut model| {
                let massless = functions::note_on_massless(&model.robot, &model.requests);
                let massless = massless.filter(|_| table.allow().no_inertia);
                model.notes.extend(massless);
                model
            }),
        false => None,
    }
}

/// The entries' meanings. Outer `None`: not written; inner `None`: in error.
#[derive(Default)]
struct Parts {
    convention: Option<Option<Convention>>,
    gravity: Option<[Option<Value>; 3]>,
    base: Option<Option<Placement>>,
    rows: Option<Vec<Option<Row>>>,
    tool: Option<Option<Tool>>,
    functions: Option<Vec<Asked>>,
    lock: Vec<Lock>,
    couple: Vec<Couple>,
    neglect: Option<(Value, Place)>,
    tests: Option<Place>,
    /// Whether a file was named, what is in it is not known: that has been reported.
    has_unread_file: bool,
}

impl Parts {
    /// Reads the entries in the order in which they were written, which is the order
    /// in which `let` binds names.
    fn read(table: &Table, scope: &mut Scope) -> Parts {
        let mut parts = Parts::default();
        let joints = joint_names(table);
        for entry in &table.entries {
            match entry {
                Entry::Let(name, value) => scope.bind(name, value.as_ref()),
                Entry::Convention(convention) => parts.convention = Some(*convention),
                Entry::Gravity(gravity) => {
                    parts.gravity = Some(gravity::gravity(gravity.as_ref(), scope));
                }
                Entry::Base(base) => {
                    let base = base.as_ref();
                    parts.base = Some(base.and_then(|base| frames::placement(base, scope)));
                }
                Entry::Tool(tool) => {
                    let tool = tool.as_ref();
                    parts.tool = Some(tool.and_then(|tool| frames::tool(tool, scope)));
                }
                Entry::Joints(place, joints) => {
                    parts.rows = Some(match joints {
                        Some(joints) if number_is_good(joints, *place, scope) => {
                            row::rows(&joints.rows, scope)
                        }
                        _ => Vec::new(),
                    });
                }
                Entry::Functions(functions) => parts.functions = functions.clone(),
                // A file may have one besides that of the call.
                Entry::Lock(locked) => {
                    let list = lock::positions(locked.as_deref(), scope);
                    lock::join(&mut parts.lock, list, scope);
                }
                Entry::Couple(coupled) => {
                    let couplings = couple::couplings(coupled.as_deref(), &joints, scope);
                    parts.couple.extend(couplings);
                }
                Entry::Neglect(share) => parts.neglect = neglect::share(share.as_ref(), scope),
                Entry::Tests(place, tests) => {
                    parts.tests = tests.unwrap_or(false).then_some(*place);
                }
                // A file that could be read has given way to its entries.
                Entry::File(_) => parts.has_unread_file = true,
                Entry::Chain(_) | Entry::Ignore(_) | Entry::RoundAngles(_) | Entry::Allow(_) => {}
            }
        }
        if let (Some(functions), Some(rows)) = (&parts.functions, &parts.rows) {
            functions::report_long(functions, rows.len(), scope);
        }
        if let Some(functions) = &parts.functions {
            functions::report(functions, table, scope);
        }
        parts
    }

    /// Whether both entries that use fields are there.
    fn have_values(&self) -> bool {
        self.gravity.is_some() && self.rows.as_ref().is_some_and(|rows| !rows.is_empty())
    }

    fn report_missing(&self, name: &Name, diagnostics: &Diagnostics) {
        let is_of_file = matches!(Place::from(name), Place::File { .. });
        if self.convention.is_none() {
            diagnostics.error(name, entry::missing_convention(is_of_file));
        }
        if self.gravity.is_none() {
            diagnostics.error(name, entry::missing_gravity(is_of_file));
        }
        if self.rows.is_none() {
            diagnostics.error(name, entry::missing_joints(is_of_file));
        }
    }

    /// A test that would compare nothing: a product is compared, and takes both factors.
    fn report_incomparable(&self, diagnostics: &Diagnostics) {
        let (Some(tests), Some(functions)) = (self.tests, &self.functions) else {
            return;
        };
        let [Asked::One(function, _)] = functions[..] else {
            return;
        };
        let Some(other) = function.row().compared_with else {
            return;
        };
        let mistake = entry::tests_of_one_factor(function.name(), other.name());
        diagnostics.error(tests, mistake);
    }

    /// Locks the joints that are to be locked.
    fn lock(&mut self, table: &Table, scope: &Scope) {
        let known = rows(table).is_some_and(|joints| joints.complete);
        if let (Some(rows), true) = (&mut self.rows, known) {
            lock::lock(rows, &self.lock, rows_of(table), scope);
        }
    }

    /// Couples the joints that follow others. One at least must be left that moves by itself.
    fn couple(&mut self, table: &Table, scope: &Scope) {
        let known = rows(table).is_some_and(|joints| joints.complete);
        let (Some(rows), true) = (&mut self.rows, known) else {
            return;
        };
        if self.couple.is_empty() {
            return;
        }
        let is_good = scope.is_good();
        couple::couple(rows, &self.couple, rows_of(table), scope);
        lock::report_all_locked(rows, &self.lock, is_good, scope);
    }

    fn model(self, table: &Table) -> Option<Model> {
        let robot = Robot {
            name: table.name.as_ref()?.plain().to_owned(),
            fields: table.fields.iter().map(Name::to_string).collect(),
            convention: self.convention??,
            gravity: all(self.gravity?)?,
            rows: self.rows?.into_iter().collect::<Option<_>>()?,
            neglected: None,
            base: given(self.base)?,
            tool: given(self.tool)?,
        };
        Some(Model {
            requests: functions::requests(self.functions.as_deref(), &robot),
            robot,
            tests: self.tests.is_some(),
            neglect: self.neglect,
            notes: table.notes.clone(),
        })
    }
}

/// The table as it was written, where it could be read.
fn rows(table: &Table) -> Option<&Joints> {
    table.entries.iter().find_map(|entry| match entry {
        Entry::Joints(_, joints) => joints.as_ref(),
        _ => None,
    })
}

/// The names of all joints.
fn joint_names(table: &Table) -> Vec<String> {
    let names = rows_of(table).iter().filter_map(|row| row.name.as_ref());
    names.map(|name| name.plain().to_owned()).collect()
}

/// Its rows.
fn rows_of(table: &Table) -> &[description::Row] {
    rows(table).map_or(&[], |joints| &joints.rows)
}

fn number_is_good(joints: &Joints, place: Place, scope: &Scope) -> bool {
    if joints.rows.is_empty() && joints.complete {
        scope.error(place, joint::none());
    }
    let Some(row) = joints.rows.get(MOST_JOINTS) else {
        return true;
    };
    let place = row.name.as_ref().map_or(place, Place::from);
    scope.error(place, size::joints());
    false
}

/// An entry that may be left out; `None` where it is in error.
fn given<T>(entry: Option<Option<T>>) -> Option<Option<T>> {
    match entry {
        None => Some(None),
        Some(value) => value.map(Some),
    }
}
