//! The subcommands, with an example of each.

use clap::{ArgAction, ArgGroup, Command};

use super::options::{
    choice, count, functions, number, number_between, of_a_file, out, path, plot, pose, torque,
    vector, words,
};
use crate::convert::WITHOUT;

/// The subcommands about a robot file.
pub(super) fn all() -> Vec<Command> {
    vec![
        show(),
        check(),
        generate(),
        evaluate(),
        simulate(),
        inverse(),
        reach(),
        measure(),
        convert(),
        page(),
        lint(),
    ]
}

/// The help on the list of functions if a subcommand knows which ones it needs.
const BESIDES: &str = "The functions, in place of the file's: their names are checked, and what is needed here is derived";

fn show() -> Command {
    of_a_file("show", "Print the table, what the functions are and cost, and their formulas")
        .long_about(
            "Print the table, or the joints of a URDF file as it places them. Then print for each function what it is, \
             its units, its operations, which entries are zero or constant and on what the others depend. The formulas \
             of arms of up to three joints follow. With --format, print the formulas alone, of arms of any length. \
             Formulas of more than --terms terms are not printed, nor those that take too long to multiply out: a \
             sentence names them. Names in the file's cells that have no value are fields: they are listed first, and \
             kept in the formulas.",
        )
        .arg(functions())
        .arg(choice("format", "FORMAT", ["text", "latex", "mathml"]).help("Print formulas alone, in this format"))
        .arg(count("terms", "1000", 1, 100_000, "The most terms of a formula that is printed"))
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics show two_link.toml\n  \
             robot-dynamics show scara.toml --functions mass_matrix --format latex --out scara.tex",
        )
}

fn check() -> Command {
    of_a_file("check", "Compare every function with numeric Newton-Euler, and with another file")
        .long_about(
            "Compare every function with the numeric Newton-Euler algorithm on the raw table. With --against, compare \
             M, V, G, tau and the pose of the tip, or the functions that --functions names, with another file besides. \
             So a table that somebody typed is compared with its source. The exit status is 1 where a difference is \
             too large.",
        )
        .arg(functions())
        .arg(path("against", "Another file of the same arm").long("against"))
        .arg(
            words("against-chain", "BASE,TIP")
                .requires("against")
                .help("The link at which the robot begins in the other file, and its tips, where they have other names there"),
        )
        .arg(count("samples", "100", 1, 1_000_000, "Random states"))
        .arg(
            number("tolerance", "Largest difference to the other file, relative to the largest entry")
                .default_value("1e-9"),
        )
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics check puma560.toml --functions default,jacobian\n  \
             robot-dynamics check carrying.toml --field load=2.5\n  \
             robot-dynamics check ur5.toml --against ur5.urdf --chain base_link,tool0 --gravity 0,0,-9.81",
        )
}

fn generate() -> Command {
    of_a_file("generate", "Write the functions as source code: Rust, C, JavaScript, Python, MATLAB or for CasADi")
        .long_about(
            "Write the functions as source code into the folder that --out names, and say which files. `rust` is the \
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
        )
        .arg(functions())
        .arg(
            choice("lang", "LANGUAGE", ["rust", "c", "js", "python", "matlab", "casadi"])
                .required(true)
                .help("The language"),
        )
        .arg(
            choice("scalar", "TYPE", ["double", "float"])
                .help("The numbers of C; `double` where this is left out"),
        )
        .arg(
            choice("sines", "LIBRARY", ["libm"])
                .help("Take the sines of C from its library and not from the source"),
        )
        .arg(
            clap::Arg::new("project")
                .long("project")
                .action(ArgAction::SetTrue)
                .help("Beside C write a header for C++, CMakeLists.txt and a test program"),
        )
        .arg(path("out", "The folder").long("out").default_value("."))
        .after_help(
            "Examples:\n  \
             robot-dynamics generate puma560.toml --lang rust --out src\n  \
             robot-dynamics generate panda.urdf --chain panda_link0,panda_link8 --ignore rest --gravity 0,0,-9.81 --lang c --scalar float --out firmware",
        )
}

fn evaluate() -> Command {
    of_a_file("evaluate", "Print the values of all functions at one state")
        .long_about(
            "Print the values of all functions at one state, in tables with the names of the joints. The poses of the \
             tip and of frames come first, then the functions that the file or --functions names. --at lists the \
             positions of the joints that move, then their velocities, then their accelerations. With N joints these \
             are N, 2 N or 3 N numbers, zeros where the list ends. --at may be given once for each of the three. On a \
             base that moves, velocities, accelerations and torques begin with six numbers of the base in its own \
             axes, linear before angular.",
        )
        .arg(functions())
        .arg(
            vector("at", "Positions, rad or m, then velocities, then accelerations; zeros where they are left out")
                .value_name("Q,...[,QD,...[,QDD,...]]")
                .action(ArgAction::Append),
        )
        .arg(pose("Where a base that moves is: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out"))
        .arg(torque())
        .arg(count("digits", "6", 1, 17, "Significant digits that are printed; 17 tell doubles apart"))
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics evaluate two_link.toml --at PI/2,-0.5\n  \
             robot-dynamics evaluate two_link.toml --at 0.3,1 --at 0,2 --at 0,0 --functions inverse_dynamics --digits 17",
        )
}

fn simulate() -> Command {
    of_a_file("simulate", "Move the arm, and write its motion as CSV")
        .long_about(
            "Move the arm under constant torques by Dormand and Prince's method, and write time, positions, \
             velocities, accelerations, torques and energies as CSV. Joints with dry friction stick; limits are passed \
             as if they were not there. On a base that moves, velocities and torques begin with six numbers of the \
             base in its own axes, linear before angular. The CSV then has the rotation of the base by rows and its \
             position.",
        )
        .arg(functions().help(BESIDES))
        .arg(pose("Where a base that moves is at the start: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out"))
        .arg(vector("from", "Positions at the start, rad or m; zeros where this is left out"))
        .arg(vector("velocity", "Velocities at the start, rad/s or m/s; zeros where this is left out"))
        .arg(torque())
        .arg(number("duration", "Time simulated, s").default_value("1"))
        .arg(count("samples", "101", 2, 10_000_000, "Rows of the output"))
        .arg(number_between("tolerance", 1e-15, 1.0, "Relative and absolute tolerance of a step").default_value("1e-9"))
        .arg(plot())
        .arg(out())
        .after_help("Example:\n  robot-dynamics simulate two_link.toml --from 0.5,-1 --duration 10 --out fall.csv --plot fall.svg")
}

fn inverse() -> Command {
    of_a_file("inverse-dynamics", "Find the torques of a motion, and write them as CSV")
        .visible_alias("inverse")
        .long_about(
            "Find the torques of a motion, and write time, positions, velocities, accelerations and torques as CSV. \
             The motion is cycloidal from --from to --to, or passes the rows of a CSV file. A row has a time and a \
             position of each joint. Cubic splines join the rows, at rest at both ends. A file that `simulate` wrote \
             also has the velocities and accelerations to pass. --at is one state, as `evaluate` takes it: a single \
             row.\n\n\
             On a base that moves, a file is one of `simulate`. With --to the base is held at --pose; with --at its \
             six velocities and accelerations come before those of the joints. The torques begin with the force on the \
             base and the moment about its origin, in its own axes: `base.fx` to `base.nz`.\n\n\
             --from and --to are positions of the joints. This is no inverse kinematics: `reach` finds the joint \
             positions of a pose of the tip.",
        )
        .arg(functions().help(BESIDES))
        .arg(vector("from", "Positions of the joints at the start of a cycloidal motion, rad or m; zeros where this is left out"))
        .arg(vector("to", "Positions of the joints at its end, rad or m: no pose of the tip"))
        .arg(
            path("waypoints", "A CSV file of times, s, and positions, rad or m")
                .long("waypoints")
                .conflicts_with_all(["from", "to", "duration"]),
        )
        .arg(
            vector("at", "One state: positions, rad or m, then velocities, then accelerations; zeros where they are left out")
                .value_name("Q,...[,QD,...[,QDD,...]]")
                .action(ArgAction::Append)
                .conflicts_with_all(["from", "duration", "samples", "plot"]),
        )
        .arg(
            pose("Where a base that moves is: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out")
                .conflicts_with("waypoints"),
        )
        .group(ArgGroup::new("motion").args(["to", "waypoints", "at"]).required(true))
        .arg(number("duration", "Time of a cycloidal motion, s").default_value("1"))
        .arg(count("samples", "101", 2, 10_000_000, "Rows of the output"))
        .arg(plot())
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics inverse-dynamics two_link.toml --to 1,-0.5 --duration 2\n  \
             robot-dynamics inverse-dynamics two_link.toml --waypoints path.csv --samples 1001 --out torques.csv",
        )
}

fn reach() -> Command {
    of_a_file("reach", "Find the positions of the joints at which the tip has a pose: inverse kinematics")
        .visible_alias("inverse-kinematics")
        .long_about(
            "Find the positions of the joints at which the tip, or a frame, has a pose: inverse kinematics. A table \
             lists all that are found, within the limits of the joints, the nearest to --from first. They are searched \
             for numerically, from --from and from random starts, the same in each run; more --starts find what few \
             starts lead to. Roll, pitch and yaw are turns about the fixed axes x, y and z, one after the other; \
             without them the rotation is free.\n\n\
             If no position was found, the exit status is 1, with the reason and the positions that came nearest.",
        )
        .arg(pose("Where the tip is to be: X,Y,Z,ROLL,PITCH,YAW, m and rad, or X,Y,Z alone").required(true))
        .arg(words("frame", "NAME").value_delimiter(None).help("The frame that is to be there, in place of the tip"))
        .arg(vector("from", "Positions at the start, rad or m; zeros where this is left out"))
        .arg(count("starts", "200", 1, 1_000_000, "How many descents there are"))
        .arg(count("digits", "6", 1, 17, "Significant digits that are printed; 17 tell doubles apart"))
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics reach puma560.toml --pose 0.4,0.1,0.2,0,PI/2,0\n  \
             robot-dynamics reach torso.toml --pose 0.3,0.5,0.1 --frame left_hand",
        )
}

fn measure() -> Command {
    of_a_file("measure", "Measure the time and the rounding error of each function on this machine")
        .long_about(
            "Measure each function on this machine: nanoseconds of a single evaluation and of a state in a batch, on \
             one core. The largest rounding error is against the same program in 31 digits, relative to the largest \
             entry. Programs are evaluated and not compiled: generated code takes a fraction of these times, with the \
             same errors.",
        )
        .arg(functions())
        .arg(out())
        .after_help("Example:\n  robot-dynamics measure puma560.toml --functions inverse_dynamics,mass_matrix")
}

fn convert() -> Command {
    of_a_file("convert", "Write the robot as another kind of file: TOML, JSON or URDF")
        .long_about(
            "Write the robot as another kind of file. A URDF file becomes a Denavit-Hartenberg table, a table becomes \
             URDF, or a table of the other convention. Positions keep their zeros and their signs. `base` and `tool` \
             have what four numbers a joint cannot say at the ends of the arm. Joints that are locked become parts of \
             the links before them. Numbers are exact where the file's are and angles are quarter turns, and rounded \
             to 25 digits where they are longer. `robot-dynamics check --against` compares the two files.",
        )
        .arg(functions().help("The functions that the table names"))
        .arg(choice("to", "FORMAT", ["toml", "json", "urdf"]).help(
            "The format; where this is left out that of the name of --out, or TOML for URDF and URDF for tables",
        ))
        .arg(
            choice("convention", "CONVENTION", ["standard", "modified"])
                .help("The convention of the table; where this is left out the file's, `modified` for URDF"),
        )
        .arg(
            choice("without", "WORD", WITHOUT)
                .value_delimiter(',')
                .action(ArgAction::Append)
                .help("Leave out what URDF has no words for: motors, springs, friction other than constant and viscous"),
        )
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics convert ur5.urdf --chain base_link,tool0 --gravity 0,0,-9.81 --convention standard --out ur5.toml\n  \
             robot-dynamics convert puma560.toml --without motor --out puma560.urdf",
        )
}

fn page() -> Command {
    of_a_file("page", "Write a page that shows the arm, and moves it")
        .long_about(
            "Write one HTML file that shows the arm in 3D with its table, M, V, G, tau and the pose of its tip at any \
             state. It plays prescribed and free motions, and plots them. It needs nothing besides: it works from a \
             disk, without a network, and on a phone. A base that moves is held at a pose, or moves freely: at first \
             it falls freely with a spin.",
        )
        .arg(functions().help(BESIDES))
        .mut_arg("field", |arg| {
            arg.help("A name in the file's cells that gets a slider, and its value at first; may be given several times")
        })
        .arg(pose("Where a base that moves is at the start: X,Y,Z,ROLL,PITCH,YAW, m and rad; zeros where this is left out"))
        .arg(vector("from", "Positions at the start, rad or m; zeros, or the middle of limits without zero, where this is left out"))
        .arg(vector("to", "Positions at the end of the prescribed motion, rad or m"))
        .arg(vector("velocity", "Velocities at the start of free motion, first the six of a base that moves. If this is left out: zeros, and a spin of such a base"))
        .arg(number_between("duration", 1e-3, 1e3, "Time of the motions, s").default_value("3"))
        .arg(out())
        .after_help(
            "Examples:\n  \
             robot-dynamics page puma560.toml --out puma560.html\n  \
             robot-dynamics page two_link.toml --field m1=3 --field l1=0.5 --out two_link.html",
        )
}

fn lint() -> Command {
    Command::new("lint")
        .about("Find what is wrong or doubtful in robot files, by rules with names")
        .long_about(
            "Find what is wrong or doubtful in robot files: first all that other commands refuse. Then rules of files \
             alone look for an effort of 0, an inertia far from the geometry of its link, or two sides that differ by a \
             digit, for example. \
             Each line has a place, `error`, `warning` or `note`, and the name of the rule in brackets, behind which the \
             remedy stands. With --format json they are a list of objects. The exit status is 1 if there is an error.\n\n\
             `.pre-commit-hooks.yaml` of the project has a hook for pre-commit. Meshes are not read.",
        )
        .arg(
            path("file", "The robots: files in TOML, JSON or URDF")
                .value_name("FILE")
                .num_args(1..)
                .required(true),
        )
        .arg(
            choice("format", "FORMAT", ["text", "json"])
                .default_value("text")
                .help("Lines of text, or a list in JSON"),
        )
        .after_help("Example:\n  robot-dynamics lint arm.urdf puma560.toml --format json")
}
