//! `robot-dynamics`: equations of motion of a robot file, shown, checked, generated and run.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod csv;
mod failure;
mod generate;
mod inverse;
mod joints;
mod load;
mod measure;
mod show;
mod simulate;

use std::io::Write as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let matches = arguments::command().get_matches();
    let Some((name, given)) = matches.subcommand() else {
        return ExitCode::from(2);
    };
    let output = match name {
        "show" => show::run(given),
        "check" => check::run(given),
        "generate" => generate::run(given),
        "simulate" => simulate::run(given),
        "inverse" => inverse::run(given),
        "measure" => measure::run(given),
        _ => Ok(arguments::completions(given)),
    };
    match output {
        Ok(text) => {
            // Whoever reads the output may have read enough.
            let _ = std::io::stdout().write_all(text.as_bytes());
            ExitCode::SUCCESS
        }
        Err(failure) => {
            let _ = std::io::stdout().write_all(failure.output.as_bytes());
            let _ = writeln!(std::io::stderr(), "{}", failure.message);
            ExitCode::from(failure.status)
        }
    }
}
