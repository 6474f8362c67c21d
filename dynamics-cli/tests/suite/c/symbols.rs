//! Functions that generated C leaves to a linker, and warnings of compilers about it.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::super::calls::{file, folder, has, output, refused, succeed};
use super::super::moving_base::BRICK;
use super::ARM;
use super::sines::chain;

const FUNCTIONS: &str = "default,jacobian,jacobian_rate,coriolis_matrix,regressor,inverse_dynamics_derivatives,\
                         forward_dynamics_derivatives";

const PRECISIONS: [&str; 2] = ["double", "float"];

/// The robot in C in a folder of its own, with functions and options.
fn generated(name: &str, table: &str, options: &str) -> PathBuf {
    let path = file(&format!("{name}.toml"), table);
    let out = folder(&format!("symbols_{name}"));
    let to = out.to_string_lossy();
    output(format!("generate {path} --lang c --out {to} {options}"));
    out
}

/// An arm with fields in an angle and in a mass.
fn tilted() -> String {
    ARM.replace("alpha = -0.4", "alpha = \"2 * tilt\"")
        .replace("mass = 1,", "mass = \"load\",")
}

/// An arm with friction that falls with the velocity.
fn stribeck() -> String {
    let friction = "coulomb = 0.2, stribeck = { static = 0.3, velocity = 0.01 }";
    ARM.replace("coulomb = 0.2", friction)
}

/// The functions that an object file asks of others, where there are the programs.
fn undefined(folder: &Path, source: &str, compiler: &str, flags: &str) -> Vec<String> {
    let mut command = Command::new(compiler);
    command.current_dir(folder).args(flags.split(' '));
    // Some compilers protect the stack unless they are told not to.
    succeed(command.args([
        "-std=c99",
        "-fno-stack-protector",
        "-c",
        source,
        "-o",
        "symbols.o",
    ]));
    let mut command = Command::new("nm");
    let symbols = succeed(command.current_dir(folder).args(["-u", "symbols.o"]));
    let names = symbols.split_whitespace().filter(|word| *word != "U");
    names.map(str::to_owned).collect()
}

/// A source calls these functions and no others, whatever the compiler and its level.
fn assert_called(name: &str, table: &str, options: &str, levels: &[&str], expected: &[&str]) {
    let folder = generated(name, table, options);
    let source = format!("{name}.c");
    for compiler in ["gcc", "clang"] {
        if !has(compiler) || !has("nm") {
            println!("left out: symbols of {name}, without {compiler} or nm");
            continue;
        }
        for level in levels {
            for flags in [(*level).to_owned(), format!("{level} -ffreestanding")] {
                let found = undefined(&folder, &source, compiler, &flags);
                assert_eq!(found, expected, "{name}: {compiler} {flags}");
            }
        }
    }
}

const LEVELS: [&str; 2] = ["-O0", "-O2"];

/// `memcpy` neither, which compilers call for a struct, and which they make of a loop that copies.
fn assert_none(functions: &str, levels: &[&str]) {
    for precision in PRECISIONS {
        let options = format!("--functions {functions} --scalar {precision}");
        assert_called(
            &format!("none_{precision}"),
            &tilted(),
            &options,
            levels,
            &[],
        );
    }
}

#[test]
fn no_function_of_a_library_is_called() {
    assert_none("mass_matrix,forward_dynamics", &LEVELS);
    let options = "--scalar float --functions inverse_dynamics";
    assert_called("none_of_a_base", BRICK, options, &LEVELS, &[]);
}

/// `cargo test -p dynamics-cli --test suite c::symbols -- --ignored`
#[test]
#[ignore = "a minute: .ci/run runs it"]
fn no_function_of_a_library_is_called_at_any_level() {
    assert_none(
        FUNCTIONS,
        &["-O0", "-O1", "-Os", "-O2", "-O3 -march=native"],
    );
}

#[test]
fn stribeck_s_friction_calls_the_exponential_alone() {
    for (precision, expected) in PRECISIONS.into_iter().zip(["exp", "expf"]) {
        let options = format!("--scalar {precision} --functions friction_vector");
        let name = format!("stribeck_{precision}");
        assert_called(&name, &stribeck(), &options, &LEVELS, &[expected]);
    }
}

/// Three joints, all solutions of which are found by quadratics.
const ELBOW: &str = r#"
convention = "standard"
gravity = [0, 0, -9.81]
functions = ["inverse_kinematics"]
joint = [
    { name = "waist", type = "revolute", d = 0.5, alpha = "PI/2" },
    { name = "shoulder", type = "revolute", a = 0.4 },
    { name = "elbow", type = "revolute", a = 0.3 },
]
"#;

/// Not at `-O0`, where clang copies structs by `memcpy`.
#[test]
fn closed_forms_call_the_root_alone() {
    for (precision, root) in PRECISIONS.into_iter().zip(["sqrt", "sqrtf"]) {
        let name = format!("elbow_{precision}");
        let folder = generated(&name, ELBOW, &format!("--scalar {precision}"));
        for compiler in ["gcc", "clang"] {
            if !has(compiler) || !has("nm") {
                println!("left out: symbols of {name}, without {compiler} or nm");
                continue;
            }
            for flags in ["-O2", "-O2 -ffreestanding"] {
                let found = undefined(&folder, &format!("{name}_inverse.c"), compiler, flags);
                assert_eq!(found, [root], "{name}: {compiler} {flags}");
            }
        }
    }
}

/// All warnings of clang but those about C99 itself, and the layout of a user's own fields.
const CLANG: &str = "-Weverything -Wno-declaration-after-statement -Wno-padded -Wno-unknown-warning-option \
                     -Wno-unsafe-buffer-usage";

const GCC: &str = "-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wundef -Wunused-macros \
                   -Wstrict-prototypes -Wmissing-prototypes -Wcast-qual -Wdouble-promotion -Wfloat-equal";

/// No compiler has anything to say about a source, on a processor without lanes neither.
fn assert_silent(name: &str, table: &str, options: &str) {
    let folder = generated(name, table, options);
    let source = format!("{name}.c");
    for (compiler, warnings) in [("gcc", GCC), ("clang", CLANG)] {
        if !has(compiler) {
            println!("left out: warnings about {name}, without {compiler}");
            continue;
        }
        let text = std::fs::read_to_string(folder.join(&source)).expect("a source");
        // A controller's processor, without a C library.
        let is_for_controllers = compiler == "clang" && !text.contains("math.h");
        let controller = "-O2 --target=thumbv7em-none-eabihf -ffreestanding";
        let controller = is_for_controllers.then_some(controller);
        for more in ["-O2", "-O1 -U__SSE2__"].into_iter().chain(controller) {
            let mut command = Command::new(compiler);
            command
                .current_dir(&folder)
                .args(warnings.split_whitespace());
            command.args(more.split(' ')).args(["-std=c99", "-Werror"]);
            succeed(command.args(["-c", &source, "-o", "silent.o"]));
        }
    }
}

/// Each number of angles, and functions that a source has alone.
#[test]
fn compilers_warn_of_nothing() {
    for joints in 1..=8 {
        let name = format!("silent_{joints}");
        let options = "--functions forward_kinematics --scalar float";
        assert_silent(&name, &chain(joints), options);
    }
    for function in [
        "forward_dynamics",
        "friction_vector",
        "kinetic_energy",
        "jacobian",
    ] {
        for precision in PRECISIONS {
            let options = format!("--functions {function} --scalar {precision}");
            assert_silent(&format!("{function}_{precision}"), &stribeck(), &options);
        }
    }
    assert_silent("silent_fields", &tilted(), "--functions inverse_dynamics");
    assert_silent(
        "silent_library",
        ARM,
        "--functions inverse_dynamics --sines libm",
    );
}

/// Flash and stack of batches are for programs that call them.
#[test]
fn no_batches_where_none_are_asked_for() {
    let options = "--functions default,jacobian --scalar float --no-batches";
    let out = generated("lean", &tilted(), options);
    for ending in ["h", "c"] {
        let text = std::fs::read_to_string(out.join(format!("lean.{ending}"))).expect("a file");
        for word in ["batch", "column", "LANES", "nan("] {
            assert!(!text.contains(word), "{word}: {text}");
        }
    }
    assert_called("lean", &tilted(), options, &LEVELS, &[]);
    let path = file("lean.toml", ARM);
    let call = format!("generate {path} --no-batches");
    refused(format!("{call} --lang js"), 2, ["is about `--lang c`"]);
    refused(
        format!("{call} --lang c --project"),
        2,
        ["--no-batches", "--project"],
    );
}
