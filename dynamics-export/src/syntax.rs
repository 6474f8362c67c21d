//! How a language says what differs between languages, and texts that several have in common.

use dynamics_symbolic::robot::Robot;

/// An angle of a function, with the names of its sine and of its cosine, where they are read.
pub(crate) struct Angle {
    pub(crate) value: String,
    pub(crate) sine: Option<String>,
    pub(crate) cosine: Option<String>,
}

/// Statements for all angles of a function.
pub(crate) type OfAngles = fn(&[Angle]) -> Vec<String>;

/// How a language says what differs between languages.
#[derive(Clone, Copy)]
pub(crate) struct Syntax {
    /// The statement that gives a number that is computed its name.
    pub(crate) declare: fn(&str, &str) -> String,
    /// How an entry of an argument is read, counted from 0.
    pub(crate) entry: fn(&str, usize) -> String,
    /// The literal of a number.
    pub(crate) number: fn(f64) -> String,
    /// Whether numbers are of single precision.
    pub(crate) is_single: bool,
    /// The operators between two numbers, with the spaces around them.
    pub(crate) times: &'static str,
    pub(crate) over: &'static str,
    /// How a field of the robot is read.
    pub(crate) field: fn(&str) -> String,
    /// The functions of a number.
    pub(crate) sine: &'static str,
    pub(crate) cosine: &'static str,
    /// The statements that give the sines and cosines of all angles their names, where these are evaluated together.
    pub(crate) of_angles: Option<OfAngles>,
    /// The function that multiplies and adds, rounded once where the processor has an instruction for it.
    pub(crate) fused: Option<&'static str>,
    pub(crate) exponential: &'static str,
    pub(crate) sign: &'static str,
    /// The statement that ends a function unless the pivot of a joint is good beside the diagonal entry.
    pub(crate) test_pivot: fn(usize, &str, &str) -> String,
    /// How a call of an own function begins, and the text of that function. One that several calls need follows itself.
    pub(crate) own_functions: &'static [(&'static str, &'static str)],
}

impl Syntax {
    /// The statements that give the sine and the cosine of an angle their names.
    pub(crate) fn sine_and_cosine(&self, value: &str, [sine, cosine]: [&str; 2]) -> Vec<String> {
        let declare = |name, function| (self.declare)(name, &format!("{function}({value})"));
        match self.of_angles {
            Some(write) => write(&[Angle {
                value: value.to_owned(),
                sine: Some(sine.to_owned()),
                cosine: Some(cosine.to_owned()),
            }]),
            None => vec![declare(sine, self.sine), declare(cosine, self.cosine)],
        }
    }

    /// The own functions that some text calls.
    pub(crate) fn called(&self, text: &str) -> String {
        let own_functions = self.own_functions.iter();
        let called = own_functions.filter(|(call, _)| text.contains(call));
        let mut functions: Vec<&str> = called.map(|(_, function)| *function).collect();
        functions.dedup();
        functions.concat()
    }
}

/// The first six pivots of M on a base that moves, in double quotes.
pub(crate) const PIVOTS_OF_BASE: &str =
    "\"base vx\", \"base vy\", \"base vz\", \"base wx\", \"base wy\", \"base wz\"";

/// Functions of a module, in which an error names the pivot of M that failed: those of a base that moves are counted before
/// the joints, by `all`.
pub(crate) fn with_pivots_of_base(robot: &Robot, functions: String, all: &str) -> String {
    match robot.freedoms().has_base() {
        true => functions.replace("JOINT_NAMES[joint]", &format!("{all}[joint]")),
        false => functions,
    }
}

/// Lines of text behind so many spaces each.
pub(crate) fn indented(lines: &[String], spaces: usize) -> String {
    let lines = lines.iter();
    lines
        .map(|line| format!("{:spaces$}{line}\n", ""))
        .collect()
}
