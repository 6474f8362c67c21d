//! Functions in Python and MATLAB beside their values in Rust.
//!
//! With numpy's sines replaced by those of Rust values are the same bits; Octave's are those of its library.

use std::fmt::Write as _;
use std::process::Command;

use dynamics_evaluation::RuntimeRobot;
use dynamics_export::{matlab_files, python_module};
use dynamics_runtime::Scalar;
use dynamics_runtime::nalgebra::{Isometry3, Rotation3, Translation3};
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request, proven_program};

use crate::languages::{
    Case, IS_FUSED, OF_OTHER_LIBRARIES, STATES, assert_same, folder, is_there, run,
};

/// Debian's Python, whose packages `.ci/run` installs, or else the one that is found.
fn python() -> Command {
    let of_debian = "/usr/bin/python3";
    let found = std::path::Path::new(of_debian).exists();
    Command::new(if found { of_debian } else { "python3" })
}

fn has_module(name: &str) -> bool {
    let found = python().args(["-c", &format!("import {name}")]).output();
    let found = found.is_ok_and(|output| output.status.success());
    found || arms::is_left_out(&format!("Python has no module {name}"))
}

pub(super) fn is_numpy_there() -> bool {
    has_module("numpy")
}

/// A number of Python, or of Octave, whose infinities are named so.
fn number(x: f64, infinity: &str) -> String {
    match x.is_finite() {
        true => format!("{x:?}"),
        false => infinity.to_owned(),
    }
}

fn numbers(entries: &[f64], infinity: &str, between: &str) -> String {
    let entries = entries.iter().map(|x| number(*x, infinity));
    format!("[{}]", entries.collect::<Vec<_>>().join(between))
}

/// An argument: where a base stands is a matrix of 4 by 4, whose rows are told from one another by `of_rows`. Octave takes
/// twelve numbers besides.
fn written(
    (name, entries): &(&str, Vec<f64>),
    infinity: &str,
    [between, of_rows]: [&str; 2],
) -> String {
    if *name != "base" {
        return numbers(entries, infinity, between);
    }
    let last = [0.0, 0.0, 0.0, 1.0].to_vec();
    let rows = (0..3).map(|i| [&entries[3 * i..3 * i + 3], &entries[9 + i..10 + i]].concat());
    let rows: Vec<_> = rows
        .chain([last])
        .map(|row| numbers(&row, infinity, ", "))
        .collect();
    format!("[{}]", rows.join(of_rows))
}

/// The beginning of every Python program.
const PYTHON: &str = r#"
import struct
import types
import numpy
import robot

inf, nan = float("inf"), float("nan")
bits = lambda x: format(struct.unpack("<Q", struct.pack("<d", x))[0], "016x")
def flat(value):
    if isinstance(value, (list, tuple)):
        return [x for part in value for x in flat(part)]
    return numpy.ravel(value).tolist()
def call(f, *arguments):
    try:
        print(" ".join(bits(x) for x in flat(f(*arguments))))
    except getattr(robot, "SingularMassMatrix", ()) as error:
        print(f"singular {error.joint}")
def rows(f, fields, *arguments):
    # All states at once, behind two axes, are the states one by one.
    with numpy.errstate(all="ignore"):
        try:
            one_by_one = [flat(f(*fields, *state)) for state in zip(*arguments)]
        except getattr(robot, "SingularMassMatrix", ()):
            return
        stacked = [numpy.array(argument)[:, None, None] for argument in arguments]
        together = f(*fields, *stacked)
    def of_state(value, k):
        if isinstance(value, (list, tuple)):
            return [of_state(part, k) for part in value]
        assert value.shape[:3] == (len(one_by_one), 1, 1), value.shape
        return value[k]
    for k, state in enumerate(one_by_one):
        assert numpy.array_equal(flat(of_state(together, k)), state, equal_nan=True), f
"#;

fn python_program(case: &Case, with_tables: bool) -> String {
    let mut text = PYTHON.to_owned();
    if with_tables {
        let table = |keys: &[f64], value: fn(f64) -> f64| {
            let entries = keys.iter().filter(|x| x.is_finite());
            let entries = entries.map(|x| format!("{x:?}: {}", number(value(*x), "nan")));
            format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
        };
        for (name, table) in [
            ("sin", table(&case.angles, |x| Scalar::sin_cos(x).0)),
            ("cos", table(&case.angles, |x| Scalar::sin_cos(x).1)),
            ("exp", table(&case.exponents, Scalar::exp)),
        ] {
            let _ = writeln!(
                text,
                "table_{name} = {table}\nnumpy.{name} = numpy.vectorize(lambda x: table_{name}.get(float(x), nan), otypes=[float])"
            );
        }
    }
    let (names, fields) = (case.arm.field_names(), case.arm.fields());
    let fields = names.iter().zip(fields);
    let fields: Vec<_> = fields.map(|(name, x)| format!("{name}={x:?}")).collect();
    let first = (!fields.is_empty()).then(|| "arm".to_owned());
    let _ = writeln!(text, "arm = types.SimpleNamespace({})", fields.join(", "));
    for (request, _) in &case.programs {
        let function = format!("robot.{}", request.name());
        let mut of_states = vec![Vec::new(); request.arguments().len()];
        for state in 0..STATES {
            let mut arguments = vec![function.clone()];
            arguments.extend(first.clone());
            for (k, argument) in case.arguments(request, state).iter().enumerate() {
                let entries = written(argument, "inf", [", ", ", "]);
                of_states[k].push(entries.clone());
                arguments.push(entries);
            }
            let _ = writeln!(text, "call({})", arguments.join(", "));
        }
        // The last state is refused.
        let finite = of_states
            .iter()
            .map(|states| states[..STATES - 1].join(", "));
        let finite: Vec<_> = finite.map(|states| format!("[{states}]")).collect();
        if !finite.is_empty() {
            let fields = if fields.is_empty() { "()" } else { "(arm,)" };
            let _ = writeln!(text, "rows({function}, {fields}, {})", finite.join(", "));
        }
    }
    text
}

pub(super) fn assert_python(case: &Case, name: &str) {
    let folder = folder(&format!("python_{name}"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    let module = python_module(case.arm.robot(), &case.programs);
    write("robot.py", &module);
    for (file, with_tables) in [("with_tables.py", true), ("with_numpy.py", false)] {
        let is_of_other_library = !case.has_tables || OF_OTHER_LIBRARIES.contains(&name);
        let is_asked = if with_tables {
            case.has_tables
        } else {
            is_of_other_library
        };
        if is_asked {
            write(file, &python_program(case, with_tables));
            let found = run(python().current_dir(&folder).args(["-W", "ignore", file]));
            assert_same(&found, case, name, !with_tables || IS_FUSED);
        }
    }
}

/// The beginning of every Octave program.
const OCTAVE: &str = "
1;
function list = flat(value)
    if iscell(value)
        parts = cellfun(@flat, value(:).', 'UniformOutput', false);
        list = vertcat(parts{:});
    else
        list = reshape(value.', [], 1);
    end
end
function call(parts, f, varargin)
    values = cell(1, parts);
    try
        [values{:}] = f(varargin{:});
        words = num2hex(flat(values));
        for k = 1:size(words, 1)
            printf('%s ', words(k, :));
        end
        printf('\\n');
    catch problem
        if ~strcmp(problem.identifier, 'robot_dynamics:SingularMassMatrix')
            rethrow(problem);
        end
        joint = sscanf(problem.message, 'the mass matrix is not positive definite at joint %d');
        printf('singular %d\\n', joint - 1);
    end
end
function part = of_state(value, single, k)
    if iscell(value)
        part = cellfun(@(x, y) of_state(x, y, k), value, single, 'UniformOutput', false);
    elseif size(single, 2) == 1 && ndims(value) == 2
        part = value(:, k);
    else
        part = value(:, :, k);
    end
end
function same(f, fields, pose, numbers, varargin)
    if ~isequaln(f(fields{:}, pose, varargin{:}), f(fields{:}, numbers, varargin{:}))
        error('%s of a pose in 4 by 4 and of its numbers', func2str(f));
    end
end
function columns(f, fields, varargin)
    % All states at once, as columns, are the states one by one: pages of a matrix.
    together = f(fields{:}, varargin{:});
    for k = 1:size(varargin{1}, 2)
        state = cellfun(@(x) x(:, k), varargin, 'UniformOutput', false);
        single = f(fields{:}, state{:});
        if ~isequaln(of_state(together, single, k), single)
            error('%s at state %d', func2str(f), k);
        end
    end
end
";

fn octave_program(case: &Case) -> String {
    let mut text = OCTAVE.to_owned();
    let (names, fields) = (case.arm.field_names(), case.arm.fields());
    let fields = names.iter().zip(fields);
    let fields: Vec<_> = fields.map(|(name, x)| format!("'{name}', {x:?}")).collect();
    let _ = writeln!(text, "arm = struct({});", fields.join(", "));
    for (request, _) in &case.programs {
        let (name, parts) = (request.name(), request.parts().len());
        let mut of_states = vec![Vec::new(); request.arguments().len()];
        let fields_of = if fields.is_empty() { "{}" } else { "{arm}" };
        for state in 0..STATES {
            let mut arguments = vec![parts.to_string(), format!("@{name}")];
            arguments.extend((!fields.is_empty()).then(|| "arm".to_owned()));
            for (k, argument) in case.arguments(request, state).iter().enumerate() {
                // An empty matrix is no state, and a column without rows is one.
                let entries = match argument.1.is_empty() {
                    true => "zeros(0, 1)".to_owned(),
                    false => numbers(&argument.1, "Inf", "; "),
                };
                of_states[k].push(entries.clone());
                arguments.push(entries);
            }
            let _ = writeln!(text, "call({});", arguments.join(", "));
        }
        if request.arguments().contains(&Argument::Base)
            && !request.is_tuple()
            && !request.refuses()
        {
            let pose = written(&case.arguments(request, 0)[0], "Inf", [", ", "; "]);
            let first = of_states.iter().map(|states| states[0].clone());
            let first: Vec<_> = first.collect();
            let _ = writeln!(
                text,
                "same(@{name}, {fields_of}, {pose}, {});",
                first.join(", ")
            );
        }
        let finite = of_states
            .iter()
            .map(|states| states[..STATES - 1].join(", "));
        let finite: Vec<_> = finite.map(|states| format!("[{states}]")).collect();
        // A state at rest is singular for none of the robots; tuples are parts of one program.
        if !finite.is_empty() && !request.is_tuple() && !request.refuses() {
            let _ = writeln!(
                text,
                "columns(@{name}, {fields_of}, {});",
                finite.join(", ")
            );
        }
    }
    text
}

pub(super) fn assert_matlab(case: &Case, name: &str) {
    let folder = folder(&format!("matlab_{name}"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    for (file, text) in matlab_files(case.arm.robot(), &case.programs) {
        write(&file, &text);
    }
    write("calls.m", &octave_program(case));
    let mut octave = Command::new("octave-cli");
    let found = run(octave
        .current_dir(&folder)
        .args(["--quiet", "--norc", "calls.m"]));
    assert_same(&found, case, name, true);
}

/// Names of joints that would end a string or a comment are read back by Python, and files of MATLAB are read.
pub(super) fn assert_names_stay(robot: &Robot, programs: &[(Request, Proven)], names: &[&str]) {
    let folder = folder("python_names");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    if is_numpy_there() {
        write("robot.py", &python_module(robot, programs));
        let print =
            "import robot\nfor name in robot.JOINT_NAMES: print(name)\nprint(robot.__doc__)";
        let mut command = python();
        let found = run(command
            .current_dir(&folder)
            .args(["-X", "utf8", "-c", print]));
        assert_eq!(found.lines().take(names.len()).collect::<Vec<_>>(), names);
    }
    if is_there("octave-cli") {
        for (file, text) in matlab_files(robot, programs) {
            write(&file, &text);
        }
        let mut octave = Command::new("octave-cli");
        let zeros = format!("disp(numel(gravity_vector(zeros({}, 1))))", names.len());
        let found = run(octave
            .current_dir(&folder)
            .args(["--norc", "--eval", &zeros]));
        assert_eq!(found.trim(), names.len().to_string());
    }
}

/// An argument of another size is told by its name or its shape.
#[test]
fn arguments_of_another_size_are_refused() {
    let robot = arms::robot("two_link_saha");
    let case = Case::new(robot, &[], [Function::MassMatrix]);
    let folder = folder("arrays_sizes");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write("robot.py", &python_module(case.arm.robot(), &case.programs));
    for (file, text) in matlab_files(case.arm.robot(), &case.programs) {
        write(&file, &text);
    }
    let refused = |command: &mut Command| {
        let output = command.current_dir(&folder).output().expect("a program");
        assert!(!output.status.success(), "{command:?}");
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    if is_numpy_there() {
        for q in ["[1.0, 2.0, 3.0]", "0.3", "[[1.0], [2.0]]"] {
            let errors =
                refused(python().args(["-c", &format!("import robot\nrobot.mass_matrix({q})")]));
            assert!(
                errors.contains("expected 2 entries along the last axis, found the shape"),
                "{errors}"
            );
        }
    }
    if is_there("octave-cli") {
        for (q, found) in [("[1; 2; 3]", 3), ("[1 2]", 1)] {
            let call = format!("mass_matrix({q})");
            let errors = refused(Command::new("octave-cli").args(["--norc", "--eval", &call]));
            assert!(
                errors.contains(&format!("q: expected 2 rows, found {found}")),
                "{errors}"
            );
        }
    }
}

/// With symbols of sympy, numbers put in afterwards: the values are those of Rust.
#[test]
fn symbols_of_sympy_are_numbers_in_the_end() {
    if !has_module("sympy") {
        return;
    }
    let robot = arms::robot("two_link_saha");
    let functions = Function::default_set(false);
    let case = Case::new(robot, &[], functions);
    let folder = folder("python_sympy");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write("robot.py", &python_module(case.arm.robot(), &case.programs));
    let mut text = PYTHON.to_owned() + "import sympy\n";
    for (request, _) in &case.programs {
        let (mut names, mut values) = (Vec::new(), Vec::new());
        for (name, entries) in case.arguments(request, 1) {
            let symbols: Vec<_> = (0..entries.len()).map(|i| format!("{name}{i}")).collect();
            names.push(format!("sympy.symbols({:?})", symbols.join(" ")));
            let entries = symbols.iter().zip(&entries);
            values.extend(entries.map(|(symbol, x)| format!("{symbol:?}: {x:?}")));
        }
        let name = request.name();
        let _ = writeln!(
            text,
            "symbolic = robot.{name}({}, xp=sympy)\n\
             print(*[bits(float(x)) for x in sympy.Matrix([symbolic]).subs({{{}}})])",
            names.join(", "),
            values.join(", ")
        );
    }
    write("symbols.py", &text);
    let found = run(python().current_dir(&folder).arg("symbols.py"));
    let expected = case.programs.iter().map(|(request, _)| {
        let arguments = case.arguments(request, 1);
        let slices: Vec<&[f64]> = arguments.iter().map(|(_, x)| x.as_slice()).collect();
        case.arm
            .evaluate_in(request.name(), &slices)
            .expect("regular")
    });
    assert_near(&found, &expected.collect::<Vec<_>>());
}

/// The pose of a base that moves is a matrix of 4 by 4, whose entries the functions in Rust take.
#[test]
fn poses_of_a_base_are_matrices() {
    let robot = arms::floating("torso");
    let programs = [Function::GravityVector, Function::InverseDynamics].map(|function| {
        let request = robot.request(Request::from(function));
        let program = proven_program(&robot, &request).expect("proven");
        (request, program)
    });
    let arm = RuntimeRobot::of_programs(robot, &programs).expect("a robot");
    let turn = Rotation3::from_euler_angles(0.3, -0.7, 1.9);
    let pose =
        Isometry3::from_parts(Translation3::new(0.1, 0.2, 0.3), turn.into()).to_homogeneous();
    let places = (0..9).map(|k| (k / 3, k % 3)).chain((0..3).map(|i| (i, 3)));
    let base: Vec<f64> = places.map(|place| pose[place]).collect();
    let rows: Vec<String> = (0..4)
        .map(|i| numbers(pose.row(i).transpose().as_slice(), "inf", ", "))
        .collect();
    let (python_pose, octave_pose) = (rows.join(", "), rows.join("; "));
    let (mut of_python, mut of_octave) = (PYTHON.to_owned(), OCTAVE.to_owned());
    let mut expected = Vec::new();
    for (request, _) in &programs {
        let name = request.name();
        let (mut entries, mut texts) = (vec![base.clone()], [String::new(), String::new()]);
        for (argument, count) in arm.arguments(name).expect("a function").skip(1) {
            let entry = |i: usize| ((3 * i + argument.len()) as f64).sin();
            let of_argument: Vec<f64> = (0..count).map(entry).collect();
            for (text, between) in texts.iter_mut().zip([", ", "; "]) {
                let _ = write!(text, ", {}", numbers(&of_argument, "inf", between));
            }
            entries.push(of_argument);
        }
        let [python, octave] = texts;
        let _ = writeln!(of_python, "call(robot.{name}, [{python_pose}]{python})");
        let _ = writeln!(of_octave, "call(1, @{name}, [{octave_pose}]{octave});");
        let slices: Vec<&[f64]> = entries.iter().map(Vec::as_slice).collect();
        expected.push(arm.evaluate_in(name, &slices).expect("regular"));
    }
    let folder = folder("arrays_torso");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("a file");
    write("robot.py", &python_module(arm.robot(), &programs));
    matlab_files(arm.robot(), &programs)
        .iter()
        .for_each(|(file, text)| write(file, text));
    write("calls.py", &of_python);
    write("calls.m", &of_octave);
    if is_numpy_there() {
        assert_near(
            &run(python().current_dir(&folder).arg("calls.py")),
            &expected,
        );
    }
    if is_there("octave-cli") {
        let mut octave = Command::new("octave-cli");
        assert_near(
            &run(octave.current_dir(&folder).args(["--norc", "calls.m"])),
            &expected,
        );
    }
}

/// Lines of bits that are values up to the sines of another library.
#[track_caller]
fn assert_near(found: &str, expected: &[Vec<f64>]) {
    assert_eq!(found.lines().count(), expected.len(), "{found}");
    for (line, expected) in found.lines().zip(expected) {
        let bits = |word: &str| f64::from_bits(u64::from_str_radix(word, 16).expect("bits"));
        let found: Vec<f64> = line.split_whitespace().map(bits).collect();
        assert_eq!(found.len(), expected.len());
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found - expected).abs() <= 1e-13 * size,
                "{found:e} {expected:e}"
            );
        }
    }
}
