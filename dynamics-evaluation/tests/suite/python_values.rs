//! The values that the tests of the Python package compare with, bit for bit: they are those of Rust.

use std::fmt::Write as _;
use std::path::Path;

use dynamics_evaluation::{ReadOptions, RuntimeRobot};

/// Files of robots, each with its field.
const FILES: [&str; 2] = ["everything.toml", "torso.toml"];

/// The value of the field `load`, kg.
const LOAD: f64 = 0.3;

fn numbers(values: &[f64]) -> String {
    let values: Vec<_> = values.iter().map(|x| format!("{x:?}")).collect();
    format!("[{}]", values.join(", "))
}

/// The arguments of the state of that number.
fn argument(state: usize, place: usize, entries: usize) -> Vec<f64> {
    let phase = |i: usize| (1 + 7 * i + 31 * place + 101 * state) as f64;
    (0..entries).map(|i| 1.5 * (0.7 * phase(i)).sin()).collect()
}

/// A line for each function of a file at each of three states.
fn lines(file: &str) -> String {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/files");
    let options = ReadOptions::new().fields(["load"]);
    let mut arm = RuntimeRobot::from_file(data.join(file), &options).unwrap();
    arm.set_field("load", LOAD).unwrap();
    let mut lines = String::new();
    for name in arm.function_names() {
        for state in 0..3 {
            let widths = arm.arguments(name).unwrap().enumerate();
            let arguments = widths.map(|(place, (_, entries))| argument(state, place, entries));
            let arguments: Vec<Vec<f64>> = arguments.collect();
            let slices: Vec<&[f64]> = arguments.iter().map(Vec::as_slice).collect();
            let mut value = vec![0.0; arm.entries(name).unwrap()];
            arm.evaluate_by_rows(name, &slices, &mut value).unwrap();
            let arguments: Vec<_> = slices.iter().map(|entries| numbers(entries)).collect();
            let _ = writeln!(
                lines,
                r#"["{file}", "{name}", [{}], {}],"#,
                arguments.join(", "),
                numbers(&value)
            );
        }
    }
    lines
}

/// Where sums of products are fused the digits are others. `UPDATE_EXPECT=1 cargo test` writes the file.
#[test]
fn values_of_the_python_tests_are_those_of_rust() {
    if cfg!(target_feature = "fma") {
        return;
    }
    let lines: String = FILES.into_iter().map(lines).collect();
    let text = format!("[\n{}\n]\n", lines.trim_end().trim_end_matches(','));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../dynamics-python/tests/values.json");
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    assert_eq!(std::fs::read_to_string(path).unwrap(), text);
}
