//! The table and the chart of each purpose.

use measuring::table::Table;

use crate::appendix::{Appendices, Appendix, Region, Rows, number};
use crate::chart::{Chart, Series};

/// What the page has of one purpose.
pub(crate) struct Purpose {
    /// Where the page has it: `{NAME}`.
    pub(crate) name: &'static str,
    /// A table in Markdown, or a sentence.
    pub(crate) text: String,
    pub(crate) chart: Option<Chart>,
}

pub(crate) fn all(of: &Appendices) -> Vec<Purpose> {
    let arms = of.arms.region("arms");
    let c = of.c.region("c");
    let [trees, legged] = ["trees", "legged"].map(|name| of.trees.region(name));
    let [closed_forms, reach] =
        ["closed_forms", "reach"].map(|name| of.inverse_kinematics.region(name));
    let texts = [
        ("conditions", conditions(of)),
        ("numeric_inverse_kinematics", copy(reach.table(), &[])),
        (
            "optimal_control",
            copy(
                of.optimal_control.region("optimal_control").table(),
                &["difference of unknowns"],
            ),
        ),
        (
            "missed_goals",
            missed_goals(of.goals.region("goals").table()),
        ),
        ("missed_by_c", missed_by_c(c.table())),
    ];
    let texts = texts.map(|(name, text)| Purpose {
        name,
        text,
        chart: None,
    });
    let charted = [
        one_state(&arms),
        batches(&arms),
        robots("trees", "Trees: ns a state", trees.table()),
        robots(
            "moving_bases",
            "Bases that move: ns a state",
            legged.table(),
        ),
        solutions(closed_forms.table()),
        languages(c.table()),
        generators(of.generators.region("generators").table()),
    ];
    texts.into_iter().chain(charted).collect()
}

/// The functions whose times are compared, and their symbols.
const FUNCTIONS: [(&str, &str); 5] = [
    ("inverse_dynamics", "tau"),
    ("mass_matrix", "M"),
    ("coriolis_vector", "V"),
    ("gravity_vector", "G"),
    ("forward_dynamics", "qdd"),
];

/// What readers know a robot as.
fn robot(id: &str) -> &str {
    match id {
        "two_link_saha" => "two links",
        "elbow_3r" => "elbow, 3R",
        "stanford" => "Stanford arm",
        "puma560" => "PUMA 560",
        "ur5" => "UR5",
        "panda" => "Panda",
        "hyq_no_sensors" => "HyQ",
        "anymal_erd" => "ANYmal",
        "panda_free" => "Panda, fingers",
        other => other,
    }
}

/// Where, with what and when each table was measured.
fn conditions(of: &Appendices) -> String {
    let regions: [(&Appendix, &str, &str); 8] = [
        (&of.arms, "arms", "six arms"),
        (&of.trees, "trees", "trees"),
        (&of.trees, "legged", "bases that move"),
        (&of.inverse_kinematics, "closed_forms", "inverse kinematics"),
        (&of.inverse_kinematics, "reach", "inverse kinematics"),
        (&of.c, "c", "C"),
        (&of.optimal_control, "optimal_control", "optimal control"),
        (&of.generators, "generators", "other generators"),
    ];
    let mut table = Table::new("", &["measured by", "tables", "processor; compilers; date"]);
    let mut rows: Vec<[String; 3]> = Vec::new();
    for (appendix, region, label) in regions {
        let conditions = appendix.region(region).conditions;
        let link = format!("[{label}]({})", appendix.path);
        let row = [format!("`{}`", appendix.command()), link, conditions];
        // Two tables of one run have the same.
        if !rows.contains(&row) {
            rows.push(row);
        }
    }
    for row in rows {
        table.row(row);
    }
    left(&table.markdown_rows())
}

/// Cells flush left.
fn left(markdown: &str) -> String {
    markdown.replacen("|--:", "|---", usize::MAX)
}

/// A table as it was measured, without some columns.
fn copy(rows: &Rows, without: &[&str]) -> String {
    let kept: Vec<usize> = (0..rows.heads.len())
        .filter(|&column| !without.contains(&rows.heads[column].as_str()))
        .collect();
    let heads: Vec<&str> = kept
        .iter()
        .map(|&column| rows.heads[column].as_str())
        .collect();
    let mut table = Table::new("", &heads);
    for row in &rows.rows {
        table.row(kept.iter().map(|&column| row[column].clone()));
    }
    table.markdown_rows()
}

const NATIVE: &str = "native, ns";

/// Other tools: what the page calls them, and their names among the candidates, of which the fastest counts.
const OTHERS: [(&str, &[&str]); 5] = [
    ("CasADi", &["CasADi,-O3", "CasADi,-Ofast"]),
    ("numeric", &["numeric"]),
    ("Pinocchio", &["Pinocchio,clang", "Pinocchio,gcc"]),
    ("dynibo", &["dynibo"]),
    ("symplex", &["symplex"]),
];

fn one_state(arms: &Region) -> Purpose {
    let time = |arm: &str, function: &str, candidates: &[&str]| -> f64 {
        let times = candidates
            .iter()
            .filter_map(|candidate| arms.below(arm).number(&[function, candidate], NATIVE));
        times.fold(f64::INFINITY, f64::min)
    };
    let here: &[&str] = &["generated"];
    let symbols = FUNCTIONS.map(|(_, symbol)| format!("{symbol}, ns"));
    let heads = ["arm"]
        .into_iter()
        .chain(symbols.iter().map(String::as_str));
    let heads: Vec<&str> = heads.chain(OTHERS.map(|(name, _)| name)).collect();
    let mut table = Table::new("", &heads);
    let ids = arms.below("Batches").heads[1..].iter().map(String::as_str);
    for arm in ids.clone() {
        let ours = FUNCTIONS.map(|(function, _)| {
            arms.below(arm)
                .cell(&[function, "generated"], NATIVE)
                .to_owned()
        });
        let others = OTHERS.map(|(_, names)| {
            let ratio = |(function, _)| time(arm, function, names) / time(arm, function, here);
            two_digits(geometric_mean(FUNCTIONS.map(ratio)))
        });
        table.row(
            [robot(arm).to_owned()]
                .into_iter()
                .chain(ours)
                .chain(others),
        );
    }
    let candidates = [("generated", here)].into_iter().chain(OTHERS);
    let series = candidates.enumerate().map(|(mark, (name, names))| Series {
        name,
        mark,
        values: ids
            .clone()
            .map(|arm| Some(time(arm, "inverse_dynamics", names)))
            .collect(),
    });
    Purpose {
        name: "one_state",
        text: table.markdown_rows(),
        chart: Some(Chart {
            file: "one_state",
            title: "Torques of one state (inverse dynamics): ns a call",
            rows: ids.clone().map(|arm| robot(arm).to_owned()).collect(),
            series: series.collect(),
        }),
    }
}

/// The time of the native build in a cell such as `5.5 / 5.4 (2e-16)`.
fn native(cell: &str) -> &str {
    let native = cell.split(' ').nth(2);
    native.unwrap_or_else(|| panic!("`{cell}`: plain / native (error)"))
}

fn batches(arms: &Region) -> Purpose {
    let batches = arms.below("Batches");
    let symbols = FUNCTIONS.map(|(_, symbol)| format!("{symbol}, ns"));
    let heads = ["arm"]
        .into_iter()
        .chain(symbols.iter().map(String::as_str));
    let heads: Vec<&str> = heads.chain(["one state / batch"]).collect();
    let mut table = Table::new("", &heads);
    let ids: Vec<&str> = batches.heads[1..].iter().map(String::as_str).collect();
    let of_batch = |arm: &str, function: &str| {
        native(batches.cell(&[&format!("{function}_batch")], arm)).to_owned()
    };
    let of_one =
        |arm: &str, function: &str| number(arms.below(arm).cell(&[function, "generated"], NATIVE));
    for arm in &ids {
        let times = FUNCTIONS.map(|(function, _)| of_batch(arm, function));
        let ratio = |(function, _)| of_one(arm, function) / number(&of_batch(arm, function));
        let ratio = two_digits(geometric_mean(FUNCTIONS.map(ratio)));
        table.row(
            [robot(arm).to_owned()]
                .into_iter()
                .chain(times)
                .chain([ratio]),
        );
    }
    let values = |time: &dyn Fn(&str, &str) -> f64| -> Vec<Option<f64>> {
        let arms = ids.iter();
        arms.flat_map(|arm| SHOWN.map(|(function, _)| Some(time(arm, function))))
            .collect()
    };
    let rows = ids
        .iter()
        .flat_map(|arm| SHOWN.map(|(_, symbol)| format!("{}, {symbol}", robot(arm))));
    Purpose {
        name: "batches",
        text: table.markdown_rows(),
        chart: Some(Chart {
            file: "batches",
            title: "Torques and accelerations: ns a state",
            rows: rows.collect(),
            series: vec![
                Series {
                    name: "one state",
                    mark: 0,
                    values: values(&of_one),
                },
                Series {
                    name: "batch",
                    mark: 1,
                    values: values(&|arm, function| number(&of_batch(arm, function))),
                },
            ],
        }),
    }
}

/// The functions of charts with two lines for each arm.
const SHOWN: [(&str, &str); 2] = [FUNCTIONS[0], FUNCTIONS[4]];

/// Robots beside Pinocchio: what the table of an appendix calls a time, and what the page calls it.
const COLUMNS: [(&str, &str); 4] = [
    ("ns", "one state"),
    ("batch, ns", "batch"),
    ("f32 batch, ns", "f32 batch"),
    ("Pinocchio, ns", "Pinocchio"),
];

fn robots(name: &'static str, title: &'static str, rows: &Rows) -> Purpose {
    let columns = COLUMNS
        .iter()
        .filter(|(head, _)| rows.heads.iter().any(|known| known == head));
    let columns: Vec<_> = columns.copied().collect();
    let names = columns.iter().map(|(_, name)| *name);
    let heads = ["robot", "function"].into_iter().chain(names);
    let heads: Vec<&str> = heads.chain(["Pinocchio / one state"]).collect();
    let mut table = Table::new("", &heads);
    let [ours, theirs] = ["ns", "Pinocchio, ns"].map(|head| rows.cells(head));
    for (number_of_row, row) in rows.rows.iter().enumerate() {
        let cells = columns
            .iter()
            .map(|(head, _)| rows.cells(head)[number_of_row].to_owned());
        let ratio = match theirs[number_of_row] {
            "" => String::new(),
            theirs => two_digits(number(theirs) / number(ours[number_of_row])),
        };
        let names = [robot(&row[0]).to_owned(), format!("`{}`", row[1])];
        table.row(names.into_iter().chain(cells).chain([ratio]));
    }
    let series = columns.iter().map(|&(head, name)| Series {
        name,
        // That of Pinocchio is the same with and without batches of `f32`.
        mark: COLUMNS
            .iter()
            .position(|column| column.0 == head)
            .unwrap_or(0),
        values: rows
            .cells(head)
            .iter()
            .map(|cell| (!cell.is_empty()).then(|| number(cell)))
            .collect(),
    });
    let symbol = |function: &str| {
        let known = FUNCTIONS.iter().find(|(name, _)| *name == function);
        known
            .map_or("derivatives of qdd", |(_, symbol)| symbol)
            .to_owned()
    };
    let labels = rows.rows.iter();
    let labels = labels.map(|row| format!("{}, {}", robot(&row[0]), symbol(&row[1])));
    Purpose {
        name,
        text: table.markdown_rows(),
        chart: Some(Chart {
            file: name,
            title,
            rows: labels.collect(),
            series: series.collect(),
        }),
    }
}

fn solutions(rows: &Rows) -> Purpose {
    let times = rows.cells("ns for all");
    Purpose {
        name: "closed_forms",
        text: copy(rows, &["error"]),
        chart: Some(Chart {
            file: "closed_forms",
            title: "Inverse kinematics in closed form: ns for all solutions of a pose",
            rows: rows
                .cells("arm")
                .iter()
                .map(|arm| (*arm).to_owned())
                .collect(),
            series: vec![Series {
                name: "all solutions",
                mark: 0,
                values: times.iter().map(|time| Some(number(time))).collect(),
            }],
        }),
    }
}

/// The ratios of C code, and what the page calls them.
const RATIOS: [(&str, &str); 3] = [
    ("gcc / Rust", "C / Rust, one state"),
    ("gcc / Rust, batch", "C / Rust, batch"),
    ("CasADi / C", "CasADi / C, one state"),
];

fn languages(rows: &Rows) -> Purpose {
    let heads = ["arm"].into_iter().chain(RATIOS.map(|(_, name)| name));
    let mut table = Table::new("", &heads.collect::<Vec<_>>());
    let mean = |arm: Option<&str>, head: &str| {
        let numbers = rows.cells(head).into_iter().zip(&rows.rows);
        let of_arm = numbers.filter(|(_, row)| arm.is_none_or(|arm| row[0] == arm));
        geometric_mean(of_arm.map(|(cell, _)| number(cell)))
    };
    let row = |arm: Option<&str>| {
        let name = arm.map_or("all", robot).to_owned();
        [name]
            .into_iter()
            .chain(RATIOS.map(|(head, _)| format!("{:.2}", mean(arm, head))))
    };
    for arm in rows.firsts() {
        table.row(row(Some(arm)));
    }
    table.row(row(None));
    let series = RATIOS
        .iter()
        .enumerate()
        .map(|(mark, &(head, name))| Series {
            name,
            mark,
            values: rows
                .firsts()
                .into_iter()
                .map(|arm| Some(mean(Some(arm), head)))
                .collect(),
        });
    Purpose {
        name: "c",
        text: table.markdown_rows(),
        chart: Some(Chart {
            file: "c",
            title: "C beside Rust and CasADi: ratios of times, geometric means",
            rows: rows
                .firsts()
                .into_iter()
                .map(|arm| robot(arm).to_owned())
                .collect(),
            series: series.collect(),
        }),
    }
}

/// How many times as long CasADi's C code is to take at least.
const BAR_OF_C: f64 = 1.8;

/// A sentence about the functions that miss this bar.
fn missed_by_c(rows: &Rows) -> String {
    let ratios = rows.cells("CasADi / C").into_iter().zip(&rows.rows);
    let missed = ratios.filter(|(ratio, _)| number(ratio) < BAR_OF_C);
    let missed: Vec<_> = missed
        .map(|(ratio, row)| format!("`{}` of the {} ({ratio})", row[1], robot(&row[0])))
        .collect();
    let bar = format!("C code is to take at most 1 / {BAR_OF_C} of the time of CasADi's");
    match missed.as_slice() {
        [] => format!("{bar}. It does for each function.\n"),
        missed => format!("{bar}. These miss it: {}.\n", missed.join(", ")),
    }
}

/// Times of this project's C code, and of CppADCodeGen's.
const TIMES: [&str; 2] = ["ns", "CppADCodeGen: ns"];

fn generators(rows: &Rows) -> Purpose {
    let heads = [
        "arm",
        "operations, CppADCodeGen / here",
        "time, CppADCodeGen / here",
    ];
    let mut table = Table::new("", &heads);
    let [ours, theirs] = ["operations", "CppADCodeGen: operations"].map(|head| rows.cells(head));
    let [our_times, their_times] = TIMES.map(|head| rows.cells(head));
    let of_row = |row: usize| {
        let operations = number(theirs[row]) / number(ours[row]);
        [
            operations,
            number(their_times[row]) / number(our_times[row]),
        ]
    };
    let means = |arm: Option<&str>| {
        let places = rows.rows.iter().enumerate();
        let places = places.filter(|(_, row)| arm.is_none_or(|arm| row[0] == arm));
        let ratios: Vec<_> = places.map(|(place, _)| of_row(place)).collect();
        [0, 1].map(|k| two_digits(geometric_mean(ratios.iter().map(|ratio| ratio[k]))))
    };
    for arm in rows.firsts() {
        table.row([robot(arm).to_owned()].into_iter().chain(means(Some(arm))));
    }
    table.row(["all".to_owned()].into_iter().chain(means(None)));
    let arms = rows.firsts();
    let labels = arms
        .iter()
        .flat_map(|arm| SHOWN.map(|(_, symbol)| format!("{}, {symbol}", robot(arm))));
    let values = |head: &str| {
        let of_arm = |arm| SHOWN.map(|(function, _)| rows.number(&[arm, function], head));
        arms.iter().copied().flat_map(of_arm).collect()
    };
    Purpose {
        name: "generators",
        text: table.markdown_rows(),
        chart: Some(Chart {
            file: "generators",
            title: "Generated C code: ns a call",
            rows: labels.collect(),
            series: vec![
                Series {
                    name: "robot-dynamics",
                    mark: 0,
                    values: values(TIMES[0]),
                },
                Series {
                    name: "CppADCodeGen",
                    mark: 1,
                    values: values(TIMES[1]),
                },
            ],
        }),
    }
}

/// The goals that a processor misses.
fn missed_goals(rows: &Rows) -> String {
    let heads: Vec<&str> = rows.heads.iter().map(String::as_str).collect();
    let mut table = Table::new("", &heads);
    for (place, row) in rows.rows.iter().enumerate() {
        // The first row has the conditions.
        if place == 0 || row.iter().any(|cell| cell.starts_with("**")) {
            table.row(row.iter().cloned());
        }
    }
    table.markdown_rows()
}

fn geometric_mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = values.into_iter().fold((0.0, 0), |(sum, count), value| {
        (sum + value.ln(), count + 1)
    });
    (sum / f64::from(count)).exp()
}

fn two_digits(x: f64) -> String {
    match x {
        ..9.95 => format!("{x:.1}"),
        _ => format!("{x:.0}"),
    }
}
