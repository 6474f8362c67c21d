//! A call: of one state without detours, of many with all that numpy allows.

use std::iter;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::thread;

use dynamics_evaluation::EvaluationError;
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arguments::{Argument, Given, Kind, Rows, broadcast};
use crate::errors;
use crate::ready::{MOST_ARGUMENTS, Ready, SHORT, require_values};
use crate::results::{Out, Results, value};

/// From so many states on other threads of Python run meanwhile.
const DETACHED: usize = 16;

/// The most threads of a call: more than there are processors gain nothing.
static PROCESSORS: LazyLock<usize> =
    LazyLock::new(|| thread::available_parallelism().map_or(1, usize::from));

/// The value at one state, whose arguments are plain vectors, lists or poses; `None` of others.
pub(crate) fn of_one_state<'py>(
    py: Python<'py>,
    ready: &Ready,
    arguments: &Bound<'py, PyTuple>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let count = ready.arguments.len();
    if arguments.len() != count || count > MOST_ARGUMENTS || !ready.is_complete {
        return Ok(None);
    }
    let (mut few, mut many) = ([0.0; SHORT], Vec::new());
    let (numbers, results) = ready.room(&mut few, &mut many);
    let mut rest = numbers;
    let mut slices: [&[f64]; MOST_ARGUMENTS] = [&[]; MOST_ARGUMENTS];
    let (mut kinds, mut positions) = ([Kind::Single; MOST_ARGUMENTS], None);
    for (i, argument) in ready.arguments.iter().enumerate() {
        let (own, others) = rest.split_at_mut(argument.entries);
        let given = arguments.get_borrowed_item(i)?;
        let Some(kind) = argument.read(&given, own)? else {
            return Ok(None);
        };
        (kinds[i], slices[i], rest) = (kind, own, others);
        if kind != Kind::Double && argument.name == "q" {
            positions = Some(i);
        }
    }
    if let Some(q) = positions {
        errors::warn_of_degrees(py, ready.arm.robot(), slices[q], 1)?;
    }
    let evaluated = ready
        .arm
        .evaluate_by_rows(&ready.name, &slices[..count], results);
    evaluated.map_err(|error| raised(py, &error, &[]))?;
    if count > 0 && kinds == [Kind::Single; MOST_ARGUMENTS] {
        let singles: Vec<f32> = results.iter().map(|x| *x as f32).collect();
        return value(py, &ready.arrangement, &mut &singles[..]).map(Some);
    }
    value(py, &ready.arrangement, &mut &*results).map(Some)
}

/// The exception of an error at a state, by its index along the leading axes.
pub(crate) fn raised(py: Python<'_>, error: &EvaluationError, lead: &[usize]) -> PyErr {
    match error {
        EvaluationError::Singular {
            state,
            joint,
            error,
        } => {
            let mut rest = state.unwrap_or(0);
            let mut index: Vec<usize> = Vec::new();
            for size in lead.iter().rev() {
                index.push(rest % size);
                rest /= size;
            }
            index.reverse();
            errors::singular(py, index, joint, &error.to_string())
        }
        other => PyRuntimeError::new_err(other.to_string()),
    }
}

/// Settings of a call.
struct Settings<'py> {
    /// Fields by their places, with values.
    fields: Vec<(usize, Bound<'py, PyAny>)>,
    out: Option<Bound<'py, PyAny>>,
    threads: usize,
    nan: bool,
}

/// An evaluation of a function: its values or their bounds, at so many states and on so many threads.
type Evaluation = fn(&Ready, &[&[f64]], &mut [f64], usize, usize) -> Result<(), EvaluationError>;

/// The value at many states, or of arguments that are converted first.
pub(crate) fn of_many<'py>(
    py: Python<'py>,
    ready: &Ready,
    arguments: &Bound<'py, PyTuple>,
    keywords: Option<&Bound<'py, PyDict>>,
    evaluate: Evaluation,
) -> PyResult<Bound<'py, PyAny>> {
    let (values, settings) = sorted(ready, arguments, keywords)?;
    let pairs = ready.arguments.iter().zip(&values);
    let fields = settings.fields.iter();
    let fields = fields.map(|(place, value)| (&ready.fields[*place], value));
    let given: Vec<Given<'_, 'py>> = pairs
        .chain(fields)
        .map(|(argument, value)| Given::new(argument, value))
        .collect::<PyResult<_>>()?;
    let lead = broadcast(&given)?;
    let rows = given.iter().map(|one| one.rows(&lead));
    let rows: Vec<_> = rows.collect::<PyResult<_>>()?;
    let slices: Vec<&[f64]> = rows.iter().map(Rows::as_slice).collect::<PyResult<_>>()?;
    let q = ready.arguments.iter().position(|of| of.name == "q");
    if let (Some(q), true) = (q, lead.is_empty()) {
        errors::warn_of_degrees(py, ready.arm.robot(), slices[q], 1)?;
    }
    let is_single = is_single(py, &given)?;
    let places: Vec<usize> = settings.fields.iter().map(|(place, _)| *place).collect();
    let (slices, fields) = slices.split_at(ready.arguments.len());
    let evaluate = WithFields::new(ready, places, fields, evaluate)?;
    let out = Out::new(ready, &lead, is_single, settings.out)?;
    let mut results = Results::new(py, ready, &lead, out, &rows)?;
    let (threads, states) = (settings.threads, lead.iter().product());
    let failed = results.fill(|numbers| {
        if states < DETACHED {
            return evaluate.at(slices, numbers, states, 1);
        }
        py.detach(|| evaluate.at(slices, numbers, states, threads))
    })?;
    match failed {
        Err(EvaluationError::Singular { .. }) if settings.nan => {}
        Err(error) => return Err(raised(py, &error, &lead)),
        Ok(()) => {}
    }
    drop(rows);
    results.finish(py, ready, &lead, is_single)
}

/// The arguments in their order, and the settings.
fn sorted<'py>(
    ready: &Ready,
    arguments: &Bound<'py, PyTuple>,
    keywords: Option<&Bound<'py, PyDict>>,
) -> PyResult<(Vec<Bound<'py, PyAny>>, Settings<'py>)> {
    let count = ready.arguments.len();
    let mut places: Vec<Option<Bound<'py, PyAny>>> = arguments.iter().map(Some).collect();
    if places.len() > count {
        return Err(PyTypeError::new_err(format!(
            "{} takes {count} arguments, and {} were given",
            ready.signature(),
            places.len()
        )));
    }
    places.resize(count, None);
    let mut settings = Settings {
        fields: Vec::new(),
        out: None,
        threads: 1,
        nan: false,
    };
    for (key, value) in keywords.into_iter().flatten() {
        let key: String = key.extract()?;
        match key.as_str() {
            "out" => settings.out = (!value.is_none()).then_some(value),
            "threads" => settings.threads = threads(&value)?,
            "on_singular" => settings.nan = is_nan(&value)?,
            name => {
                let of_name = |of: &Argument| of.name == name;
                let place = ready.arguments.iter().position(of_name);
                match (place, ready.fields.iter().position(of_name)) {
                    (Some(place), _) if places[place].is_none() => places[place] = Some(value),
                    (Some(_), _) => {
                        let message = format!("{}: `{name}` is given twice", ready.signature());
                        return Err(PyTypeError::new_err(message));
                    }
                    (None, Some(field)) => settings.fields.push((field, value)),
                    (None, None) => {
                        let message = format!("{} has no argument `{name}`", ready.signature());
                        return Err(PyTypeError::new_err(message));
                    }
                }
            }
        }
    }
    let given = places.into_iter().zip(&ready.arguments);
    let given = given.map(|(place, argument)| {
        place.ok_or_else(|| {
            let signature = ready.signature();
            PyTypeError::new_err(format!("{signature}: `{}` is missing", argument.name))
        })
    });
    Ok((given.collect::<PyResult<_>>()?, settings))
}

fn threads(value: &Bound<'_, PyAny>) -> PyResult<usize> {
    match value.extract::<usize>() {
        _ if value.is_none() => Ok(1),
        Ok(count) if count > 0 => Ok(count),
        _ => Err(PyValueError::new_err(format!(
            "`threads` is {value}: expected a number of at least 1"
        ))),
    }
}

fn is_nan(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    match value.extract::<&str>() {
        Ok("nan") => Ok(true),
        Ok("raise") => Ok(false),
        _ => Err(PyValueError::new_err(format!(
            "`on_singular` is {value}: expected \"raise\" or \"nan\""
        ))),
    }
}

/// An evaluation with values of fields that a call gives, each for all states.
struct WithFields<'a> {
    ready: &'a Ready,
    places: Vec<usize>,
    values: &'a [&'a [f64]],
    evaluate: Evaluation,
}

impl<'a> WithFields<'a> {
    /// `ValueError` of fields without a value.
    fn new(
        ready: &'a Ready,
        places: Vec<usize>,
        values: &'a [&'a [f64]],
        evaluate: Evaluation,
    ) -> PyResult<Self> {
        let mut known = ready.arm.fields().to_vec();
        places.iter().for_each(|place| known[*place] = 0.0);
        require_values(ready.arm.field_names(), &known)?;
        Ok(WithFields {
            ready,
            places,
            values,
            evaluate,
        })
    }

    /// The values at all states. States one after the other that have the same fields are evaluated together.
    fn at(
        &self,
        arguments: &[&[f64]],
        results: &mut [f64],
        states: usize,
        threads: usize,
    ) -> Result<(), EvaluationError> {
        if self.places.is_empty() {
            return (self.evaluate)(self.ready, arguments, results, states, threads);
        }
        let mut ready = self.ready.clone();
        let mut fields = ready.arm.fields().to_vec();
        let (mut first, mut ended) = (0, Ok(()));
        let same = |one: usize, other: usize| self.values.iter().all(|of| of[one] == of[other]);
        while first < states {
            let alike = (first + 1..states).take_while(|state| same(first, *state));
            let count = 1 + alike.count();
            for (place, values) in self.places.iter().zip(self.values) {
                fields[*place] = values[first];
            }
            Arc::make_mut(&mut ready.arm).set_fields(&fields)?;
            let parts = rows_of(&ready, arguments, first, count);
            let results = &mut results[first * ready.entries..(first + count) * ready.entries];
            let found = (self.evaluate)(&ready, &parts, results, count, threads);
            ended = ended.and(found.map_err(|error| later(error, first)));
            first += count;
        }
        ended
    }
}

/// Whether numpy would have the result in single precision.
fn is_single(py: Python<'_>, given: &[Given<'_, '_>]) -> PyResult<bool> {
    let singles = given.iter().filter(|one| one.is_float(4)).count();
    if singles == 0 || singles == given.len() || given.iter().any(|one| one.is_float(8)) {
        return Ok(singles > 0 && singles == given.len());
    }
    let arrays = PyTuple::new(py, given.iter().map(Given::array))?;
    let kind = py.import("numpy")?.getattr("result_type")?.call1(arrays)?;
    let kind: String = kind.getattr("name")?.extract()?;
    Ok(kind == "float32")
}

/// Proven bounds of the values' rounding at all states, on one thread.
pub(crate) fn bounds(
    ready: &Ready,
    arguments: &[&[f64]],
    results: &mut [f64],
    states: usize,
    _threads: usize,
) -> Result<(), EvaluationError> {
    let mut ended = Ok(());
    if ready.entries == 0 {
        return ended;
    }
    for (state, row) in (0..states).zip(results.chunks_exact_mut(ready.entries)) {
        let of_state = rows_of(ready, arguments, state, 1);
        match ready.arm.bounds_by_rows(&ready.name, &of_state) {
            Ok(bounds) => row.copy_from_slice(&bounds),
            Err(EvaluationError::Singular { joint, error, .. }) => {
                row.fill(f64::NAN);
                let state = Some(state);
                ended = ended.and(Err(EvaluationError::Singular {
                    state,
                    joint,
                    error,
                }));
            }
            Err(error) => return Err(error),
        }
    }
    ended
}

/// Evaluates all states, on some threads. The values of states at which M is singular are NaN.
pub(crate) fn evaluate(
    ready: &Ready,
    arguments: &[&[f64]],
    results: &mut [f64],
    states: usize,
    threads: usize,
) -> Result<(), EvaluationError> {
    let (name, arm) = (ready.name.as_str(), &ready.arm);
    // Link poses of a body without joints have no entries.
    if states == 0 || ready.entries == 0 {
        return Ok(());
    }
    let has_width = ready.arguments.iter().any(|of| of.entries > 0);
    if states == 1 || !has_width {
        let value = arm.evaluate_by_rows(name, arguments, &mut results[..ready.entries]);
        if value.is_err() {
            results.fill(f64::NAN);
        } else {
            let (first, rest) = results.split_at_mut(ready.entries);
            rest.chunks_exact_mut(ready.entries)
                .for_each(|row| row.copy_from_slice(first));
        }
        return value;
    }
    let chunk = states.div_ceil(threads.min(states)).next_multiple_of(32);
    if chunk >= states {
        return arm.batch_by_rows(name, arguments, results);
    }
    let part = |first: usize, results: &mut [f64]| {
        let parts = rows_of(ready, arguments, first, results.len() / ready.entries);
        arm.batch_by_rows(name, &parts, results)
            .map_err(|error| later(error, first))
    };
    let chunks = Mutex::new(results.chunks_mut(chunk * ready.entries).enumerate());
    shared(threads.min(*PROCESSORS), || {
        let mut chunks = chunks.lock().unwrap_or_else(PoisonError::into_inner);
        let (k, results) = chunks.next()?;
        drop(chunks);
        Some(part(k * chunk, results).map_err(|error| (k, error)))
    })
}

/// Does all parts of some work on so many threads, or on as many as the system has. The error of the first part that fails.
fn shared(
    threads: usize,
    next: impl Fn() -> Option<Result<(), (usize, EvaluationError)>> + Sync,
) -> Result<(), EvaluationError> {
    // Each thread takes parts in their order, so that its first error is the one that counts.
    let work = || iter::from_fn(&next).fold(Ok(()), Result::and);
    let ended: Vec<_> = thread::scope(|scope| {
        let more = || thread::Builder::new().spawn_scoped(scope, work).ok();
        let running: Vec<_> = (1..threads).map_while(|_| more()).collect();
        let own = iter::once(work());
        let others = running.into_iter();
        own.chain(others.map(|thread| thread.join().expect("no batch panics")))
            .collect()
    });
    let failed = ended.into_iter().filter_map(Result::err);
    let first = failed.min_by_key(|(part, _)| *part);
    first.map_or(Ok(()), |(_, error)| Err(error))
}

/// The arguments of some states.
fn rows_of<'a>(
    ready: &Ready,
    arguments: &[&'a [f64]],
    first: usize,
    count: usize,
) -> Vec<&'a [f64]> {
    let pairs = ready.arguments.iter().zip(arguments);
    let rows = pairs.map(|(of, rows)| &rows[first * of.entries..(first + count) * of.entries]);
    rows.collect()
}

/// The error of a state that stands behind so many others.
fn later(error: EvaluationError, before: usize) -> EvaluationError {
    match error {
        EvaluationError::Singular {
            state,
            joint,
            error,
        } => EvaluationError::Singular {
            state: Some(state.unwrap_or(0) + before),
            joint,
            error,
        },
        other => other,
    }
}
