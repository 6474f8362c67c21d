//! Functions in other languages beside their values in Rust, on every arm of the data files.
//!
//! The programs are the same. Products and sums are rounded alike, so that values are equal to the last
//! bit where sines and exponentials are: C has the sines in its source, and the engine that runs the module takes those
//! of Rust first. Then with those of their libraries, which may be off by a unit in the last place.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use dynamics_evaluation::{EvaluationError, RuntimeRobot, Value};
use dynamics_export::{CNumbers, CSource, c_source, c_source_in, javascript_module};
use dynamics_runtime::Scalar;
use dynamics_runtime::nalgebra::Rotation3;
use dynamics_symbolic::mechanism::Mechanism;
use dynamics_symbolic::robot::{Frame, Placement, Robot};
use dynamics_symbolic::{Function, Proven, Request, proven_program};

use crate::{arrays, generated};

/// States at which functions are called.
pub(super) const STATES: usize = 5;

/// A bound on errors where sines are those of another library: of values relative to the largest entry.
/// The arms' condition numbers stay below 1e5.
const OF_OTHER_SINES: f64 = 1e-10;

/// Whether this build fuses products with sums, as C does for the same processor and other languages do not: their last
/// digits differ.
pub(super) const IS_FUSED: bool = cfg!(target_feature = "fma");

/// The arms whose functions are called with the sines of other libraries too.
pub(super) const OF_OTHER_LIBRARIES: [&str; 3] = ["panda", "puma560", "scene"];

/// An arm, its programs, and the states at which they are called.
pub(super) struct Case {
    pub(super) arm: RuntimeRobot,
    pub(super) programs: Vec<(Request, Proven)>,
    pub(super) angles: Vec<f64>,
    pub(super) exponents: Vec<f64>,
    /// Whether these are all angles and exponents, so that tables of their sines and exponentials stand for libraries.
    pub(super) has_tables: bool,
}

impl Case {
    pub(super) fn new<R: Into<Request>>(
        robot: Robot,
        fields: &[f64],
        functions: impl IntoIterator<Item = R>,
    ) -> Self {
        let programs = functions.into_iter().map(|request| {
            let request: Request = request.into();
            let program = proven_program(&robot, &request).expect("proven");
            (request, program)
        });
        let programs = programs.collect();
        let mut case = Case::of_programs(robot, fields, programs);
        case.tabulate(fields);
        case
    }

    /// A case without tables.
    pub(super) fn of_programs(
        robot: Robot,
        fields: &[f64],
        programs: Vec<(Request, Proven)>,
    ) -> Self {
        let mut arm = RuntimeRobot::of_programs(robot, &programs).expect("an arm");
        arm.set_fields(fields).expect("a value for each field");
        Case {
            arm,
            programs,
            angles: Vec::new(),
            exponents: Vec::new(),
            has_tables: false,
        }
    }

    fn tabulate(&mut self, fields: &[f64]) {
        let joints = self.arm.dof();
        let of_axes = |name: &str| -> Vec<f64> {
            let states = (0..STATES).map(|state| argument(name, joints, state));
            states
                .flat_map(|entries| {
                    Mechanism::from(self.arm.robot()).with_followers(&entries, fields)
                })
                .collect()
        };
        let mut angles = of_axes("q");
        angles.extend(fields);
        let exponents = match fields.last() {
            Some(slow) => of_axes("qd")
                .into_iter()
                .map(|qd| -((qd / slow) * (qd / slow)))
                .collect(),
            None => Vec::new(),
        };
        (self.angles, self.exponents, self.has_tables) = (angles, exponents, true);
    }

    pub(super) fn arguments(
        &self,
        request: &Request,
        state: usize,
    ) -> Vec<(&'static str, Vec<f64>)> {
        let arguments = self.arm.arguments(request.name()).expect("a function");
        let entries = arguments.map(|(name, count)| (name, argument(name, count, state)));
        entries.collect()
    }

    /// The values of Rust: a line for each call, as the programs print it.
    fn expected(&self) -> Vec<Result<Vec<f64>, usize>> {
        let calls = self.programs.iter().flat_map(|(request, _)| {
            (0..STATES).map(move |state| {
                let arguments = self.arguments(request, state);
                let slices: Vec<&[f64]> = arguments.iter().map(|(_, x)| x.as_slice()).collect();
                match self.arm.evaluate(request.name(), &slices) {
                    Ok(value) => Ok(by_rows(&value)),
                    Err(EvaluationError::Singular { error, .. }) => Err(error.joint),
                    Err(error) => panic!("{error}"),
                }
            })
        });
        calls.collect()
    }
}

/// Not finite at the last state: functions that solve with M refuse it.
fn argument(name: &str, count: usize, state: usize) -> Vec<f64> {
    if name == "base" {
        return base(state);
    }
    let seed = name.len() * 5 + usize::from(name.as_bytes()[0]);
    let entry = |i: usize| match (state, name) {
        (0, "qd") => 0.0,
        (4, "q") if i + 1 == count => f64::INFINITY,
        _ => 2.0 * ((seed + 11 * state + 3 * i) as f64).sin(),
    };
    (0..count).map(entry).collect()
}

/// Where a base that moves stands: a rotation by rows, then a position.
fn base(state: usize) -> Vec<f64> {
    let [roll, pitch, yaw, x, y, z] = [0, 1, 2, 3, 4, 5].map(|i| (1 + 7 * state + i) as f64);
    let rotation = Rotation3::from_euler_angles(roll, pitch, yaw);
    let by_rows = rotation.matrix().transpose();
    let position = [x, y, z].map(f64::sin);
    by_rows.iter().copied().chain(position).collect()
}

pub(super) fn by_rows(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(x) => vec![*x],
        Value::Matrix(matrix) => matrix.transpose().iter().copied().collect(),
        Value::Each(values) | Value::Tuple(values) => values.iter().flat_map(by_rows).collect(),
    }
}

/// A folder for the files of a test.
pub(super) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

pub(super) use arms::is_installed as is_there;

#[track_caller]
pub(super) fn run(command: &mut Command) -> String {
    let output = command.output().expect("a program that runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// Lines of the bits of values, or of the joint of a refusal.
fn printed(text: &str) -> Vec<Result<Vec<f64>, usize>> {
    let bits = |word: &str| f64::from_bits(u64::from_str_radix(word, 16).expect("bits"));
    let line = |line: &str| match line.strip_prefix("singular ") {
        Some(joint) => Err(joint.parse::<usize>().expect("a joint")),
        None => Ok(line.split_whitespace().map(bits).collect()),
    };
    text.lines().map(line).collect()
}

#[track_caller]
pub(super) fn assert_same(found: &str, case: &Case, label: &str, is_rounded_otherwise: bool) {
    let (found, expected) = (printed(found), case.expected());
    assert_eq!(found.len(), expected.len(), "{label}");
    let names = case
        .programs
        .iter()
        .flat_map(|(request, _)| [request.name(); STATES]);
    for ((found, expected), name) in found.iter().zip(&expected).zip(names) {
        let (found, expected) = match (found, expected) {
            (Ok(found), Ok(expected)) => (found, expected),
            (found, expected) => {
                assert_eq!(found, expected, "{name} of {label}");
                continue;
            }
        };
        assert_eq!(found.len(), expected.len(), "{name} of {label}");
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (found, expected) in found.iter().zip(expected) {
            let is_near = is_rounded_otherwise && (found - expected).abs() <= OF_OTHER_SINES * size;
            let is_same = found.to_bits() == expected.to_bits() || is_near;
            let both_nan = found.is_nan() && expected.is_nan();
            assert!(
                is_same || both_nan,
                "{name} of {label}: {found:e} {expected:e}"
            );
        }
    }
}

/// A double as C reads it.
fn c_number(x: f64) -> String {
    match x.is_finite() {
        true => format!("{x:?}"),
        false => "(1.0 / 0.0)".to_owned(),
    }
}

/// An array of doubles as C reads it: one zero where there are no entries, for no array of C is without.
fn c_array(entries: &[f64]) -> String {
    let entries: Vec<_> = entries.iter().map(|x| c_number(*x)).collect();
    match &entries[..] {
        [] => "{0}".to_owned(),
        entries => format!("{{{}}}", entries.join(", ")),
    }
}

/// A program that calls every function at every state and prints the bits of what it writes.
fn c_program(case: &Case, name: &str, header: &str) -> String {
    let mut text = format!("#include \"{name}.h\"\n#include <stdio.h>\n#include <string.h>\n");
    text.push_str(
        "static void print(const double *x, int count) {\n    for (int i = 0; i < count; i++) {\n        \
         unsigned long long bits;\n        memcpy(&bits, &x[i], 8);\n        printf(\"%016llx \", bits);\n    }\n}\n\
         int main(void) {\n",
    );
    let fields = case.arm.fields();
    if !fields.is_empty() {
        let fields: Vec<_> = fields.iter().map(|x| c_number(*x)).collect();
        let _ = writeln!(
            text,
            "    const {name}_fields arm = {{{}}};",
            fields.join(", ")
        );
    }
    for (request, _) in &case.programs {
        for state in 0..STATES {
            text.push_str("    {\n");
            let mut arguments = Vec::new();
            if !fields.is_empty() {
                arguments.push("&arm".to_owned());
            }
            for (argument, entries) in case.arguments(request, state) {
                let _ = writeln!(
                    text,
                    "    const double {argument}[] = {};",
                    c_array(&entries)
                );
                arguments.push(argument.to_owned());
            }
            let function = request.name();
            let parts = c_parts(name, request, header);
            if parts.is_empty() {
                let _ = writeln!(
                    text,
                    "    const double value = {name}_{function}({});\n    print(&value, 1);",
                    arguments.join(", ")
                );
            } else {
                for (part, dimensions) in &parts {
                    let _ = writeln!(text, "    double {part}_value{dimensions};");
                    arguments.push(format!("{}{part}_value", pointer(dimensions)));
                }
                let call = format!("{name}_{function}({})", arguments.join(", "));
                let print: Vec<_> = parts
                    .iter()
                    .map(|(part, dimensions)| {
                        let pointer = pointer(dimensions);
                        format!(
                            "print((const double *){pointer}{part}_value, (int)(sizeof {part}_value / 8));"
                        )
                    })
                    .collect();
                let print = print.join(" ");
                match request.refuses() {
                    true => {
                        let _ = writeln!(
                            text,
                            "    const int code = {call};\n    if (code) printf(\"singular %d\", code - 1); else {{ {print} }}"
                        );
                    }
                    false => {
                        let _ = writeln!(text, "    {call};\n    {print}");
                    }
                }
            }
            text.push_str("    printf(\"\\n\");\n    }\n");
        }
    }
    for (request, _) in &case.programs {
        text.push_str(&c_batch(case, name, request, header));
    }
    text.push_str("    return 0;\n}\n");
    text
}

/// States of a batch: more than a block of them, and no whole number of lanes.
const MANY: usize = 131;

/// Statements that compare a function at many states, a column for each entry, with the same function at one state after
/// the other, to the last bit; `main` fails where they differ.
fn c_batch(case: &Case, name: &str, request: &Request, header: &str) -> String {
    let function = request.name();
    let mut text = format!("    {{\n    size_t first = 0;\n    enum {{ many = {MANY} }};\n");
    let fields = (!case.arm.fields().is_empty()).then(|| "&arm".to_owned());
    let (mut one, mut all): (Vec<_>, Vec<_>) = (
        fields.iter().cloned().collect(),
        fields.into_iter().collect(),
    );
    let states: Vec<_> = (0..STATES)
        .map(|state| case.arguments(request, state))
        .collect();
    for (at, (argument, entries)) in states[0].iter().enumerate() {
        let count = entries.len();
        // No array of C is without entries.
        let count = count.max(1);
        let rows = states.iter().map(|arguments| c_array(&arguments[at].1));
        let rows = rows.collect::<Vec<_>>().join(", ");
        let _ = writeln!(
            text,
            "    const double {argument}_states[{STATES}][{count}] = {{{rows}}};\n    \
             static double {argument}_columns[{count}][many];\n    const double *{argument}[{count}];\n    \
             for (int i = 0; i < {count}; i++) {{\n        {argument}[i] = {argument}_columns[i];\n        \
             for (int k = 0; k < many; k++) {argument}_columns[i][k] = {argument}_states[k % {STATES}][i];\n    }}"
        );
        one.push(format!("{argument}_states[k % {STATES}]"));
        all.push((*argument).to_owned());
    }
    let parts = c_parts(name, request, header);
    let is_number = parts.is_empty();
    let mut compare = String::new();
    for (part, dimensions) in if is_number {
        vec![(function.to_owned(), String::new())]
    } else {
        parts
    } {
        let count = dimensions
            .split(['[', ']'])
            .filter_map(|size| size.parse::<usize>().ok());
        let count: usize = count.product();
        if !is_number {
            let _ = writeln!(text, "    double {part}_value{dimensions};");
        }
        let _ = writeln!(
            text,
            "    static double {part}_columns[{count}][many];\n    double *{part}[{count}];\n    \
             for (int i = 0; i < {count}; i++) {part}[i] = {part}_columns[i];"
        );
        let pointer = pointer(&dimensions);
        let star = if dimensions.is_empty() { "*" } else { "" };
        all.push(format!("{star}{part}"));
        if !is_number {
            one.push(format!("{pointer}{part}_value"));
        }
        let _ = writeln!(
            compare,
            "        for (int i = 0; i < {count}; i++) {{\n            \
             const double x = ((const double *){pointer}{part}_value)[i], y = {part}_columns[i][k];\n            \
             if (memcmp(&x, &y, 8) && (x == x || y == y)) return fprintf(stderr, \"{function} %d\\n\", k), 1;\n        }}"
        );
    }
    all.push("many".to_owned());
    let (one, all) = (one.join(", "), all.join(", "));
    let _ = if request.refuses() {
        writeln!(text, "    first = {name}_{function}_batch({all});")
    } else {
        writeln!(text, "    {name}_{function}_batch({all});")
    };
    text.push_str("    for (int k = 0; k < many; k++) {\n");
    let _ = if is_number {
        writeln!(
            text,
            "        const double {function}_value = {name}_{function}({one});"
        )
    } else if request.refuses() {
        writeln!(
            text,
            "        if ({name}_{function}({one})) {{\n            \
             if (first == 0 || first > (size_t)k + 1) return fprintf(stderr, \"{function} %d accepted\\n\", k), 1;\n            \
             continue;\n        }}\n        if (first == (size_t)k + 1) return fprintf(stderr, \"{function} %d refused\\n\", k), 1;"
        )
    } else {
        writeln!(text, "        {name}_{function}({one});")
    };
    text + &compare + "    }\n    (void)first;\n    }\n"
}

/// The sign by which a variable of these dimensions is handed to a function that writes to it.
fn pointer(dimensions: &str) -> &'static str {
    if dimensions.is_empty() { "&" } else { "" }
}

/// The places that a function writes to, with the dimensions of their declarations. A number has none.
fn c_parts(name: &str, request: &Request, header: &str) -> Vec<(String, String)> {
    let call = format!(" {name}_{}(", request.name());
    let declaration = header
        .lines()
        .find(|line| line.starts_with("ROBOT") && line.contains(&call));
    let (_, parameters) = declaration
        .expect("a declaration")
        .split_once('(')
        .expect("parameters");
    let parameters = parameters.trim_end_matches(");").split(", ");
    let written = parameters.filter_map(|parameter| parameter.strip_prefix("double "));
    let parts = written.map(|parameter| {
        let at = parameter.find('[').unwrap_or(parameter.len());
        let name = parameter[..at].trim_start_matches('*');
        (name.to_owned(), parameter[at..].to_owned())
    });
    parts.collect()
}

/// Exponentials of the numbers that occur, as Rust has them: `x`, then its value, by bits.
fn c_table(case: &Case) -> String {
    let mut text = "#include <string.h>\ntypedef unsigned long long word;\n".to_owned();
    let mut array = |name: &str, values: &mut dyn Iterator<Item = f64>| {
        let words: Vec<_> = values
            .map(|x| format!("0x{:016x}ull", x.to_bits()))
            .collect();
        let words = if words.is_empty() {
            "0".to_owned()
        } else {
            words.join(", ")
        };
        let _ = writeln!(text, "static const word {name}[] = {{{words}}};");
    };
    array("exponents", &mut case.exponents.iter().copied());
    array(
        "exponentials",
        &mut case.exponents.iter().map(|x| Scalar::exp(*x)),
    );
    text.push_str(
        "double table_exp(double x) {\n    word bits; memcpy(&bits, &x, 8);\n    double value = 0.0 / 0.0;\n    \
         for (unsigned i = 0; i < sizeof exponents / 8; i++) {\n        \
         if (exponents[i] == bits) memcpy(&value, &exponentials[i], 8);\n    }\n    return value;\n}\n",
    );
    text
}

const WARNINGS: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];

/// The programs in C with the sines of the source, and for some arms with those of the C library.
fn assert_c(case: &Case) {
    let robot = case.arm.robot();
    let with_own = c_source(robot, &case.programs);
    let name = with_own.name.clone();
    let folder = folder(&format!("c_{name}"));
    let write = |file: String, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write("table.c".to_owned(), &c_table(case));
    write("table.h".to_owned(), "double table_exp(double);\n");
    let tables = [
        "-include",
        "table.h",
        "table.c",
        "-DROBOT_DYNAMICS_EXP=table_exp",
    ];
    // Lanes for the arms that are compiled fast.
    let level = if name == "panda" || case.arm.dof() <= 3 {
        "-O3"
    } else {
        "-O1"
    };
    let compile = |files: &CSource, program: &str, options: &[&str]| {
        write(format!("{name}.h"), &files.header);
        write(format!("{name}.c"), &files.source);
        write("main.c".to_owned(), &c_program(case, &name, &files.header));
        let mut command = Command::new("gcc");
        command
            .current_dir(&folder)
            .args([level, "-std=c99"])
            .args(WARNINGS);
        command.args(IS_FUSED.then_some("-mfma"));
        command.args(options).args([&format!("{name}.c"), "main.c"]);
        run(command.args(["-lm", "-o", program]));
        run(&mut Command::new(folder.join(program)))
    };
    let is_near = !case.has_tables;
    let tables = if is_near { &[][..] } else { &tables };
    assert_same(
        &compile(&with_own, "with_own", tables),
        case,
        &name,
        is_near,
    );
    if OF_OTHER_LIBRARIES.contains(&name.as_str()) {
        let files = c_source_in(robot, &case.programs, CNumbers::DoubleWithLibrary);
        assert_same(&compile(&files, "with_libm", &[]), case, &name, true);
    }
    if name == "scene" {
        let mut command = Command::new("g++");
        command
            .current_dir(&folder)
            .args(["-x", "c++", "-std=c++11", "-c"])
            .args(WARNINGS);
        command.arg("-DROBOT_DYNAMICS_DEVICE=__attribute__((unused))");
        run(command.arg(format!("{name}.c")).args(["-o", "scene.o"]));
    }
}

/// A module that calls every function at every state and prints the bits of what it returns.
fn javascript_program(case: &Case, with_tables: bool) -> String {
    let mut text = "import * as robot from \"./robot.mjs\";\n".to_owned();
    let number = |x: &f64| {
        if x.is_finite() {
            format!("{x:?}")
        } else {
            "Infinity".to_owned()
        }
    };
    let map = |keys: &[f64], value: fn(f64) -> f64| {
        // JavaScript has one NaN.
        let value = |x: f64| {
            Some(value(x))
                .filter(|x| x.is_finite())
                .map_or("NaN".to_owned(), |x| format!("{x:?}"))
        };
        let entries = keys
            .iter()
            .map(|x| format!("[{}, {}]", number(x), value(*x)));
        format!("new Map([{}])", entries.collect::<Vec<_>>().join(", "))
    };
    if with_tables {
        let _ = writeln!(
            text,
            "const s = {};",
            map(&case.angles, |x| Scalar::sin_cos(x).0)
        );
        let _ = writeln!(
            text,
            "const c = {};",
            map(&case.angles, |x| Scalar::sin_cos(x).1)
        );
        let _ = writeln!(text, "const e = {};", map(&case.exponents, Scalar::exp));
        text.push_str(
            "Math.sin = (x) => s.get(x); Math.cos = (x) => c.get(x); Math.exp = (x) => e.get(x);\n",
        );
    }
    text.push_str(
        "const bits = (x) => new BigUint64Array(new Float64Array([x]).buffer)[0].toString(16).padStart(16, \"0\");\n\
         const flat = (value) => Array.isArray(value) ? value.flatMap(flat) : [value];\n\
         const call = (f, ...args) => {\n  try {\n    console.log(flat(f(...args)).map(bits).join(\" \"));\n  } \
         catch (error) {\n    if (!(error instanceof robot.SingularMassMatrix)) throw error;\n    \
         console.log(`singular ${error.joint}`);\n  }\n};\n",
    );
    let fields: BTreeMap<_, _> = case
        .arm
        .field_names()
        .iter()
        .zip(case.arm.fields())
        .collect();
    let fields: Vec<_> = fields
        .iter()
        .map(|(name, x)| format!("{name}: {}", number(x)))
        .collect();
    let _ = writeln!(text, "const arm = {{{}}};", fields.join(", "));
    for (request, _) in &case.programs {
        for state in 0..STATES {
            let mut arguments = vec![format!("robot.{}", request.name())];
            arguments.extend((!fields.is_empty()).then(|| "arm".to_owned()));
            for (_, entries) in case.arguments(request, state) {
                let entries: Vec<_> = entries.iter().map(number).collect();
                arguments.push(format!("[{}]", entries.join(", ")));
            }
            let _ = writeln!(text, "call({});", arguments.join(", "));
        }
    }
    text
}

fn assert_javascript(case: &Case, name: &str) {
    let folder = folder(&format!("javascript_{name}"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write(
        "robot.mjs",
        &javascript_module(case.arm.robot(), &case.programs),
    );
    for (file, with_tables) in [("with_tables.mjs", true), ("with_math.mjs", false)] {
        if with_tables && !case.has_tables {
            continue;
        }
        write(file, &javascript_program(case, with_tables));
        let found = run(Command::new("node").current_dir(&folder).arg(file));
        assert_same(&found, case, name, !with_tables || IS_FUSED);
    }
}

/// Functions that every arm has; `forward_dynamics` refuses the last state.
const FUNCTIONS: [Function; 3] = [
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::Jacobian,
];

/// The arms of the data files with a number of joints.
fn cases(has_joints: fn(usize) -> bool) -> impl Iterator<Item = Case> {
    let robots = arms::NAMES.iter().map(|name| arms::robot(name));
    let robots = robots.filter(move |robot| has_joints(robot.dof()));
    robots.map(|robot| Case::new(robot, &[], FUNCTIONS))
}

pub(super) fn assert_languages(cases: impl Iterator<Item = Case>) {
    let (has_c, has_javascript) = (is_there("gcc") && is_there("g++"), is_there("node"));
    let (has_numpy, has_octave) = (arrays::is_numpy_there(), is_there("octave-cli"));
    if ![has_c, has_javascript, has_numpy, has_octave].contains(&true) {
        return;
    }
    for case in cases {
        let name = case.arm.robot().name.clone();
        if has_c {
            assert_c(&case);
        }
        if has_javascript {
            assert_javascript(&case, &name);
        }
        if has_numpy {
            arrays::assert_python(&case, &name);
        }
        if has_octave {
            arrays::assert_matlab(&case, &name);
        }
    }
}

#[test]
fn values_of_short_arms_are_those_of_rust() {
    assert_languages(cases(|joints| joints <= 2));
}

/// Functions at frames, and those of the whole tree.
#[test]
fn values_of_trees_are_those_of_rust() {
    let case = |name: &&str| {
        let mut robot = arms::tree(name);
        for (name, on) in [
            ("knee", Some(2)),
            ("last link", robot.rows.len().checked_sub(1)),
            ("door", None),
        ] {
            robot.frames.push(Frame {
                name: name.to_owned(),
                on,
                places: vec![Placement {
                    xyz: [0.1, 0.2, -0.3].map(arms::decimal),
                    rpy: [0.4, -0.5, 0.6].map(arms::decimal),
                }],
                body: None,
            });
        }
        let frames = robot.frames.iter().enumerate();
        let of_frames = frames.flat_map(|(i, frame)| {
            [
                Function::Jacobian,
                Function::ForwardKinematics,
                Function::ToolVelocity,
            ]
            .map(|function| Request::of_frame(function, i, &frame.name))
        });
        let functions = [
            Function::MassMatrix,
            Function::InverseDynamics,
            Function::ForwardDynamics,
        ];
        let functions = functions.map(Request::from).into_iter().chain(of_frames);
        let functions: Vec<_> = functions.collect();
        Case::new(robot, &[], functions)
    };
    assert_languages(["hyq", "forked_chain"].iter().map(case));
}

/// Names that would end a comment or a string, or are trigraphs, compile in C99, and are the names that are written.
#[test]
fn names_of_joints_stay_what_they_are() {
    const NAMES: [&str; 6] = [
        "??/",
        "???/*",
        "*/",
        "say \"\\",
        "\u{e9}\u{301}\u{202e}",
        "??<%:",
    ];
    let mut robot = arms::robot("two_link_saha");
    robot.name = "names ??/*/".to_owned();
    let row = robot.rows[1].clone();
    robot.rows.resize(NAMES.len(), row);
    for (row, name) in robot.rows.iter_mut().zip(NAMES) {
        row.name = name.to_owned();
    }
    let request = Request::from(Function::GravityVector);
    let program = proven_program(&robot, &request).expect("proven");
    let programs = [(request, program)];
    let files = c_source(&robot, &programs);
    let name = files.name.as_str();
    let folder = folder("c_names");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write(&format!("{name}.h"), &files.header);
    write(&format!("{name}.c"), &files.source);
    let upper = name.to_uppercase();
    write(
        "main.c",
        &format!(
            "#include \"{name}.h\"\n#include <stdio.h>\nint main(void) {{\n    const char *names[] = {upper}_JOINT_NAMES;\n    \
             for (int i = 0; i < {upper}_DOF; i++) puts(names[i]);\n    return 0;\n}}\n"
        ),
    );
    write("robot.mjs", &javascript_module(&robot, &programs));
    if is_there("gcc") {
        let mut command = Command::new("gcc");
        command
            .current_dir(&folder)
            .args(["-std=c99", "-Wtrigraphs"]);
        command
            .args(WARNINGS)
            .args([&format!("{name}.c"), "main.c"]);
        run(command.args(["-lm", "-o", "names"]));
        let found = run(&mut Command::new(folder.join("names")));
        assert_eq!(found.lines().collect::<Vec<_>>(), NAMES);
    }
    if is_there("node") {
        run(Command::new("node")
            .current_dir(&folder)
            .args(["--check", "robot.mjs"]));
    }
    arrays::assert_names_stay(&robot, &programs, &NAMES);
}

/// `cargo test -p dynamics-evaluation --test suite languages:: -- --ignored`
#[test]
#[ignore = "needs gcc and node, and takes a minute: .ci/run runs it"]
fn values_are_those_of_rust() {
    let scene = Case::new(
        generated::description(),
        &generated::FIELDS,
        generated::all_functions(),
    );
    assert_languages(cases(|joints| joints > 2).chain([scene]));
}
