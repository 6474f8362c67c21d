//! Makes one program of each chapter: the Rust code that a reader sees in it, in order, as the body of a `main`.
//! `lib.rs` has these programs as tests of documentation.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    println!("cargo::rerun-if-changed=src");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo names a folder"));
    let mut modules = String::new();
    for chapter in chapters() {
        let text = fs::read_to_string(&chapter).expect("a chapter");
        let file = out.join(chapter.file_name().expect("a file"));
        let name = chapter.file_stem().expect("a file").display();
        if let Some(program) = program(&text, &chapter) {
            fs::write(&file, program).expect("the folder of the build");
            let _ = writeln!(modules, "#[doc = include_str!({file:?})]\nmod {name} {{}}");
        }
    }
    fs::write(out.join("chapters.rs"), modules).expect("the folder of the build");
}

fn chapters() -> Vec<PathBuf> {
    let entries = fs::read_dir("src").expect("the chapters");
    let paths = entries.map(|entry| entry.expect("a chapter").path());
    let mut paths: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "md"))
        .collect();
    paths.sort();
    paths
}

/// The Rust code of a chapter as one block, each line where it stands in the chapter; none without such code.
fn program(text: &str, chapter: &Path) -> Option<String> {
    let mut lines = Vec::new();
    let mut language = None;
    for (number, line) in (1..).zip(text.lines()) {
        let place = || format!("{}:{number}", chapter.display());
        let fence = line.strip_prefix("```");
        let is_code = language == Some("rust") && fence.is_none();
        assert!(
            !(is_code && (line == "#" || line.starts_with("# "))),
            "{}: a reader does not see this line",
            place()
        );
        lines.push(if is_code { line } else { "" });
        language = match (language, fence) {
            (None, Some(opened)) => Some(opened),
            (Some(_), Some(_)) => None,
            (language, None) => language,
        };
        let is_left_out = language
            .is_some_and(|language| language.starts_with("rust,") && language != "rust,ignore");
        assert!(!is_left_out, "{}: only `rust` is compiled", place());
    }
    let first = lines.iter().position(|line| !line.is_empty())?;
    // Two lines above the first of the program: the opening fence of its block, and what stands before it.
    let opening = first
        .checked_sub(2)
        .expect("a chapter begins with a heading");
    lines[opening] = "```rust";
    let code = if lines.iter().any(|line| line.starts_with("fn main()")) {
        lines.join("\n")
    } else {
        lines[opening + 1] = "fn main() -> Result<(), Box<dyn std::error::Error>> {";
        lines.join("\n") + "\nOk(())\n}"
    };
    // The robot of the examples, which the reader has copied.
    Some(code.replace("\"picker.urdf\"", "\"../../examples/robots/picker.urdf\"") + "\n```\n")
}
