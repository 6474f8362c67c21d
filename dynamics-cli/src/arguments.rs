//! The command line.

use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use clap_complete::Shell;

/// The whole command.
pub(crate) fn command() -> Command {
    Command::new("robot-dynamics")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Equations of motion of a robot arm: shown, checked, generated and run")
        .long_about(
            "Equations of motion of a robot arm: shown, checked, generated and run.\n\n\
             A robot FILE is a Denavit-Hartenberg table in TOML, in the words of the macro `robot_dynamics!`, or in \
             JSON. Its functions are derived and proven equal to the textbook Lagrangian each time. SI units, \
             radians.\n\n\
             Mistakes in a file are told on standard error as FILE:LINE:COLUMN: what is wrong, what was expected. The \
             exit status is 0, 1 where something is wrong with the file or the robot, 2 where the command line is.",
        )
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(show())
        .subcommand(check())
        .subcommand(generate())
        .subcommand(simulate())
        .subcommand(inverse())
        .subcommand(measure())
        .subcommand(
            Command::new("completions")
                .about("Print the completions of a shell, for its start-up file")
                .arg(Arg::new("shell").required(true).value_parser(value_parser!(Shell))),
        )
}

/// The text of `completions`.
pub(crate) fn completions(given: &ArgMatches) -> String {
    let mut text = Vec::new();
    if let Some(shell) = given.get_one::<Shell>("shell") {
        clap_complete::generate(*shell, &mut command(), "robot-dynamics", &mut text);
    }
    String::from_utf8_lossy(&text).into_owned()
}

fn show() -> Command {
    of_a_file("show", "Print the table, what the functions are and cost, or their formulas")
        .long_about(
            "Print the table and, of each function, what it is, its units, its operations, which of its entries are \
             zero or constant and on what the others depend, and the formulas of small arms. With --format, print the \
             formulas alone, of up to --terms terms each.",
        )
        .arg(functions())
        .arg(
            Arg::new("format")
                .long("format")
                .value_name("FORMAT")
                .value_parser(PossibleValuesParser::new(["text", "latex", "mathml"]))
                .help("Print formulas in this format"),
        )
        .arg(
            number("terms", "The most terms of a formula that is printed")
                .default_value("100")
                .value_parser(value_parser!(u32).range(1..=10_000))
                .requires("format"),
        )
}

fn check() -> Command {
    of_a_file("check", "Compare every function with numeric Newton-Euler, and with another file")
        .long_about(
            "Compare every function with the numeric Newton-Euler algorithm on the raw table, and, with --against, M, \
             V, G and tau with those of another file: the table that somebody typed with the one it came from. The exit \
             status is 1 where a difference is too large.",
        )
        .arg(functions())
        .arg(file("against", "Another file of the same arm").long("against"))
        .arg(number("samples", "Random states").default_value("100").value_parser(value_parser!(u32).range(1..=1_000_000)))
        .arg(
            number("tolerance", "Largest difference to the other file, relative to the largest entry")
                .default_value("1e-9"),
        )
}

fn generate() -> Command {
    of_a_file("generate", "Write the functions in another language")
        .long_about(
            "Write the functions in another language, into the folder that --out names: C99 (a header and a source \
             without dependencies, which are C++ and device code as well), or JavaScript (an ES module).",
        )
        .arg(functions())
        .arg(
            Arg::new("lang")
                .long("lang")
                .required(true)
                .value_name("LANGUAGE")
                .value_parser(PossibleValuesParser::new(["c", "js"]))
                .help("The language"),
        )
        .arg(file("out", "The folder").long("out").default_value("."))
}

fn simulate() -> Command {
    of_a_file("simulate", "Move the arm, and write its motion as CSV")
        .long_about(
            "Move the arm under constant torques by Dormand and Prince's method, and write time, positions, velocities \
             and energy as CSV. Joints with dry friction stick.",
        )
        .arg(vector("from", "Positions at the start; zeros where this is left out"))
        .arg(vector("velocity", "Velocities at the start"))
        .arg(vector("torque", "Torques and forces at the joints"))
        .arg(number("duration", "Time simulated, s").default_value("1"))
        .arg(number("samples", "Rows of the output").default_value("101").value_parser(value_parser!(u32).range(2..=10_000_000)))
        .arg(number("tolerance", "Relative and absolute tolerance of a step").default_value("1e-9"))
        .arg(out())
}

fn inverse() -> Command {
    of_a_file("inverse", "Find the torques of a motion, and write them as CSV")
        .long_about(
            "Find the torques of a motion, and write time, positions, velocities, accelerations and torques as CSV. The \
             motion is cycloidal from --from to --to, or passes the rows of a CSV file: a time and a position of each joint, \
             joined by cubic splines at rest at both ends.",
        )
        .arg(vector("from", "Positions at the start of a cycloidal motion; zeros where this is left out"))
        .arg(vector("to", "Positions at its end").required_unless_present("waypoints"))
        .arg(file("waypoints", "A CSV file of times and positions").long("waypoints").conflicts_with_all(["from", "to", "duration"]))
        .arg(number("duration", "Time of a cycloidal motion, s").default_value("1"))
        .arg(number("samples", "Rows of the output").default_value("101").value_parser(value_parser!(u32).range(2..=10_000_000)))
        .arg(out())
}

fn measure() -> Command {
    of_a_file("measure", "Measure the time and the rounding error of each function on this machine")
        .long_about(
            "Measure each function on this machine: nanoseconds of a single evaluation and of a state in a batch, on one \
             core, and the largest error of rounding, against the same program in 31 digits, relative to the largest entry. \
             Programs are evaluated and not compiled: generated code takes a fraction of these times, with the same errors.",
        )
        .arg(functions())
}

fn of_a_file(name: &'static str, about: &'static str) -> Command {
    Command::new(name)
        .about(about)
        .arg(
            file("file", "The robot: a file in TOML, JSON or URDF")
                .required(true)
                .value_name("FILE"),
        )
        .arg(
            Arg::new("gravity")
                .long("gravity")
                .value_name("X,Y,Z")
                .value_delimiter(',')
                .num_args(1)
                .allow_hyphen_values(true)
                .help("Acceleration of gravity, m/s^2, in place of the file's"),
        )
        .arg(
            Arg::new("lock")
                .long("lock")
                .value_name("JOINT=POSITION")
                .action(ArgAction::Append)
                .help("A joint that stands still, rad or m; may be given several times"),
        )
        .arg(
            Arg::new("chain")
                .long("chain")
                .value_name("BASE,TIP")
                .value_delimiter(',')
                .num_args(1)
                .help("The first and the last link of the arm in a URDF file"),
        )
        .arg(
            Arg::new("ignore")
                .long("ignore")
                .value_name("JOINT")
                .action(ArgAction::Append)
                .help("A joint of a URDF file that is left out, with all that hangs on it; may be given several times"),
        )
        .arg(
            Arg::new("round-angles")
                .long("round-angles")
                .value_name("RAD")
                .value_parser(value_parser!(f64))
                .help("How near an angle of a URDF file is to a quarter turn that is taken as one, such as 1e-4"),
        )
}

fn functions() -> Arg {
    Arg::new("functions")
        .long("functions")
        .value_name("A,B,C")
        .value_delimiter(',')
        .help(
            "The functions, in place of the file's; `default` are those of a file that names none",
        )
}

fn file(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .value_name("PATH")
        .value_parser(value_parser!(PathBuf))
        .help(help)
}

fn out() -> Arg {
    file(
        "out",
        "The file that is written; standard output where this is left out",
    )
    .long("out")
}

fn number(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name("NUMBER")
        .allow_hyphen_values(true)
        .value_parser(value_parser!(f64))
        .help(help)
}

fn vector(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name("X,Y,...")
        .value_delimiter(',')
        .num_args(1)
        .allow_hyphen_values(true)
        .value_parser(value_parser!(f64))
        .help(help)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_command_line_is_consistent() {
        super::command().debug_assert();
    }
}
