//! `robot-dynamics`: equations of motion of a robot file, shown, checked, generated and run.
#![forbid(unsafe_code)]

mod arguments;
mod beside;
mod check;
mod columns;
mod compare;
mod convert;
mod csv;
mod evaluate;
mod excerpt;
mod failure;
mod generate;
mod inverse;
mod joints;
mod lint;
mod load;
mod measure;
mod page_file;
mod plot;
mod progress;
mod reach;
mod show;
mod simulate;
mod spline;
mod state;
mod write;

use std::io::Write as _;
use std::process::ExitCode;

use clap::ArgMatches;

use failure::Failure;

fn main() -> ExitCode {
    let matches = arguments::command().get_matches();
    let Some((name, given)) = matches.subcommand() else {
        return ExitCode::from(2);
    };
    let (text, failure) = match output(name, given) {
        Ok(text) => (text, None),
        Err(failure) => (failure.output.clone(), Some(failure)),
    };
    let failure = failure.or(write::print(&text).err());
    match failure {
        None => ExitCode::SUCCESS,
        Some(failure) => {
            let report = failure.report();
            if !report.is_empty() {
                let _ = writeln!(std::io::stderr(), "{report}");
            }
            ExitCode::from(failure.status)
        }
    }
}

/// The output of a subcommand, unless it goes to a file.
fn output(name: &str, given: &ArgMatches) -> Result<String, Failure> {
    write::not_over_what_is_read(given)?;
    let text = match name {
        "show" => show::run(given),
        "check" => check::run(given),
        "generate" => return generate::run(given),
        "evaluate" => evaluate::run(given),
        "simulate" => simulate::run(given),
        "inverse-dynamics" => inverse::run(given),
        "reach" => reach::run(given),
        "measure" => measure::run(given),
        "page" => page_file::run(given),
        "convert" => convert::run(given),
        "lint" => return lint::run(given),
        _ => Ok(arguments::completions(given)),
    };
    match text {
        Ok(text) => write::put_out(text, given),
        Err(failure) => {
            let rest = write::put_out(failure.output.clone(), given)?;
            Err(failure.with_output(rest))
        }
    }
}
