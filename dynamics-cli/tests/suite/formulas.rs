//! Formulas that are too long to read beside a method.

use super::calls::{data, folder, output};

/// What generated code leaves out names the command that prints it, and the command does.
#[test]
fn the_command_prints_what_documentation_leaves_out() {
    let arm = data("robots/elbow_3r.json");
    let out = folder("formulas");
    let functions = ["--functions", "inverse_dynamics"];
    for (language, file) in [("c", "elbow_3r.h"), ("rust", "elbow_3r.rs")] {
        let call = [
            "generate",
            &arm,
            "--lang",
            language,
            "--out",
            &out.to_string_lossy(),
        ];
        output(&[&call[..], &functions[..]].concat());
        let code = std::fs::read_to_string(out.join(file)).expect("a file");
        let hint = code.lines().find(|line| line.contains("tau1: too long: "));
        let hint = hint.unwrap_or_else(|| panic!("{language}"));
        assert!(hint.ends_with(" terms; `robot-dynamics show`"), "{hint}");
    }
    let whole = |text: &str| {
        let formula = text.lines().find(|line| line.contains("tau1 = "));
        formula.is_some_and(|formula| formula.len() > 400)
    };
    let shown = output(&[&["show", &arm][..], &functions[..]].concat());
    assert!(whole(&shown) && !shown.contains("too long"), "{shown}");
    let text = ["--format", "text"];
    let shown = output(&[&["show", &arm][..], &functions[..], &text[..]].concat());
    assert!(whole(&shown), "{shown}");
    // And says how many terms it was asked for where they are not enough.
    let few = ["--terms", "300", "--format", "text"];
    let shown = output(&[&["show", &arm][..], &functions[..], &few[..]].concat());
    assert!(whole(&shown), "{shown}");
    let few = ["--terms", "20"];
    let shown = output(&[&["show", &arm][..], &functions[..], &few[..]].concat());
    assert!(
        shown.contains("terms: a larger `--terms` prints them"),
        "{shown}"
    );
}
