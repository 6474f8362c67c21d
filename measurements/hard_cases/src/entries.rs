//! The entries of `tests/data/hard_cases.json`, and their reference digits.

use robot_dynamics::nalgebra::SVector;
use serde_json::Value;

use testkit::references::Decimal;

/// One entry.
pub struct Entry(Value);

/// All entries, in the order of the file.
///
/// # Panics
///
/// Where the file is not there, or has something else in it.
pub fn all() -> Vec<Entry> {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/data/hard_cases.json"
    );
    let text = std::fs::read_to_string(path).expect("the file of the hard cases");
    let file: Value = serde_json::from_str(&text).expect("JSON");
    let cases = file["cases"].as_array().expect("a list of cases");
    cases.iter().cloned().map(Entry).collect()
}

/// The entry of that name.
pub(crate) fn entry(id: &str) -> Entry {
    let found = all().into_iter().find(|entry| entry.id() == id);
    found.unwrap_or_else(|| panic!("no entry {id}"))
}

impl Entry {
    /// Its name.
    ///
    /// # Panics
    ///
    /// Where it has none.
    pub fn id(&self) -> &str {
        self.0["id"].as_str().expect("a name")
    }

    /// A number among the parameters.
    pub(crate) fn number(&self, name: &str) -> f64 {
        self.0["params"][name].as_f64().expect("a number")
    }

    /// A vector among the parameters.
    pub(crate) fn vector<const N: usize>(&self, name: &str) -> SVector<f64, N> {
        let numbers = self.0["params"][name].as_array().expect("a list");
        assert_eq!(numbers.len(), N);
        SVector::from_fn(|i, _| numbers[i].as_f64().expect("a number"))
    }

    /// The reference digits under a name of `exact`.
    pub(crate) fn exact(&self, name: &str) -> Vec<Decimal> {
        decimals(&self.0["exact"][name])
    }

    /// The reference digits where `exact` is a list.
    pub(crate) fn exact_list(&self) -> Vec<Decimal> {
        decimals(&self.0["exact"])
    }
}

/// The numbers of a list, a matrix row by row, or one number.
fn decimals(value: &Value) -> Vec<Decimal> {
    match value {
        Value::Array(list) => list.iter().flat_map(decimals).collect(),
        Value::String(text) => {
            vec![Decimal::try_from(text.clone()).expect("a decimal")]
        }
        Value::Number(x) => {
            vec![Decimal::try_from(x.to_string()).expect("a decimal")]
        }
        other => panic!("no digits: {other}"),
    }
}

/// The largest error over the largest reference value; infinite where a value is not a number.
pub(crate) fn relative_error<'a>(
    found: impl IntoIterator<Item = &'a f64>,
    exact: &[Decimal],
) -> f64 {
    let size = largest(exact.iter().map(|x| x.nearest()));
    absolute_error(found, exact) / size
}

/// The largest error; infinite where a value is not a number.
pub(crate) fn absolute_error<'a>(
    found: impl IntoIterator<Item = &'a f64>,
    exact: &[Decimal],
) -> f64 {
    let found: Vec<_> = found.into_iter().collect();
    assert_eq!(found.len(), exact.len());
    largest(
        found
            .iter()
            .zip(exact)
            .map(|(x, exact)| exact.error_of(**x)),
    )
}

/// The largest absolute value; infinite where one is not a number.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    let size = |x: f64| if x.is_nan() { f64::INFINITY } else { x.abs() };
    values.into_iter().map(size).fold(0.0, f64::max)
}
