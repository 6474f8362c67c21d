//! C in single precision, compiled and beside the values of Rust.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use dynamics_evaluation::{ReadOptions, RuntimeRobot};
use dynamics_runtime::Scalar;

use super::calls::{errors, file, folder, output};

/// An arm with friction, a slide and a follower.
const ARM: &str = r#"
convention = "modified"
gravity = [0, 0, -9.81]
couple = { third = "2*first + 0.1" }
functions = ["default", "jacobian"]

[[joint]]
name = "first"
type = "revolute"
mass = 2
com = [0.1, 0, 0.2]
inertia = { zz = 0.3 }
friction = { viscous = 0.1, coulomb = 0.2 }

[[joint]]
name = "second"
type = "prismatic"
alpha = "deg(20)"
a = 0.3
mass = 1
com = [0, 0.1, 0]

[[joint]]
name = "third"
type = "revolute"
alpha = -0.4
mass = 0.7
com = [0.2, 0, 0.1]
inertia = { xx = 0.01, yy = 0.02, zz = 0.03 }

[[joint]]
name = "fourth"
type = "revolute"
alpha = "PI/2"
a = 0.5
mass = 0.5
com = [0.1, 0, 0]
inertia = { yy = 0.01, zz = 0.01 }
"#;

const FLAGS: [&str; 8] = [
    "-std=c99",
    "-O2",
    "-ffp-contract=off",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wdouble-promotion",
    "-Werror",
];

fn has_gcc() -> bool {
    Command::new("gcc").arg("--version").output().is_ok()
}

#[track_caller]
fn succeed(command: &mut Command) -> String {
    let output = command.output().expect("a program that runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{errors}");
    String::from_utf8(output.stdout).expect("text")
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
fn main_of(name: &str, calls: &[(String, usize)]) -> String {
    let mut main = format!(
        "#include \"{name}.h\"\n#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n\
         static void print(const float *x, int n)\n{{\n    for (int i = 0; i < n; ++i) {{\n        uint32_t bits;\n        \
         memcpy(&bits, x + i, 4);\n        printf(\"%08x \", (unsigned)bits);\n    }}\n    puts(\"\");\n}}\n\
         int main(void)\n{{\n    float x[64];\n"
    );
    for (call, entries) in calls {
        let _ = writeln!(main, "    {call}\n    print(x, {entries});");
    }
    main + "    return 0;\n}\n"
}

fn literal(x: &[f32]) -> String {
    let entries: Vec<_> = x.iter().map(|x| format!("{x:?}f")).collect();
    format!("(const float[]){{{}}}", entries.join(", "))
}

/// Every function at several states has the bits of Rust's `f32`.
#[test]
fn single_precision_has_the_digits_of_rust() {
    let path = file("single.toml", ARM);
    let out = folder("single");
    let to = out.to_string_lossy();
    output(&[
        "generate", &path, "--lang", "c", "--scalar", "float", "--out", &to,
    ]);
    let text = std::fs::read_to_string(out.join("single.c")).expect("a source");
    let header = std::fs::read_to_string(out.join("single.h")).expect("a header");
    for word in ["double", "sin(", "cos(", "math.h"] {
        assert!(!text.contains(word), "{word}: {text}");
    }
    assert!(!header.contains("double"), "{header}");
    assert!(
        text.contains("robot_dynamics_sin_cosf(q[0], &s_1, &c_1);"),
        "{text}"
    );
    if !has_gcc() {
        return;
    }
    let arm = RuntimeRobot::from_file(&path, &ReadOptions::new()).expect("an arm");
    let states: [[f32; 9]; 4] = [
        [0.3, 0.2, -1.1, 0.5, -0.7, 1.3, 2.0, -1.0, 0.25],
        [-2.5, 0.0, 3.0, 0.0, 0.0, -0.5, 0.1, 0.2, 0.3],
        [1e3, -0.4, 1e-6, -3.0, 1.0, 8.0, 1.5, 2.5, -3.5],
        [-7e4, 0.1, 3e8, 2.0, -1.0, 1.0, 0.0, 1.0, 0.0],
    ];
    let mut calls = Vec::new();
    let mut expected = String::new();
    for name in arm.function_names() {
        for state in &states {
            let arguments: Vec<&[f32]> = arm
                .arguments(name)
                .expect("arguments")
                .zip([&state[..3], &state[3..6], &state[6..]])
                .map(|(_, entries)| entries)
                .collect();
            let values = arm.evaluate_in(name, &arguments).expect("values");
            let texts: Vec<_> = arguments.iter().map(|entries| literal(entries)).collect();
            let texts = texts.join(", ");
            let call = format!("single_{name}({texts}");
            let matrix = ["mass_matrix", "jacobian"].contains(&name);
            calls.push(match (values.len(), matrix) {
                (1, _) => (format!("x[0] = {call});"), 1),
                (n, true) => (format!("{call}, (float (*)[3])x);"), n),
                (n, false) => (format!("{call}, x);"), n),
            });
            // Matrices are by rows in C, and have a column for each of the three joints that move.
            let rows = values.len() / 3;
            let by_rows = (0..values.len()).map(|k| if matrix { k / 3 + k % 3 * rows } else { k });
            for x in by_rows.map(|k| values[k]) {
                let _ = write!(expected, "{:08x} ", x.to_bits());
            }
            expected.push('\n');
        }
    }
    let found = compiled(&out, "single", &main_of("single", &calls), &[]);
    for ((found, expected), (call, _)) in found.lines().zip(expected.lines()).zip(&calls) {
        assert_eq!(found, expected, "{call}");
    }
    assert_eq!(found.lines().count(), calls.len());
}

/// The sines in the source are those of Rust at angles of any size, and NaN where there is none.
#[test]
fn sines_of_single_precision_are_those_of_rust() {
    if !has_gcc() {
        return;
    }
    let pendulum = "convention = 'modified'\ngravity = [1, 0, 0]\nfunctions = ['gravity_vector', \
                    'potential_energy']\nallow = ['odd_gravity']\n[[joint]]\nname = 'pivot'\ntype = 'revolute'\nmass = 1\n\
                    com = [1, 0, 0]\n";
    let path = file("sine.toml", pendulum);
    let out = folder("sines_of_c");
    let to = out.to_string_lossy();
    output(&[
        "generate", &path, "--lang", "c", "--scalar", "float", "--out", &to,
    ]);
    let mut main = "#include \"sine.h\"\n#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n\
                    int main(void)\n{\n    for (uint64_t k = 0; k < 4294967296u; k += 600011u) {\n        \
                    const uint32_t bits = (uint32_t)k;\n        float q, s, c;\n        uint32_t of_s, of_c;\n        \
                    memcpy(&q, &bits, 4);\n        sine_gravity_vector(&q, &s);\n        c = -sine_potential_energy(&q);\n"
        .to_owned();
    main += "        memcpy(&of_s, &s, 4);\n        memcpy(&of_c, &c, 4);\n        printf(\"%x %x %x\\n\", \
             (unsigned)bits, (unsigned)of_s, (unsigned)of_c);\n    }\n    return 0;\n}\n";
    let found = compiled(&out, "sine", &main, &[]);
    let mut lines = 0;
    for line in found.lines() {
        let bits = line
            .split(' ')
            .map(|word| u32::from_str_radix(word, 16).expect("bits"));
        let [q, s, c] = bits.map(f32::from_bits).collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let (sine, cosine) = Scalar::sin_cos(q);
        let same = |x: f32, y: f32| x == y || x.is_nan() && y.is_nan();
        assert!(
            same(s, sine) && same(c, cosine),
            "{q}: {s} {c}, {sine} {cosine}"
        );
        lines += 1;
    }
    assert_eq!(lines, 7159);
}

/// With `--sines libm` the functions call sinf and cosf, and nothing in double precision.
#[test]
fn sines_of_the_c_library() {
    let path = file("library.toml", ARM);
    let out = folder("library");
    let to = out.to_string_lossy();
    let scalar = ["--lang", "c", "--scalar", "float", "--sines", "libm"];
    output(&[&["generate", &path, "--out", &to][..], &scalar].concat());
    let text = std::fs::read_to_string(out.join("library.c")).expect("a source");
    assert!(
        text.contains("#define ROBOT_DYNAMICS_SINF sinf") && !text.contains("double "),
        "{text}"
    );
    if has_gcc() {
        let call = "x[0] = library_potential_energy((const float[]){0.5f, 0.1f, 0.2f});";
        let main = main_of("library", &[(call.to_owned(), 1)]);
        let found = compiled(&out, "library", &main, &["-lm"]);
        let bits = u32::from_str_radix(found.trim(), 16).expect("bits");
        let arm = RuntimeRobot::from_file(&path, &ReadOptions::new()).expect("an arm");
        let expected = arm.potential_energy(&[0.5, 0.1, 0.2]).expect("a value");
        assert!(
            (f64::from(f32::from_bits(bits)) - expected).abs() < 1e-5,
            "{found}"
        );
    }
    for (option, word) in [("--scalar", "float"), ("--sines", "libm")] {
        let message = errors(&["generate", &path, "--lang", "js", option, word], 2);
        assert!(message.contains("is about `--lang c`"), "{message}");
    }
}

/// Fields are a struct of floats, and the sine of an angle made of them is that of Rust.
#[test]
fn fields_of_single_precision() {
    let tilted = ARM
        .replace("alpha = -0.4", "alpha = \"2 * tilt\"")
        .replace("mass = 1\n", "mass = \"load\"\n");
    let path = file("tilted.toml", tilted);
    let out = folder("tilted");
    let to = out.to_string_lossy();
    let scalar = ["--lang", "c", "--scalar", "float"];
    output(&[&["generate", &path, "--out", &to][..], &scalar].concat());
    let header = std::fs::read_to_string(out.join("tilted.h")).expect("a header");
    assert!(
        header.contains("    float load;\n    float tilt;\n} tilted_fields;"),
        "{header}"
    );
    if !has_gcc() {
        return;
    }
    let options = ReadOptions::new().names_are_fields();
    let mut arm = RuntimeRobot::from_file(&path, &options).expect("an arm");
    let state: [f32; 9] = [0.3, 0.2, -1.1, 0.5, -0.7, 1.3, 2.0, -1.0, 0.25];
    let fields: [f32; 2] = [1.7, 0.35];
    arm.set_fields(&fields.map(f64::from)).expect("two fields");
    let parts = [&state[..3], &state[3..6], &state[6..]];
    let expected = arm.evaluate_in("inverse_dynamics", &parts).expect("values");
    let expected: Vec<_> = expected
        .iter()
        .map(|x| format!("{:08x}", x.to_bits()))
        .collect();
    let texts: Vec<_> = parts.iter().map(|part| literal(part)).collect();
    let call = format!(
        "const tilted_fields arm = {{1.7f, 0.35f}}; tilted_inverse_dynamics(&arm, {}, x);",
        texts.join(", ")
    );
    let found = compiled(&out, "tilted", &main_of("tilted", &[(call, 3)]), &[]);
    assert_eq!(found.trim(), expected.join(" "));
}

/// A robot on a base that moves compiles in single precision, as C++ too.
#[test]
fn a_base_that_moves_in_single_precision() {
    let path = file("single_brick.toml", super::moving_base::BRICK);
    let out = folder("single_brick");
    let to = out.to_string_lossy();
    output(&[
        "generate", &path, "--lang", "c", "--scalar", "float", "--out", &to,
    ]);
    let header = std::fs::read_to_string(out.join("single_brick.h")).expect("a header");
    assert!(
        header.contains("const float base[12]") && !header.contains("double"),
        "{header}"
    );
    for (compiler, language) in [("gcc", "c"), ("g++", "c++")] {
        if Command::new(compiler).arg("--version").output().is_ok() {
            let mut command = Command::new(compiler);
            command
                .current_dir(&out)
                .args(["-x", language])
                .args(&FLAGS[1..]);
            succeed(command.args(["-c", "single_brick.c", "-o", "single_brick.o"]));
        }
    }
}
