//! The first part of the report: functions.

use std::error::Error;

use measuring::median;
use measuring::table::{Table, digits, short};
use testkit::plot::{Mark, Plot, Series};

use crate::functions::{Function, Measured, Variant};
use crate::page::{Part, Section};

/// Errors below this are drawn here: an exact result has no place on a logarithmic axis.
const LEAST: f64 = 1e-18;

pub(crate) fn section(all: &[Measured]) -> Result<Section, Box<dyn Error>> {
    let mut section = Section::appendix("Functions", "functions");
    section.text(
        "Times are medians of one evaluation on one core, over the time of the generated function in \
         doubles. Errors are the largest at 64 states: 48 random ones, 8 at rest, and 8 with angles of up \
         to 10^6 rad. Single precision holds all of their numbers. The exact values are Newton-Euler in \
         31 digits on the doubles of the table.",
    );
    section.text(
        "Errors are relative to the natural magnitude. It is max |M| for M and max |M| max |qd|^2 for V. \
         For G it is sum m |g| reach, with at least 1 m where a joint slides. For tau it is \
         max |M| max |qdd| with both of these. The error of qdd is the torque that it takes, M times the \
         error, over the magnitude of tau. The proven bound is the largest of Certified at these \
         states. It counts from the decimals of the table, not from its doubles.",
    );
    section.text(
        "Bits are how many of the last of 53 bits of a single entry are wrong, in the worst case and in \
         the median, whatever cancelled in it. Zeros are values that are identically zero, and how many \
         of them came out as anything else.",
    );
    section.parts.push(Part::Table(summary(all)));
    section.text(format!(
        "The next table has the errors in single precision above {OF_SINGLES:e}. Beside each stands what \
         half a unit in the last place of the arguments, added for all of them, changes at that state in \
         exact arithmetic."
    ));
    section.parts.push(Part::Table(singles(all)));
    for robot in robots(all) {
        let of_robot: Vec<_> = all.iter().filter(|m| m.robot == robot).collect();
        section.parts.push(Part::Plot(
            format!("functions_{robot}"),
            plot(robot, &of_robot).svg()?,
        ));
        let table = table(robot, &of_robot);
        section.parts.push(if SHOWN.contains(&robot) {
            Part::Table(table)
        } else {
            Part::Folded(table)
        });
    }
    Ok(section)
}

/// The robots whose tables are in the appendix; those of the others are on the page.
const SHOWN: [&str; 3] = ["puma560", "panda", "two_link_saha"];

fn robots(all: &[Measured]) -> Vec<&'static str> {
    let mut robots: Vec<_> = all.iter().map(|m| m.robot).collect();
    robots.dedup();
    robots
}

/// Over all robots: the largest errors, and times relative to the generated function in doubles.
fn summary(all: &[Measured]) -> Table {
    let heads = [
        "function, variant",
        "robots",
        "time / f64, median",
        "largest error",
        "largest proven bound",
        "median of the robots' largest",
        "median of bound / error",
        "rms, median",
        "worst bits, median",
        "zeros broken",
    ];
    let mut table = Table::new("All robots", &heads);
    for function in Function::ALL {
        for variant in Variant::ALL {
            let here = |m: &&Measured| m.function == function && m.variant == variant;
            let found: Vec<_> = all.iter().filter(here).collect();
            if found.is_empty() {
                continue;
            }
            let ratio = |m: &&Measured| ratio(m, all.iter());
            let zeros: usize = found.iter().map(|m| m.errors.zeros).sum();
            let broken: usize = found.iter().map(|m| m.errors.broken_zeros).sum();
            let largest = found.iter().map(|m| m.errors.largest).fold(0.0, f64::max);
            table.row([
                format!("{}, {}", function.symbol(), variant.name()),
                found.len().to_string(),
                format!("{:.2}", median(found.iter().map(ratio))),
                short(largest),
                largest_bound(&found),
                short(median(found.iter().map(|m| m.errors.largest))),
                median_ratio(&found),
                short(median(found.iter().map(|m| m.errors.rms))),
                format!("{:.0}", median(found.iter().map(|m| m.errors.worst_bits))),
                format!("{broken} of {zeros}"),
            ]);
        }
    }
    table
}

/// The time of a variant over that of the generated function in doubles.
fn ratio<'a>(measured: &Measured, mut all: impl Iterator<Item = &'a Measured>) -> f64 {
    let f64 = all.find(|other| {
        (other.robot, other.function, other.variant)
            == (measured.robot, measured.function, Variant::F64)
    });
    f64.map_or(f64::NAN, |f64| measured.nanoseconds / f64.nanoseconds)
}

/// The bound of all errors in single precision except those of this table.
const OF_SINGLES: f64 = 4e-7;

/// The largest errors in single precision, each beside the conditioning.
fn singles(all: &[Measured]) -> Table {
    let heads = [
        "robot, function",
        "largest error",
        "half a unit in the arguments",
    ];
    let title = format!("Single precision, errors above {OF_SINGLES:e}");
    let mut table = Table::new(title, &heads);
    let is_large = |m: &&Measured| m.variant == Variant::F32 && m.errors.largest > OF_SINGLES;
    for m in all.iter().filter(is_large) {
        table.row([
            format!("{}, {}", m.robot, m.function.symbol()),
            short(m.errors.largest),
            m.conditioning.map_or_else(String::new, short),
        ]);
    }
    table
}

/// The largest proven bound of some measurements, where there are bounds.
fn largest_bound(found: &[&Measured]) -> String {
    let bounds = found.iter().filter_map(|m| m.bound);
    bounds.reduce(f64::max).map_or_else(String::new, short)
}

/// How many times their largest errors the largest bounds of the robots are, in the median.
fn median_ratio(found: &[&Measured]) -> String {
    let ratio =
        |m: &&&Measured| Some(m.bound? / m.errors.largest).filter(|ratio| ratio.is_finite());
    let ratios: Vec<f64> = found.iter().filter_map(|m| ratio(&m)).collect();
    match ratios.is_empty() {
        true => String::new(),
        false => format!("{:.0}", median(ratios)),
    }
}

fn table(robot: &str, measured: &[&Measured]) -> Table {
    let joints = measured.first().map_or(0, |m| m.joints);
    let title = match joints {
        1 => format!("{robot}, 1 joint"),
        n => format!("{robot}, {n} joints"),
    };
    let heads = [
        "function, variant",
        "time / f64",
        "largest error",
        "proven bound",
        "rms",
        "bits, worst",
        "bits, median",
        "zeros broken",
    ];
    let mut table = Table::new(title, &heads);
    for function in Function::ALL {
        for m in measured.iter().filter(|m| m.function == function) {
            table.row([
                format!("{}, {}", function.symbol(), m.variant.name()),
                digits(ratio(m, measured.iter().copied())),
                short(m.errors.largest),
                m.bound.map_or_else(String::new, short),
                short(m.errors.rms),
                format!("{:.0}", m.errors.worst_bits),
                format!("{:.1}", m.errors.median_bits),
                format!("{} of {}", m.errors.broken_zeros, m.errors.zeros),
            ]);
        }
    }
    table
}

/// Error across, time up, a point for each variant of each function.
fn plot(robot: &str, measured: &[&Measured]) -> Plot {
    let series = Variant::ALL.iter().map(|&variant| Series {
        name: variant.name().to_owned(),
        joined: false,
        points: (measured.iter())
            .filter(|m| m.variant == variant && m.errors.largest.is_finite())
            .map(|m| {
                let letter = Mark::Letter(m.function.symbol());
                (m.errors.largest.max(LEAST), m.nanoseconds, letter)
            })
            .collect(),
    });
    Plot {
        title: format!("{robot}: time of a call against its largest error"),
        x: "largest error, relative to the natural magnitude (exact: 1e-18)",
        y: "ns",
        series: series.filter(|series| !series.points.is_empty()).collect(),
        limits: Vec::new(),
    }
}
