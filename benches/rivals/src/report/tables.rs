//! The tables of the document.

use std::fmt::Write;

use measuring::table::Table;

use crate::candidates::GENERATED;
use crate::measure::GROUPS;
use measured_arms::for_each_arm;
use measuring::records::Records;
use testkit::five::NAMES;

macro_rules! names {
    ($($file:ident: $arm:ident, $n:literal;)*) => { [$(stringify!($file)),*] };
}
const ARMS: [&str; 6] = for_each_arm!(names);

/// A table for each arm: times and errors of every candidate in both builds.
pub(crate) fn details(plain: &Records, native: &Records, elsewhere: &Records) -> String {
    ARMS.map(|arm| {
        let mut table = Table::new("", &HEADS);
        for function in NAMES {
            for name in native.names("time", 3) {
                row(&mut table, [arm, function, name], Some(plain), native);
            }
            for name in elsewhere.names("time", 3) {
                row(&mut table, [arm, function, name], None, elsewhere);
            }
        }
        format!("### {arm}\n\n{}\n", table.markdown_rows())
    })
    .concat()
}

const HEADS: [&str; 8] = [
    "function",
    "by",
    "plain, ns",
    "largest error",
    "rms",
    "native, ns",
    "largest error",
    "rms",
];

fn row(
    table: &mut Table,
    [arm, function, name]: [&str; 3],
    plain: Option<&Records>,
    native: &Records,
) {
    let Some(time) = native.median(["time", arm, function, name]) else {
        return;
    };
    let time_of = |records: &Records| {
        records
            .median(["time", arm, function, name])
            .map(three_digits)
    };
    let errors_of = |records: &Records| -> [String; 2] {
        let errors = records.errors(arm, function, name);
        [0, 1].map(|k| or_dash(errors.map(|errors| format!("{:.0e}", errors[k]))))
    };
    let [largest, rms] = errors_of(native);
    let [plain_largest, plain_rms] = plain.map_or_else(|| ["–".into(), "–".into()], errors_of);
    table.row([
        function.to_owned(),
        name.to_owned(),
        or_dash(plain.and_then(time_of)),
        plain_largest,
        plain_rms,
        three_digits(time),
        largest,
        rms,
    ]);
}

const GROUP: &str = "\
Generated code: ns for one state, plain / native, and the largest error of the native build in brackets.
";

/// The functions that only the generated code has, a table for each group, a column for each arm.
pub(crate) fn groups(plain: &Records, native: &Records) -> String {
    let mut text = String::new();
    for (title, functions) in GROUPS {
        let measured = |function: &&&str| {
            native
                .median(["time", ARMS[0], function, GENERATED])
                .is_some()
        };
        let functions: Vec<&&str> = functions.iter().filter(measured).collect();
        if functions.is_empty() {
            continue;
        }
        writeln!(text, "## {title}\n").unwrap();
        writeln!(text, "{GROUP}").unwrap();
        let mut table = Table::new("", &[&["function"][..], &ARMS[..]].concat());
        for function in functions {
            let cell = |arm: &str| {
                let time = |records: &Records| records.median(["time", arm, function, GENERATED]);
                let [fast, faster] = [plain, native].map(|r| or_dash(time(r).map(three_digits)));
                let errors = native.errors(arm, function, GENERATED);
                let error = or_dash(errors.map(|[largest, _]| format!("{largest:.0e}")));
                format!("{fast} / {faster} ({error})")
            };
            table.row([function.to_string()].into_iter().chain(ARMS.map(cell)));
        }
        text += &table.markdown_rows();
        text += "\n";
    }
    text
}

fn three_digits(x: f64) -> String {
    match x {
        ..9.95 => format!("{x:.1}"),
        _ => format!("{x:.0}"),
    }
}

fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "–".into())
}
