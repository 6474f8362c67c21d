//! C code beside Rust and beside that of other generators.

use measuring::table::Table;

use super::{Purpose, SHOWN, geometric_mean, robot, two_digits};
use crate::appendix::{Rows, number};
use crate::chart::{Chart, Series};

/// The ratios of C code, and what the page calls them.
const RATIOS: [(&str, &str); 3] = [
    ("gcc / Rust", "C / Rust, one state"),
    ("gcc / Rust, batch", "C / Rust, batch"),
    ("CasADi / C", "CasADi / C, one state"),
];

pub(super) fn languages(rows: &Rows) -> Purpose {
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

/// The least time of CasADi's C code over that of C code here.
const BAR_OF_C: f64 = 1.8;

/// A sentence about the functions that miss this bar.
pub(super) fn missed_by_c(rows: &Rows) -> String {
    let ratios = rows.cells("CasADi / C").into_iter().zip(&rows.rows);
    let missed = ratios.filter(|(ratio, _)| number(ratio) < BAR_OF_C);
    let missed: Vec<_> = missed
        .map(|(ratio, row)| format!("`{}` of the {} ({ratio})", row[1], robot(&row[0])))
        .collect();
    let bar = format!("The goal for C code is at most 1 / {BAR_OF_C} of the time of CasADi's");
    match missed.as_slice() {
        [] => format!("{bar}. Every function reaches it.\n"),
        missed => format!("{bar}. These miss it: {}.\n", missed.join(", ")),
    }
}

/// Times of this project's C code, and of CppADCodeGen's.
const TIMES: [&str; 2] = ["ns", "CppADCodeGen: ns"];

pub(super) fn generators(rows: &Rows) -> Purpose {
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
