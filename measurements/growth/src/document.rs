//! The tables, as they are in `docs/contributing/GROWTH.md`.

use std::process::Command;

use measuring::machine;
use measuring::table::Table;

use crate::chain::{Chain, LISTED, Outcome};
use crate::compile::flags;
use crate::fit;
use crate::series::{Panel, panels};

const INTRODUCTION: &str = "\
# Growth with the number of joints

Generic chains: revolute joints, every cell of the table non-zero, full inertia tensors, no
parallel or intersecting axes, nothing that an engine could use. Arms that are built are cheaper
than these at the same number of joints.

";

const EXPLANATIONS: [&str; 4] = [
    "Seconds on a processor from the table to tokens, for the functions that a table gets by
default: derivation, proof, rounding of constants, emission. Cargo compiles macros without
optimisation unless `[profile.dev.build-override]` says otherwise: the second column is what a
user waits for, the first what the two lines in the README make of it.",
    "Multiplications, additions and divisions; sines and cosines apart. Forward dynamics factors
the mass matrix up to 11 joints (a cubic number of operations) and goes by articulated bodies from
12 on (a linear one): the shorter one is taken.",
    "Seconds of rustc on a processor, without cargo, for a crate with the methods of the default
set at `f64`: release profile, and dev profile with debug information. L is the number of
operations of all of them. What grows faster than L in the release profile is LLVM's vectoriser of
straight-line code, in the longest function, M; one function has one block of code here.",
    "Nanoseconds, `f64`, one state after the other in a loop; medians of 31 batches. Each
instruction is read once in a call: where a function outgrows the first instruction cache (32 KiB
on the usual machines, some 1,900 operations) an operation takes up to twice as long.",
];

const TREE: &str = "\
Two legs of six joints, a trunk of two, a neck of two and two arms of seven, all of generic links
(`humanoid` of `testkit/arms`): expansion in an optimised engine and rustc, as above. Entries of M
between branches are zero and take no operations. `growth -- --tree` prints this section alone.";

/// The longest expansion and the longest time of rustc that a tree is meant to take, s.
const BARS: [f64; 2] = [1.0, 10.0];

/// The document, with the machine and the date.
pub(crate) fn document(chains: &[Chain]) -> Outcome<String> {
    let mut text = INTRODUCTION.to_owned() + &origin()?;
    for (index, panel) in panels(chains).iter().enumerate() {
        text += &format!("\n## {}\n\n{}\n\n", panel.title, EXPLANATIONS[index]);
        text += &table(chains, index);
        text += &powers(panel);
    }
    Ok(text)
}

/// The section about a tree, with the machine and the date.
pub(crate) fn section(tree: &Chain) -> String {
    let heads = ["joints", "expansion, s", "L", "release, s", "dev, s"];
    let mut table = Table::new("", &heads);
    table.row([
        tree.joints.to_string(),
        seconds(Some(tree.expansion)),
        format!("{:.0}", tree.length),
        seconds(Some(tree.release)),
        seconds(Some(tree.dev)),
    ]);
    let [of_expansion, of_rustc] = BARS;
    let verdict = |time: f64, bar: f64| if time <= bar { "kept" } else { "missed" };
    format!(
        "\n## A tree\n\n{TREE}\n\n{}\nBars: expansion within {of_expansion} s, {}; rustc within {of_rustc} s, {}.\n\
         Measured on {}, {}.\n",
        table.markdown_rows(),
        verdict(tree.expansion, of_expansion),
        verdict(tree.release.max(tree.dev), of_rustc),
        machine::now()[0],
        machine::processor(),
    )
}

/// When, where and how the numbers were measured.
fn origin() -> Outcome<String> {
    let rustc = Command::new("rustc").arg("--version").output()?;
    let flags = match flags().join(" ") {
        none if none.is_empty() => "none".to_owned(),
        flags => format!("`{flags}`"),
    };
    Ok(format!(
        "Measured on {} on a shared machine, {},\n{}, RUSTFLAGS: {flags}, by\n\n\
         ```text\ntaskset -c 1 cargo run --release -p growth -- --full\n```\n\n\
         which writes this file, and log-log plots of the tables to `examples/output/growth_*.svg`.\n\
         Powers are fitted by least squares on the logarithms over the upper half of the range.\n",
        machine::now()[0],
        machine::processor(),
        String::from_utf8(rustc.stdout)?.trim(),
    ))
}

fn table(chains: &[Chain], index: usize) -> String {
    let heads = match index {
        0 => vec!["optimised", "unoptimised"],
        2 => vec!["L", "release", "dev", "release, us an operation"],
        _ => LISTED.map(|(_, name)| name).to_vec(),
    };
    let mut table = Table::new("", &[vec!["n"], heads].concat());
    for chain in chains {
        let cells = match index {
            0 => vec![seconds(Some(chain.expansion)), seconds(chain.unoptimised)],
            1 => chain.operations.map(|x| format!("{x:.0}")).to_vec(),
            2 => vec![
                format!("{:.0}", chain.length),
                seconds(Some(chain.release)),
                seconds(Some(chain.dev)),
                format!("{:.0}", 1e6 * chain.release / chain.length),
            ],
            _ => chain.calls.map(|x| format!("{x:.0}")).to_vec(),
        };
        table.row([vec![chain.joints.to_string()], cells].concat());
    }
    table.markdown_rows()
}

fn seconds(time: Option<f64>) -> String {
    time.map_or("-".to_owned(), |time| format!("{time:.2}"))
}

fn powers(panel: &Panel) -> String {
    let fitted = panel.series.iter().filter_map(|series| {
        let exponent = fit::exponent(&series.points)?;
        Some(format!("{} {}^{exponent:.2}", series.name, panel.x.1))
    });
    let fitted: Vec<_> = fitted.collect();
    match fitted.is_empty() {
        true => String::new(),
        false => format!("\nFitted: {}.\n", fitted.join(", ")),
    }
}
