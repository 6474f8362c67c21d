//! Inverse kinematics in closed form, as C and JavaScript: random poses are solved, and all solutions lead to them.

use std::path::Path;
use std::process::Command;

use super::calls::{assert_has, errors, file, folder, has, output, refused, succeed};

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
    let (beyond, counts) = (beyond(name), u8::from(elbow.is_empty()));
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
        lost += {counts} && nearest > 1e-9;
    }}
    double far[4][4] = {{{{1, 0, 0, NAN}}, {{0, 1, 0, 0}}, {{0, 0, 1, 0}}, {{0, 0, 0, 1}}}}, found[8][{joints}];
    int singular[8];
    lost += {name}_inverse_kinematics({arm}(const double(*)[4])far{elbow}, found, singular) != -2;
    far[0][3] = far[1][3] = 100;
    lost += {name}_inverse_kinematics({arm}(const double(*)[4])far{elbow}, found, singular) != {beyond};
    double pose[4][4], transposed[4][4];
    for (int i = 0; i < {joints}; ++i) found[0][i] = 0.3;
    {name}_forward_kinematics({arm}found[0], pose);
    for (int i = 0; i < 16; ++i) transposed[i % 4][i / 4] = pose[i / 4][i % 4];
    lost += {name}_inverse_kinematics({arm}(const double(*)[4])transposed{elbow}, found, singular) != -2;
    for (int i = 0; i < 16; ++i) pose[i / 4][i % 4] = floor(pose[i / 4][i % 4] * 1e4) / 1e4;
    lost += {name}_inverse_kinematics({arm}(const double(*)[4])pose{elbow}, found, singular) < 1;
    pose[0][0] += 0.01;
    lost += {name}_inverse_kinematics({arm}(const double(*)[4])pose{elbow}, found, singular) != -2;
    printf("%d %.1e %d\n", all, worst, lost);
    return 0;
}}
"#
    )
}

/// The count for a pose 100 m away; a joint that slides has no end.
fn beyond(name: &str) -> i32 {
    if name == "stanford" { 8 } else { -1 }
}

fn javascript_program(name: &str, joints: usize, fields: &str, elbow: &str) -> String {
    let arm = if fields.is_empty() {
        ""
    } else {
        "{ upper: 0.4318, double: 0.4318 }, "
    };
    let elbow = if elbow.is_empty() { "" } else { ", 0.3" };
    let (beyond, counts) = (beyond(name), u8::from(elbow.is_empty()));
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
  lost += {counts} && Math.min(...ways) > 1e-9 ? 1 : 0;
  lost += found.filter((one) => one.q[0] <= -Math.PI).length;
}}
const far = [[1, 0, 0, NaN], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
lost += inverse_kinematics({arm}far{elbow}).count !== -2;
far[0][3] = far[1][3] = 100;
lost += inverse_kinematics({arm}far{elbow}).count !== {beyond};
const pose = forward_kinematics({arm}Array({joints}).fill(0.3));
const transposed = pose[0].map((_, j) => pose.map((row) => row[j]));
lost += inverse_kinematics({arm}transposed{elbow}).count !== -2;
const rounded = pose.map((row) => row.map((x) => Math.floor(x * 1e4) / 1e4));
lost += inverse_kinematics({arm}rounded{elbow}).count < 1;
rounded[0][0] += 0.01;
lost += inverse_kinematics({arm}rounded{elbow}).count !== -2;
console.log(`${{all}} ${{worst.toExponential(1)}} ${{lost}}`);
"#
    )
}

/// Checks the numbers that a program printed, and returns how many solutions it found. For seven joints the program
/// chooses another angle of the elbow than the drawn joints have, so that these may be missing and are not counted.
fn check(printed: &str) -> usize {
    let words: Vec<&str> = printed.split_whitespace().collect();
    let [all, worst, lost] = words[..] else {
        panic!("{printed}")
    };
    let worst: f64 = worst.parse().expect("a number");
    assert!(worst < 2e-14, "{printed}");
    assert_eq!(lost, "0", "{printed}");
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
            counts.push(check(&succeed(&mut Command::new(at("main")))));
        }
        if has_javascript {
            let folder = generated(name, table, "js");
            let program = Path::new(&folder).join("main.mjs");
            std::fs::write(&program, javascript_program(name, joints, fields, elbow))
                .expect("a file");
            counts.push(check(&succeed(Command::new("node").arg(&program))));
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

/// A UR3e, and solutions of its singular poses as Rust finds them: a line of degrees, then a line with `#` for each solution.
const UR3E: &str = r#"
convention = "standard"
gravity = [0, 0, -9.81]
functions = ["forward_kinematics", "inverse_kinematics"]
joint = [
    { name = "q1", type = "revolute", d = 0.15185, alpha = "PI/2" },
    { name = "q2", type = "revolute", a = -0.24355 },
    { name = "q3", type = "revolute", a = -0.2132 },
    { name = "q4", type = "revolute", d = 0.13105, alpha = "PI/2" },
    { name = "q5", type = "revolute", d = 0.08535, alpha = "-PI/2" },
    { name = "q6", type = "revolute", d = 0.0921 },
]
"#;
const LISTED: &str = include_str!("../../../tests/data/closed_forms.txt");

/// The poses of a listing, each with its solutions.
fn parsed(listing: &str) -> Vec<(String, Vec<[f64; 7]>)> {
    let mut poses: Vec<(String, Vec<[f64; 7]>)> = Vec::new();
    for line in listing.lines() {
        match line.strip_prefix('#') {
            None => poses.push((line.trim().to_owned(), Vec::new())),
            Some(numbers) => {
                let words = numbers.split_whitespace();
                let numbers: Vec<f64> = words.map(|x| x.parse().expect("a number")).collect();
                let (_, solutions) = poses.last_mut().expect("a pose");
                solutions.push(numbers.try_into().expect("six joints and a mark"));
            }
        }
    }
    poses
}

/// Whether a solution is among others, to the digits of the listing: a double root is there once or twice.
fn is_among(one: &[f64; 7], others: &[[f64; 7]]) -> bool {
    let is_near = |a: f64, b: f64| (0.5 * (a - b)).sin().abs() < 2e-6;
    let is_same = |other: &[f64; 7]| {
        let joints = one[..6].iter().zip(other);
        joints.into_iter().all(|(a, b)| is_near(*a, *b)) && one[6] == other[6]
    };
    others.iter().any(is_same)
}

fn is_as_listed(printed: &str) {
    let (found, expected) = (parsed(printed), parsed(LISTED));
    assert_eq!(found.len(), expected.len());
    for ((degrees, found), (_, expected)) in found.iter().zip(&expected) {
        for (some, others) in [(found, expected), (expected, found)] {
            let missing = some.iter().find(|one| !is_among(one, others));
            assert!(
                missing.is_none(),
                "{degrees}: {missing:?} of {found:?} and {expected:?}"
            );
        }
    }
}

/// Singular poses, where joints are free and arms at the edge of their reach: C and JavaScript have the solutions of Rust.
#[test]
fn c_and_javascript_have_the_solutions_of_rust() {
    let poses = parsed(LISTED);
    let rows: Vec<_> = poses
        .iter()
        .map(|(line, _)| line.replace(' ', ", "))
        .collect();
    if has("gcc") {
        let folder = generated("ur3e", UR3E, "c");
        let at = |file: &str| Path::new(&folder).join(file);
        let rows: Vec<_> = rows.iter().map(|row| format!("{{{row}}}")).collect();
        let program = format!(
            r##"#include <stdio.h>
#include "ur3e.h"
#include "ur3e_inverse.h"
static const double degrees[][6] = {{{}}};
int main(void)
{{
    for (unsigned k = 0; k < sizeof degrees / sizeof degrees[0]; ++k) {{
        double q[6], pose[4][4], found[8][6];
        int singular[8];
        for (int i = 0; i < 6; ++i) {{
            q[i] = degrees[k][i] * (3.141592653589793 / 180);
            printf("%.0f ", degrees[k][i]);
        }}
        printf("\n");
        ur3e_forward_kinematics(q, pose);
        const int count = ur3e_inverse_kinematics((const double(*)[4])pose, found, singular);
        for (int j = 0; j < count; ++j) {{
            printf("#");
            for (int i = 0; i < 6; ++i) printf(" %.9f", found[j][i]);
            printf(" %d\n", singular[j]);
        }}
    }}
    return 0;
}}
"##,
            rows.join(", ")
        );
        std::fs::write(at("main.c"), program).expect("a file");
        let mut gcc = Command::new("gcc");
        gcc.current_dir(&folder).args([
            "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "main",
        ]);
        succeed(gcc.args(["main.c", "ur3e.c", "ur3e_inverse.c", "-lm"]));
        is_as_listed(&succeed(&mut Command::new(at("main"))));
    }
    if has("node") {
        let folder = generated("ur3e", UR3E, "js");
        let program = Path::new(&folder).join("main.mjs");
        let rows: Vec<_> = rows.iter().map(|row| format!("[{row}]")).collect();
        let text = format!(
            r##"import {{ forward_kinematics }} from "./ur3e.mjs";
import {{ inverse_kinematics }} from "./ur3e_inverse.mjs";
for (const degrees of [{}]) {{
  console.log(degrees.join(" "));
  const found = inverse_kinematics(forward_kinematics(degrees.map((x) => x * (Math.PI / 180))));
  for (const {{ q, isSingular }} of found) console.log(`# ${{q.join(" ")}} ${{isSingular ? 1 : 0}}`);
}}
"##,
            rows.join(", ")
        );
        std::fs::write(&program, text).expect("a file");
        is_as_listed(&succeed(Command::new("node").arg(&program)));
    }
}
