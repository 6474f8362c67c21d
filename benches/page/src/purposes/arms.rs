//! Arms at one state and in batches, beside other tools.

use measuring::table::Table;

use super::{FUNCTIONS, Purpose, SHOWN, geometric_mean, robot, two_digits};
use crate::appendix::{Region, number};
use crate::chart::{Chart, Series};

const NATIVE: &str = "native, ns";

/// Other tools: what the page calls them, and their names among the candidates, of which the fastest counts.
const OTHERS: [(&str, &[&str]); 5] = [
    ("CasADi", &["CasADi,-O3", "CasADi,-Ofast"]),
    ("numeric", &["numeric"]),
    ("Pinocchio", &["Pinocchio,clang", "Pinocchio,gcc"]),
    ("dynibo", &["dynibo"]),
    ("symplex", &["symplex"]),
];

pub(super) fn one_state(arms: &Region) -> Purpose {
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

pub(super) fn batches(arms: &Region) -> Purpose {
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
