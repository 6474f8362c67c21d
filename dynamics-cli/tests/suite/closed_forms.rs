//! Inverse kinematics in closed form, as C and JavaScript: random poses are solved, and all solutions lead to them.

use std::path::Path;
use std::process::Command;

use super::calls::{errors, file, folder, has, output, succeed};

/// A PUMA with fields, one of them a word of C, seven joints, and a gantry with a wrist.
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
const SEVEN: &str = r#"
convention = "standard"
gravity = [0, 0, -9.81]
functions = ["forward_kinematics", "inverse_kinematics"]
joint = [
    { name = "q1", type = "revolute", d = 0.36, alpha = "-PI/2" },
    { name = "q2", type = "revolute", alpha = "PI/2" },
    { name = "q3", type = "revolute", d = 0.42, alpha = "PI/2" },
    { name = "q4", type = "revolute", alpha = "-PI/2" },
    { name = "q5", type = "revolute", d = 0.4, alpha = "-PI/2" },
    { name = "q6", type = "revolute", alpha = "PI/2" },
    { name = "q7", type = "revolute", d = 0.126 },
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

/// Name, table, number of joints, the first arguments of functions, and the last one of the inverse in C and in JavaScript.
const ARMS: [(&str, &str, usize, &str, &str); 3] = [
    ("puma", PUMA, 6, "FIELDS", ""),
    ("seven", SEVEN, 7, "", "ELBOW"),
    ("stanford", STANFORD, 6, "", ""),
];

/// The first joint of some poses: its sine is nothing but rounding, of either sign.
const HALF_TURN: f64 = std::f64::consts::PI;

/// A program that prints how many solutions 200 random poses have, the largest error of a pose, and of how many poses the joints
/// were not among the solutions, or an angle of them was minus half a turn.
fn c_program(name: &str, joints: usize, fields: &str, elbow: &str) -> String {
    let arm = if fields.is_empty() { "" } else { "&arm, " };
    let elbow = if elbow.is_empty() { "" } else { ", 0.3" };
    let declared = format!("const {name}_fields arm = {{0.4318, 0.4318}};");
    let declared = if fields.is_empty() { "" } else { &declared };
    format!(
        r#"#include <math.h>
#include <stdio.h>
#include "{name}.h"
#include "{name}_inverse.h"
static unsigned long long state = 7;
static double draw(void)
{{
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11) / (double)(1ULL << 52) - 1;
}}
int main(void)
{{
    {declared}
    int all = 0, lost = 0;
    double worst = 0;
    for (int draws = 0; draws < 200; ++draws) {{
        double q[{joints}], pose[4][4], found[8][{joints}], there[4][4], nearest = 1e9;
        int singular[8];
        for (int i = 0; i < {joints}; ++i) q[i] = 3.1 * draw();
        if (draws % 4 == 0) q[0] = {HALF_TURN};
        {name}_forward_kinematics({arm}q, pose);
        const int count = {name}_inverse_kinematics({arm}(const double(*)[4])pose{elbow}, found, singular);
        all += count;
        for (int k = 0; k < count; ++k) {{
            double way = 0;
            {name}_forward_kinematics({arm}found[k], there);
            for (int i = 0; i < 16; ++i) worst = fmax(worst, fabs(there[i / 4][i % 4] - pose[i / 4][i % 4]));
            for (int i = 0; i < {joints}; ++i) way = fmax(way, fabs(sin(0.5 * (found[k][i] - q[i]))));
            nearest = fmin(nearest, way);
            lost += found[k][0] <= -{HALF_TURN};
        }}
        lost += nearest > 1e-9;
    }}
    double far[4][4] = {{{{1, 0, 0, NAN}}, {{0, 1, 0, 0}}, {{0, 0, 1, 0}}, {{0, 0, 0, 1}}}}, found[8][{joints}];
    int singular[8];
    all += 100000 * {name}_inverse_kinematics({arm}(const double(*)[4])far{elbow}, found, singular);
    double pose[4][4], transposed[4][4];
    for (int i = 0; i < {joints}; ++i) found[0][i] = 0.3;
    {name}_forward_kinematics({arm}found[0], pose);
    for (int i = 0; i < 16; ++i) transposed[i % 4][i / 4] = pose[i / 4][i % 4];
    all += 100000 * {name}_inverse_kinematics({arm}(const double(*)[4])transposed{elbow}, found, singular);
    printf("%d %.1e %d\n", all, worst, lost);
    return 0;
}}
"#
    )
}

fn javascript_program(name: &str, joints: usize, fields: &str, elbow: &str) -> String {
    let arm = if fields.is_empty() {
        ""
    } else {
        "{ upper: 0.4318, double: 0.4318 }, "
    };
    let elbow = if elbow.is_empty() { "" } else { ", 0.3" };
    format!(
        r#"import {{ forward_kinematics }} from "./{name}.mjs";
import {{ inverse_kinematics }} from "./{name}_inverse.mjs";
let state = 7n;
const draw = () => {{
  state = (state * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
  return Number(state >> 11n) / 2 ** 52 - 1;
}};
let [all, worst, lost] = [0, 0, 0];
for (let draws = 0; draws < 200; ++draws) {{
  const q = Array.from({{ length: {joints} }}, () => 3.1 * draw());
  if (draws % 4 === 0) q[0] = Math.PI;
  const pose = forward_kinematics({arm}q);
  const found = inverse_kinematics({arm}pose{elbow});
  all += found.length;
  for (const one of found) {{
    const there = forward_kinematics({arm}one.q);
    there.forEach((row, i) => row.forEach((x, j) => (worst = Math.max(worst, Math.abs(x - pose[i][j])))));
  }}
  const ways = found.map((one) => Math.max(...one.q.map((x, i) => Math.abs(Math.sin(0.5 * (x - q[i]))))));
  lost += Math.min(...ways) > 1e-9 ? 1 : 0;
  lost += found.filter((one) => one.q[0] <= -Math.PI).length;
}}
const far = [[1, 0, 0, NaN], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
all += 100000 * inverse_kinematics({arm}far{elbow}).length;
const pose = forward_kinematics({arm}Array({joints}).fill(0.3));
const transposed = pose[0].map((_, j) => pose.map((row) => row[j]));
all += 100000 * inverse_kinematics({arm}transposed{elbow}).length;
console.log(`${{all}} ${{worst.toExponential(1)}} ${{lost}}`);
"#
    )
}

/// Checks the numbers that a program printed, and returns how many solutions it found. For seven joints the program
/// chooses another angle of the elbow than the drawn joints have, so that these may be missing.
fn check(printed: &str, elbow: &str) -> usize {
    let words: Vec<&str> = printed.split_whitespace().collect();
    let [all, worst, lost] = words[..] else {
        panic!("{printed}")
    };
    let worst: f64 = worst.parse().expect("a number");
    assert!(worst < 2e-14, "{printed}");
    assert!(
        elbow.is_empty() && lost == "0" || !elbow.is_empty(),
        "{printed}"
    );
    all.parse().expect("a number")
}

/// The path of a folder.
fn text_of(name: &str) -> String {
    folder(name).display().to_string()
}

fn generated(name: &str, table: &str, language: &str) -> String {
    let table = file(&format!("{name}.toml"), table);
    let folder = text_of(&format!("closed_forms_{name}_{language}"));
    output(&["generate", &table, "--lang", language, "--out", &folder]);
    folder
}

#[test]
fn c_and_javascript_solve_every_pose() {
    let (has_c, has_javascript) = (has("gcc"), has("node"));
    for (name, table, joints, fields, elbow) in ARMS {
        let mut counts = Vec::new();
        if has_c {
            let folder = generated(name, table, "c");
            let at = |file: &str| Path::new(&folder).join(file);
            std::fs::write(at("main.c"), c_program(name, joints, fields, elbow)).expect("a file");
            let sources = [
                "main.c".to_owned(),
                format!("{name}.c"),
                format!("{name}_inverse.c"),
            ];
            let mut gcc = Command::new("gcc");
            gcc.current_dir(&folder).args([
                "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "main",
            ]);
            succeed(gcc.args(&sources).arg("-lm"));
            counts.push(check(&succeed(&mut Command::new(at("main"))), elbow));
        }
        if has_javascript {
            let folder = generated(name, table, "js");
            let program = Path::new(&folder).join("main.mjs");
            std::fs::write(&program, javascript_program(name, joints, fields, elbow))
                .expect("a file");
            counts.push(check(&succeed(Command::new("node").arg(&program)), elbow));
        }
        counts.dedup();
        assert!(counts.len() <= 1, "{name}: {counts:?}");
        assert!(
            counts.iter().all(|count| (800..=1600).contains(count)),
            "{name}: {counts:?}"
        );
    }
}

/// Other languages leave it out and say so; a file that asks for nothing else has nothing to write.
#[test]
fn other_languages_leave_it_out() {
    let table = file("closed_matlab.toml", STANFORD);
    let to = text_of("closed_forms_matlab");
    let said = super::calls::run(&["generate", &table, "--lang", "matlab", "--out", &to]);
    let remark = String::from_utf8_lossy(&said.stderr).into_owned();
    assert!(
        said.status.success() && remark.contains("`inverse_kinematics` is left out"),
        "{remark}"
    );
    let alone = STANFORD.replace("\"forward_kinematics\", ", "");
    let alone = file("closed_alone.toml", alone);
    let refused = errors(&["generate", &alone, "--lang", "matlab", "--out", &to], 1);
    assert!(refused.contains("nothing else is requested"), "{refused}");
    let files = output(&["generate", &alone, "--lang", "js", "--out", &to]);
    assert!(
        files.trim().ends_with("closed_alone_inverse.mjs") && files.lines().count() == 1,
        "{files}"
    );
    let none = STANFORD.replace("alpha = \"deg(60)\"", "alpha = \"deg(60)\", a = 0.01");
    let none = file("closed_none.toml", none);
    let refused = errors(&["generate", &none, "--lang", "c", "--out", &to], 1);
    assert!(
        refused.contains("neither the first three nor the last three")
            && refused.contains("`robot-dynamics reach` solves numerically"),
        "{refused}"
    );
}
