//! Speed against error: tables on standard output, and a page with plots.
//!
//! `cargo run --release --example speed_error` measures everything and writes
//! `target/speed_error/report.html`, with the plots as files beside it. Arguments: `--quick` for a
//! run of seconds with fewer robots and shorter measurements, `--functions` or another part's name
//! for one part, and a path for the page. Times are of one core: `taskset -c 1 cargo run ...`.

use std::error::Error;
use std::path::PathBuf;

mod errors;
#[path = "../../tests/support/exact.rs"]
mod exact;
mod functions;
mod functions_section;
mod machine;
mod number;
mod page;
mod plot;
#[path = "../../tests/support/random.rs"]
mod random;
mod robots;
mod samples;
mod table;
mod timing;

use functions::{Measured, Measurements};
use robots::*;
use timing::Effort;

/// What the command line asks for.
struct Arguments {
    quick: bool,
    path: PathBuf,
    parts: Vec<String>,
}

impl Arguments {
    fn read() -> Self {
        let mut arguments = Arguments {
            quick: false,
            path: PathBuf::from("target/speed_error/report.html"),
            parts: Vec::new(),
        };
        for argument in std::env::args().skip(1) {
            match argument.strip_prefix("--") {
                Some("quick") => arguments.quick = true,
                Some(part) => arguments.parts.push(part.to_owned()),
                None => arguments.path = PathBuf::from(argument),
            }
        }
        arguments
    }

    fn wants(&self, part: &str) -> bool {
        self.parts.is_empty() || self.parts.iter().any(|wanted| wanted == part)
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
        sections.push(functions_section::section(&functions(&arguments))?);
    }
    sections.iter().for_each(page::Section::print);
    page::write(&arguments.path, &conditions, &sections)?;
    println!("\npage: {}", arguments.path.display());
    Ok(())
}

/// The robots of a quick run.
const QUICK: [&str; 4] = ["one_link", "two_link_saha", "puma560", "panda"];

fn functions(arguments: &Arguments) -> Vec<Measured> {
    let mut all = Vec::new();
    macro_rules! measure {
        ($($file:ident: $robot:ident, $n:literal;)*) => {$(
            let name = stringify!($file);
            if !arguments.quick || QUICK.contains(&name) {
                all.extend(Measurements::<$n>::of(name, &$robot, arguments.effort()).all);
            }
        )*};
    }
    for_each_robot!(measure);
    all
}
