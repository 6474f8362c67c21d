//! Formulas that are too long to read beside a method.

use super::calls::{PENDULUM, assert_has, data, file, folder, output};

/// Generated code that leaves a formula out names the command that prints it, and the command does.
#[test]
fn the_command_prints_what_documentation_leaves_out() {
    let arm = data("robots/elbow_3r.json");
    let out = folder("formulas");
    let functions = "--functions inverse_dynamics";
    for (language, file) in [("c", "elbow_3r.h"), ("rust", "elbow_3r.rs")] {
        let to = out.to_string_lossy();
        output(format!(
            "generate {arm} --lang {language} --out {to} {functions}"
        ));
        let code = std::fs::read_to_string(out.join(file)).expect("a file");
        let hint = code.lines().find(|line| line.contains("tau1: too long: "));
        let hint = hint.unwrap_or_else(|| panic!("{language}"));
        assert!(hint.ends_with(" terms; `robot-dynamics show`"), "{hint}");
    }
    let whole = |text: &str| {
        let formula = text.lines().find(|line| line.contains("tau1 = "));
        formula.is_some_and(|formula| formula.len() > 400)
    };
    let shown = output(format!("show {arm} {functions}"));
    assert!(whole(&shown) && !shown.contains("too long"), "{shown}");
    let text = "--format text";
    let shown = output(format!("show {arm} {functions} {text}"));
    assert!(whole(&shown), "{shown}");
    // And says how many terms it was asked for where they are not enough.
    let few = "--terms 300 --format text";
    let shown = output(format!("show {arm} {functions} {few}"));
    assert!(whole(&shown), "{shown}");
    let few = "--terms 20";
    let shown = output(format!("show {arm} {functions} {few}"));
    assert!(
        shown.ends_with("a larger `--terms` prints them\n"),
        "{shown}"
    );
}

/// A wrist with skew axes: one sentence says that its formulas are too long, after a bounded amount of work.
#[test]
fn one_sentence_for_all_long_formulas() {
    let wrist = data("files/skew_wrist.urdf");
    let shown = output(format!("show {wrist} --chain base,l3 --gravity 0,0,-9.81"));
    let sentences: Vec<&str> = shown
        .lines()
        .filter(|line| line.contains("--terms"))
        .collect();
    let expected = "not printed, because of more than 1000 terms: ";
    assert!(
        sentences.len() == 1 && sentences[0].starts_with(expected),
        "{shown}"
    );
    let names = [
        "M11, M12, ",
        "V1, V2, V3",
        "G1, G2, G3",
        "tau1, tau2, tau3",
        "T, U",
    ];
    assert!(
        names.iter().all(|name| sentences[0].contains(name)),
        "{shown}"
    );
    assert!(shown.contains("\n    M33 = "), "{shown}");
}

/// A function that has no formulas says so.
#[test]
fn functions_without_formulas() {
    let arm = data("robots/elbow_3r.json");
    let functions = ["forward_dynamics", "regressor", "gravity_vector"];
    for format in ["text", "latex", "mathml"] {
        let call = [
            "show",
            &arm,
            "--format",
            format,
            "--functions",
            &functions.join(","),
        ];
        let shown = output(&call);
        let sections: Vec<&str> = shown.split("\n\n").collect();
        assert!(
            sections[0].starts_with("forward_dynamics\nno formulas: it solves"),
            "{shown}"
        );
        assert!(
            sections[1].starts_with("regressor\nno formulas: "),
            "{shown}"
        );
        assert!(!sections[2].contains("no formulas"), "{shown}");
    }
}

/// Functions as JSON: operations, and bounds of rounding where joints have limits.
#[test]
fn functions_are_printed_as_json() {
    let limited = PENDULUM.replace(
        "type = \"revolute\"",
        "type = \"revolute\"\nlimits = [-1, 1]",
    );
    for (table, is_bounded) in [(PENDULUM, false), (&limited, true)] {
        let table = file(&format!("json_{is_bounded}.toml"), table);
        let json = output(format!(
            "show {table} --functions gravity_vector --format json"
        ));
        assert_has(
            &json,
            [
                "\"name\": \"gravity_vector\"",
                "\"multiplications\": ",
                "\"joints\": [",
            ],
        );
        let none = "\"rounding\": {\"double\": null, \"single\": null}";
        assert_eq!(json.contains(none), !is_bounded, "{json}");
        if is_bounded {
            let call = format!("show {table} --functions forward_dynamics --format json --bounds ");
            let bound = |more: &str| {
                let json = output(call.replace("--bounds ", more));
                let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
                json["functions"][0]["rounding"]["double"].as_f64()
            };
            let [whole, tight] = ["", "--bounds tight"].map(bound);
            assert!(tight.expect("a bound") < whole.unwrap_or(f64::INFINITY));
        }
    }
}
