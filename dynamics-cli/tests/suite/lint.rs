//! The subcommand `lint`: rules, their page, and files that break none.

use std::path::Path;

use dynamics_codegen::lint::RULES;
use serde_json::Value;

use super::calls::{PENDULUM, assert_has, data, errors, file, folder, run};

/// A line of the output.
#[derive(Debug)]
struct Row {
    rule: String,
    severity: String,
    line: u64,
    text: Value,
}

/// The rows of a call in JSON, whose exit status tells whether there is an error among them.
#[track_caller]
fn rows(files: &[&str]) -> Vec<Row> {
    let output = run(&[&["lint", "--format", "json"], files].concat());
    let (text, told) = (
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
    assert_eq!(told, "", "{files:?}");
    let list: Vec<Value> = serde_json::from_str(&text).expect("a list in JSON");
    let rows: Vec<Row> = list.into_iter().map(row).collect();
    let has_error = rows.iter().any(|row| row.severity == "error");
    assert_eq!(
        output.status.code(),
        Some(i32::from(has_error)),
        "{files:?}"
    );
    rows
}

fn row(text: Value) -> Row {
    let keys: Vec<&String> = text.as_object().expect("an object").keys().collect();
    assert_eq!(
        keys,
        [
            "column", "file", "line", "message", "remedy", "rule", "severity"
        ]
    );
    let word = |key: &str| text[key].as_str().expect("a text").to_owned();
    // The remedy of an error is a part of its message.
    let is_in_message = match text["remedy"].as_str() {
        Some(remedy) => word("message").ends_with(&format!(": {remedy}")),
        None => true,
    };
    assert_eq!(is_in_message, !is_of_files_alone(&word("rule")), "{text}");
    Row {
        rule: word("rule"),
        severity: word("severity"),
        line: text["line"].as_u64().expect("a line"),
        text,
    }
}

fn is_of_files_alone(rule: &str) -> bool {
    RULES.iter().any(|known| known.name == rule)
}

/// Severity, rule and line of each row of a file.
#[track_caller]
fn found(file: &str) -> Vec<(String, String, u64)> {
    rows(&[file])
        .into_iter()
        .map(|row| (row.severity, row.rule, row.line))
        .collect()
}

#[track_caller]
fn rules(file: &str) -> Vec<String> {
    rows(&[file]).into_iter().map(|row| row.rule).collect()
}

#[test]
fn each_defect_is_found_at_its_line() {
    type Expected<'e> = &'e [(&'e str, &'e str, u64)];
    let cases: [(&str, Expected); 12] = [
        ("tensor_of_no_body", &[("error", "urdf::no_body", 5)]),
        (
            "limits_reversed",
            &[("error", "joint::limits_of_a_file_swapped", 8)],
        ),
        ("follows_nobody", &[("error", "urdf::no_leader", 9)]),
        ("two_trees", &[("error", "urdf::several_trees", 8)]),
        ("effort_zero", &[("warning", "effort_zero", 8)]),
        (
            "no_mass_but_geometry",
            &[("warning", "no_mass_but_geometry", 7)],
        ),
        (
            "inertia_far_from_geometry",
            &[("warning", "inertia_far_from_geometry", 5)],
        ),
        (
            "mass_in_milligrams",
            &[
                ("warning", "mass_in_other_unit", 5),
                ("warning", "mass_in_other_unit", 7),
            ],
        ),
        (
            "axis_not_unit",
            &[
                ("warning", "axis_not_unit", 8),
                ("warning", "axis_not_unit", 9),
            ],
        ),
        (
            "nearly_quarter_turns",
            &[
                ("warning", "nearly_quarter_turns", 8),
                ("warning", "nearly_quarter_turns", 9),
            ],
        ),
        (
            "left_and_right_differ",
            &[("warning", "left_and_right_differ", 7)],
        ),
        ("centre_outside", &[("warning", "centre_outside", 5)]),
    ];
    for (name, expected) in cases {
        let path = format!("{}/tests/data/lint/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
        let expected: Vec<_> = expected
            .iter()
            .map(|(severity, rule, line)| ((*severity).to_owned(), (*rule).to_owned(), *line))
            .collect();
        assert_eq!(found(&path), expected, "{name}");
    }
}

/// The plausible unit is named: 2,000,000 kg are 2 kg in mg.
#[test]
fn plausible_numbers_are_named() {
    let of = |name: &str| format!("{}/tests/data/lint/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
    let remedies = |name: &str| {
        let rows = rows(&[&of(name)]);
        rows.iter()
            .map(|row| format!("{} {}", row.text["message"], row.text["remedy"]))
            .collect::<String>()
    };
    let mass = remedies("mass_in_milligrams");
    assert_has(&mass, ["2e6 mg are 2 kg", "1e6 mg are 1 kg"]);
    assert!(remedies("centre_outside").contains("a thousandth"));
    assert!(remedies("left_and_right_differ").contains("izz 0.04"));
    assert!(remedies("effort_zero").contains("effort and velocity"));
    assert!(remedies("nearly_quarter_turns").contains("-1.5708, 3.14"));
}

/// The page of the rules: tables with a row for each, and an example that breaks it.
fn page() -> String {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide/src/lint.md");
    std::fs::read_to_string(page).expect("the page")
}

/// The cells of the row about a rule: its weight, what breaks it, and limits.
fn row_of<'p>(page: &'p str, rule: &str) -> [&'p str; 3] {
    let start = format!("| [`{rule}`](#{}) | ", rule.replace("::", ""));
    let mut rows = page.lines().filter_map(|line| line.strip_prefix(&start));
    let row = rows.next().unwrap_or_else(|| panic!("{rule} has no row"));
    let cells: Vec<&str> = row
        .trim_end_matches('|')
        .split('|')
        .map(str::trim)
        .collect();
    cells.try_into().expect("three cells")
}

#[test]
fn the_page_has_each_rule_with_a_file_that_breaks_it() {
    let page = page();
    let mut told = Vec::new();
    for section in page.split("\n### ").skip(1) {
        let (rule, text) = section.split_once("\n\n```").expect("a heading");
        let [severity, about, limits] = row_of(&page, rule);
        let (opening, code) = text.split_once('\n').expect("a name");
        let (example, _) = code.split_once("```").expect("the end of the example");
        let (_, name) = opening.split_once(',').expect("a file");
        for row in rows(&[&file(name, example)]) {
            if row.rule == rule {
                assert_eq!(row.severity, severity, "{rule}");
                told.push(rule);
            } else {
                assert!(
                    limits.contains(&format!("`{}`", row.rule)),
                    "{name}: {row:?}"
                );
            }
        }
        assert!(
            told.ends_with(&[rule]),
            "{rule} is not broken by its example"
        );
        if let Some(known) = RULES.iter().find(|known| known.name == rule) {
            assert_eq!(known.severity.to_string(), severity, "{rule}");
            assert_eq!(known.about.trim(), format!("{about}."), "{rule}");
        }
    }
    for rule in RULES {
        assert!(told.contains(&rule.name), "{} has no example", rule.name);
    }
}

#[test]
fn the_line_on_the_page_is_one_of_the_output() {
    let picker = format!(
        "{}/../examples/robots/picker.urdf",
        env!("CARGO_MANIFEST_DIR")
    );
    let output = run(format!("lint {picker}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let page = page();
    let line = page
        .lines()
        .find(|line| line.starts_with("picker.urdf:"))
        .expect("a line");
    assert!(text.contains(line.trim_end_matches("...")), "{text}");
    assert!(
        text.ends_with("1 file: 0 errors, 2 warnings, 0 notes\n"),
        "{text}"
    );
}

/// The robots of the tests: what is told of them is true, and this is all of it. Tensors of no body apart, which are errors.
#[test]
fn robots_of_the_tests_break_few_rules() {
    let mut told = Vec::new();
    for folder in [
        "urdf",
        "urdf/trees",
        "files",
        "files/kinds",
        "files/trees",
        "robots",
    ] {
        let entries = std::fs::read_dir(data(folder)).expect("a folder");
        let paths = entries.map(|entry| entry.expect("an entry").path());
        let is_robot = |path: &std::path::PathBuf| {
            let ending = path.extension().and_then(|ending| ending.to_str());
            matches!(ending, Some("urdf" | "toml"))
                || (folder == "robots" && ending == Some("json"))
        };
        let mut paths: Vec<_> = paths.filter(is_robot).collect();
        paths.sort();
        assert!(!paths.is_empty(), "{folder}");
        for path in paths {
            let name = path
                .file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            for row in rows(&[&path.to_string_lossy()]) {
                let is_told =
                    |(file, rule, _): &(String, String, usize)| *file == name && *rule == row.rule;
                if row.severity == "note"
                    || row.rule == "urdf::no_body"
                    || row.rule == "nearly_quarter_turns"
                {
                    continue;
                }
                match told.iter_mut().find(|known| is_told(known)) {
                    Some((_, _, count)) => *count += 1,
                    None => told.push((name.clone(), row.rule, 1)),
                }
            }
        }
    }
    let expected = [
        // 0.2 kg as a point of 2 mm, denser than osmium.
        ("anymal-kinova", "inertia_far_from_uniform", 2),
        ("baxter", "inertia_far_from_uniform", 2),
        ("double_pendulum", "effort_zero", 2),
        ("finger_edu", "inertia_far_from_uniform", 1),
        // 1 kg m^2 for every body.
        ("simple_humanoid", "inertia_far_from_uniform", 12),
        ("tiago_no_hand", "inertia_far_from_uniform", 1),
        ("finger", "urdf::no_inertial", 1),
        ("noise_axis", "inertia_far_from_uniform", 2),
        ("skew_wrist", "axis_not_unit", 3),
    ];
    let expected: Vec<_> = expected
        .map(|(file, rule, count)| (file.to_owned(), rule.to_owned(), count))
        .into();
    assert_eq!(told, expected);
}

/// A URDF file of two links and a joint, with changes.
fn arm(changes: &[(&str, &str)]) -> String {
    let text = "<robot name=\"arm\">\n<link name=\"base\"/>\n<link name=\"arm\"><inertial><mass value=\"2\"/>\
                <inertia ixx=\"0.02\" iyy=\"0.02\" izz=\"0.02\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n\
                <joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/>\
                <origin xyz=\"0 0 0.3\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"5\" velocity=\"3\"/>\
                </joint>\n</robot>\n";
    changes.iter().fold(text.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    })
}

#[test]
fn files_of_nothing_and_of_anything_have_rows() {
    let cases = [
        ("hostile_empty.urdf", String::new(), &["file::syntax"][..]),
        (
            "hostile_empty.json",
            String::new(),
            &[
                "instead",
                "entry::missing_convention",
                "entry::missing_gravity",
                "entry::missing_joints",
            ],
        ),
        ("hostile.step", String::new(), &["file::unknown_format"]),
        (
            "hostile_mjcf.urdf",
            "<mujoco/>".to_owned(),
            &["urdf::no_robot"],
        ),
        (
            "hostile_sdf.urdf",
            "<sdf version=\"1.7\"/>".to_owned(),
            &["urdf::no_robot"],
        ),
        ("hostile_two.urdf", arm(&[]) + &arm(&[]), &["file::syntax"]),
        ("hostile_massless.urdf", arm(&[("inertial>", "x>")]), &[]),
        (
            "hostile_numbers.urdf",
            arm(&[
                ("value=\"2\"", "value=\"nan\""),
                ("ixx=\"0.02\"", "ixx=\"1e999\""),
                ("0 0 0.3", "inf 0 -1e400"),
            ]),
            &[
                "number::other_literal",
                "number::too_large",
                "number::other_literal",
            ],
        ),
        (
            "hostile_xacro.urdf",
            arm(&[(
                "</robot>",
                "<a:arm xmlns:a=\"http://ros.org/xacro\"/></robot>",
            )]),
            &["urdf::xacro"],
        ),
        (
            "hostile_names.urdf",
            arm(&[
                ("\"arm\"", "\"a&quot;\\\u{202e}: b\u{e9}\""),
                ("name=\"j\"", "name=\"\""),
            ]),
            &["name_of_no_other_tool", "name_of_no_other_tool"],
        ),
        (
            "hostile_control.urdf",
            arm(&[("\"arm\"", "\"a&#9;b\"")]),
            &["file::control_in_name", "name_of_no_other_tool"],
        ),
        (
            "hostile_ball.urdf",
            arm(&[("revolute", "planar")]),
            &["urdf::unsupported"],
        ),
        (
            "hostile_floating.urdf",
            arm(&[("revolute", "floating")]),
            &["moving_base"],
        ),
        (
            "hostile_fixed.urdf",
            arm(&[("revolute", "fixed")]),
            &["moving_base"],
        ),
        (
            "hostile_body.urdf",
            "<robot name=\"x\"><link name=\"a\"/></robot>".to_owned(),
            &["urdf::no_inertial"],
        ),
        (
            "hostile_fields.toml",
            PENDULUM
                .replace("mass = 2", "mass = \"m\"")
                .replace("a = 1", "a = \"l\""),
            &[],
        ),
        (
            "hostile_geometry.toml",
            PENDULUM.replace("mass", "#").replace("com", "#"),
            &[],
        ),
        (
            "hostile_named.toml",
            "file = \"hostile_massless.urdf\"\ngravity = [0, 0, -9.81]\n".to_owned(),
            &[],
        ),
        (
            "hostile_cells.toml",
            PENDULUM
                .replace("mass = 2", "mas = 2")
                .replace("a = 1", "a = true"),
            &["unknown", "instead"],
        ),
    ];
    for (name, text, expected) in cases {
        assert_eq!(rules(&file(name, text)), expected, "{name}");
    }
    for name in ["bytes.urdf", "bytes.toml"] {
        assert_eq!(
            rules(&file(name, [0x89, b'P', b'N', b'G', 0])),
            ["file::no_text"]
        );
    }
    let folder = folder("no_lint.urdf");
    assert_eq!(rules(&folder.to_string_lossy()), ["file::unreadable"]);
}

/// Names of a file and of files are shown, and act on no terminal.
#[test]
fn rows_are_text_of_one_line_each() {
    let odd = file(
        "lint \u{202e}\t\"x\".urdf",
        arm(&[("\"arm\"", "\"a\u{202e} b\"")]),
    );
    let good = file("lint_good.urdf", arm(&[]));
    let output = run(&["lint", &odd, &good]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines.len(), 2, "{text}");
    assert!(
        lines[0].contains(".urdf:3:1: warning: other tools refuse the link `a\u{fffd} b`: "),
        "{text}"
    );
    assert!(
        lines[0].contains(" [name_of_no_other_tool]: write letters"),
        "{text}"
    );
    assert!(!text.contains('\u{202e}'), "{text}");
    assert_eq!(lines[1], "2 files: 0 errors, 1 warning, 0 notes");
    assert_eq!(rows(&[&odd])[0].text["file"], odd.as_str());
    let output = run(format!("lint {good}"));
    assert_eq!(
        String::from_utf8_lossy(&output.stdout),
        "1 file: nothing found\n"
    );
    let output = run(format!("lint {good} --format json"));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "[]\n");
    assert!(errors(&["lint"], 2).contains("<FILE>..."));
    assert!(errors(format!("lint {good} --format xml"), 2).contains("possible values: text, json"));
}

/// Each rule has good files beside the ones that break it.
#[test]
fn what_is_meant_is_not_told() {
    let mimic = "</joint>\n<link name=\"tip\"><inertial><mass value=\"1\"/><inertia ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" \
                 ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n<joint name=\"k\" type=\"revolute\">\
                 <parent link=\"arm\"/><child link=\"tip\"/><mimic joint=\"j\"/><limit effort=\"0\" velocity=\"0\"/></joint>";
    let mesh = "<visual><geometry><mesh filename=\"a.stl\"/></geometry></visual><inertial>";
    for (name, changes) in [
        // A follower has no drive, and points have no tensors.
        ("meant_follower.urdf", &[("</joint>", mimic)][..]),
        ("meant_point.urdf", &[("\"0.02\"", "\"0\"")]),
        ("meant_mesh.urdf", &[("<inertial>", mesh)]),
        // An axis of 0.7071 and a calibrated angle.
        (
            "meant_axis.urdf",
            &[
                ("<axis xyz=\"0 0 1\"", "<axis xyz=\"0.7071 0 0.7071\""),
                ("0.3\"", "0.3\" rpy=\"1.5683 0 0\""),
            ],
        ),
    ] {
        assert_eq!(rules(&file(name, arm(changes))), [""; 0], "{name}");
    }
    let table = |text: &str| rules(&file("meant.toml", text));
    let upwards = PENDULUM.replace("[\"9.81\", 0, 0]", "[0, 9.81, 0]");
    assert_eq!(table(&upwards), ["falls_upwards"]);
    assert_eq!(
        table(&upwards.replace("convention", "allow = [\"odd_gravity\"]\nconvention")),
        [""; 0]
    );
    assert_eq!(
        table(&upwards.replace("a = 1", "a = 1\nalpha = 1")),
        [""; 0]
    );
    // The centre of a tool, and one that is meant.
    let far = PENDULUM.replace("com = [0.25, 0, 0]", "com = [5, 0, 0]");
    assert_eq!(table(&far), ["centre_outside"]);
    assert_eq!(
        table(&far.replace("a = 1", "a = 1\nallow = [\"odd_com\"]")),
        [""; 0]
    );
}

/// The hook's lines name a call of the command.
#[test]
fn the_hook_calls_the_command() {
    let hook = Path::new(env!("CARGO_MANIFEST_DIR")).join("../.pre-commit-hooks.yaml");
    let hook = std::fs::read_to_string(hook).expect("the hook");
    for line in [
        "- id: robot-dynamics-lint",
        "  entry: robot-dynamics lint",
        "  language: system",
        "  files: \\.urdf$",
    ] {
        assert!(hook.lines().any(|known| known == line), "{line}");
    }
}

/// A remedy stands behind the colon of an error, whatever the names of a file are.
#[test]
fn remedies_of_errors_are_told() {
    let remedy = |text: String| {
        let rows = rows(&[&file("remedy.toml", text)]);
        rows[0].text["remedy"].clone()
    };
    let misspelled = PENDULUM.replace("mass = 2", "mas = 2");
    assert_eq!(remedy(misspelled), "did you mean `mass`?");
    let named = PENDULUM.replace("mass = 2", "\"a: b\" = 2");
    let told = remedy(named);
    let starts = |told: &str| told.starts_with("expected `a`, `alpha`");
    assert!(told.as_str().is_some_and(starts), "{told}");
}
