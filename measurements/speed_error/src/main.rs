//! Speed against error: tables on standard output, and a page with plots.
//!
//! ```text
//! taskset -c 1 cargo run --release -p speed_error --features long_arms
//! ```
//!
//! measures everything on one core and writes `target/speed_error/report.html`. Beside it are the plots, and as
//! Markdown the appendices of `docs/ACCURACY.md`, which belong in `docs/accuracy`. Arguments: `--quick` for a run of
//! seconds with fewer robots and shorter measurements; `--long` to watch energies for 10^5 s instead of 10^3, which
//! takes two minutes. `--functions`, `--numbers`, `--integrators`, `--structure`, `--pieces` or `--hard` measures these
//! parts alone; a path is that of the page.
//!
//! Building takes some five minutes of one core: 26 robots, five functions, in every kind of numbers
//! and once for each instruction set.

use std::error::Error;
use std::path::PathBuf;

mod errors;
mod functions;
mod functions_section;
mod hard;
mod integrators;
mod integrators_section;
mod machine;
mod measured_robots;
mod number;
mod page;
mod pieces;
mod problems;
mod reference_motion;
mod samples;
mod scalars;
mod structure;
/// M, V and G by the textbook, as the build script writes them.
#[allow(unused_variables, unreachable_pub, missing_docs, clippy::all)]
mod textbook_programs {
    include!(concat!(env!("OUT_DIR"), "/textbook_programs.rs"));
}

use functions::{Measured, Measurements};
use measured_robots::for_each_measured_robot;
use measuring::Effort;
use robots::*;

/// The requests of the command line.
struct Arguments {
    quick: bool,
    /// Energies over 10^5 s, which take minutes.
    long: bool,
    path: PathBuf,
    parts: Vec<String>,
}

impl Arguments {
    fn read() -> Self {
        let mut arguments = Arguments {
            quick: false,
            long: false,
            path: PathBuf::from("target/speed_error/report.html"),
            parts: Vec::new(),
        };
        for argument in std::env::args().skip(1) {
            match argument.strip_prefix("--") {
                Some("quick") => arguments.quick = true,
                Some("long") => arguments.long = true,
                Some(part) => arguments.parts.push(part.to_owned()),
                None => arguments.path = PathBuf::from(argument),
            }
        }
        arguments
    }

    fn wants(&self, part: &str) -> bool {
        self.parts.is_empty() || self.parts.iter().any(|wanted| wanted == part)
    }

    /// How long the energy is watched, s.
    fn duration(&self) -> f64 {
        match (self.quick, self.long) {
            (true, _) => 20.0,
            (_, true) => 1e5,
            _ => structure::USUAL,
        }
    }

    fn effort(&self) -> Effort {
        if self.quick {
            Effort::QUICK
        } else {
            Effort::FULL
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read();
    let conditions = machine::conditions(if arguments.quick { "quick" } else { "full" });
    for (name, value) in &conditions {
        println!("{name}: {value}");
    }
    let mut sections = Vec::new();
    if arguments.wants("functions") {
        sections.push(functions_section::section(&measured_functions(&arguments))?);
    }
    if arguments.wants("numbers") {
        sections.push(scalars::section(arguments.effort()));
    }
    if arguments.wants("integrators") {
        sections.push(integrators_section::section(arguments.quick)?);
    }
    if arguments.wants("structure") {
        sections.push(structure::section(arguments.duration())?);
    }
    if arguments.wants("pieces") {
        sections.push(pieces::section());
    }
    if arguments.wants("hard") && !arguments.quick {
        sections.push(hard::section());
    }
    sections.iter().for_each(page::Section::print);
    page::write(&arguments.path, &conditions, &sections)?;
    println!("\npage: {}", arguments.path.display());
    Ok(())
}

/// The robots of a quick run.
const QUICK: [&str; 4] = ["one_link", "two_link_saha", "puma560", "panda"];

fn measured_functions(arguments: &Arguments) -> Vec<Measured> {
    let mut all = Vec::new();
    macro_rules! measure {
        ($($file:ident: $robot:ident, $n:literal, $lanes:ident;)*) => {$(
            let name = stringify!($file);
            if !arguments.quick || QUICK.contains(&name) {
                let mut measurements = Measurements::<$n>::of(name, &$robot, arguments.effort());
                measurements.$lanes(&$robot);
                all.extend(measurements.all);
            }
        )*};
    }
    for_each_measured_robot!(measure);
    macro_rules! measure_textbook {
        ($($file:ident: $robot:ident, $n:literal;)*) => {$(
            let name = stringify!($file);
            if !arguments.quick || QUICK.contains(&name) {
                let (textbook, table) = (textbook_programs::$robot, robots::$robot.table());
                let effort = arguments.effort();
                all.extend(Measurements::<$n>::textbook(name, &textbook, &table, effort));
            }
        )*};
    }
    measure_textbook! {
        two_link_saha: TwoLinkSaha, 2;
        two_link_craig: TwoLinkCraig, 2;
        elbow_3r: Elbow3r, 3;
        rrr_planar: RrrPlanar, 3;
        spherical_wrist: SphericalWrist, 3;
    }
    let mut robots: Vec<_> = all.iter().map(|m| m.robot).collect();
    robots.dedup();
    all.sort_by_key(|m| robots.iter().position(|robot| *robot == m.robot));
    all
}
