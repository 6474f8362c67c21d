//! The command line.

mod options;
mod subcommands;
mod values;

use clap::{CommandFactory as _, Parser};

pub(crate) use options::{FileOptions, Output, RobotOptions};
pub(crate) use subcommands::*;

/// The whole command.
#[derive(Parser)]
#[command(
    name = "robot-dynamics",
    version,
    about = "Equations of motion of a robot: shown, checked, generated and run",
    long_about = "Equations of motion of a robot: shown, checked, generated and run.\n\n\
        A robot FILE is a Denavit-Hartenberg table in TOML, in the words of the macro `robot_dynamics!`, or in \
        JSON. It may also be a URDF file, the whole of it or the arm between two links that --chain names. Its \
        functions are derived and proven equal to the textbook Lagrangian each time. SI units, radians. Numbers \
        of options may be values, such as PI/2 or deg(90).\n\n\
        Mistakes in a file are written to standard error as FILE:LINE:COLUMN: what is wrong, what was expected. \
        The exit status is 0, 1 if something is wrong with the file or the robot, 2 if the command line is wrong.",
    after_help = "Examples:\n  \
        robot-dynamics show puma560.toml\n  \
        robot-dynamics show panda.urdf --chain panda_link0,panda_link8 --ignore rest --gravity 0,0,-9.81\n  \
        robot-dynamics convert panda.urdf --chain panda_link0,panda_link8 --ignore rest --gravity 0,0,-9.81 --out panda.toml"
)]
pub(crate) struct CommandLine {
    #[command(subcommand)]
    pub(crate) subcommand: Subcommand,
}

/// The subcommand that is called, with its options.
#[derive(clap::Subcommand)]
pub(crate) enum Subcommand {
    Show(Show),
    Check(Check),
    Generate(Generate),
    Evaluate(Evaluate),
    Simulate(Simulate),
    InverseDynamics(InverseDynamics),
    Reach(Reach),
    Measure(Measure),
    Convert(Convert),
    Page(Page),
    Lint(Lint),
    Completions(Completions),
}

/// The text of `completions`.
pub(crate) fn completions(given: &Completions) -> String {
    let mut text = Vec::new();
    let mut command = CommandLine::command();
    clap_complete::generate(given.shell, &mut command, "robot-dynamics", &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    #[test]
    fn the_command_line_is_consistent() {
        super::CommandLine::command().debug_assert();
    }
}
