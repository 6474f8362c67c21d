//! The options of each subcommand, and its help with an example.

use std::path::PathBuf;

use clap::ArgAction::{Append, Set};
use clap::{Arg, ArgGroup, Args};
use clap_complete::Shell;
use dynamics_codegen::files::Format as FileFormat;
use dynamics_export::Language;
use dynamics_symbolic::formula::Format;
use dynamics_symbolic::robot::Convention;

use super::options::{FileOptions, MotionOutput, Output, RobotOptions};
use super::values::{Kind as _, between, choice, count, numbers, positive, words};

/// The help on the list of functions if a subcommand knows which ones it needs.
const BESIDES: &str = "The functions, in place of the file's: their names are checked, and what is needed here is derived";

/// The parts of joints that URDF has no words for, as `convert` leaves them out.
pub(crate) const WITHOUT: [&str; 3] = ["motor", "spring", "friction"];

/// Gives an option another help.
fn helped(id: &str, help: &'static str) -> impl FnMut(Arg) -> Arg {
    move |option| match option.get_id() == id {
        true => option.help(help),
        false => option,
    }
}

#[derive(Args)]
#[command(
    about = "Print the table, what the functions are and cost, and their formulas",
    long_about = "Print the table, or the joints of a URDF file as it places them. Then print for each function what it is, \
        its units, its operations, which entries are zero or constant and on what the others depend. The formulas \
        of arms of up to three joints follow. With --format, print the formulas alone, of arms of any length. \
        Formulas of more than --terms terms are not printed, nor those that take too long to multiply out: a \
        sentence names them. --format json prints the joints and the functions, with operations and bounds of rounding errors, null \
        where there is none. Names in the file's cells that have no value are fields: they are listed first, and \
        kept in the formulas.",
    after_help = "Examples:\n  \
        robot-dynamics show two_link.toml\n  \
        robot-dynamics show scara.toml --functions mass_matrix --format latex --out scara.tex"
)]
pub(crate) struct Show {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// Print formulas alone, in this format, or functions with operations and rounding
    #[arg(long, value_parser = choice([
        ("text", Shown::Formulas(Format::Text)), ("latex", Shown::Formulas(Format::Latex)),
        ("mathml", Shown::Formulas(Format::MathMl)), ("json", Shown::Json),
    ]))]
    pub(crate) format: Option<Shown>,
    /// The most terms of a formula that is printed
    #[arg(long, kind = count("1000", 1, 100_000))]
    pub(crate) terms: usize,
    #[command(flatten)]
    pub(crate) output: Output,
}

/// A format of `show`.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shown {
    /// The formulas.
    Formulas(Format),
    /// The joints and the functions.
    Json,
}

#[derive(Args)]
#[command(
    about = "Compare every function with numeric Newton-Euler, and with another file",
    long_about = "Compare every function with the numeric Newton-Euler algorithm on the raw table. With --against, compare \
        M, V, G, tau and the pose of the tip, or the functions that --functions names, with another file besides. \
        So a table that somebody typed is compared with its source. The exit status is 1 where a difference is \
        too large.",
    after_help = "Examples:\n  \
        robot-dynamics check puma560.toml --functions default,jacobian\n  \
        robot-dynamics check carrying.toml --field load=2.5\n  \
        robot-dynamics check ur5.toml --against ur5.urdf --chain base_link,tool0 --gravity 0,0,-9.81"
)]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// Another file of the same arm
    #[arg(long, value_name = "PATH")]
    pub(crate) against: Option<PathBuf>,
    /// The link at which the robot begins in the other file, and its tips, where they have other names there
    #[arg(long, kind = words(Set, "BASE,TIP"), requires = "against")]
    pub(crate) against_chain: Vec<String>,
    /// Random states
    #[arg(long, kind = count("100", 1, 1_000_000))]
    pub(crate) samples: usize,
    /// Largest difference to the other file, relative to the largest entry
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = positive, default_value = "1e-9")]
    pub(crate) tolerance: f64,
    #[command(flatten)]
    pub(crate) output: Output,
}

#[derive(Args)]
#[command(
    about = "Write the functions as source code: Rust, C, JavaScript, Python, MATLAB or for CasADi",
    long_about = "Write the functions as source code into the folder that --out names, and say which files. `rust` is the \
        expansion of the macro `robot_dynamics!`, as a file of a crate that depends on `robot-dynamics`. It has a \
        struct with the name of the file, documented methods and the runtime's traits. `c` is C99, a header and a \
        source without dependencies, which are C++ and device code as well. It has sines of its own, with the \
        digits of Rust's. With --scalar float no operation is in double precision. `js` is an ES module. `python` \
        is a module for numpy, jax.numpy, torch, casadi and sympy; `matlab` is a file for each function, which \
        Octave runs too. `casadi` is a C file for `casadi.external`, with first derivatives of \
        `inverse_dynamics`, `forward_dynamics`, `bias_force` and `center_of_mass`, and second ones of \
        `inverse_dynamics`. The same file gives the same bytes each time.\n\n\
        Names in the file's cells that have no value are fields of the struct in Rust. In C and MATLAB they are \
        fields of a struct, in JavaScript and Python of an object, which is the first argument. For CasADi they \
        are a vector.",
    after_help = "Examples:\n  \
        robot-dynamics generate puma560.toml --lang rust --out src\n  \
        robot-dynamics generate panda.urdf --chain panda_link0,panda_link8 --ignore rest --gravity 0,0,-9.81 --lang c --scalar float --out firmware"
)]
pub(crate) struct Generate {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// The language
    #[arg(long, value_name = "LANGUAGE", value_parser = choice(Language::ALL.map(|language| (language.name(), language))))]
    pub(crate) lang: Language,
    /// The numbers of C; `double` where this is left out
    #[arg(long, value_name = "TYPE", value_parser = ["double", "float"])]
    pub(crate) scalar: Option<String>,
    /// Take the sines of C from its library and not from the source
    #[arg(long, value_name = "LIBRARY", value_parser = ["libm"])]
    pub(crate) sines: Option<String>,
    /// Beside C write a header for C++, CMakeLists.txt and a test program
    #[arg(long, conflicts_with = "no_batches")]
    pub(crate) project: bool,
    /// Write C without functions over columns of states
    #[arg(long)]
    pub(crate) no_batches: bool,
    /// The folder
    #[arg(long, value_name = "PATH", default_value = ".")]
    pub(crate) out: PathBuf,
}

#[derive(Args)]
#[command(
    about = "Print the values of all functions at one state",
    long_about = "Print the values of all functions at one state, in tables with the names of the joints. The poses of the \
        tip and of frames come first, then the functions that the file or --functions names. --at lists the \
        positions of the joints that move, then their velocities, then their accelerations. With N joints these \
        are N, 2 N or 3 N numbers, zeros where the list ends. --at may be given once for each of the three. On a \
        base that moves, velocities, accelerations and torques begin with six numbers of the base in its own \
        axes, linear before angular.",
    after_help = "Examples:\n  \
        robot-dynamics evaluate two_link.toml --at PI/2,-0.5\n  \
        robot-dynamics evaluate two_link.toml --at 0.3,1 --at 0,2 --at 0,0 --functions inverse_dynamics --digits 17"
)]
pub(crate) struct Evaluate {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// Positions, rad or m, then velocities, then accelerations; zeros where they are left out
    #[arg(long, kind = numbers(Append, "Q,...[,QD,...[,QDD,...]]"))]
    pub(crate) at: Vec<f64>,
    /// Where a base that moves is: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) pose: Vec<f64>,
    /// Torques and forces at the joints, N m or N; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) torque: Vec<f64>,
    /// Significant digits that are printed; 17 tell doubles apart
    #[arg(long, kind = count("6", 1, 17))]
    pub(crate) digits: usize,
    #[command(flatten)]
    pub(crate) output: Output,
}

#[derive(Args)]
#[command(
    about = "Move the arm, and write its motion as CSV",
    long_about = "Move the arm under constant torques by Dormand and Prince's method, and write time, positions, \
        velocities, accelerations, torques and energies as CSV. Joints with dry friction stick; limits are passed \
        as if they were not there. On a base that moves, velocities and torques begin with six numbers of the \
        base in its own axes, linear before angular. The CSV then has the rotation of the base by rows and its \
        position.",
    after_help = "Example:\n  robot-dynamics simulate two_link.toml --from 0.5,-1 --duration 10 --out fall.csv --plot fall.svg",
    mut_args(helped("functions", BESIDES))
)]
pub(crate) struct Simulate {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// Where a base that moves is at the start: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) pose: Vec<f64>,
    /// Positions at the start, rad or m; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) from: Vec<f64>,
    /// Velocities at the start, rad/s or m/s; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) velocity: Vec<f64>,
    /// Torques and forces at the joints, N m or N; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) torque: Vec<f64>,
    /// Time simulated, s
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = positive, default_value = "1")]
    pub(crate) duration: f64,
    /// Rows of the output
    #[arg(long, kind = count("101", 2, 10_000_000))]
    pub(crate) samples: usize,
    /// Relative and absolute tolerance of a step
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = between(1e-15, 1.0), default_value = "1e-9")]
    pub(crate) tolerance: f64,
    #[command(flatten)]
    pub(crate) output: MotionOutput,
}

#[derive(Args)]
#[command(
    about = "Find the torques of a motion, and write them as CSV",
    visible_alias = "inverse",
    long_about = "Find the torques of a motion, and write time, positions, velocities, accelerations and torques as CSV. \
        The motion is cycloidal from --from to --to, or passes the rows of a CSV file. A row has a time and a \
        position of each joint. Cubic splines join the rows, at rest at both ends. A file that `simulate` wrote \
        also has the velocities and accelerations to pass. --at is one state, as `evaluate` takes it: a single \
        row.\n\n\
        On a base that moves, a file is one of `simulate`. With --to the base is held at --pose; with --at its \
        six velocities and accelerations come before those of the joints. The torques begin with the force on the \
        base and the moment about its origin, in its own axes: `base.fx` to `base.nz`.\n\n\
        --from and --to are positions of the joints. This is no inverse kinematics: `reach` finds the joint \
        positions of a pose of the tip.",
    after_help = "Examples:\n  \
        robot-dynamics inverse-dynamics two_link.toml --to 1,-0.5 --duration 2\n  \
        robot-dynamics inverse-dynamics two_link.toml --waypoints path.csv --samples 1001 --out torques.csv",
    mut_args(helped("functions", BESIDES)),
    group(ArgGroup::new("motion").args(["to", "waypoints", "at"]).required(true))
)]
pub(crate) struct InverseDynamics {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// Positions of the joints at the start of a cycloidal motion, rad or m; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) from: Vec<f64>,
    /// Positions of the joints at its end, rad or m: no pose of the tip
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) to: Vec<f64>,
    /// A CSV file of times, s, and positions, rad or m
    #[arg(long, value_name = "PATH", conflicts_with_all = ["from", "to", "duration"])]
    pub(crate) waypoints: Option<PathBuf>,
    /// One state: positions, rad or m, then velocities, then accelerations; zeros where they are left out
    #[arg(
        long,
        kind = numbers(Append, "Q,...[,QD,...[,QDD,...]]"),
        conflicts_with_all = ["from", "duration", "samples", "plot"]
    )]
    pub(crate) at: Vec<f64>,
    /// Where a base that moves is: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."), conflicts_with = "waypoints")]
    pub(crate) pose: Vec<f64>,
    /// Time of a cycloidal motion, s
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = positive, default_value = "1")]
    pub(crate) duration: f64,
    /// Rows of the output
    #[arg(long, kind = count("101", 2, 10_000_000))]
    pub(crate) samples: usize,
    #[command(flatten)]
    pub(crate) output: MotionOutput,
}

#[derive(Args)]
#[command(
    about = "Find the positions of the joints at which the tip has a pose: inverse kinematics",
    visible_alias = "inverse-kinematics",
    long_about = "Find the positions of the joints at which the tip, or a frame, has a pose: inverse kinematics. A table \
        lists all that are found, within the limits of the joints, the nearest to --from first. They are searched \
        for numerically, from --from and from random starts, the same in each run; more --starts find what few \
        starts lead to. Roll, pitch and yaw are turns about the fixed axes x, y and z, one after the other; \
        without them the rotation is free.\n\n\
        If no position was found, the exit status is 1, with the reason and the positions that came nearest.",
    after_help = "Examples:\n  \
        robot-dynamics reach puma560.toml --pose 0.4,0.1,0.2,0,PI/2,0\n  \
        robot-dynamics reach torso.toml --pose 0.3,0.5,0.1 --frame left_hand"
)]
pub(crate) struct Reach {
    #[command(flatten)]
    pub(crate) file: FileOptions,
    /// Where the tip is to be: X,Y,Z,ROLL,PITCH,YAW, m and rad, or X,Y,Z alone
    #[arg(long, kind = numbers(Set, "X,Y,..."), required = true)]
    pub(crate) pose: Vec<f64>,
    /// The frame that is to be there, in place of the tip
    #[arg(long, value_name = "NAME")]
    pub(crate) frame: Option<String>,
    /// Positions at the start, rad or m; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) from: Vec<f64>,
    /// How many descents there are
    #[arg(long, kind = count("200", 1, 1_000_000))]
    pub(crate) starts: usize,
    /// Significant digits that are printed; 17 tell doubles apart
    #[arg(long, kind = count("6", 1, 17))]
    pub(crate) digits: usize,
    #[command(flatten)]
    pub(crate) output: Output,
}

#[derive(Args)]
#[command(
    about = "Measure the time and the rounding error of each function on this machine",
    long_about = "Measure each function on this machine: nanoseconds of a single evaluation and of a state in a batch, on \
        one core. The largest rounding error is against the same program in 31 digits, relative to the largest \
        entry. Programs are evaluated and not compiled: generated code takes a fraction of these times, with the \
        same errors.",
    after_help = "Example:\n  robot-dynamics measure puma560.toml --functions inverse_dynamics,mass_matrix"
)]
pub(crate) struct Measure {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    #[command(flatten)]
    pub(crate) output: Output,
}

#[derive(Args)]
#[command(
    about = "Write the robot as another kind of file: TOML, JSON or URDF",
    long_about = "Write the robot as another kind of file. A URDF file becomes a Denavit-Hartenberg table, a table becomes \
        URDF, or a table of the other convention. Positions keep their zeros and their signs. `base` and `tool` \
        have what four numbers a joint cannot say at the ends of the arm. Joints that are locked become parts of \
        the links before them. Numbers are exact where the file's are and angles are quarter turns, and rounded \
        to 25 digits where they are longer. `robot-dynamics check --against` compares the two files.",
    after_help = "Examples:\n  \
        robot-dynamics convert ur5.urdf --chain base_link,tool0 --gravity 0,0,-9.81 --convention standard --out ur5.toml\n  \
        robot-dynamics convert puma560.toml --without motor --out puma560.urdf",
    mut_args(helped("functions", "The functions that the table names"))
)]
pub(crate) struct Convert {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// The format; where this is left out that of the name of --out, or TOML for URDF and URDF for tables
    #[arg(long, value_name = "FORMAT", value_parser = choice([("toml", FileFormat::Toml), ("json", FileFormat::Json), ("urdf", FileFormat::Urdf)]))]
    pub(crate) to: Option<FileFormat>,
    /// The convention of the table; where this is left out the file's, `modified` for URDF
    #[arg(long, value_parser = choice([("standard", Convention::Standard), ("modified", Convention::Modified)]))]
    pub(crate) convention: Option<Convention>,
    /// Leave out what URDF has no words for: motors, springs, friction other than constant and viscous
    #[arg(long, value_name = "WORD", value_delimiter = ',', value_parser = WITHOUT)]
    pub(crate) without: Vec<String>,
    #[command(flatten)]
    pub(crate) output: Output,
}

#[derive(Args)]
#[command(
    about = "Write a page that shows the arm, and moves it",
    long_about = "Write one HTML file that shows the arm in 3D with its table, M, V, G, tau and the pose of its tip at any \
        state. It plays prescribed and free motions, and plots them. It needs nothing besides: it works from a \
        disk, without a network, and on a phone. A base that moves is held at a pose, or moves freely: at first \
        it falls freely with a spin.",
    after_help = "Examples:\n  \
        robot-dynamics page puma560.toml --out puma560.html\n  \
        robot-dynamics page two_link.toml --field m1=3 --field l1=0.5 --out two_link.html",
    mut_args(helped("functions", BESIDES)),
    mut_args(helped(
        "field",
        "A name in the file's cells that gets a slider, and its value at first; may be given several times",
    ))
)]
pub(crate) struct Page {
    #[command(flatten)]
    pub(crate) robot: RobotOptions,
    /// Where a base that moves is at the start: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) pose: Vec<f64>,
    /// Positions at the start, rad or m; zeros, or the middle of limits without zero, where this is left out
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) from: Vec<f64>,
    /// Positions at the end of the prescribed motion, rad or m
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) to: Vec<f64>,
    /// Velocities at the start of free motion, first the six of a base that moves. If this is left out: zeros, and a spin of
    /// such a base
    #[arg(long, kind = numbers(Set, "X,Y,..."))]
    pub(crate) velocity: Vec<f64>,
    /// Time of the motions, s
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = between(1e-3, 1e3), default_value = "3")]
    pub(crate) duration: f64,
    #[command(flatten)]
    pub(crate) output: Output,
}

#[derive(Args)]
#[command(
    about = "Find what is wrong or doubtful in robot files, by rules with names",
    long_about = "Find what is wrong or doubtful in robot files: first all that other commands refuse. Then rules of files \
        alone look for an effort of 0, an inertia far from the geometry of its link, or two sides that differ by a \
        digit, for example. \
        Each line has a place, `error`, `warning` or `note`, and the name of the rule in brackets, behind which the \
        remedy stands. With --format json they are a list of objects. The exit status is 1 if there is an error.\n\n\
        `.pre-commit-hooks.yaml` of the project has a hook for pre-commit. Meshes are not read.",
    after_help = "Example:\n  robot-dynamics lint arm.urdf puma560.toml --format json"
)]
pub(crate) struct Lint {
    /// The robots: files in TOML, JSON or URDF
    #[arg(value_name = "FILE", num_args = 1.., required = true, action = Set)]
    pub(crate) file: Vec<PathBuf>,
    /// Lines of text, or a list in JSON
    #[arg(long, value_parser = ["text", "json"], default_value = "text")]
    pub(crate) format: String,
}

#[derive(Args)]
#[command(
    about = "Print the completions of a shell, for its start-up file",
    after_help = "Example:\n  robot-dynamics completions bash > ~/.local/share/bash-completion/completions/robot-dynamics"
)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_name = "shell")]
    pub(crate) shell: Shell,
    #[command(flatten)]
    pub(crate) output: Output,
}
