//! Every function of every kind of robot in every language.
//!
//! The robots are small files of `tests/data/files/kinds`, one for each kind. Each function, at the tip and at each frame, is
//! derived, compared with Newton-Euler and written in all languages, or refused: a golden file has the sentences. The list is
//! that of the table of functions, so that a new one is asked of all kinds.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use dynamics_codegen::Model;
use dynamics_evaluation::{ReadOptions, RuntimeRobot, read_file};
use dynamics_export::{
    CNumbers, c_project, c_source_in, casadi_requests, casadi_source, inverse_in_c,
    inverse_in_javascript, javascript_module, matlab_files, python_module,
};
use dynamics_numeric::check::Check;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request, proven_plan, proven_program};
use expect_test::expect_file;

use crate::languages::{Case, assert_languages, folder, is_there, run};

/// The files of all kinds, by name.
fn kinds() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/files/kinds");
    let entries = std::fs::read_dir(folder).expect("the folder of kinds");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
    paths.sort();
    paths
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .expect("a name")
        .to_string_lossy()
        .into_owned()
}

/// The robot of a file and a function, or why it has none.
fn model(path: &Path, function: &str) -> Result<Model, String> {
    let options = ReadOptions::new().functions([function]).names_are_fields();
    read_file(path, &options).map_err(|error| error.to_string())
}

/// Each word that `functions` takes for a robot with these frames.
fn words(frames: &[String]) -> Vec<String> {
    let of_function = |function: Function| {
        let of_tip = function.row().of_tip;
        let frames = frames.iter().filter(move |_| of_tip);
        let at_frames = frames.map(move |frame| format!("{}({frame:?})", function.name()));
        [function.name().to_owned()].into_iter().chain(at_frames)
    };
    let inverse = "inverse_kinematics";
    let inverses = frames.iter().map(|frame| format!("{inverse}({frame:?})"));
    let inverses = [inverse.to_owned()].into_iter().chain(inverses);
    let words = Function::ALL.into_iter().flat_map(of_function);
    words.chain(inverses).collect()
}

/// A kind of robot, what can be asked of it, and the sentences of what cannot.
struct Kind {
    robot: Robot,
    programs: Vec<(Request, Proven)>,
    /// The frames, or the tip, that have inverse kinematics in closed form.
    inverses: Vec<Option<usize>>,
    refused: String,
}

impl Kind {
    fn new(path: &Path) -> Self {
        let robot = model(path, "mass_matrix").expect("M is there always").robot;
        let frames: Vec<_> = robot
            .frames
            .iter()
            .map(|frame| frame.name.clone())
            .collect();
        let mut kind = Kind {
            robot,
            programs: Vec::new(),
            inverses: Vec::new(),
            refused: String::new(),
        };
        for word in words(&frames) {
            if let Err(why) = kind.ask(path, &word) {
                let why = why.replace(&path.display().to_string(), "FILE");
                let _ = writeln!(kind.refused, "{} {word}: {why}", stem(path));
            }
        }
        kind
    }

    fn ask(&mut self, path: &Path, word: &str) -> Result<(), String> {
        let model = model(path, word)?;
        for (frame, _) in &model.inverses {
            proven_plan(&self.robot, *frame).map_err(|why| why.to_string())?;
            self.inverses.push(*frame);
        }
        for (request, _) in model.requests {
            self.add(request)?;
        }
        Ok(())
    }

    fn add(&mut self, request: Request) -> Result<(), String> {
        let program = proven_program(&self.robot, &request).map_err(|why| why.to_string())?;
        self.programs.push((self.robot.request(request), program));
        Ok(())
    }

    /// The first two functions of three lists as one program: numbers, what solves with M, and base parameters.
    fn add_tuples(&mut self) {
        let lists = [
            [Function::KineticEnergy, Function::MassMatrix],
            [Function::ForwardDynamics, Function::LinkPoses],
            [Function::BaseParameters, Function::EnergyRegressors],
        ];
        for (k, list) in lists.into_iter().enumerate() {
            let tuple = Request::fused(format!("tuple_{k}"), list);
            self.add(tuple).expect("a program of several functions");
        }
    }

    /// Each text of the engine: the name of a file, and what it says.
    fn texts(&self) -> Vec<(String, String)> {
        let (robot, programs) = (&self.robot, &self.programs);
        let mut texts = Vec::new();
        for (folder, numbers) in NUMBERS {
            let source = c_source_in(robot, programs, numbers);
            let name = &source.name;
            let mut files = vec![
                (format!("{name}.h"), source.header),
                (format!("{name}.c"), source.source),
            ];
            files.extend(c_project(robot, programs, numbers));
            let files = files.into_iter();
            texts.extend(files.map(|(name, text)| (format!("{folder}/{name}"), text)));
        }
        let requests: Vec<_> = programs
            .iter()
            .map(|(request, _)| request.clone())
            .collect();
        let derived = casadi_requests(robot, &requests)
            .into_iter()
            .map(|request| {
                let known = programs
                    .iter()
                    .find(|(other, _)| other.parts() == request.parts());
                let program = known.map(|(_, program)| program.clone());
                let program =
                    program.unwrap_or_else(|| proven_program(robot, &request).expect("proven"));
                (robot.request(request), program)
            });
        let derived: Vec<_> = derived.collect();
        let casadi = casadi_source(robot, &requests, &derived);
        texts.push((casadi.name, casadi.text));
        texts.push(("robot.mjs".to_owned(), javascript_module(robot, programs)));
        texts.push(("robot.py".to_owned(), python_module(robot, programs)));
        texts.extend(matlab_files(robot, programs));
        let plans = self.inverses.iter().map(|frame| {
            let plan = proven_plan(robot, *frame).expect("a closed form");
            (frame.map(|frame| robot.frames[frame].name.as_str()), plan)
        });
        let plans: Vec<_> = plans.collect();
        if !plans.is_empty() {
            // Beside the header that has the struct of fields.
            for (folder, numbers) in NUMBERS {
                let of_c = inverse_in_c(robot, &plans, numbers).into_iter();
                texts.extend(of_c.map(|(name, text)| (format!("{folder}/{name}"), text)));
            }
            texts.push(inverse_in_javascript(robot, &plans));
        }
        texts
    }
}

const NUMBERS: [(&str, CNumbers); 4] = [
    ("double", CNumbers::Double),
    ("float", CNumbers::Float),
    ("double_libm", CNumbers::DoubleWithLibrary),
    ("float_libm", CNumbers::FloatWithLibrary),
];

/// Values of the fields, which no cell refuses.
fn values(robot: &Robot) -> Vec<f64> {
    (0..robot.fields.len())
        .map(|k| 0.7 + 0.1 * k as f64)
        .collect()
}

/// A program that reads the file without output, and its call.
fn reads(path: &str) -> Option<(&'static str, Command)> {
    let ending = path.rsplit('.').next()?;
    let (program, options): (&str, &[&str]) = match ending {
        "c" => (
            "gcc",
            &[
                "-std=c99",
                "-fsyntax-only",
                "-Wall",
                "-Wextra",
                "-Wpedantic",
                "-Werror",
            ],
        ),
        "hpp" => (
            "g++",
            &[
                "-std=c++11",
                "-x",
                "c++",
                "-fsyntax-only",
                "-Wall",
                "-Wextra",
                "-Werror",
            ],
        ),
        "mjs" => ("node", &["--check"]),
        "py" => ("python3", &["-W", "error", "-m", "py_compile"]),
        _ => return None,
    };
    let mut command = Command::new(program);
    command.args(options).arg(path);
    Some((program, command))
}

/// The kinds are derived once, each with the values of all of its functions beside Newton-Euler.
#[test]
fn every_function_is_written_in_every_language_or_refused() {
    let there: Vec<_> = ["gcc", "g++", "node", "python3"]
        .into_iter()
        .filter(|program| is_there(program))
        .collect();
    let mut refused = String::new();
    for path in kinds() {
        let mut kind = Kind::new(&path);
        kind.add_tuples();
        refused.push_str(&kind.refused);
        let name = stem(&path);
        let fields = values(&kind.robot);
        let mut arm =
            RuntimeRobot::of_programs(kind.robot.clone(), &kind.programs).expect("a robot");
        arm.set_fields(&fields).expect("a value for each field");
        let report = Check::new().samples(3).run_any(&arm);
        assert!(report.is_ok(), "{name}: {report}");
        let folder = folder(&format!("kind_{name}"));
        for (file, text) in kind.texts() {
            let path = folder.join(&file);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            std::fs::write(path, text).expect("a file");
            if let Some(mut command) = reads(&file).filter(|(program, _)| there.contains(program)) {
                run(command.1.current_dir(&folder));
            }
        }
    }
    expect_file!["../golden/kinds.txt"].assert_eq(&refused);
}

/// `cargo test -p dynamics-evaluation --test suite kinds:: -- --ignored`
#[test]
#[ignore = "needs gcc and node, and takes a minute: .ci/run runs it"]
fn every_value_in_other_languages_is_that_of_rust() {
    let case = |path: PathBuf| {
        let mut kind = Kind::new(&path);
        kind.add_tuples();
        let fields = values(&kind.robot);
        let mut case = Case::of_programs(kind.robot, &fields, kind.programs);
        // Poses of the links of a body without joints are no values.
        let arm = &case.arm;
        let has_values = |request: &Request| arm.entries(request.name()) != Ok(0);
        case.programs.retain(|(request, _)| has_values(request));
        case
    };
    assert_languages(kinds().into_iter().map(case));
}
