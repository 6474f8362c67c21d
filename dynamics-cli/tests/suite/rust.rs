//! What the macro expands to, as a file.

use std::path::Path;

use super::calls::{PENDULUM, file, folder, output};

/// The file that `tests/files` compiles, and compares with the macro.
const GOLDEN: &str = "../tests/files/generated/two_rods.rs";

#[test]
fn generated_rust_is_the_file_that_is_compiled() {
    let pendulum = file("two_rods.toml", PENDULUM);
    let out = folder("rust");
    let text = output(&[
        "generate",
        &pendulum,
        "--lang",
        "rust",
        "--out",
        &out.to_string_lossy(),
    ]);
    assert!(text.trim_end().ends_with("two_rods.rs"), "{text}");
    let generated = std::fs::read_to_string(out.join("two_rods.rs")).expect("a file");
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join(GOLDEN);
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(&golden, &generated).expect("a file");
    }
    let expected = std::fs::read_to_string(&golden).expect("the file that is compiled");
    assert_eq!(generated, expected, "UPDATE_EXPECT=1 writes {GOLDEN} anew");
}
