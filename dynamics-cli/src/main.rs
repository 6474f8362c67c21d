//! `robot-dynamics`: equations of motion of a robot file, shown, checked, generated and run.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod compare;
mod convert;
mod csv;
mod excerpt;
mod failure;
mod generate;
mod inverse;
mod joints;
mod load;
mod measure;
mod page;
mod progress;
mod rust;
mod show;
mod simulate;
mod spline;
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
    match output(name, given) {
        Ok(text) => {
            // Whoever reads the output may have read enough.
            let _ = std::io::stdout().write_all(text.as_bytes());
            ExitCode::SUCCESS
        }
        Err(failure) => {
            let _ = std::io::stdout().write_all(failure.output.as_bytes());
            let _ = writeln!(std::io::stderr(), "{}", failure.told());
            ExitCode::from(failure.status)
        }
    }
}

/// The output of a subcommand, unless it goes to a file.
fn output(name: &str, given: &ArgMatches) -> Result<String, Failure> {
    let text = match name {
        "show" => show::run(given),
        "check" => check::run(given),
        "generate" => return generate::run(given),
        "simulate" => simulate::run(given),
        "inverse" => inverse::run(given),
        "measure" => measure::run(given),
        "page" => page::run(given),
        "convert" => convert::run(given),
        _ => Ok(arguments::completions(given)),
    }?;
    write::put_out(text, given)
}
