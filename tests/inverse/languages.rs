//! Solutions, and the choice among them, in Rust, C and JavaScript: the same digits on 2,000 poses of six arms.
//!
//! Each arm has one number, a hash of all that is found, in `tests/data/closed_form_digits.txt`; Python's test reads it too.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use dynamics_evaluation::{ReadOptions, read_source};
use dynamics_export::{CNumbers, Language, Options, files};
use dynamics_symbolic::Proven;
use expect_test::expect_file;
use robot_dynamics::closed_form::{NoSolution, Real, Solutions};
use robot_dynamics::nalgebra::{Matrix4, SVector};

use crate::arms::*;
use crate::run_time::table;
use crate::{Inverse, Random};

const POSES: usize = 2_000;
const MOST: f64 = 2.5;

/// A hash of numbers, by their bits (Fowler, Noll, Vo, a word at a time).
struct Hash(u64);

impl Hash {
    fn add(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(1_099_511_628_211);
    }

    fn add_text(&mut self, text: &str) {
        let add = |hash: u64, byte: u8| hash.wrapping_mul(31).wrapping_add(u64::from(byte));
        self.add(text.bytes().fold(0, add));
    }
}

/// A number whose bits are compared.
trait Bits: Real {
    fn of(x: f64) -> Self;
    fn bits(self) -> u64;
}

impl Bits for f64 {
    fn of(x: f64) -> Self {
        x
    }

    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl Bits for f32 {
    fn of(x: f64) -> Self {
        x as f32
    }

    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

/// A pose, the elbow's angle there, a position to begin at, and the position that the pose comes from.
struct Case<const N: usize> {
    elbow: f64,
    pose: Matrix4<f64>,
    seed: SVector<f64, N>,
    q: SVector<f64, N>,
}

/// Poses in reach; every eighth each is of quarter turns, singular, out of reach, or written with four digits, and some are
/// none.
fn cases<const N: usize, A: Inverse<N>>(arm: &A) -> Vec<Case<N>> {
    let mut random = Random(41);
    let mut case = |k: usize| {
        let mut q: SVector<f64, N> = random.joints();
        match k % 8 {
            4 => q.apply(|x| *x = FRAC_PI_2 * (*x / FRAC_PI_2).round_ties_even()),
            5 => q[N - 2] = 0.0,
            _ => {}
        }
        let mut pose = arm.pose(&q);
        match k % 64 {
            3 => pose[(0, 3)] = f64::NAN,
            11 => pose = pose.transpose(),
            _ if k % 8 == 6 => (0..3).for_each(|i| pose[(i, 3)] *= 3.0),
            _ if k % 8 == 7 => pose = pose.map(|x| (x * 1e4).floor() / 1e4),
            _ => {}
        }
        let (elbow, seed) = (3.0 * random.next(), random.joints());
        Case {
            elbow,
            pose,
            seed,
            q,
        }
    };
    (0..POSES).map(&mut case).collect()
}

/// Ranges of joints: none, of more than a turn, and of less.
fn limits<const N: usize>() -> [Option<[f64; 2]>; N] {
    std::array::from_fn(|i| [None, Some([-7.0, 0.5]), Some([-2.0, 2.5])][i % 3])
}

fn add_all<T: Bits, const N: usize>(hash: &mut Hash, solutions: &Solutions<T, N>) {
    hash.add(solutions.len() as u64);
    for solution in solutions {
        solution.q.iter().for_each(|q| hash.add(q.bits()));
        hash.add(u64::from(solution.is_singular));
        hash.add_text(solution.branch);
    }
}

/// The hash of all that is found at the poses.
fn digits<T: Bits, const N: usize, A: Inverse<N>>(
    arm: &A,
    elbow_angle: impl Fn(&SVector<T, N>) -> Option<T>,
) -> u64 {
    let mut hash = Hash(14_695_981_039_346_656_037);
    for case in cases(arm) {
        let solutions = arm.solutions(&case.pose.map(T::of), T::of(case.elbow));
        add_all(&mut hash, &solutions);
        hash.add(match solutions.reason() {
            None => 0,
            Some(NoSolution::OutOfReach) => 1,
            Some(NoSolution::NotAPose) => 2,
        });
        let within = solutions.within(&limits());
        add_all(&mut hash, &within);
        let seed = case.seed.map(T::of);
        if let Some(nearest) = within.nearest(&seed) {
            nearest.q.iter().for_each(|q| hash.add(q.bits()));
        }
        match solutions.follow(&seed, T::of(MOST)) {
            Ok(solution) => hash.add(solution.q[0].bits()),
            Err(ends) => {
                hash.add(ends.joint.map_or(9, |joint| joint as u64));
                if ends.joint.is_some() {
                    hash.add(T::of(ends.way).bits());
                }
            }
        }
        if let Some(elbow) = elbow_angle(&case.q.map(T::of)) {
            hash.add(elbow.bits());
        }
    }
    hash.0
}

/// The words in which the programs of the test differ, by arm.
struct Words<'a> {
    name: &'a str,
    joints: usize,
    has_elbow: bool,
    cases: &'a Path,
}

impl Words<'_> {
    fn in_c(&self, word: &str) -> String {
        let (is_single, elbow) = (word == "float", if self.has_elbow { "elbow, " } else { "" });
        let unsigned = if is_single { "uint32_t" } else { "uint64_t" };
        let angle = if self.has_elbow {
            "add_number(NAME_elbow_angle(q));"
        } else {
            "(void)q;"
        };
        let infinity = if is_single { "HUGE_VALF" } else { "HUGE_VAL" };
        let range = |range: &Option<[f64; 2]>| match range {
            None => format!("{{-{infinity}, {infinity}}}"),
            Some([lower, upper]) => format!("{{{lower:?}, {upper:?}}}"),
        };
        let limits: Vec<_> = limits::<8>()[..self.joints].iter().map(range).collect();
        let words = [
            ("ANGLE", angle),
            ("NAME", self.name),
            ("JOINTS", &self.joints.to_string()),
            ("REAL", word),
            ("WORD", unsigned),
            ("ELBOW", elbow),
            ("LIMITS", &limits.join(", ")),
            ("CASES", &self.cases.display().to_string()),
        ];
        words.iter().fold(
            include_str!("languages.c").to_owned(),
            |text, (word, own)| text.replace(word, own),
        )
    }

    fn in_javascript(&self) -> String {
        let [elbow, angle] = match self.has_elbow {
            true => [", elbow", "add_number(of_elbow.elbow_angle(q));"],
            false => ["", ""],
        };
        let range = |range: &Option<[f64; 2]>| {
            range.map_or("null".to_owned(), |range| format!("{range:?}"))
        };
        let limits: Vec<_> = limits::<8>()[..self.joints].iter().map(range).collect();
        let words = [
            ("ANGLE", angle),
            ("NAME", self.name),
            ("JOINTS", &self.joints.to_string()),
            ("ELBOW", elbow),
            ("LIMITS", &limits.join(", ")),
            ("CASES", &self.cases.display().to_string()),
        ];
        words.iter().fold(
            include_str!("languages.mjs").to_owned(),
            |text, (word, own)| text.replace(word, own),
        )
    }
}

fn is_there(program: &str) -> bool {
    let is_there = Command::new(program).arg("--version").output().is_ok();
    if !is_there {
        println!("left out: {program} is not installed");
    }
    is_there
}

fn printed(command: &mut Command) -> String {
    let output = command.output().expect("a program");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

/// Writes the files of a language into the folder of a robot.
fn write(folder: &Path, table: &str, language: Language, numbers: CNumbers) {
    let options = ReadOptions::new().functions(["inverse_kinematics"]);
    let path = folder.with_extension("toml");
    let model = read_source(&path, table, &options).expect("a table");
    let options = Options {
        numbers,
        ..Options::default()
    };
    let none = |_: &_, _: &[_]| Ok::<Vec<(_, Proven)>, ()>(Vec::new());
    for (name, text) in files(language, model, &options, none).expect("files") {
        std::fs::write(folder.join(name), text).expect("a file");
    }
}

fn text_of<const N: usize>(cases: &[Case<N>]) -> String {
    let mut text = String::new();
    for case in cases {
        let pose = case.pose.transpose();
        let numbers = pose.iter().chain(&case.seed).chain(&case.q);
        let _ = write!(text, "{:?}", case.elbow);
        for number in numbers {
            let _ = write!(text, " {number:?}");
        }
        text.push('\n');
    }
    text
}

fn check<const N: usize, A: Inverse<N>>(
    arm: &A,
    rows: &str,
    [double, single]: [u64; 2],
    has_elbow: bool,
) -> String {
    let name = A::NAME.to_lowercase();
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(&name);
    std::fs::create_dir_all(&folder).expect("a folder");
    let table = table(rows);
    let path = folder.join("cases.txt");
    std::fs::write(&path, text_of(&cases(arm))).expect("a file");
    let words = Words {
        name: &name,
        joints: N,
        has_elbow,
        cases: &path,
    };
    if is_there("cc") {
        for (word, numbers, expected) in [
            ("double", CNumbers::Double, double),
            ("float", CNumbers::Float, single),
        ] {
            write(&folder, &table, Language::C, numbers);
            std::fs::write(folder.join("main.c"), words.in_c(word)).expect("a file");
            let mut compiler = Command::new("cc");
            compiler.current_dir(&folder).args([
                "-std=c99",
                "-O1",
                "-Wall",
                "-Wextra",
                "-Wconversion",
                "-Wdouble-promotion",
                "-Werror",
                "-o",
                word,
            ]);
            printed(compiler.args(["main.c", &format!("{name}_inverse.c"), "-lm"]));
            let found = printed(&mut Command::new(folder.join(word)));
            assert_eq!(found, format!("{expected:016x}"), "{name} in C, {word}");
        }
    }
    if is_there("node") {
        write(&folder, &table, Language::JavaScript, CNumbers::Double);
        let program = folder.join("main.mjs");
        std::fs::write(&program, words.in_javascript()).expect("a file");
        let found = printed(Command::new("node").arg(&program));
        assert_eq!(found, format!("{double:016x}"), "{name} in JavaScript");
    }
    format!("{double:016x} {name}\n{table}\n")
}

/// The digits of an arm in double and in single precision; where the angle of an elbow is found, too.
macro_rules! checked {
    ($arm:ident, elbow) => {
        checked!(
            $arm,
            |q| Some($arm.elbow_angle(q)),
            |q| Some($arm.elbow_angle(q)),
            true
        )
    };
    ($arm:ident) => {
        checked!($arm, |_| None, |_| None, false)
    };
    ($arm:ident, $double:expr, $single:expr, $has_elbow:literal) => {{
        let both = [
            digits::<f64, _, _>(&$arm, $double),
            digits::<f32, _, _>(&$arm, $single),
        ];
        check(&$arm, $arm::ROWS, both, $has_elbow)
    }};
}

#[test]
fn solutions_have_the_digits_of_rust() {
    let found = [
        checked!(Puma560),
        checked!(Ur5e),
        checked!(Stanford),
        checked!(Iiwa14, elbow),
        checked!(Scara),
        checked!(So100),
    ];
    // With fused instructions Rust has other digits than the file, which is of a build without them.
    if !cfg!(target_feature = "fma") && cfg!(target_arch = "x86_64") {
        expect_file!["../data/closed_form_digits.txt"].assert_eq(&found.concat());
    }
}
