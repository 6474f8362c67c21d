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
mod inverse_dynamics;
mod lint;
mod load;
mod measure;
mod page;
mod progress;
mod reach;
mod show;
mod simulate;
mod spline;
mod state;
mod write;

use std::io::Write as _;
use std::process::ExitCode;

use clap::Parser as _;

use arguments::{CommandLine, FileOptions, Output, Subcommand};
use failure::Failure;
use write::put_out;

fn main() -> ExitCode {
    let (text, failure) = match output(&CommandLine::parse().subcommand) {
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
fn output(given: &Subcommand) -> Result<String, Failure> {
    let put = |file: &FileOptions, output: &Output, run: &dyn Fn() -> Result<String, Failure>| {
        put_out([&file.path], [&output.out, &None], run)
    };
    match given {
        Subcommand::Show(given) => put(&given.robot.file, &given.output, &|| show::run(given)),
        Subcommand::Check(given) => {
            let read = [&given.robot.file.path].into_iter().chain(&given.against);
            put_out(read, [&given.output.out, &None], || check::run(given))
        }
        Subcommand::Generate(given) => generate::run(given),
        Subcommand::Evaluate(given) => {
            put(&given.robot.file, &given.output, &|| evaluate::run(given))
        }
        Subcommand::Simulate(given) => {
            let written = [&given.output.text.out, &given.output.plot];
            put_out([&given.robot.file.path], written, || simulate::run(given))
        }
        Subcommand::InverseDynamics(given) => {
            let read = [&given.robot.file.path].into_iter().chain(&given.waypoints);
            let written = [&given.output.text.out, &given.output.plot];
            put_out(read, written, || inverse_dynamics::run(given))
        }
        Subcommand::Reach(given) => put(&given.file, &given.output, &|| reach::run(given)),
        Subcommand::Measure(given) => {
            put(&given.robot.file, &given.output, &|| measure::run(given))
        }
        Subcommand::Convert(given) => {
            put(&given.robot.file, &given.output, &|| convert::run(given))
        }
        Subcommand::Page(given) => put(&given.robot.file, &given.output, &|| page::run(given)),
        Subcommand::Lint(given) => lint::run(given),
        Subcommand::Completions(given) => put_out([], [&given.output.out, &None], || {
            Ok(arguments::completions(given))
        }),
    }
}
