//! Inverse kinematics in closed form, as C and JavaScript: random poses are solved, and all solutions lead to them.

use std::path::Path;
use std::process::Command;

use super::calls::{assert_has, errors, file, folder, has, output, refused, succeed};

/// A PUMA with fields, one of them a word of C, and a gantry with a wrist.
const PUMA: &str = r#"
convention = "standard"
gravity = [0, 0, -9.81]
functions = ["forward_kinematics", "inverse_kinematics"]
joint = [
    { name = "q1", type = "revolute", d = 0.67183, alpha = "PI/2" },
    { name = "q2", type = "revolute", a = "upper" },
    { name = "q3", type = "revolute", a = 0.0203, d = 0.15005, alpha = "-PI/2" },
    { name = "q4", type = "revolute", d = "double", alpha = "PI/2" },
    { name = "q5", type = "revolute", alpha = "-PI/2" },
    { name = "q6", type = "revolute" },
]
"#;
const STANFORD: &str = r#"
convention = "standard"
gravity = [0, 0, -9.81]
functions = ["forward_kinematics", "inverse_kinematics"]
joint = [
    { name = "q1", type = "revolute", d = 0.412, alpha = "-PI/2" },
    { name = "q2", type = "revolute", d = 0.154, alpha = "PI/2" },
    { name = "q3", type = "prismatic", a = 0.0203, theta = "-PI/2" },
    { name = "q4", type = "revolute", alpha = "deg(-60)" },
    { name = "q5", type = "revolute", alpha = "deg(60)" },
    { name = "q6", type = "revolute", d = 0.1 },
]
"#;

/// Programs that print how many solutions 200 random poses have, and the largest error of a pose.
const C_PROGRAM: &str = r#"#include <math.h>
#include <stdio.h>
#include "puma.h"
#include "puma_inverse.h"
static unsigned long long state = 7;
static double draw(void)
{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11) / (double)(1ULL << 52) - 1;
}
int main(void)
{
    const puma_fields arm = {0.4318, 0.4318};
    int all = 0, singular[8];
    double q[6], pose[4][4], found[8][6], there[4][4], worst = 0;
    for (int draws = 0; draws < 200; ++draws) {
        for (int i = 0; i < 6; ++i) q[i] = 3.1 * draw();
        puma_forward_kinematics(&arm, q, pose);
        const int count = puma_inverse_kinematics(&arm, (const double(*)[4])pose, found, singular);
        all += count;
        for (int k = 0; k < count; ++k) {
            puma_forward_kinematics(&arm, found[k], there);
            for (int i = 0; i < 16; ++i) worst = fmax(worst, fabs(there[i / 4][i % 4] - pose[i / 4][i % 4]));
        }
    }
    printf("%d %.1e\n", all, worst);
    return 0;
}
"#;
const JAVASCRIPT_PROGRAM: &str = r#"import { forward_kinematics } from "./puma.mjs";
import { inverse_kinematics } from "./puma_inverse.mjs";
let state = 7n;
const draw = () => {
  state = (state * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
  return Number(state >> 11n) / 2 ** 52 - 1;
};
const arm = { upper: 0.4318, double: 0.4318 };
let [all, worst] = [0, 0];
for (let draws = 0; draws < 200; ++draws) {
  const pose = forward_kinematics(arm, Array.from({ length: 6 }, () => 3.1 * draw()));
  const found = inverse_kinematics(arm, pose);
  all += found.length;
  for (const one of found) {
    const there = forward_kinematics(arm, one.q);
    there.forEach((row, i) => row.forEach((x, j) => (worst = Math.max(worst, Math.abs(x - pose[i][j])))));
  }
}
console.log(`${all} ${worst.toExponential(1)}`);
"#;

/// Checks the numbers that a program printed, and returns how many solutions it found.
fn check(printed: &str) -> usize {
    let (all, worst) = printed.trim().split_once(' ').expect("two numbers");
    let worst: f64 = worst.parse().expect("a number");
    assert!(worst < 2e-14, "{printed}");
    all.parse().expect("a number")
}

/// The path of a folder.
fn text_of(name: &str) -> String {
    folder(name).display().to_string()
}

fn generated(name: &str, table: &str, language: &str) -> String {
    let table = file(&format!("{name}.toml"), table);
    let folder = text_of(&format!("closed_forms_{name}_{language}"));
    output(format!("generate {table} --lang {language} --out {folder}"));
    folder
}

/// Fields are the first argument. That solutions are those of Rust is a test of `tests/inverse`.
#[test]
fn c_and_javascript_take_fields() {
    let mut counts = Vec::new();
    if has("gcc") {
        let folder = generated("puma", PUMA, "c");
        let at = |file: &str| Path::new(&folder).join(file);
        std::fs::write(at("main.c"), C_PROGRAM).expect("a file");
        let mut gcc = Command::new("gcc");
        gcc.current_dir(&folder).args([
            "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "main",
        ]);
        succeed(gcc.args(["main.c", "puma.c", "puma_inverse.c", "-lm"]));
        counts.push(check(&succeed(&mut Command::new(at("main")))));
    }
    if has("node") {
        let folder = generated("puma", PUMA, "js");
        let program = Path::new(&folder).join("main.mjs");
        std::fs::write(&program, JAVASCRIPT_PROGRAM).expect("a file");
        counts.push(check(&succeed(Command::new("node").arg(&program))));
    }
    assert!(counts.iter().all(|count| *count == 1_600), "{counts:?}");
}

/// Other languages leave it out and say so; a file that asks for nothing else has nothing to write.
#[test]
fn other_languages_leave_it_out() {
    let table = file("closed_matlab.toml", STANFORD);
    let to = text_of("closed_forms_matlab");
    let said = super::calls::run(format!("generate {table} --lang matlab --out {to}"));
    let remark = String::from_utf8_lossy(&said.stderr).into_owned();
    assert!(
        said.status.success() && remark.contains("`inverse_kinematics` is left out"),
        "{remark}"
    );
    let alone = STANFORD.replace("\"forward_kinematics\", ", "");
    let alone = file("closed_alone.toml", alone);
    refused(
        format!("generate {alone} --lang matlab --out {to}"),
        1,
        ["nothing else is requested"],
    );
    let files = output(format!("generate {alone} --lang js --out {to}"));
    assert!(
        files.trim().ends_with("closed_alone_inverse.mjs") && files.lines().count() == 1,
        "{files}"
    );
    let none = STANFORD.replace("alpha = \"deg(60)\"", "alpha = \"deg(60)\", a = 0.01");
    let none = file("closed_none.toml", none);
    let refused = errors(format!("generate {none} --lang c --out {to}"), 1);
    assert_has(
        &refused,
        [
            "neither the first three nor the last three",
            "`robot-dynamics reach` solves numerically",
        ],
    );
}
