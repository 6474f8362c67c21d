//! Names in the cells of a file that nothing binds.

use super::calls::{assert_has, errors, file, folder, output, refused};

/// Two rods whose lengths and masses are names, the second one's mass a sum, on a planet of any gravity.
pub(super) const NAMES: &str = r#"
convention = "standard"
gravity = [0, "-g", 0]

[let]
half = 0.5

[[joint]]
name = "shoulder"
type = "revolute"
a = "l1"
mass = "m1"

[[joint]]
name = "elbow"
type = "revolute"
a = "half * l2"
mass = "m2 + load"
"#;

/// The options that give the names their values.
const VALUES: &str =
    "--field g=9.81 --field l1=1/2 --field m1=2 --field l2=0.8 --field m2=1 --field load=3";

/// The same robot in numbers.
fn in_numbers() -> String {
    let numbers = [
        ("-g", "-9.81"),
        ("l1", "0.5"),
        ("m1", "2"),
        ("half * l2", "0.4"),
        ("m2 + load", "4"),
    ];
    numbers
        .into_iter()
        .fold(NAMES.to_owned(), |text, (name, number)| {
            text.replace(&format!("\"{name}\""), number)
        })
}

/// The names stand first, in the table as they are written, and in formulas.
#[test]
fn names_are_shown() {
    let names = file("names.toml", NAMES);
    let asked = "--functions mass_matrix,gravity_vector";
    let text = output(format!("show {names} {asked}"));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[..3],
        [
            "names: 2 joints that move, standard convention, gravity [0, -g, 0] m/s^2",
            "",
            "fields: g, l1, m1, l2, m2, load"
        ]
    );
    for line in [
        "shoulder  revolute           l1         0         0         0        m1  [0, 0, 0]",
        "M22 = 1/4 l2^2 (m2 + load)",
    ] {
        assert!(
            lines.iter().any(|shown| shown.trim() == line),
            "{line}: {text}"
        );
    }
    let latex = output(format!("show {names} --format latex {asked}"));
    assert!(latex.contains("l_{1}") || latex.contains("l_1"), "{latex}");
}

/// A name with a value is a number everywhere, and the others stay names.
#[test]
fn values_are_folded() {
    let names = file("folded.toml", NAMES);
    let numbers = file("in_numbers.toml", in_numbers());
    let alone = "--functions mass_matrix --format text";
    let some = output(format!("show {names} --field l2=2 {alone}"));
    assert!(some.contains("M22 = m2 + load\n"), "{some}");
    let all = output(format!("show {names} {alone} {VALUES}"));
    assert_eq!(all, output(format!("show {numbers} {alone}")));
    for language in ["c", "rust", "js", "python"] {
        let written = |path: &str, to: &str, fields: &str| {
            let out = folder(to);
            let to = out.to_string_lossy();
            let call = format!("generate {path} --name folded --lang {language} --out {to}");
            let files = output(format!("{call} {fields}"));
            let texts = files
                .lines()
                .map(|file| std::fs::read_to_string(file).expect("a file"));
            texts
                .collect::<String>()
                .replace("in_numbers.toml", "folded.toml")
        };
        assert_eq!(
            written(&names, "folded_names", VALUES),
            written(&numbers, "folded_numbers", ""),
            "{language}"
        );
    }
}

/// Text in each language has the names as one argument.
#[test]
fn names_are_arguments_in_every_language() {
    let names = file("arguments.toml", NAMES);
    let out = folder("arguments");
    let to = out.to_string_lossy();
    for (language, file, texts) in [
        (
            "c",
            "arguments.h",
            [
                "typedef struct {\n    double g;\n    double l1;\n    double m1;\n    double l2;\n    double m2;\n    \
                 double load;\n} arguments_fields;",
                "arguments_gravity_vector(const arguments_fields *arm, const double q[2],",
            ],
        ),
        (
            "js",
            "arguments.mjs",
            [
                "FIELD_NAMES = [\"g\", \"l1\", \"m1\", \"l2\", \"m2\", \"load\"]",
                "export function gravity_vector(arm, q)",
            ],
        ),
        (
            "python",
            "arguments.py",
            [
                "FIELD_NAMES = [\"g\", \"l1\",",
                "def gravity_vector(arm, q, xp=numpy):",
            ],
        ),
        (
            "matlab",
            "gravity_vector.m",
            [
                "function value = gravity_vector(arm, q)",
                "`arm`: a struct of the symbolic parameters g, l1,",
            ],
        ),
        (
            "casadi",
            "arguments_casadi.c",
            [
                "The input `arm` has the symbolic parameters, in this order: g, l1, m1, l2, m2, load.",
                "(arm[6], q[2]) -> (gravity_vector[2])",
            ],
        ),
        (
            "rust",
            "arguments.rs",
            [
                "pub struct Arguments {",
                "pub load: ::core::primitive::f64,",
            ],
        ),
    ] {
        output(format!("generate {names} --lang {language} --out {to}"));
        let written = std::fs::read_to_string(out.join(file)).expect("a file");
        for text in texts {
            assert!(written.contains(text), "{text}: {written}");
        }
    }
}

/// Commands that evaluate at the user's numbers ask for each name once.
#[test]
fn numbers_are_asked_for() {
    let names = file("asked.toml", NAMES.replace("m2 + load", "m2 + m1"));
    for call in [
        format!("evaluate {names}"),
        format!("simulate {names}"),
        format!("inverse-dynamics {names} --to 1,1"),
        format!("measure {names}"),
        format!("page {names}"),
        format!("convert {names}"),
    ] {
        let message = errors(&call, 1);
        let asked: Vec<&str> = message.matches("unknown name `").collect();
        assert_eq!(asked.len(), 5, "{call:?}: {message}");
        assert_has(&message, ["unknown name `m1`: `--field m1=2`"]);
    }
    let all = file("all.toml", NAMES);
    output(format!("check {all} --samples 5 {VALUES}"));
}

/// Names without a value are numbers of the check's own, the same in each run, and are listed.
#[test]
fn a_table_of_names_is_checked() {
    let path = file("own_numbers.toml", NAMES);
    let check = format!("check {path} --samples 5 --field g=9.81");
    let text = output(&check);
    assert!(
        text.starts_with("fields without a value, which are checked with these numbers (`--field l1=2` gives another): l1 = "),
        "{text}"
    );
    assert!(
        text.contains(", load = ") && !text.contains("g = "),
        "{text}"
    );
    assert!(
        text.contains("\ninverse_dynamics") && !text.contains("WRONG"),
        "{text}"
    );
    assert_eq!(output(&check), text);
    // A name of which no number makes a body: the sign is wrong.
    let negative = file("negative.toml", NAMES.replace("\"m1\"", "\"-m1 - 9\""));
    refused(
        format!("check {negative} --samples 5"),
        1,
        ["the mass matrix is not positive definite"],
    );
}

/// A list in the file is closed: another name in a cell is a mistake at its place, and so is one that no cell uses.
#[test]
fn a_list_of_fields_is_closed() {
    let list = r#"fields = ["l1", "l2", "m1", "m2", "g", "load"]"#;
    let closed = |name: &str, text: String| file(name, format!("{list}{text}"));
    let path = closed("closed.toml", NAMES.to_owned());
    let shown = output(format!("show {path} --functions mass_matrix"));
    assert_has(&shown, ["fields: l1, l2, m1, m2, g, load\n"]);
    let shown = output(format!(
        "show {path} --field g=1 --functions mass_matrix --allow odd_gravity"
    ));
    assert!(shown.contains("fields: l1, l2, m1, m2, load\n"), "{shown}");
    output(format!("check {path} --samples 5 {VALUES}"));
    let message = errors(format!("simulate {path} --field g=9.81"), 1);
    assert_has(
        &message,
        [
            "fields have no value: `l1`, `l2`, `m1`, `m2`, `load`. This command needs numbers",
            "--field l1=2 --field l2=2",
        ],
    );
    for (wrong, right, expected) in [
        (
            "m2 + laod",
            "m2 + load",
            "wrong.toml:18:8: unknown name `laod`: did you mean `load`?",
        ),
        (
            "m2 + tray",
            "m2 + load",
            "unknown name `tray`: `fields` of the file does not list it",
        ),
        ("m2", "m2 + load", "`load`"),
    ] {
        let path = closed("wrong.toml", NAMES.replace(right, wrong));
        for call in [format!("show {path}"), format!("check {path}")] {
            refused(&call, 1, [expected]);
        }
    }
    let path = file("no_list.toml", format!("fields = 3{NAMES}"));
    refused(format!("show {path}"), 1, ["an array of names"]);
}

/// Names that were meant otherwise are told, and none of them becomes a field.
#[test]
fn other_names_are_no_fields() {
    for (name, expected) in [
        ("pi", "PI"),
        ("inf", "every number of a table is finite"),
        ("FRAC_PI_2", "PI/2"),
    ] {
        let path = file(
            "meant.toml",
            NAMES.replace("\"m1\"", &format!("\"{name}\"")),
        );
        refused(format!("show {path}"), 1, [&format!("`{name}`"), expected]);
    }
    let below = NAMES.replace("half = 0.5", "half = \"2 * third\"\nthird = 0.25");
    refused(
        &["show", &file("below.toml", below)],
        1,
        ["bound further down"],
    );
}

/// The page shows the names in the table, with a slider for each.
#[test]
fn names_are_on_the_page() {
    let names = file("paged.toml", NAMES);
    let page = output(format!("page {names} {VALUES}"));
    for text in ["arm.load", "m2 + load", "0.5 l2"] {
        assert!(page.contains(text), "{text}");
    }
    refused(
        format!("page {names} {}", VALUES.replace("--field g=9.81 ", "")),
        1,
        ["unknown name `g`: `--field g=2`"],
    );
}

/// Tables in JSON have names too, and a keyword of Rust may be one.
#[test]
fn names_in_json_and_keywords() {
    let text = r#"{"convention": "modified", "gravity": [0, 0, "-g"], "functions": ["mass_matrix"], "joints": [
        {"name": "p", "type": "revolute", "mass": "type", "com": ["l", 0, 0]}]}"#;
    let json = file("names.json", text);
    let shown = output(format!("show {json}"));
    assert_has(&shown, ["fields: g, type, l\n", "M11 = type l^2"]);
    let out = folder("keywords");
    output(&[
        "generate",
        &json,
        "--lang",
        "rust",
        "--out",
        &out.to_string_lossy(),
    ]);
    let rust = std::fs::read_to_string(out.join("names.rs")).expect("a file");
    assert_has(&rust, ["pub r#type: ::core::primitive::f64"]);
}
