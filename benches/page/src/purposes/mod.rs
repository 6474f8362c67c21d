//! The table and the chart of each purpose.

mod arms;
mod c;
mod robots;

use measuring::table::Table;

use crate::appendix::{Appendices, Appendix, Rows, number};
use crate::chart::{Chart, Series};

/// The part of the page that serves one purpose.
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
        ("missed_by_c", c::missed_by_c(c.table())),
    ];
    let texts = texts.map(|(name, text)| Purpose {
        name,
        text,
        chart: None,
    });
    let charted = [
        arms::one_state(&arms),
        arms::batches(&arms),
        robots::robots("trees", "Trees: ns a state", trees.table()),
        robots::robots(
            "moving_bases",
            "Bases that move: ns a state",
            legged.table(),
        ),
        solutions(closed_forms.table()),
        c::languages(c.table()),
        c::generators(of.generators.region("generators").table()),
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

/// The name by which readers know a robot.
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

/// The functions of charts with two lines for each arm.
const SHOWN: [(&str, &str); 2] = [FUNCTIONS[0], FUNCTIONS[4]];

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
