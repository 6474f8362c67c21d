//! The files of `--project`: the test of a source passes, C++ has the same values, and CMake builds all of it.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::super::calls::{file, folder, has, output, refused, succeed};
use super::super::moving_base::BRICK;
use super::ARM;

/// Writes a project, and returns its folder.
fn project(name: &str, table: &str, options: &str) -> PathBuf {
    let path = file(&format!("{name}.toml"), table);
    let out = folder(&format!("project_{name}"));
    let to = out.to_string_lossy();
    let call = format!("generate {path} --lang c --project --out {to}");
    let written = output(format!("{call} {options}"));
    assert_eq!(written.lines().count(), 5, "{written}");
    out
}

/// The test passes in lanes, and where nothing is optimised.
fn assert_tested(folder: &Path, name: &str) {
    if !has("gcc") {
        return;
    }
    for build in ["-O0", "-O3 -march=native"] {
        let mut command = Command::new("gcc");
        command.current_dir(folder).args(super::FLAGS);
        command.args(build.split(' '));
        command.args([
            &format!("{name}.c"),
            &format!("{name}_test.c"),
            "-o",
            "tested",
            "-lm",
        ]);
        succeed(&mut command);
        let found = succeed(&mut Command::new(folder.join("tested")));
        assert!(found.contains("has the digits of single calls"), "{found}");
    }
}

#[test]
fn batches_have_the_digits_of_single_calls() {
    let name = "batches";
    assert_tested(&project(name, ARM, ""), name);
    let name = "single_batches";
    assert_tested(&project(name, ARM, "--scalar float"), name);
    let name = "library_batches";
    assert_tested(&project(name, ARM, "--sines libm"), name);
}

#[test]
fn batches_with_fields() {
    let tilted = ARM
        .replace("alpha = -0.4", "alpha = \"2 * tilt\"")
        .replace("mass = 1,", "mass = \"load\",");
    for (name, options) in [("tilts", ""), ("single_tilts", "--scalar float")] {
        assert_tested(&project(name, &tilted, options), name);
    }
}

#[test]
fn batches_of_a_base_that_moves() {
    for (name, options) in [("bricks", ""), ("single_bricks", "--scalar float")] {
        assert_tested(&project(name, BRICK, options), name);
    }
}

/// Arrays of the standard library have the values of C.
#[test]
fn arrays_of_cpp() {
    let out = project("arrays", ARM, "");
    if !has("g++") {
        return;
    }
    let main = "#include \"arrays.hpp\"\n#include <cstdio>\n\nint main()\n{\n    \
                const std::array<double, 3> q{{0.3, 0.2, -1.1}}, qd{{0.5, -0.7, 1.3}};\n    \
                std::array<double, 3> qdd;\n    double m[3][3];\n    const auto mass = arrays::mass_matrix(q);\n    \
                arrays_mass_matrix(q.data(), m);\n    for (int i = 0; i < 3; ++i) {\n        \
                for (int j = 0; j < 3; ++j) if (mass[i][j] != m[i][j]) return 1;\n    }\n    \
                if (arrays::forward_dynamics(q, qd, arrays::inverse_dynamics(q, qd, {{0, 0, 0}}), qdd) != 0) return 2;\n    \
                for (double x : qdd) if (x > 1e-9 || x < -1e-9) return 3;\n    \
                std::puts(arrays::kinetic_energy(q, qd) > 0.0 ? \"same\" : \"none\");\n    return 0;\n}\n";
    std::fs::write(out.join("main.cpp"), main).expect("a file");
    let mut command = Command::new("g++");
    command
        .current_dir(&out)
        .args(["-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
    succeed(command.args(["main.cpp", "-x", "c++", "arrays.c", "-o", "arrays"]));
    assert_eq!(succeed(&mut Command::new(out.join("arrays"))), "same\n");
}

#[test]
fn cmake_builds_and_tests() {
    let out = project("built", ARM, "");
    if !has("gcc") || !has("cmake") {
        return;
    }
    let run = |arguments: &str| {
        succeed(
            Command::new("cmake")
                .current_dir(&out)
                .args(arguments.split(' ')),
        )
    };
    run("-S . -B build -DBUILT_NATIVE=ON");
    run("--build build");
    succeed(&mut Command::new(out.join("build/built_test")));
}

/// A controller's project with the two lines that the guide's chapter about languages shows.
#[test]
fn cmake_links_the_functions_to_a_program() {
    let out = project("linked", ARM, "");
    if !has("g++") || !has("cmake") {
        return;
    }
    let outer = folder("project_around");
    let name = out.to_string_lossy();
    let lists = format!(
        "cmake_minimum_required(VERSION 3.10)\nproject(controller C CXX)\nadd_subdirectory(\"{name}\" linked)\n\
         add_executable(controller main.cpp)\ntarget_link_libraries(controller PRIVATE linked)\n"
    );
    let program = "#include \"linked.hpp\"\nint main() { return linked::mass_matrix({0.1, 0.2, 0.3})[0][0] > 0 ? 0 : 1; }\n";
    for (file, text) in [("CMakeLists.txt", lists.as_str()), ("main.cpp", program)] {
        std::fs::write(outer.join(file), text).expect("a file");
    }
    let run = |arguments: &str| {
        succeed(
            Command::new("cmake")
                .current_dir(&outer)
                .args(arguments.split(' ')),
        )
    };
    run("-S . -B build");
    run("--build build");
    succeed(&mut Command::new(outer.join("build/controller")));
}

#[test]
fn a_project_is_of_c() {
    let path = file("no_project.toml", ARM);
    refused(
        format!("generate {path} --lang js --project"),
        2,
        ["`--project` is about `--lang c`"],
    );
}
