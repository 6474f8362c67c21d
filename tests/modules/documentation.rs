//! Documentation for users names the crate that they have.

use std::fs;
use std::path::Path;

/// The crates behind the facade, by the names that Rust code has for them.
const BEHIND: [&str; 10] = [
    "dynamics_functions",
    "dynamics_runtime",
    "dynamics_numeric",
    "dynamics_simulation",
    "dynamics_evaluation",
    "dynamics_symbolic",
    "dynamics_codegen",
    "dynamics_export",
    "dynamics_items",
    "dynamics_macros",
];

/// The lines of examples that a page shows, with the file and the number of each.
fn shown_lines(folder: &Path, shown: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            shown_lines(&path, shown);
            continue;
        }
        let text = fs::read_to_string(&path).expect("a text");
        let is_page = path.extension().is_some_and(|extension| extension == "md");
        let mut is_code = false;
        for (k, line) in text.lines().enumerate() {
            let line = line.trim_start();
            let comment = line.strip_prefix("///").or(line.strip_prefix("//!"));
            let Some(line) = comment.or(is_page.then_some(line)) else {
                is_code |= line.contains("doc = \"```");
                continue;
            };
            let line = line.trim();
            if line.starts_with("```") {
                is_code = !is_code;
            } else if is_code && line != "#" && !line.starts_with("# ") {
                let place = format!("{}:{}", path.display(), k + 1);
                shown.push((place, line.to_owned()));
            }
        }
    }
}

/// Whether a line names a crate that users do not have.
fn names_one_behind(line: &str) -> bool {
    BEHIND.iter().any(|name| line.contains(name))
}

#[test]
fn examples_name_the_facade() {
    let mut shown = Vec::new();
    for name in [
        "dynamics-runtime",
        "dynamics-numeric",
        "dynamics-simulation",
        "dynamics-evaluation",
    ] {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        shown_lines(&root.join(name).join("src"), &mut shown);
    }
    let facade = |line: &&(String, String)| line.1.starts_with("use robot_dynamics::");
    assert!(shown.iter().filter(facade).count() > 25);
    let wrong = shown.iter().filter(|(_, line)| names_one_behind(line));
    let wrong: Vec<_> = wrong
        .map(|(place, line)| format!("{place}: {line}"))
        .collect();
    assert!(
        wrong.is_empty(),
        "say `robot_dynamics`:\n{}",
        wrong.join("\n")
    );
}

#[test]
fn other_names_are_found() {
    assert!(names_one_behind("use dynamics_runtime::Scalar;"));
    assert!(names_one_behind(
        "# Ok::<(), dynamics_evaluation::FileError>(())"
    ));
    assert!(!names_one_behind(
        "use robot_dynamics::evaluation::RuntimeRobot;"
    ));
}
