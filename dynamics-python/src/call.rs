//! A call: of one state without detours, of many with all that numpy allows.

use std::iter;
use std::sync::{LazyLock, Mutex, PoisonError};
use std::thread;

use dynamics_evaluation::EvaluationError;
use numpy::{PyArray1, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arguments::{Given, broadcast};
use crate::errors;
use crate::ready::{MOST_ARGUMENTS, Ready, SHORT};
use crate::results::{Out, Results, array};
use dynamics_evaluation::Arrangement;

/// From so many states on other threads of Python run meanwhile.
const DETACHED: usize = 16;

/// The most threads of a call: more than there are processors gain nothing.
static PROCESSORS: LazyLock<usize> =
    LazyLock::new(|| thread::available_parallelism().map_or(1, usize::from));

/// The value at one state, whose arguments are plain vectors of aligned doubles; `None` of others.
pub(crate) fn of_one_state<'py>(
    py: Python<'py>,
    ready: &Ready,
    arguments: &Bound<'py, PyTuple>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let Arrangement::Array(axes) = &ready.arrangement else {
        return Ok(None);
    };
    if arguments.len() != ready.arguments.len() || !ready.is_short {
        return Ok(None);
    }
    let mut numbers = [0.0; SHORT];
    let mut rest = numbers.as_mut_slice();
    let mut slices: [&[f64]; MOST_ARGUMENTS] = [&[]; MOST_ARGUMENTS];
    for (i, argument) in ready.arguments.iter().enumerate() {
        let given = arguments.get_borrowed_item(i)?;
        let Ok(given) = given.cast::<PyArray1<f64>>() else {
            return Ok(None);
        };
        let is_plain = given.is_exact_instance_of::<PyUntypedArray>() && given.is_aligned();
        if given.len() != argument.entries || argument.is_pose() || !is_plain {
            return Ok(None);
        }
        let (own, others) = rest.split_at_mut(argument.entries);
        for (k, number) in own.iter_mut().enumerate() {
            *number = given.get_owned([k]).unwrap_or(f64::NAN);
        }
        (slices[i], rest) = (own, others);
    }
    let mut room = [0.0; SHORT];
    let results = &mut room[..ready.entries];
    let evaluated =
        ready
            .arm
            .evaluate_by_rows(&ready.name, &slices[..ready.arguments.len()], results);
    evaluated.map_err(|error| raised(py, &error, &[]))?;
    array(py, axes, results).map(Some)
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
    let given: Vec<Given<'_, 'py>> = pairs
        .map(|(argument, value)| Given::new(argument, value))
        .collect::<PyResult<_>>()?;
    let lead = broadcast(&given)?;
    if lead.is_empty() {
        warn_of_degrees(py, ready, &given)?;
    }
    let rows = given.iter().map(|one| one.rows(&lead));
    let rows: Vec<_> = rows.collect::<PyResult<_>>()?;
    let locks: Vec<_> = rows
        .iter()
        .map(|rows| rows.try_readonly())
        .collect::<Result<_, _>>()?;
    let slices: Vec<&[f64]> = locks
        .iter()
        .map(|lock| lock.as_slice())
        .collect::<Result<_, _>>()?;
    let is_single = is_single(py, &given)?;
    let out = Out::new(ready, &lead, is_single, settings.out)?;
    let mut results = Results::new(py, ready, &lead, out, &rows)?;
    let (threads, states) = (settings.threads, lead.iter().product());
    let failed = results.fill(|numbers| {
        if states < DETACHED {
            return evaluate(ready, &slices, numbers, states, 1);
        }
        py.detach(|| evaluate(ready, &slices, numbers, states, threads))
    })?;
    match failed {
        Err(EvaluationError::Singular { .. }) if settings.nan => {}
        Err(error) => return Err(raised(py, &error, &lead)),
        Ok(()) => {}
    }
    drop(locks);
    results.finish(py, ready, &lead, is_single)
}

/// A `UserWarning` if positions of joints were perhaps meant in degrees.
fn warn_of_degrees(py: Python<'_>, ready: &Ready, given: &[Given<'_, '_>]) -> PyResult<()> {
    let mut pairs = ready.arguments.iter().zip(given);
    let Some((_, q)) = pairs.find(|(argument, _)| argument.name == "q") else {
        return Ok(());
    };
    let positions = q.array().call_method0("ravel")?.extract::<Vec<f64>>()?;
    errors::warn_of_degrees(py, ready.arm.robot(), &positions, 1)
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
                let place = ready.arguments.iter().position(|of| of.name == name);
                match place {
                    Some(place) if places[place].is_none() => places[place] = Some(value),
                    Some(_) => {
                        let message = format!("{}: `{name}` is given twice", ready.signature());
                        return Err(PyTypeError::new_err(message));
                    }
                    None => {
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

/// Whether numpy would have the result in single precision.
fn is_single(py: Python<'_>, given: &[Given<'_, '_>]) -> PyResult<bool> {
    if given.is_empty() || given.iter().any(Given::is_double) {
        return Ok(false);
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
            state: state.map(|state| state + before),
            joint,
            error,
        },
        other => other,
    }
}
