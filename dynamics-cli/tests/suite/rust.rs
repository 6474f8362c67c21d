//! The macro's expansion, as a file.

use std::path::Path;

use super::calls::{PENDULUM, file, folder, output};

/// The files that `tests/files` compiles, and compares with the macro.
const GOLDEN: &str = "../tests/files/generated";

/// Generates the Rust of a table, and compares it with the file that is compiled.
#[track_caller]
fn assert_compiled(name: &str, table: &str, functions: &str) {
    let table = file(&format!("{name}.toml"), table);
    let out = folder("rust");
    let to = out.to_string_lossy();
    let call = format!("generate {table} --lang rust --out {to}");
    let text = output(format!("{call} --functions {functions}"));
    let file = format!("{name}.rs");
    assert!(text.trim_end().ends_with(&file), "{text}");
    let generated = std::fs::read_to_string(out.join(&file)).expect("a file");
    let golden = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join(GOLDEN)
        .join(&file);
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(&golden, &generated).expect("a file");
    }
    let expected = std::fs::read_to_string(&golden).expect("the file that is compiled");
    assert_eq!(generated, expected, "UPDATE_EXPECT=1 writes {file} anew");
}

#[test]
fn generated_rust_is_the_file_that_is_compiled() {
    assert_compiled("two_rods", PENDULUM, "default,taylor_series");
}

/// Names in the cells are the fields of the struct.
#[test]
fn generated_rust_has_fields() {
    assert_compiled(
        "named_rods",
        super::fields::NAMES,
        "mass_matrix,gravity_vector",
    );
}
