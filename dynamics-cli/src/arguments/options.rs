//! Options that several subcommands have.

use std::path::PathBuf;

use clap::ArgAction::{Append, Set};
use clap::Args;
use clap::builder::PossibleValuesParser;
use dynamics_codegen::description::Allow;

use super::values::{Kind as _, robot_name, small_angle, svg, trimmed, words};

/// The heading of options about a file.
const ABOUT: &str = "About the file";

/// The file of a robot, and what it does not say.
#[derive(Args)]
pub(crate) struct FileOptions {
    /// The robot: a file in TOML, JSON or URDF
    #[arg(id = "file", value_name = "FILE")]
    pub(crate) path: PathBuf,
    /// The name of the robot, of its struct, of the files and functions that are written; that of the file where this is
    /// left out
    #[arg(long, help_heading = ABOUT, value_parser = robot_name)]
    pub(crate) name: Option<String>,
    /// The link of a URDF file at which the robot begins, and its tips; without tips all that the link carries. The whole
    /// tree of the file where this is left out
    #[arg(long, help_heading = ABOUT, kind = words(Set, "BASE,TIP"))]
    pub(crate) chain: Vec<String>,
    /// Acceleration of gravity, m/s^2, in place of the file's; a URDF file has none
    #[arg(long, help_heading = ABOUT, kind = words(Set, "X,Y,Z"), allow_hyphen_values = true)]
    pub(crate) gravity: Vec<String>,
    /// The base moves: the root link of a URDF file is its body. All but `reach` know such robots
    #[arg(long, help_heading = ABOUT, value_parser = ["floating"])]
    pub(crate) base: Option<String>,
    /// The value of a name in the file's cells, such as load=2.5; may be given several times. `show` and `generate` keep
    /// names without a value
    #[arg(long, help_heading = ABOUT, value_name = "NAME=VALUE", value_parser = trimmed)]
    pub(crate) field: Vec<String>,
    /// Joints that stand still, rad or m, beside those that the file locks; `rest` as for --ignore
    #[arg(long, help_heading = ABOUT, kind = words(Append, "JOINT=POSITION"))]
    pub(crate) lock: Vec<String>,
    /// Joints of a URDF file that are left out, with all that hangs on them; `rest` is all beside the chain that are not
    /// named
    #[arg(long, help_heading = ABOUT, kind = words(Append, "JOINT"))]
    pub(crate) ignore: Vec<String>,
    /// The largest distance at which an angle or axis of a URDF file is taken for a multiple of a quarter turn, such as
    /// 1e-4
    #[arg(long, help_heading = ABOUT, value_name = "RAD", value_parser = small_angle)]
    pub(crate) round_angles: Option<f64>,
    /// How bounds of rounding are found: `tight` cuts the ranges of the joints into parts, for up to a second a function
    #[arg(long, help_heading = ABOUT, value_parser = ["tight"])]
    pub(crate) bounds: Option<String>,
    /// Accept what is refused otherwise, anywhere in the file
    #[arg(long, help_heading = ABOUT, value_name = "WORD", value_delimiter = ',', num_args = 1, value_parser = PossibleValuesParser::new(Allow::WORDS))]
    pub(crate) allow: Vec<String>,
}

/// A robot, and which of its functions are meant.
#[derive(Args)]
pub(crate) struct RobotOptions {
    #[command(flatten)]
    pub(crate) file: FileOptions,
    /// The functions, in place of the file's; `default` is the set of a file that names none
    #[arg(long, kind = words(Append, "A,B,C"))]
    pub(crate) functions: Vec<String>,
}

/// Where a text goes.
#[derive(Args)]
pub(crate) struct Output {
    /// The file that is written; standard output where this is left out
    #[arg(long, value_name = "PATH")]
    pub(crate) out: Option<PathBuf>,
}

/// Where a motion goes.
#[derive(Args)]
pub(crate) struct MotionOutput {
    /// Draw the motion as curves over time into this file too, as SVG
    #[arg(long, value_name = "PATH", value_parser = svg())]
    pub(crate) plot: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) text: Output,
}
