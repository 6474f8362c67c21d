//! The files of `tests/data`.

use serde::de::DeserializeOwned;

/// Reads one file of `tests/data`.
///
/// # Panics
///
/// Where there is no such file, or something else in it.
pub fn read<T: DeserializeOwned>(folder: &str, name: &str) -> T {
    let path = format!(
        "{}/../tests/data/{folder}/{name}.json",
        env!("CARGO_MANIFEST_DIR")
    );
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"))
}
