//! The compiler's output for mistakes in a call of the macro. It shows each error at the token that is wrong, in the
//! tokens of another macro too. Nothing else in the file is an error: the methods that `main` calls still exist.
//!
//! The mistakes themselves, nearly all of them, are tests of `dynamics-codegen` (`tests/mistakes`), which need no
//! compiler. The compiler is called here with the library that this test is built with. `trybuild` would build it and
//! all of its dependencies once more, a minute of processor time, and expand each case by an engine that is not
//! optimised.

mod accepted;
mod rebuild;

use std::fs::DirEntry;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use expect_test::expect_file;

/// The compiler whose way of showing errors the `.stderr` files hold.
const WRITTEN_FOR: &str = "rustc 1.95.";

/// The folder of the cases, in that of the workspace.
const CASES: &str = "tests/compile-fail/cases";

#[test]
fn the_compiler_shows_mistakes_where_they_are() {
    let version = rustc().arg("--version").output().expect("a compiler");
    let compiler = text(&version.stdout);
    if !compiler.starts_with(WRITTEN_FOR) {
        println!("skipped: {compiler} shows errors in its own way, not in that of {WRITTEN_FOR}*");
        return;
    }
    let library = &*LIBRARY;
    let cases = files(&workspace().join(CASES), "", ".rs");
    assert!(cases.len() >= 6, "{cases:?}");
    // Each in a thread, whose panic is the test's.
    std::thread::scope(|scope| {
        for case in &cases {
            scope.spawn(|| {
                let shown = compiled(case, library);
                assert!(!shown.status.success(), "{} compiles", case.display());
                let expected = case.with_extension("stderr");
                expect_file![expected].assert_eq(&normalized(&text(&shown.stderr)));
            });
        }
    });
}

fn workspace() -> &'static Path {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).expect("the workspace's folder")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn rustc() -> Command {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    Command::new(rustc)
}

/// A file as the compiler reads it that `cargo check` calls.
fn compiled(file: &Path, library: &Path) -> Output {
    rustc()
        .current_dir(workspace())
        .args(["--edition=2024", "--crate-type=bin", "--emit=metadata"])
        .args(["--color=never", "--diagnostic-width=140"])
        .args(["--out-dir", env!("CARGO_TARGET_TMPDIR")])
        .args(library_flags(library))
        .arg(file.strip_prefix(workspace()).unwrap_or(file))
        .output()
        .expect("a compiler")
}

/// Tells the compiler where the library is, and what it depends on.
fn library_flags(library: &Path) -> [String; 4] {
    let name = |path: &Path| path.to_string_lossy().into_owned();
    let folder = library.parent().expect("the folder of all libraries");
    [
        "-L".to_owned(),
        format!("dependency={}", name(folder)),
        "--extern".to_owned(),
        format!("robot_dynamics={}", name(library)),
    ]
}

/// The library in the folder of this test's program. There is one for each selection of features that was
/// ever built: the newest is as new as the sources, and it can be used if what it depends on was not built
/// anew without it.
///
/// Found once: the tests, which run side by side, would write the file that is compiled over each other's.
static LIBRARY: LazyLock<PathBuf> = LazyLock::new(|| {
    let program = std::env::current_exe().expect("the test's program");
    let folder = program.parent().expect("the folder of all libraries");
    let mut libraries = files(folder, "librobot_dynamics-", ".rlib");
    libraries.sort_by_key(|path| path.metadata().and_then(|data| data.modified()).ok());
    let empty = Path::new(env!("CARGO_TARGET_TMPDIR")).join("empty.rs");
    std::fs::write(&empty, "use robot_dynamics as _;\nfn main() {}\n").expect("a file");
    let is_usable = |library: &PathBuf| compiled(&empty, library).status.success();
    let library = libraries.into_iter().rev().find(is_usable);
    library.expect("the library that this test is built with")
});

/// The files of a folder with names that begin and end so, sorted.
fn files(folder: &Path, start: &str, end: &str) -> Vec<PathBuf> {
    let is_one = |entry: &DirEntry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        name.starts_with(start) && name.ends_with(end)
    };
    let entries = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry"));
    let mut files: Vec<_> = entries.filter(is_one).map(|entry| entry.path()).collect();
    files.sort();
    files
}

/// The errors as they are shown, without what other files and other crates change.
fn normalized(shown: &str) -> String {
    let errors: Vec<_> = shown.split("\n\n").map(without_numbers).collect();
    errors.join("\n\n").trim_end().to_owned() + "\n"
}

/// One error. `LL` stands for the number of a line at the margin, whose width depends on the largest one.
fn without_numbers(error: &str) -> String {
    let margin = error.lines().find_map(|line| line.find("--> "));
    let line = |line: &str| {
        let Some((number, rest)) = margin.and_then(|margin| line.split_at_checked(margin)) else {
            return line.to_owned();
        };
        match number.trim() {
            "" => format!("  {rest}"),
            digits if digits.bytes().all(|byte| byte.is_ascii_digit()) => format!("LL{rest}"),
            _ => line.to_owned(),
        }
    };
    let lines: Vec<_> = told(error).into_iter().map(line).collect();
    lines.join("\n")
}

/// The lines up to the first help of the compiler's, and what this project adds behind it: in its help the
/// compiler lists what is elsewhere, which depends on the features that the workspace is built with.
fn told(error: &str) -> Vec<&str> {
    let is_help = |line: &str| line.starts_with("help: ") || line.starts_with("note: ");
    let first_help = error.lines().position(is_help).unwrap_or(usize::MAX);
    let is_of_features = |line: &str| {
        [
            "candidate #",
            "= note: this error originates",
            "= note: required",
        ]
        .iter()
        .any(|start| line.trim_start().starts_with(start))
    };
    let is_told = |(number, line): &(usize, &str)| {
        let is_added = line.trim_start().starts_with("= note: ");
        (*number < first_help || is_added) && !is_of_features(line)
    };
    let lines = error.lines().enumerate().filter(is_told);
    lines.map(|(_, line)| line).collect()
}
