//! C under flags that let compilers reorder sums, forget what is not finite, or compute in wider registers.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::Command;

use dynamics_evaluation::{ReadOptions, RuntimeRobot};

use super::super::calls::{data, file, folder, has, output, succeed};
use super::super::moving_base::BRICK;
use super::{ARM, Number, literal, main_of};

const FUNCTIONS: &str = "mass_matrix,coriolis_vector,gravity_vector,bias_force,inverse_dynamics,forward_dynamics,\
                         kinetic_energy,potential_energy,jacobian,center_of_mass";

const X87: &str = "add -msse2 -mfpmath=sse";
const FAST: &str = "/fp:precise";

/// Flags, and a part of the sentence by which they are refused.
const FLAGS: [(&str, Option<&str>); 16] = [
    ("-O2", None),
    ("-O3 -march=native", None),
    ("-O2 -funsafe-math-optimizations", None),
    (
        "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math",
        None,
    ),
    ("-O2 -ffast-math -fno-finite-math-only", None),
    ("-O3 -ffast-math -fno-finite-math-only", None),
    ("-O2 -m32 -msse2 -mfpmath=sse", None),
    (
        "-O2 -m32 -msse2 -mfpmath=sse -funsafe-math-optimizations",
        None,
    ),
    ("-O2 -ffast-math", Some("-fno-finite-math-only")),
    ("-Ofast", Some("-fno-finite-math-only")),
    ("-O2 -ffinite-math-only", Some("-fno-finite-math-only")),
    ("-O2 -m32 -mfpmath=387", Some(X87)),
    ("-O1 -m32 -std=c99 -mno-sse", Some(X87)),
    ("-O2 -mfpmath=387", Some(X87)),
    ("-O2 -m32", Some(X87)),
    ("-O2 -D_M_FP_FAST", Some(FAST)),
];

/// A slide with a follower, a base that moves, and serial arms.
fn robots() -> [(&'static str, String); 6] {
    [
        ("slide", file("flags_slide.toml", ARM)),
        (
            "brick",
            file(
                "flags_brick.toml",
                BRICK.replace("mass = 0.5", "mass = 0.5\ncom = [0.1, 0, 0]"),
            ),
        ),
        ("stanford", data("robots/stanford.json")),
        ("scara", data("robots/scara.json")),
        ("elbow_3r", data("robots/elbow_3r.json")),
        ("ur5", data("robots/ur5.json")),
    ]
}

/// A function at a state, and Rust's values.
struct Evaluation<F> {
    function: &'static str,
    /// The arguments as literals of C.
    arguments: Vec<String>,
    /// By columns.
    values: Vec<F>,
}

fn evaluations<F: Number>(arm: &RuntimeRobot, functions: &'static str) -> Vec<Evaluation<F>> {
    let at = |function, state: f64| {
        let entries = |(of, (argument, count)): (usize, (&str, usize))| -> Vec<F> {
            let entry = |i: usize| match argument {
                // A base that is not turned: the rotation by rows, then the position.
                "base" => f64::from(u8::from(i.is_multiple_of(4) && i < 9)),
                _ => state * ((7 * of + 3 * i + 1) as f64).sin(),
            };
            (0..count).map(|i| F::of(entry(i))).collect()
        };
        let arguments = arm.arguments(function).expect("arguments");
        let arguments: Vec<Vec<F>> = arguments.enumerate().map(entries).collect();
        let slices: Vec<&[F]> = arguments.iter().map(Vec::as_slice).collect();
        Evaluation {
            function,
            arguments: slices.iter().map(|slice| literal(slice)).collect(),
            values: arm.evaluate_in(function, &slices).expect("values"),
        }
    };
    let functions = functions.split(',');
    functions
        .flat_map(|function| [1.0, 40.0].map(|state| at(function, state)))
        .collect()
}

fn arm(path: &str, functions: &str) -> RuntimeRobot {
    let options = ReadOptions::new().functions(functions.split(','));
    RuntimeRobot::from_file(path, &options).expect("an arm")
}

/// The calls of ten functions at two states, and Rust's values by rows.
fn calls<F: Number>(name: &str, path: &str) -> (Vec<(String, usize)>, Vec<Vec<F>>) {
    let arm = arm(path, FUNCTIONS);
    let joints = arm.dof();
    let (mut calls, mut expected) = (Vec::new(), Vec::new());
    for evaluation in evaluations::<F>(&arm, FUNCTIONS) {
        let Evaluation {
            function,
            arguments,
            values,
        } = evaluation;
        let call = format!("{name}_{function}({}", arguments.join(", "));
        let (count, rows) = (values.len(), values.len() / joints);
        let is_matrix = ["mass_matrix", "jacobian"].contains(&function);
        let call = match (count, is_matrix) {
            (1, _) => format!("x[0] = {call});"),
            (_, true) => format!("{call}, ({} (*)[{joints}])x);", F::WORD),
            _ => format!("{call}, x);"),
        };
        let by_rows = (0..count).map(|k| match is_matrix {
            true => values[k / joints + k % joints * rows],
            false => values[k],
        });
        expected.push(by_rows.collect());
        calls.push((call, count));
    }
    (calls, expected)
}

const CASADI_FUNCTIONS: &str = "inverse_dynamics,bias_force,potential_energy";

/// The `main` that calls the functions for CasADi as CasADi does, and Rust's values.
fn casadi_program(path: &str) -> (String, Vec<Vec<f64>>) {
    let mut declarations = main_of::<f64>("declarations", &[]);
    let body = declarations.find("int main").expect("a main");
    declarations.truncate(body);
    let mut main = declarations.replacen("#include \"declarations.h\"\n", "", 1);
    let mut calls = String::new();
    let mut expected = Vec::new();
    for function in CASADI_FUNCTIONS.split(',') {
        let _ = writeln!(
            main,
            "int {function}(const double **, double **, long long *, double *, int);"
        );
    }
    for Evaluation {
        function,
        arguments,
        values,
    } in evaluations::<f64>(&arm(path, CASADI_FUNCTIONS), CASADI_FUNCTIONS)
    {
        let count = values.len();
        let arguments = arguments.join(", ");
        let _ = writeln!(
            calls,
            "    {function}((const double *[32]){{{arguments}}}, (double *[32]){{x}}, iw, w, 0);\n    print(x, {count});"
        );
        expected.push(values);
    }
    let room = "static double x[64], w[100000];\nstatic long long iw[1000];";
    let _ = writeln!(main, "{room}\nint main(void)\n{{\n{calls}    return 0;\n}}");
    (main, expected)
}

/// The file for CasADi with every flag.
fn assert_casadi(name: &'static str, path: &str) {
    let label = format!("{name}_casadi");
    let out = folder(&format!("flags_{label}"));
    let to = out.to_string_lossy();
    let options = format!("--lang casadi --name {name} --out {to}");
    output(format!(
        "generate {path} --functions {CASADI_FUNCTIONS} {options}"
    ));
    let (main, expected) = casadi_program(path);
    std::fs::write(out.join("main.c"), main).expect("a file");
    Generated {
        source: format!("{label}.c"),
        test: None,
        out,
        label,
        expected,
        has_own_sines: true,
    }
    .assert();
}

/// The roundings by which values may differ: a thousand operations, which a compiler puts into another order, times the
/// condition of a mass matrix, a hundred.
const ROUNDINGS: f64 = 1e5;

/// The values that a program prints are Rust's up to these roundings of the largest of a call.
#[track_caller]
fn assert_near<F: Number>(found: &str, expected: &[Vec<F>], label: &str) {
    let bound = ROUNDINGS * F::EPSILON;
    assert_eq!(found.lines().count(), expected.len(), "{label}");
    for (call, (line, expected)) in found.lines().zip(expected).enumerate() {
        let number = |word| F::of_bits(u64::from_str_radix(word, 16).expect("bits"));
        let as_f64 = |x: F| x.ratio_to_f64(F::of(1.0));
        let found: Vec<f64> = line
            .split_whitespace()
            .map(|word| as_f64(number(word)))
            .collect();
        let expected: Vec<f64> = expected.iter().map(|x| as_f64(*x)).collect();
        let size = expected.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
        assert_eq!(found.len(), expected.len(), "{label}, call {call}");
        for (found, expected) in found.iter().zip(&expected) {
            let error = (found - expected).abs();
            assert!(
                error <= bound * size,
                "{label}, call {call}: {found:e} {expected:e}"
            );
        }
    }
}

/// Compiles one robot with every flag: values are Rust's and batches those of single calls, or a sentence refuses the flag.
fn assert_flags<F: Number + Sync>(name: &str, path: &str, sines: &str) {
    let label = format!("{name}_{}_{}", F::WORD, sines.len());
    let out = folder(&format!("flags_{label}"));
    let to = out.to_string_lossy();
    let options = format!("--lang c --project --name {name} --scalar {}", F::WORD);
    let call = format!("generate {path} --functions {FUNCTIONS} --out {to}");
    output(format!("{call} {options} {sines}"));
    let (calls, expected) = calls::<F>(name, path);
    std::fs::write(out.join("main.c"), main_of::<F>(name, &calls)).expect("a file");
    let has_own_sines = sines.is_empty();
    Generated {
        source: format!("{name}.c"),
        // Batches have the digits of single calls where registers are as wide as numbers.
        test: has_own_sines.then(|| format!("{name}_test.c")),
        out,
        label,
        expected,
        has_own_sines,
    }
    .assert();
}

/// A robot in C, and what its program has to print.
struct Generated<F> {
    source: String,
    /// Its own test.
    test: Option<String>,
    out: PathBuf,
    label: String,
    expected: Vec<Vec<F>>,
    has_own_sines: bool,
}

impl<F: Number + Sync> Generated<F> {
    fn assert(&self) {
        std::thread::scope(|scope| {
            for compiler in ["gcc", "clang"] {
                scope.spawn(move || self.assert_compiler(compiler));
            }
        });
    }

    fn assert_compiler(&self, compiler: &str) {
        let Self { source, out, .. } = self;
        for (flags, refusal) in FLAGS {
            // The registers of an x87 are no trouble to the library's sines, and clang has no such flag on 64 bits.
            let is_x87 = refusal == Some(X87);
            let is_about_sines = is_x87 || refusal == Some(FAST);
            if compiler == "clang" && flags.contains("387") {
                continue;
            }
            let refusal = refusal.filter(|_| self.has_own_sines || !is_about_sines);
            let label = format!("{}, {compiler} {flags}", self.label);
            let compile = |files: &[&str]| {
                let mut command = Command::new(compiler);
                command.current_dir(out).args(flags.split(' '));
                command.args(files).output().expect("a compiler")
            };
            let object = format!("{compiler}.o");
            let compiled = compile(&["-c", source, "-o", &object]);
            let told = String::from_utf8_lossy(&compiled.stderr);
            if let Some(sentence) = refusal {
                assert!(
                    !compiled.status.success() && told.contains(sentence),
                    "{label}: {told}"
                );
                continue;
            }
            assert!(compiled.status.success(), "{label}: {told}");
            let run = |main: &str, program: &str| {
                let linked = compile(&[main, &object, "-o", program, "-lm"]);
                assert!(linked.status.success(), "{label}: {linked:?}");
                succeed(&mut Command::new(out.join(program)))
            };
            assert_near::<F>(
                &run("main.c", &format!("{compiler}_program")),
                &self.expected,
                &label,
            );
            if let Some(test) = &self.test {
                run(test, &format!("{compiler}_batches"));
            }
        }
    }
}

/// Some of the robots, and the first with the sines of the library.
fn assert_robots(some: std::ops::Range<usize>) {
    if !has("gcc") || !has("clang") {
        return;
    }
    let robots = robots();
    for (name, path) in &robots[some] {
        assert_flags::<f64>(name, path, "");
        assert_flags::<f32>(name, path, "");
    }
    let (name, path) = &robots[0];
    assert_flags::<f64>(name, path, "--sines libm");
    assert_flags::<f32>(name, path, "--sines libm");
    assert_casadi(name, path);
}

/// `cargo test -p dynamics-cli --test suite c::flags -- --ignored`
#[test]
#[ignore = "needs gcc and clang, both for 32 bits too, and takes half a minute: .ci/run runs it"]
fn no_flag_makes_values_wrong_in_silence() {
    assert_robots(0..2);
}

mod release {
    #[test]
    #[ignore = "two minutes: run before a release"]
    fn no_flag_makes_values_of_longer_arms_wrong_in_silence() {
        super::assert_robots(2..6);
    }
}
