//! A table to a robot that the engine knows.
//!
//! The robot that comes out makes sense; every reason why one does not is
//! reported. A value that could not be read is unknown (`None`) from then on, so
//! that nothing is said about it twice.

mod angle;
mod asked;
mod base;
mod body;
mod couple;
mod elementary;
mod frames;
pub(crate) mod functions;
mod known;
mod limits;
mod link;
mod lock;
mod measured;
pub(crate) mod named;
mod nearly;
mod neglect;
mod reach;
mod row;
mod scope;
mod solid;
mod units;

use std::collections::BTreeSet;

use dynamics_symbolic::Request;
use dynamics_symbolic::function::Freedoms;
use dynamics_symbolic::robot::{Base, Bounds, Convention, Frame, Robot, Row, Tool, Value};

use crate::description::{self, Asked, Entry, Name, Table};
#[cfg(feature = "files")]
use crate::description::{Allow, Expr};
use crate::diagnose::Diagnostics;
use crate::finding::Finding;
use crate::mistake::{Mistake, base as base_mistake, entry, file, joint, structure};
use crate::place::Place;
#[cfg(feature = "files")]
pub(crate) use angle::is_in_whole_degrees;
#[cfg(feature = "files")]
pub(crate) use body::refusal;
use couple::Couple;
use lock::Lock;
use scope::Scope;
#[cfg(feature = "files")]
pub(crate) use units::{heaviest_of, in_kilograms, lightest_of};

/// A robot and the code that is to be generated for it.
#[derive(Debug)]
pub struct Model {
    /// The robot.
    pub robot: Robot,
    /// The methods, each with the place where it was requested by name.
    pub requests: Vec<(Request, Option<Place>)>,
    /// Inverse kinematics in closed form: the frame among those of the robot, or the tip, and where they are requested.
    pub inverses: Vec<(Option<usize>, Place)>,
    /// Whether a test is to be generated too.
    pub tests: bool,
    /// The share below which terms are neglected, and where it was written.
    pub neglect: Option<(Value, Place)>,
    /// Further lines of the struct's documentation.
    pub notes: Vec<String>,
    /// Notes on values that its user may not expect. Whoever reads a file is told them.
    pub warnings: Vec<Finding>,
}

impl Model {
    /// All that is noted of it: the lines of the documentation and the warnings.
    pub fn remarks(&self) -> impl Iterator<Item = &String> {
        let warnings = self.warnings.iter().map(|warning| &warning.message);
        self.notes.iter().chain(warnings)
    }
}

/// The model that the call describes, or `None` where an error was reported.
pub(crate) fn model(table: &Table, diagnostics: &Diagnostics) -> Option<Model> {
    let mut scope = Scope::new(table, diagnostics);
    let mut parts = Parts::read(table, &mut scope);
    if let Some(name) = &table.name {
        if !parts.has_unread_file {
            parts.report_missing(name, table, diagnostics);
        }
        parts.lock_and_couple(table, &scope);
        if !reach::report(&parts, table, &scope) {
            units::report(&parts, reach::longest(&parts, table), table, &scope);
        }
        asked::report(&parts, table, &scope);
        neglect::report(&parts, table, diagnostics);
        parts.report_incomparable(diagnostics);
        if parts.have_values(table) {
            report_unused(table, &scope);
        }
    }
    if !diagnostics.is_empty() {
        return None;
    }
    let mut model = parts.model(table)?;
    let is_good = functions::have_mass(&model.requests, &model.robot, diagnostics)
        && functions::have_inertia(&model.robot, table, diagnostics)
        && base::resists(&model.robot, table, diagnostics);
    if table.allow().no_inertia {
        let note = functions::note_on_massless(&model.robot, &model.requests);
        model.notes.extend(note);
    }
    is_good.then(|| Model {
        warnings: [table.warnings.clone(), nearly::notes(&model, table)].concat(),
        ..model
    })
}

/// The names in the values of a table that nothing binds, in the order in which they are read. Mistakes are reported when
/// the table is read with its fields.
#[cfg(feature = "files")]
pub(crate) fn free_names(table: &Table) -> Vec<String> {
    Diagnostics::without(|diagnostics| {
        let mut scope = Scope::new(table, diagnostics);
        let parts = Parts::read(table, &mut scope);
        drop(parts);
        scope.into_free_names()
    })
}

/// The value of an expression without fields and `let`.
#[cfg(feature = "files")]
pub(crate) fn constant(expr: &Expr) -> Option<Value> {
    Diagnostics::without(|diagnostics| value(expr, diagnostics))
}

/// The same, reporting why there is none.
#[cfg(feature = "files")]
pub(crate) fn value(expr: &Expr, diagnostics: &Diagnostics) -> Option<Value> {
    let table = Table {
        entries: vec![Entry::Allow(Some(Allow::EVERYTHING))],
        ..Table::default()
    };
    Scope::new(&table, diagnostics).value(expr)
}

/// Reports the fields that no value uses. Where there are errors, the value that uses
/// one may be unreadable: then only a field that the table never names is reported.
fn report_unused(table: &Table, scope: &Scope) {
    let is_good = scope.is_good();
    for (index, name) in table.fields.iter().enumerate() {
        let word = name.plain();
        let is_named = !is_good && table.mentions.contains(word);
        if !scope.is_used(index) && !is_named {
            scope.error(name, structure::unused_field(word));
        }
    }
}

/// The entries' meanings. Outer `None`: not written; inner `None`: in error.
#[derive(Default)]
struct Parts {
    convention: Option<Option<Convention>>,
    gravity: Option<Option<[Value; 3]>>,
    base: Option<Option<Base>>,
    rows: Option<Vec<Option<Row>>>,
    tool: Option<Option<Tool>>,
    frames: Vec<Option<Frame>>,
    functions: Option<Vec<Asked>>,
    lock: Vec<Lock>,
    couple: Vec<Couple>,
    neglect: Option<(Value, Place)>,
    bounds: Bounds,
    tests: Option<Place>,
    /// Whether a file was named, what is in it is not known: that has been reported.
    has_unread_file: bool,
}

impl Parts {
    /// Reads the entries in the order in which they were written, which is the order
    /// in which `let` binds names.
    fn read(table: &Table, scope: &mut Scope) -> Parts {
        let mut parts = Parts::default();
        for entry in &table.entries {
            match entry {
                Entry::Let(name, value) => scope.bind(name, value.as_ref()),
                Entry::Convention(convention) => parts.convention = Some(*convention),
                Entry::Gravity(gravity) => {
                    let gravity = gravity.as_ref();
                    parts.gravity = Some(gravity.and_then(|g| frames::gravity(g, scope)));
                }
                Entry::Base(base) => {
                    let base = base.as_ref();
                    parts.base = Some(base.and_then(|base| base::base(base, scope)));
                }
                Entry::Tool(_, tool) => {
                    let tool = tool.as_ref();
                    parts.tool = Some(tool.and_then(|tool| frames::tool(tool, scope)));
                }
                Entry::Joints(place, joints) => {
                    parts.rows = Some(match joints {
                        Some(joints) => {
                            if joints.rows.is_empty()
                                && joints.complete
                                && !base::may_be_alone(table)
                            {
                                scope.error(*place, joint::none());
                            }
                            row::rows(table, scope)
                        }
                        None => Vec::new(),
                    });
                }
                Entry::Beside(place, _) => {
                    // Beside a file that could be read they have gone into its rows.
                    let is_file = |entry: &Entry| matches!(entry, Entry::File(_));
                    if !table.entries.iter().any(is_file) {
                        let is_of_file = matches!(place, Place::File { .. });
                        scope.error(*place, file::without_a_file(is_of_file));
                    }
                    parts.rows.get_or_insert_default();
                }
                Entry::Links(place, links) => {
                    // Beside a file with links they have gone into its frames.
                    let is_file = |entry: &Entry| matches!(entry, Entry::File(_));
                    if links.is_some() && !table.entries.iter().any(is_file) {
                        scope.error(*place, file::links_of_a_table());
                    }
                }
                Entry::Functions(functions) => parts.functions = functions.clone(),
                // A file may have one besides that of the call.
                Entry::Lock(locked) => {
                    let list = lock::positions(locked.as_deref(), scope);
                    lock::join(&mut parts.lock, list, scope);
                }
                Entry::Couple(coupled) => {
                    parts
                        .couple
                        .extend(couple::couplings(coupled.as_deref(), scope));
                }
                Entry::Neglect(share) => parts.neglect = neglect::share(share.as_ref(), scope),
                Entry::Bounds(bounds) => parts.bounds = bounds.unwrap_or_default(),
                Entry::Tests(place, tests) => {
                    parts.tests = tests.unwrap_or(false).then_some(*place);
                }
                // A file that could be read has given way to its entries.
                Entry::File(_) => parts.has_unread_file = true,
                Entry::Frames(_, frames) => {
                    let frames = frames.iter().flatten();
                    parts
                        .frames
                        .extend(frames.map(|frame| frames::frame(frame, table, scope)));
                }
                Entry::Chain(_)
                | Entry::Ignore(_)
                | Entry::RoundAngles(_)
                | Entry::Fields(_)
                | Entry::Allow(_) => {}
            }
        }
        frames::report_names(table, scope);
        if let Some(rows) = &parts.rows {
            let freedoms = Freedoms {
                base: table.floating().map_or(0, |_| Base::FREEDOMS),
                joints: rows.len().saturating_sub(parts.lock.len()),
            };
            let place = table.name.as_ref().map(Place::from);
            functions::report_long(parts.functions.as_deref(), freedoms, place, scope);
        }
        if let Some(functions) = &parts.functions {
            functions::report(functions, table, scope);
        }
        let asked = parts.functions.as_deref().unwrap_or_default();
        base::report(asked, &parts, table, scope);
        parts
    }

    /// The frames that a table has, and those that a file has beside its links. One is `None` where it is in error.
    fn frames<'p>(
        &'p self,
        table: &'p Table,
    ) -> impl Iterator<Item = (Option<&'p Frame>, &'p description::Frame)> {
        let frames = self.frames.iter().map(Option::as_ref).zip(table.frames());
        frames.filter(|(_, written)| !written.is_link)
    }

    /// Whether both entries that use fields are there.
    fn have_values(&self, table: &Table) -> bool {
        let rows = self.rows.as_ref();
        let has_rows = rows.is_some_and(|rows| !rows.is_empty() || base::is_alone(table));
        self.gravity.is_some() && has_rows
    }

    /// Reports entries that are missing. A file of a body that moves alone need not say that it has no joints, and nobody how
    /// these would be placed.
    fn report_missing(&mut self, name: &Name, table: &Table, diagnostics: &Diagnostics) {
        let is_of_file = matches!(Place::from(name), Place::File { .. });
        if base::is_alone(table) {
            if is_of_file {
                self.rows.get_or_insert_default();
            }
            self.convention.get_or_insert(Some(Convention::Modified));
        }
        let report = |is_missing: bool, mistake: fn(bool) -> Mistake| {
            if is_missing {
                diagnostics.error(name, mistake(is_of_file));
            }
        };
        report(self.convention.is_none(), entry::missing_convention);
        report(self.gravity.is_none(), entry::missing_gravity);
        report(
            self.rows.is_none(),
            if table.floating().is_some() {
                |_| base_mistake::missing_joints()
            } else {
                entry::missing_joints
            },
        );
    }

    /// A test that would compare nothing: a product is compared, and takes both factors.
    fn report_incomparable(&self, diagnostics: &Diagnostics) {
        if let (Some(tests), Some([Asked::One(wanted)])) = (self.tests, self.functions.as_deref())
            && let Some(other) = wanted.function.row().compared_with
        {
            let mistake = entry::tests_of_one_factor(wanted.function.name(), other.name());
            diagnostics.error(tests, mistake);
        }
    }

    /// Locks the joints that are to be locked, and couples those that follow others. One at least must be left that
    /// moves by itself, unless the base moves.
    fn lock_and_couple(&mut self, table: &Table, scope: &Scope) {
        let is_known = table.joints().is_some_and(|joints| joints.complete);
        let written = table.rows();
        let Some(rows) = self
            .rows
            .as_mut()
            .filter(|rows| is_known && rows.len() == written.len())
        else {
            return;
        };
        let needs_one = !base::may_be_alone(table);
        if lock::lock(rows, &self.lock, written, scope) && needs_one {
            lock::report_all(&self.lock, scope);
        }
        if !self.couple.is_empty() {
            let is_good = scope.is_good();
            couple::couple(rows, &self.couple, written, scope);
            if needs_one {
                lock::report_all_locked(rows, &self.lock, is_good, scope);
            }
        }
    }

    fn model(self, table: &Table) -> Option<Model> {
        let asked = named::named(self.functions.as_deref().unwrap_or_default());
        let asked = asked.filter_map(|wanted| wanted.frame.as_ref());
        let asked: BTreeSet<&str> = asked.map(Name::plain).collect();
        let is_kept = |frame: &description::Frame| {
            let is_named = !frame.is_link || asked.contains(frame.word());
            table.keeps_links || is_named || frame.body.is_written()
        };
        let rows: Vec<Row> = self.rows?.into_iter().collect::<Option<_>>()?;
        let notes = table.notes.clone();
        let frames = self.frames.into_iter().zip(table.frames().map(is_kept));
        let frames = frames.filter_map(|(frame, is_kept)| is_kept.then_some(frame));
        let frames: Option<Vec<Frame>> = frames.collect();
        let robot = Robot {
            name: table.name.as_ref()?.plain().to_owned(),
            fields: table.fields.iter().map(Name::to_string).collect(),
            convention: self.convention??,
            gravity: self.gravity??,
            rows,
            frames: frames?,
            neglected: None,
            bounds: self.bounds,
            base: self.base.map_or(Some(None), |base| base.map(Some))?,
            tool: self.tool.map_or(Some(None), |tool| tool.map(Some))?,
        };
        Some(Model {
            requests: functions::requests(self.functions.as_deref(), &robot),
            inverses: functions::inverses(self.functions.as_deref(), &robot.frames),
            robot,
            tests: self.tests.is_some(),
            neglect: self.neglect,
            notes,
            warnings: Vec::new(),
        })
    }
}
