//! C in both precisions, compiled and beside the values of Rust.

mod flags;
mod projects;
mod sines;
mod symbols;

use std::fmt::{Debug, Write as _};
use std::path::Path;
use std::process::Command;

use dynamics_evaluation::{ReadOptions, RuntimeRobot};
use dynamics_runtime::Scalar;

use super::calls::{assert_has, file, folder, has, output, refused, succeed};

/// An arm with friction, a slide and a follower.
const ARM: &str = r#"
convention = "modified"
gravity = [0, 0, -9.81]
couple = { third = "2*first + 0.1" }
functions = ["default", "jacobian"]
joint = [
    { name = "first", type = "revolute", mass = 2, com = [0.1, 0, 0.2], inertia = { zz = 0.3 }, friction = { viscous = 0.1, coulomb = 0.2 } },
    { name = "second", type = "prismatic", alpha = "deg(20)", a = 0.3, mass = 1, com = [0, 0.1, 0] },
    { name = "third", type = "revolute", alpha = -0.4, mass = 0.7, com = [0.2, 0, 0.1], inertia = { xx = 0.01, yy = 0.02, zz = 0.03 } },
    { name = "fourth", type = "revolute", alpha = "PI/2", a = 0.5, mass = 0.5, com = [0.1, 0, 0], inertia = { yy = 0.01, zz = 0.01 } },
]
"#;

/// The header of a long robot says how it is compiled fast, and that of a short one is silent.
#[test]
fn long_texts_say_how_to_compile_them() {
    let folder = folder("long_c");
    let out = folder.to_str().expect("a path");
    let g1 = format!(
        "{}/../tests/data/urdf/g1_29dof_rev_1_0.urdf",
        env!("CARGO_MANIFEST_DIR")
    );
    let of_base = "--base floating --gravity 0,0,-9.81";
    let arm = file("short.toml", ARM);
    for (path, more, is_long) in [(&g1, of_base, true), (&arm, "", false)] {
        let functions = format!("--lang c --functions mass_matrix --out {out}");
        let written = output(format!("generate {path} {more} {functions}"));
        let header = written.lines().find(|line| line.ends_with(".h"));
        let header = std::fs::read_to_string(header.expect("a header")).expect("a file");
        assert_eq!(header.contains("max-combine-insns=2"), is_long, "{path}");
    }
}

const FLAGS: [&str; 7] = [
    "-std=c99",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wdouble-promotion",
    "-Werror",
];

/// A type of numbers, in Rust and in C.
trait Number: Scalar + Debug {
    const WORD: &'static str;
    /// The unsigned integer of as many bytes, and the letters of its hexadecimal digits.
    const BITS: &'static str;
    const DIGITS: usize;
    const SUFFIX: &'static str;
    const EPSILON: f64;

    fn of(x: f64) -> Self;
    fn bits(self) -> u64;
    fn of_bits(bits: u64) -> Self;
}

impl Number for f64 {
    const WORD: &'static str = "double";
    const BITS: &'static str = "uint64_t";
    const DIGITS: usize = 16;
    const SUFFIX: &'static str = "";
    const EPSILON: f64 = f64::EPSILON;

    fn of(x: f64) -> Self {
        x
    }

    fn bits(self) -> u64 {
        self.to_bits()
    }

    fn of_bits(bits: u64) -> Self {
        f64::from_bits(bits)
    }
}

impl Number for f32 {
    const WORD: &'static str = "float";
    const BITS: &'static str = "uint32_t";
    const DIGITS: usize = 8;
    const SUFFIX: &'static str = "f";
    const EPSILON: f64 = f32::EPSILON as f64;

    fn of(x: f64) -> Self {
        x as f32
    }

    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }

    fn of_bits(bits: u64) -> Self {
        f32::from_bits(bits as u32)
    }
}

/// Compiles the robot's source beside a `main`, and returns what it prints.
#[track_caller]
fn compiled(folder: &Path, name: &str, main: &str, libraries: &[&str]) -> String {
    std::fs::write(folder.join("main.c"), main).expect("a file");
    let mut command = Command::new("gcc");
    command.current_dir(folder).args(FLAGS);
    command.args([&format!("{name}.c"), "main.c", "-o", "program"]);
    succeed(command.args(libraries));
    succeed(&mut Command::new(folder.join("program")))
}

/// A `main` that prints the bits of what a function writes, at some states.
fn main_of<F: Number>(name: &str, calls: &[(String, usize)]) -> String {
    let (word, bits, digits) = (F::WORD, F::BITS, F::DIGITS);
    let mut main = format!(
        "#include \"{name}.h\"\n#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n\
         static void print(const {word} *x, int n)\n{{\n    for (int i = 0; i < n; ++i) {{\n        {bits} bits;\n        \
         memcpy(&bits, x + i, sizeof bits);\n        printf(\"%0{digits}llx \", (unsigned long long)bits);\n    }}\n    \
         puts(\"\");\n}}\nint main(void)\n{{\n    {word} x[64];\n"
    );
    for (call, entries) in calls {
        let _ = writeln!(main, "    {call}\n    print(x, {entries});");
    }
    main + "    return 0;\n}\n"
}

/// The bits of numbers, as that program prints them.
fn printed<F: Number>(values: impl IntoIterator<Item = F>) -> String {
    let digits = F::DIGITS;
    let words = values
        .into_iter()
        .map(|x| format!("{:0digits$x} ", x.bits()));
    words.collect()
}

fn literal<F: Number>(x: &[F]) -> String {
    let entries: Vec<_> = x.iter().map(|x| format!("{x:?}{}", F::SUFFIX)).collect();
    format!("(const {}[]){{{}}}", F::WORD, entries.join(", "))
}

/// Every function at several states has the bits of Rust's, large angles among them.
fn assert_functions<F: Number>(name: &str) -> (String, String) {
    let path = file(&format!("{name}.toml"), ARM);
    let out = folder(name);
    let to = out.to_string_lossy();
    let scalar = format!("--lang c --scalar {}", F::WORD);
    output(format!("generate {path} --out {to} {scalar}"));
    let read = |ending: &str| {
        std::fs::read_to_string(out.join(format!("{name}.{ending}"))).expect("a file")
    };
    let (text, header) = (read("c"), read("h"));
    for word in [" sin(", " cos(", "math.h"] {
        assert!(!text.contains(word), "{word}: {text}");
    }
    if !has("gcc") {
        return (text, header);
    }
    let arm = RuntimeRobot::from_file(&path, &ReadOptions::new()).expect("an arm");
    let states = [
        [0.3, 0.2, -1.1, 0.5, -0.7, 1.3, 2.0, -1.0, 0.25],
        [-2.5, 0.0, 3.0, 0.0, 0.0, -0.5, 0.1, 0.2, 0.3],
        [1e3, -0.4, 1e-6, -3.0, 1.0, 8.0, 1.5, 2.5, -3.5],
        [-7e5, 0.1, 3e8, 2.0, -1.0, 1.0, 0.0, 1.0, 0.0],
    ]
    .map(|state| state.map(F::of));
    let mut calls = Vec::new();
    let mut expected = String::new();
    for function in arm.function_names() {
        for state in &states {
            let arguments: Vec<&[F]> = arm
                .arguments(function)
                .expect("arguments")
                .zip([&state[..3], &state[3..6], &state[6..]])
                .map(|(_, entries)| entries)
                .collect();
            let values = arm.evaluate_in(function, &arguments).expect("values");
            let texts: Vec<_> = arguments.iter().map(|entries| literal(entries)).collect();
            let texts = texts.join(", ");
            let call = format!("{name}_{function}({texts}");
            let matrix = ["mass_matrix", "jacobian"].contains(&function);
            calls.push(match (values.len(), matrix) {
                (1, _) => (format!("x[0] = {call});"), 1),
                (n, true) => (format!("{call}, ({} (*)[3])x);", F::WORD), n),
                (n, false) => (format!("{call}, x);"), n),
            });
            // Matrices are by rows in C, and have a column for each of the three joints that move.
            let rows = values.len() / 3;
            let by_rows = (0..values.len()).map(|k| if matrix { k / 3 + k % 3 * rows } else { k });
            expected.push_str(&printed(by_rows.map(|k| values[k])));
            expected.push('\n');
        }
    }
    let found = compiled(&out, name, &main_of::<F>(name, &calls), &[]);
    for ((found, expected), (call, _)) in found.lines().zip(expected.lines()).zip(&calls) {
        assert_eq!(found, expected, "{call}");
    }
    assert_eq!(found.lines().count(), calls.len());
    (text, header)
}

#[test]
fn double_precision_has_the_digits_of_rust() {
    let (text, _) = assert_functions::<f64>("double_arm");
    assert_has(
        &text,
        ["robot_dynamics_sin_cos_2(q[0], q[2], &sines_1, &cosines_1);"],
    );
}

#[test]
fn single_precision_has_the_digits_of_rust() {
    let (text, header) = assert_functions::<f32>("single");
    assert!(!text.contains("double"), "{text}");
    assert!(!header.contains("double"), "{header}");
}

/// With `--sines libm` the functions call those of the C library.
fn assert_library<F: Number>(name: &str, sine: &str, tolerance: f64) -> String {
    let path = file(&format!("{name}.toml"), ARM);
    let out = folder(name);
    let to = out.to_string_lossy();
    let scalar = format!("--lang c --scalar {} --sines libm", F::WORD);
    output(format!("generate {path} --out {to} {scalar}"));
    let text = std::fs::read_to_string(out.join(format!("{name}.c"))).expect("a source");
    assert!(text.contains(sine), "{text}");
    if has("gcc") {
        let q = literal(&[0.5, 0.1, 0.2].map(F::of));
        let call = format!("x[0] = {name}_potential_energy({q});");
        let main = main_of::<F>(name, &[(call, 1)]);
        let found = compiled(&out, name, &main, &["-lm"]);
        let bits = u64::from_str_radix(found.trim(), 16).expect("bits");
        let arm = RuntimeRobot::from_file(&path, &ReadOptions::new()).expect("an arm");
        let expected = arm.potential_energy(&[0.5, 0.1, 0.2]).expect("a value");
        let found = F::of_bits(bits).ratio_to_f64(F::of(1.0));
        assert!((found - expected).abs() < tolerance, "{found}");
    }
    text
}

#[test]
fn sines_of_the_c_library() {
    assert_library::<f64>("library", "#define ROBOT_DYNAMICS_SIN sin\n", 1e-13);
    let of_floats =
        assert_library::<f32>("library_single", "#define ROBOT_DYNAMICS_SINF sinf\n", 1e-5);
    assert!(!of_floats.contains("double "), "{of_floats}");
    let path = file("library.toml", ARM);
    for (option, word) in [("--scalar", "float"), ("--sines", "libm")] {
        refused(
            format!("generate {path} --lang js {option} {word}"),
            2,
            ["is about `--lang c`"],
        );
    }
}

/// Fields are a struct of floats, and the sine of an angle made of them is that of Rust.
#[test]
fn fields_of_single_precision() {
    let tilted = ARM
        .replace("alpha = -0.4", "alpha = \"2 * tilt\"")
        .replace("mass = 1,", "mass = \"load\",");
    let path = file("tilted.toml", tilted);
    let out = folder("tilted");
    let to = out.to_string_lossy();
    let scalar = "--lang c --scalar float";
    output(format!("generate {path} --out {to} {scalar}"));
    let header = std::fs::read_to_string(out.join("tilted.h")).expect("a header");
    assert_has(
        &header,
        ["    float load;\n    float tilt;\n} tilted_fields;"],
    );
    if !has("gcc") {
        return;
    }
    let options = ReadOptions::new().names_are_fields();
    let mut arm = RuntimeRobot::from_file(&path, &options).expect("an arm");
    let state: [f32; 9] = [0.3, 0.2, -1.1, 0.5, -0.7, 1.3, 2.0, -1.0, 0.25];
    let fields: [f32; 2] = [1.7, 0.35];
    arm.set_fields(&fields.map(f64::from)).expect("two fields");
    let parts = [&state[..3], &state[3..6], &state[6..]];
    let expected = arm.evaluate_in("inverse_dynamics", &parts).expect("values");
    let texts: Vec<_> = parts.iter().map(|part| literal(part)).collect();
    let call = format!(
        "const tilted_fields arm = {{1.7f, 0.35f}}; tilted_inverse_dynamics(&arm, {}, x);",
        texts.join(", ")
    );
    let found = compiled(&out, "tilted", &main_of::<f32>("tilted", &[(call, 3)]), &[]);
    assert_eq!(found.trim(), printed(expected).trim());
}

/// A robot on a base that moves compiles in single precision, as C++ too.
#[test]
fn a_base_that_moves_in_single_precision() {
    let path = file("single_brick.toml", super::moving_base::BRICK);
    let out = folder("single_brick");
    let to = out.to_string_lossy();
    output(format!(
        "generate {path} --lang c --scalar float --out {to}"
    ));
    let header = std::fs::read_to_string(out.join("single_brick.h")).expect("a header");
    assert!(
        header.contains("const float base[12]") && !header.contains("double"),
        "{header}"
    );
    for (compiler, language) in [("gcc", "c"), ("g++", "c++")] {
        if has(compiler) {
            let mut command = Command::new(compiler);
            command
                .current_dir(&out)
                .args(["-x", language])
                .args(&FLAGS[1..]);
            succeed(command.args(["-c", "single_brick.c", "-o", "single_brick.o"]));
        }
    }
}
