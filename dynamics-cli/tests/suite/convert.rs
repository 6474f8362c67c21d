//! Files that are converted describe the same arm, as numeric Newton-Euler reads them.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use dynamics_evaluation::{ReadOptions, RuntimeRobot, read_file};
use dynamics_numeric::NewtonEuler;
use dynamics_runtime::nalgebra::SVector;
use dynamics_symbolic::robot::{Convention, Robot};

use super::calls::{assert_has, data, errors, file, folder, output};

/// An arm in a URDF file of `tests/data/urdf`.
struct Arm {
    name: String,
    file: String,
    options: String,
    besides: ReadOptions,
}

const GRAVITY: &str = "gravity = [0, 0, -9.81]\nallow = [\"unphysical_inertia\"]\n";

/// The strings between brackets behind a key of a JSON file that has no other brackets in them.
fn strings(json: &str, key: &str) -> Vec<String> {
    let behind = json
        .split_once(&format!("\"{key}\": ["))
        .expect("the key")
        .1;
    let list = behind.split_once(']').expect("a list").0;
    list.split('"')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

/// The numbers of an object of them.
fn numbers(json: &str, key: &str) -> BTreeMap<String, String> {
    let behind = json
        .split_once(&format!("\"{key}\": {{"))
        .expect("the key")
        .1;
    let items = behind.split_once('}').expect("an object").0.split(',');
    let item = |item: &str| {
        let (name, number) = item.split_once(':')?;
        Some((
            name.trim().trim_matches('"').to_owned(),
            number.trim().to_owned(),
        ))
    };
    items.filter_map(item).collect()
}

/// All arms of the folder.
fn arms() -> Vec<Arm> {
    let folder = PathBuf::from(data("urdf"));
    let entries = std::fs::read_dir(&folder).expect("the folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "json"))
        .collect();
    paths.sort();
    paths.iter().map(|path| arm(path)).collect()
}

fn arm(path: &Path) -> Arm {
    let json = std::fs::read_to_string(path).expect("a reference");
    let file = json.split('"').nth(3).expect("a file");
    let chain: [String; 2] = strings(&json, "chain").try_into().expect("two links");
    let ignore = strings(&json, "ignore");
    let lock = numbers(&json, "lock");
    let mut options = format!("--chain {}", chain.join(","));
    let mut entries = GRAVITY.to_owned();
    for joint in &ignore {
        options += &format!(" --ignore {joint}");
    }
    for (joint, position) in &lock {
        options += &format!(" --lock {joint}={position}");
    }
    if !lock.is_empty() {
        let lock: Vec<_> = lock
            .iter()
            .map(|(joint, q)| format!("{joint:?} = {q}"))
            .collect();
        entries += &format!("lock = {{ {} }}\n", lock.join(", "));
    }
    options += " --gravity 0,0,-9.81 --allow unphysical_inertia";
    Arm {
        name: path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned(),
        file: data(&format!("urdf/{file}")),
        options,
        besides: ReadOptions::new()
            .entries(&entries)
            .chain(chain)
            .ignore(ignore),
    }
}

pub(super) fn read(path: &str, besides: &ReadOptions) -> Robot {
    let model = read_file(Path::new(path), besides);
    model.unwrap_or_else(|error| panic!("{error}")).robot
}

/// Calls `convert`, and reads what it wrote to that file.
pub(super) fn converted(
    file: &str,
    options: &str,
    name: &str,
    besides: &ReadOptions,
) -> (String, Robot) {
    let path = folder("converted").join(name);
    let path = path.to_string_lossy().into_owned();
    output(format!("convert {file} --out {path} {options}"));
    let robot = read(&path, besides);
    (path, robot)
}

/// The largest difference of M, V, G, tau and the tip's pose at some states, relative to the largest entry.
fn difference(one: &Robot, other: &Robot) -> f64 {
    largest(differences(one, other))
}

pub(super) fn largest(differences: impl IntoIterator<Item = f64>) -> f64 {
    let worse = |worst, x: f64| if x > worst || x.is_nan() { x } else { worst };
    differences.into_iter().fold(0.0, worse)
}

/// The largest difference of each of the five.
fn differences(one: &Robot, other: &Robot) -> [f64; 5] {
    macro_rules! of_joints {
        ($($n:literal)*) => {
            match one.dof() {
                $($n => differences_of::<$n>(one, other),)*
                dof => panic!("{dof} joints"),
            }
        };
    }
    of_joints!(1 2 3 4 5 6 7 8)
}

fn differences_of<const N: usize>(one: &Robot, other: &Robot) -> [f64; 5] {
    let values = [one, other].map(|robot| {
        let arm = RuntimeRobot::of_programs(robot.clone(), &[]).expect("an arm");
        let table = arm.table().of_joints::<N>().expect("so many joints");
        let numeric = NewtonEuler::new(&table);
        let mut values: [Vec<f64>; 5] = Default::default();
        for state in 0..20 {
            let vector = |seed: usize, range: f64| {
                SVector::<f64, N>::from_fn(|i, _| {
                    range * ((1 + 31 * state + 7 * seed + 13 * i) as f64).sin()
                })
            };
            let (q, qd, qdd) = (vector(0, 3.0), vector(1, 3.0), vector(2, 10.0));
            values[0].extend(numeric.mass_matrix(&q).iter());
            values[1].extend(numeric.coriolis_vector(&q, &qd).iter());
            values[2].extend(numeric.gravity_vector(&q).iter());
            values[3].extend(numeric.inverse_dynamics(&q, &qd, &qdd).iter());
            values[4].extend(numeric.forward_kinematics(&q).iter());
        }
        values
    });
    let of_quantity = |k: usize| {
        let (a, b) = (&values[0][k], &values[1][k]);
        assert_eq!(a.len(), b.len());
        let size = a.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        let worst = largest(differences);
        if size > 0.0 { worst / size } else { worst }
    };
    [0, 1, 2, 3, 4].map(of_quantity)
}

fn names(robot: &Robot) -> Vec<&str> {
    robot.joints().map(|row| row.name.as_str()).collect()
}

/// Every arm is converted to tables of both conventions, and one of these back to URDF. All of them have M, V, G, tau
/// and the tip's pose of the published file.
#[test]
fn arms_of_urdf_files_are_the_same_as_tables_and_back() {
    let arms = arms();
    assert!(arms.len() >= 29, "{}", arms.len());
    let mut worst: f64 = 0.0;
    for arm in &arms {
        let source = read(&arm.file, &arm.besides);
        let options = &arm.options;
        let none = ReadOptions::new();
        let (standard, name) = ("--convention standard", &arm.name);
        let modified = format!("{name}.toml");
        let (path, modified) = converted(&arm.file, options, &modified, &none);
        let standard = converted(
            &arm.file,
            &format!("{options} {standard}"),
            &format!("{name}.json"),
            &none,
        )
        .1;
        assert_eq!(modified.convention, Convention::Modified);
        assert_eq!(standard.convention, Convention::Standard);
        let back = ReadOptions::new().chain(["base", "tip"]).entries(GRAVITY);
        let back = converted(&path, "", &format!("{name}_back.urdf"), &back).1;
        for (kind, robot) in [
            ("modified", modified),
            ("standard", standard),
            ("back", back),
        ] {
            assert_eq!(names(&robot), names(&source), "{name} {kind}");
            let difference = difference(&source, &robot);
            println!("{name:<20} {kind:<10} {difference:.1e}");
            assert!(difference < 1e-12, "{name} {kind}: {difference:e}");
            worst = worst.max(difference);
            let limits = |robot: &Robot| robot.joints().filter(|row| row.limits.is_some()).count();
            assert_eq!(limits(&robot), limits(&source), "{name} {kind}");
        }
    }
    println!("largest difference {worst:.1e}");
}

/// The tables of published arms, of both conventions, with motors, slides, a base and odd angles, as tables of
/// the other convention and back.
#[test]
fn tables_are_the_same_in_both_conventions() {
    let none = ReadOptions::new();
    for name in [
        "puma560",
        "stanford",
        "scara",
        "cylindrical_rpp",
        "gantry_ppp",
        "spherical_wrist",
        "generic_chain_n6",
        "generic_mixed_n6_standard",
        "elbow_3r",
        "ur5",
        "panda",
        "aristo",
        "one_link",
    ] {
        let source = data(&format!("robots/{name}.json"));
        let robot = read(&source, &none);
        let mut path = source;
        for (step, convention) in ["modified", "standard", "modified"].into_iter().enumerate() {
            let options = format!("--convention {convention} --to toml");
            let file = format!("{name}_{step}.toml");
            let (next, converted) = converted(&path, &options, &file, &none);
            let difference = difference(&robot, &converted);
            println!("{name:<28} {convention:<10} {difference:.1e}");
            assert!(difference < 1e-12, "{name} {convention}: {difference:e}");
            path = next;
        }
    }
}

/// A table that is converted to its own convention has the cells that it had.
#[test]
fn the_cells_of_a_published_table_are_found_again() {
    let path = data("robots/panda.json");
    let robot = read(&path, &ReadOptions::new());
    let (_, same) = converted(&path, "--to toml", "same.toml", &ReadOptions::new());
    for (row, expected) in same.rows.iter().zip(&robot.rows) {
        let cells = |row: &dynamics_symbolic::robot::Row| {
            let angles = [&row.alpha, &row.theta].map(dynamics_symbolic::robot::Angle::new);
            (
                row.a.clone(),
                row.d.clone(),
                angles,
                row.mass.clone(),
                row.com.clone(),
                row.inertia.clone(),
            )
        };
        assert_eq!(cells(row), cells(expected), "{}", row.name);
    }
}

/// Frames that are no feet of normals, angles and numbers without an end, locked and coupled joints, base and tool.
#[test]
fn a_table_in_its_own_convention_keeps_its_rows() {
    let text = "convention = \"modified\"\ngravity = [0, 0, -9.80665]\n\
        lock = { brake = \"deg(-30)\" }\ncouple = { back = \"-one / 3 + 0.02\" }\n\
        [base]\nxyz = [0, 0, 0.8]\nrpy = [0, \"deg(15)\", 0.2]\n\
        [tool]\nxyz = [0.1, 0, 0]\nrpy = [\"PI / 7\", 0, 0]\nmass = 0.3\ncom = [0, 0, 0.05]\ninertia = \"sphere(0.04)\"\n\
        [[joint]]\nname = \"one\"\ntype = \"revolute\"\nd = 0.3\ntheta = \"PI / 5\"\nmass = 1.2345678901234567890123456789\n\
        com = [0.1, \"1 / 3\", -2e-7]\ninertia = \"rod(2)\"\nlimits = [\"-2 * PI\", 3]\n\
        [[joint]]\nname = \"slide\"\ntype = \"prismatic\"\na = 0.4\nalpha = -0.3\nd = 0.1\ntheta = 0.2\nmass = 2\n\
        motor = { inertia = 1e-40, gear_ratio = 100 }\nspring = { stiffness = 40, rest = 0.1 }\n\
        [[joint]]\nname = \"brake\"\ntype = \"revolute\"\na = 0.1\nalpha = \"PI / 2\"\nmass = 0.5\ncom = [0, 0, 0.1]\n\
        [[joint]]\nname = \"back\"\ntype = \"revolute\"\nalpha = 1.5707963267948966\nd = 0.2\nmass = 0.25\ncom = [0.1, 0, 0]\n\
        friction = { viscous = 0.1, coulomb = { positive = 0.5, negative = 0.4 } }\n";
    let path = file("kept.toml", text);
    let none = ReadOptions::new();
    let source = read(&path, &none);
    for (options, name) in [
        ("--to toml", "kept_again.toml"),
        ("--to json --convention modified", "kept_again.json"),
    ] {
        let (written, same) = converted(&path, options, name, &none);
        assert_eq!(same.rows, source.rows, "{name}");
        assert_eq!((&same.base, &same.gravity), (&source.base, &source.gravity));
        assert!(source.tool.is_some());
        assert_eq!(same.tool, source.tool, "{name}");
        let text = std::fs::read_to_string(written).expect("a table");
        assert!(text.contains("1.2345678901234567890123456789"), "{text}");
        assert!(text.contains("Numbers are exact."), "{text}");
    }
}

/// Nearly parallel axes have no normal that is near: a locked joint stands between them, and digits stay.
#[test]
fn axes_that_are_nearly_parallel_keep_their_digits() {
    let link = |index: usize, tilt: &str| {
        format!(
            "<joint name=\"j{index}\" type=\"continuous\"><parent link=\"l{}\"/><child link=\"l{index}\"/>\
             <origin xyz=\"0.5 0 0.1\" rpy=\"0 {tilt} 0.3\"/><axis xyz=\"0 0 1\"/></joint>\n\
             <link name=\"l{index}\"><inertial><origin xyz=\"0.2 0.1 0.3\"/><mass value=\"1\"/>\
             <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" iyz=\"0\" ixz=\"0\"/></inertial></link>\n",
            index - 1
        )
    };
    let links = [
        link(1, "0"),
        link(2, "1e-9"),
        link(3, "-1e-6"),
        link(4, "1.570796"),
    ]
    .concat();
    let path = file(
        "tilted.urdf",
        format!("<robot name=\"tilted\">\n<link name=\"l0\"/>\n{links}</robot>\n"),
    );
    let besides = ReadOptions::new().chain(["l0", "l4"]).entries(GRAVITY);
    let source = read(&path, &besides);
    for convention in ["standard", "modified"] {
        let options = format!("--convention {convention} --chain l0,l4 --gravity 0,0,-9.81");
        let name = format!("tilted_{convention}.toml");
        let (written, table) = converted(&path, &options, &name, &ReadOptions::new());
        let text = std::fs::read_to_string(written).expect("a table");
        assert!(text.contains("lock = { fixed_1 = 0, fixed_2 = 0"), "{text}");
        let difference = difference(&source, &table);
        assert!(difference < 1e-12, "{convention}: {difference:e}");
    }
}

/// Joints that follow others do so in the other convention, by the same factors and offsets.
#[test]
fn couplings_are_kept() {
    let row = |name: &str, cells: &str| {
        format!("[[joint]]\nname = \"{name}\"\nmass = 1\ncom = [0.1, 0.02, 0.3]\n{cells}\n")
    };
    let rows = [
        row("lead", "type = \"revolute\"\nd = 0.2"),
        row("slide", "type = \"prismatic\"\nalpha = \"PI/2\"\na = 0.1"),
        row(
            "follow",
            "type = \"revolute\"\nalpha = 0.3\na = 0.4\ntheta = 0.2",
        ),
        row(
            "slide_back",
            "type = \"prismatic\"\nalpha = \"-PI/2\"\nd = 0.1",
        ),
    ];
    let head = "convention = \"modified\"\ngravity = [0, 1, -9.81]\n\
                couple = { follow = \"-2 * lead + 0.25\", slide_back = \"0.5 * slide - 0.125\" }\n";
    let path = file("coupled.toml", head.to_owned() + &rows.concat());
    let none = ReadOptions::new();
    let source = read(&path, &none);
    assert_eq!(source.dof(), 2);
    let options = "--convention standard --to toml";
    let (_, standard) = converted(&path, options, "coupled_standard.toml", &none);
    assert_eq!(names(&standard), names(&source));
    let couplings = |robot: &Robot| {
        let followers = robot.followers();
        let coupling = |(row, coupling): (
            &dynamics_symbolic::robot::Row,
            &dynamics_symbolic::robot::Coupling,
        )| {
            let leader = robot.rows[coupling.leader].name.clone();
            (
                row.name.clone(),
                leader,
                coupling.factor.clone(),
                coupling.offset.clone(),
            )
        };
        followers.map(coupling).collect::<Vec<_>>()
    };
    assert_eq!(couplings(&standard), couplings(&source));
    let difference = difference(&source, &standard);
    assert!(difference < 1e-12, "{difference:e}");
    let urdf = output(format!("convert {path} --to urdf"));
    let mimic = "<mimic joint=\"lead\" multiplier=\"-2\" offset=\"0.25\"/>";
    assert!(urdf.contains(mimic), "{urdf}");
}

/// Words by which a file accepts its numbers go where they belong: to the whole table, or to the row of the number.
#[test]
fn odd_numbers_stay_allowed() {
    let text = "convention = \"standard\"\ngravity = [0, 0, -9.81]\nallow = [\"odd_length\", \"odd_gear_ratio\"]\n\
                [[joint]]\nname = \"one\"\ntype = \"revolute\"\na = 120\nmass = 9\ncom = [-60, 0, 0]\n\
                [[joint]]\nname = \"two\"\ntype = \"revolute\"\na = 110\nmass = 8\ncom = [-50, 0, 0]\n\
                motor = { inertia = 0.1, gear_ratio = 0.5 }\n";
    let path = file("odd_numbers.toml", text);
    for convention in ["standard", "modified"] {
        let options = format!("--convention {convention} --to toml");
        let to = format!("odd_numbers_{convention}.toml");
        let (written, _) = converted(&path, &options, &to, &ReadOptions::new());
        let written = std::fs::read_to_string(written).expect("a table");
        let (head, rows) = written.split_once("[[joint]]").expect("joints");
        assert!(head.contains("allow = [\"odd_length\"]"), "{written}");
        assert_eq!(rows.matches("odd_").count(), 1, "{written}");
        assert!(rows.contains("allow = [\"odd_gear_ratio\"]"), "{written}");
    }
}

/// Everything that a table may say of joints and tool stays in a table; URDF has no words for some of it.
#[test]
fn what_urdf_cannot_say_is_told() {
    let text = std::fs::read_to_string(data("files/everything.toml")).expect("a table");
    let path = file("everything.toml", text.replace("\"load\"", "1.25"));
    let source = read(&path, &ReadOptions::new());
    let options = "--convention standard --to toml";
    let (written, standard) = converted(
        &path,
        options,
        "everything_standard.toml",
        &ReadOptions::new(),
    );
    assert!(difference(&source, &standard) < 1e-12);
    for (row, expected) in standard.joints().zip(source.joints()) {
        assert_eq!(
            (
                &row.spring,
                &row.stribeck,
                &row.coulomb,
                &row.viscous,
                &row.gear_ratio
            ),
            (
                &expected.spring,
                &expected.stribeck,
                &expected.coulomb,
                &expected.viscous,
                &expected.gear_ratio
            ),
        );
    }
    let text = std::fs::read_to_string(written).expect("a table");
    assert_has(&text, ["\"jacobian\"", "control_terms"]);
    let urdf = folder("converted").join("everything.urdf");
    let urdf = urdf.to_string_lossy();
    let message = errors(format!("convert {path} --out {urdf}"), 1);
    assert_has(
        &message,
        [
            "`lift` has a spring",
            "`turn` has a motor",
            "`--without motor,spring,friction`",
        ],
    );
    output(format!(
        "convert {path} --out {urdf} --without spring,motor --without friction"
    ));
    let text = std::fs::read_to_string(&*urdf).expect("a file");
    assert!(text.contains("Left out: `turn` has a motor"), "{text}");
    // The arm that is left has no springs, no motors and no such friction.
    let besides = ReadOptions::new().chain(["base", "tip"]).entries(GRAVITY);
    let left = read(&urdf, &besides);
    let mut bare = source.clone();
    for row in &mut bare.rows {
        let zero = dynamics_symbolic::robot::Value::zero;
        (row.spring, row.stribeck) = (None, None);
        (row.motor_inertia, row.gear_ratio) = (zero(), zero());
        if row.coulomb[0] != row.coulomb[1] {
            row.coulomb = [zero(), zero()];
        }
    }
    assert!(difference(&bare, &left) < 1e-12);
}

/// The command compares a table with the URDF file that it came from, where joints and links have other names
/// and number.
#[test]
fn check_compares_a_table_with_its_file() {
    let urdf = data("urdf/panda.urdf");
    let options = "--chain panda_link0,panda_hand_tcp --gravity 0,0,-9.81 --lock panda_finger_joint1=0.02 --lock panda_finger_joint2=0.035";
    let table = folder("converted").join("panda_table.toml");
    let table = table.to_string_lossy();
    output(format!("convert {urdf} --out {table} {options}"));
    let functions = "--functions gravity_vector,forward_kinematics --samples 20 --tolerance 1e-12";
    let text = output(format!(
        "check {table} --against {urdf} {options} {functions}"
    ));
    assert_has(&text, ["against the other file", "forward_kinematics"]);
    let back = folder("converted").join("panda_table.urdf");
    let back = back.to_string_lossy();
    output(format!("convert {table} --out {back}"));
    let other = "--against-chain base,tip";
    output(format!(
        "check {urdf} --against {back} {options} {functions} {other}"
    ));
}

/// Numbers that are the same each time.
pub(super) struct Draws(pub(super) u64);

impl Draws {
    /// A number between 0 and 1.
    fn next(&mut self) -> f64 {
        let Draws(state) = self;
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.next() * choices.len() as f64) as usize]
    }

    /// One of the numbers, or any, in two cases of three with noise from 10^smallest to 1e-7 beside it.
    pub(super) fn noisy(&mut self, smallest: f64, numbers: &[f64]) -> String {
        let (any, one) = (2.0 * self.next() - 1.0, self.of(numbers));
        let number = self.of(&[one, one, any]);
        let noise = 10_f64.powf(smallest + self.next() * (-7.0 - smallest));
        let noise = noise * self.of(&[0.0, 1.0, -1.0]);
        format!("{}", number + noise)
    }

    fn three(&mut self, smallest: f64, numbers: &[f64]) -> String {
        [(); 3].map(|()| self.noisy(smallest, numbers)).join(" ")
    }
}

pub(super) const TURNS: [f64; 4] = [
    0.0,
    0.0,
    core::f64::consts::FRAC_PI_2,
    core::f64::consts::PI,
];

/// A chain of some links, with noise beside zeros and quarter turns, and skew axes.
fn noisy_chain(draws: &mut Draws, links: usize) -> String {
    let mut text = "<robot name=\"noisy\">\n<link name=\"l0\"/>\n".to_owned();
    for index in 1..=links {
        let kind = match index == links {
            true => "fixed",
            false => draws.of(&["continuous", "continuous", "prismatic"]),
        };
        let origin = draws.three(-18.0, &[0.0, 0.0, 0.3]);
        let angles = draws.three(-18.0, &TURNS);
        let [x, y, z] = draws.of(&[
            [0.0, 0.0, 1.0],
            [0.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.3, -0.5, 0.7],
        ]);
        let axis = [x, y, z]
            .map(|part| draws.noisy(-18.0, &[part, part, part]))
            .join(" ");
        text += &format!(
            "<joint name=\"j{index}\" type=\"{kind}\"><parent link=\"l{}\"/><child link=\"l{index}\"/>\
             <origin xyz=\"{origin}\" rpy=\"{angles}\"/><axis xyz=\"{axis}\"/></joint>\n\
             <link name=\"l{index}\"><inertial><origin xyz=\"0.02 0.01 0.03\"/><mass value=\"1\"/>\
             <inertia ixx=\"0.1\" iyy=\"0.15\" izz=\"0.2\" ixy=\"0\" iyz=\"0\" ixz=\"0\"/></inertial></link>\n",
            index - 1
        );
    }
    text + "</robot>\n"
}

/// A table with noise in all four parameters, which no reader takes for zero.
fn noisy_table(draws: &mut Draws, joints: usize, convention: &str) -> String {
    let mut text = format!(
        "convention = \"{convention}\"\ngravity = [0, 0, -9.81]\nallow = [\"odd_angle\"]\n"
    );
    for index in 0..joints {
        let kind = draws.of(&["revolute", "revolute", "prismatic"]);
        let [a, d] = [(); 2].map(|()| draws.noisy(-40.0, &[0.0, 0.3]));
        let [alpha, theta] = [(); 2].map(|()| draws.noisy(-40.0, &TURNS));
        text += &format!(
            "[[joint]]\nname = \"j{index}\"\ntype = \"{kind}\"\na = {a}\nd = {d}\nalpha = {alpha}\ntheta = {theta}\n\
             mass = 1\ncom = [0.02, 0.01, 0.03]\ninertia = {{ xx = 0.1, yy = 0.15, zz = 0.2 }}\nallow = [\"odd_com\"]\n"
        );
    }
    text
}

/// Converts noisy chains and tables to both conventions, and compares what is read of them.
fn convert_noise(cases: Range<usize>) {
    let mut worst: f64 = 0.0;
    for case in cases.clone() {
        let mut draws = Draws(0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(1 + case as u64));
        let links = 3 + case % 4;
        let name = format!("noisy_{case}");
        let urdf = file(&format!("{name}.urdf"), noisy_chain(&mut draws, links));
        let tip = format!("l{links}");
        let besides = ReadOptions::new().chain(["l0", &tip]).entries(GRAVITY);
        let chain = format!("l0,{tip}");
        let options = format!("--chain {chain} --gravity 0,0,-9.81");
        let kind = ["standard", "modified"][case % 2];
        let table = file(
            &format!("{name}.toml"),
            noisy_table(&mut draws, links - 1, kind),
        );
        for convention in ["standard", "modified"] {
            for (path, besides, options) in [
                (&urdf, &besides, &options[..]),
                (&table, &ReadOptions::new(), ""),
            ] {
                let other = format!("--to toml --convention {convention}");
                let to = format!("{name}_{}_{convention}.toml", options.len());
                let (_, table) = converted(
                    path,
                    &format!("{other} {options}"),
                    &to,
                    &ReadOptions::new(),
                );
                // V and G of axes that are nearly parallel are small beside what they are differences of.
                let [mass, _, _, torques, pose] = differences(&read(path, besides), &table);
                let difference = largest([mass, torques, pose]);
                assert!(difference < 1e-12, "{path} to {convention}: {difference:e}");
                worst = worst.max(difference);
            }
        }
    }
    println!("cases {cases:?}, largest difference {worst:e}");
}

/// Any axes have a table, however near they are to those of an arm without noise.
#[test]
fn arms_with_noise_have_tables() {
    convert_noise(15..17);
}

#[test]
#[ignore = "a minute: many arms"]
fn many_arms_with_noise_have_tables() {
    convert_noise(0..150);
}

/// Two joints of a file that a program of construction wrote: their axes are z but for noise.
#[test]
fn axes_with_noise_have_a_table_without_it() {
    let path = data("files/noise_axis.urdf");
    let written = output(format!("convert {path} --chain a,c --gravity 0,0,-9.81"));
    assert_has(
        &written,
        ["# 10 numbers of the file are noise and taken as zero"],
    );
    assert!(
        written.contains("alpha = \"PI/2\"") && !written.contains("fixed_1"),
        "{written}"
    );
}
