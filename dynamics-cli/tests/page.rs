//! The pages: one file each, and in a browser the numbers of Rust.

use arms::is_installed;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use dynamics_evaluation::{ReadOptions, RuntimeRobot, Value};
use dynamics_runtime::nalgebra::Rotation3;
use dynamics_symbolic::robot::{JointType, Row};

/// The size of every page is below this number of bytes.
const MEGABYTE: usize = 1_000_000;

fn data(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data");
    folder.join(name).to_string_lossy().into_owned()
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages");
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_robot-dynamics"));
    command.args(arguments).output().expect("the command")
}

#[track_caller]
fn output(arguments: &[&str]) -> String {
    let output = run(arguments);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// The functions that pages show, besides poses.
const FUNCTIONS: [&str; 8] = [
    "mass_matrix",
    "coriolis_vector",
    "gravity_vector",
    "friction_vector",
    "spring_vector",
    "inverse_dynamics",
    "kinetic_energy",
    "potential_energy",
];

/// A robot whose page is looked at.
struct Arm {
    name: &'static str,
    file: String,
    options: Vec<&'static str>,
    /// Whether its base moves.
    is_floating: bool,
    besides: ReadOptions,
    /// The fields, with the values that they have at first.
    fields: Vec<(&'static str, f64)>,
    /// The method of the pose that the page shows at first.
    tip: &'static str,
}

impl Arm {
    fn new(name: &'static str, file: &str) -> Arm {
        let tip = "forward_kinematics";
        let functions = FUNCTIONS.into_iter().chain([tip]);
        Arm {
            name,
            file: data(file),
            options: Vec::new(),
            is_floating: false,
            besides: ReadOptions::new().functions(functions),
            fields: Vec::new(),
            tip,
        }
    }

    /// A robot with branches, whose page shows that frame at first.
    fn with_frame(mut self, function: &str, method: &'static str) -> Arm {
        let functions = FUNCTIONS.into_iter().chain([function]);
        (self.besides, self.tip) = (self.besides.functions(functions), method);
        self
    }

    fn with_fields(mut self, fields: &[(&'static str, f64)]) -> Arm {
        self.fields = fields.to_vec();
        self.besides = self.besides.fields(fields.iter().map(|(name, _)| *name));
        self
    }

    /// Writes the page, and returns its file.
    fn page(&self) -> PathBuf {
        let path = folder().join(self.name).with_extension("html");
        let out = path.to_string_lossy();
        let fields: Vec<_> = self
            .fields
            .iter()
            .map(|(name, value)| format!("{name}={value:?}"))
            .collect();
        let mut arguments = vec!["page", &self.file, "--out", &out];
        arguments.extend(&self.options);
        arguments.extend(fields.iter().flat_map(|field| ["--field", field]));
        assert_eq!(output(&arguments), "");
        path
    }

    fn robot(&self) -> RuntimeRobot {
        RuntimeRobot::from_file(&self.file, &self.besides).expect("a robot")
    }
}

fn arms() -> Vec<Arm> {
    let mut panda = Arm::new("panda", "urdf/panda.urdf");
    panda.options = vec![
        "--chain",
        "panda_link0,panda_hand_tcp",
        "--gravity",
        "0,0,-9.81",
        "--lock",
        "panda_finger_joint1=0.02",
        "--lock",
        "panda_finger_joint2=0.02",
    ];
    let lock = "lock = { panda_finger_joint1 = 0.02, panda_finger_joint2 = 0.02 }";
    let besides = panda
        .besides
        .entries("gravity = [0, 0, \"-9.81\"]")
        .entries(lock);
    panda.besides = besides.chain(["panda_link0", "panda_hand_tcp"]);
    vec![
        Arm::new("two_link", "files/two_link.toml").with_fields(&[
            ("m1", 3.0),
            ("m2", 1.0),
            ("l1", 2.0),
            ("l2", 1.0),
            ("g", 9.81),
        ]),
        Arm::new("two_link_saha", "robots/two_link_saha.json"),
        Arm::new("puma560", "robots/puma560.json"),
        Arm::new("aristo", "robots/aristo.json"),
        Arm::new("cell", "files/cell.toml").with_fields(&[("load", 1.0), ("tilt", 0.2)]),
        panda,
        Arm::new("torso", "files/torso.toml")
            .with_frame(
                "forward_kinematics(left_hand)",
                "forward_kinematics_left_hand",
            )
            .with_fields(&[("load", 1.0)]),
        gripper(),
        brick(),
        body(),
        hyq(),
    ]
}

/// Robots whose base moves: a brick with a wheel, a single body, and a quadruped.
fn brick() -> Arm {
    let wheel = "\n[[joint]]\nname = \"wheel\"\ntype = \"revolute\"\nat = { xyz = [0.1, 0, 0.2], rpy = [0.4, 0, 0] }\n\
                 mass = 0.5\ncom = [0.05, 0, 0]\ninertia = { xx = 1e-3, yy = 1e-3, zz = 2e-3 }\nfriction = { viscous = 1e-3, coulomb = 0.05 }\n";
    thrown("brick", wheel, "forward_kinematics", "forward_kinematics")
}

fn body() -> Arm {
    let frame = "joint = []\n[frame.corner]\non = \"base\"\nxyz = [0.2, 0.1, 0]\n";
    thrown(
        "body",
        frame,
        "forward_kinematics(corner)",
        "forward_kinematics_corner",
    )
}

/// A brick of 2 kg with more behind it.
fn thrown(name: &'static str, more: &str, function: &str, method: &'static str) -> Arm {
    let base = "base = { floating = true, mass = 2, com = [0, 0.01, 0.02], inertia = { xx = 0.02, yy = 0.03, zz = 0.04 } }";
    let text = format!("convention = \"modified\"\ngravity = [0, 0, -10]\n{base}\n{more}");
    let path = folder().join(name).with_extension("toml");
    std::fs::write(&path, text).expect("a file");
    let functions = FUNCTIONS.into_iter().chain([function]);
    Arm {
        name,
        file: path.to_string_lossy().into_owned(),
        options: Vec::new(),
        is_floating: true,
        besides: ReadOptions::new().functions(functions),
        fields: Vec::new(),
        tip: method,
    }
}

fn hyq() -> Arm {
    let foot = "forward_kinematics_lf_foot";
    let file = "urdf/trees/hyq_no_sensors.urdf";
    let mut hyq = Arm::new("hyq", file).with_frame("forward_kinematics(lf_foot)", foot);
    hyq.options = vec![
        "--base",
        "floating",
        "--gravity",
        "0,0,-9.81",
        "--allow",
        "unphysical_inertia",
        "--functions",
        "forward_kinematics(lf_foot)",
    ];
    let entries =
        "base = \"floating\"\ngravity = [0, 0, \"-9.81\"]\nallow = [\"unphysical_inertia\"]";
    hyq.besides = hyq.besides.entries(entries);
    hyq.is_floating = true;
    hyq
}

/// One of its fingers follows the other one.
fn gripper() -> Arm {
    let finger = "forward_kinematics_panda_leftfinger";
    let mut gripper = Arm::new("gripper", "urdf/trees/panda_erd.urdf")
        .with_frame("forward_kinematics(panda_leftfinger)", finger);
    gripper.options = vec!["--gravity", "0,0,-9.81"];
    gripper.besides = gripper.besides.entries("gravity = [0, 0, \"-9.81\"]");
    gripper
}

/// One file below a megabyte that loads nothing, with the licences of what is in it.
#[test]
fn a_page_is_one_file() {
    let mut arms = arms();
    // The longest of the data files.
    arms.push(Arm::new(
        "generic_chain_n12",
        "robots/generic_chain_n12.json",
    ));
    // A single body, without any frame.
    arms.push(thrown("bare", "joint = []", "mass_matrix", ""));
    for arm in arms {
        let text = std::fs::read_to_string(arm.page()).expect("a page");
        println!("{}: {} bytes", arm.name, text.len());
        assert!(text.len() < MEGABYTE, "{}: {} bytes", arm.name, text.len());
        for notice in [
            "three 0.187.0",
            "uplot 1.6.32",
            "three.js authors",
            "Leon Sorokin",
            "Permission is hereby granted",
        ] {
            assert!(text.contains(notice), "{}: {notice}", arm.name);
        }
        for loaded in [
            "<script src",
            "<link rel=\"stylesheet",
            "@import url",
            "from\"http",
        ] {
            assert!(!text.contains(loaded), "{}: {loaded}", arm.name);
        }
        assert_eq!(text.matches("</script>").count(), 3, "{}", arm.name);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let file = data("files/two_link.toml");
    let refused = |options: &[&str], status: i32, expected: &str| {
        let arguments: Vec<_> = ["page", &file].iter().chain(options).copied().collect();
        let output = run(&arguments);
        let errors = String::from_utf8(output.stderr).expect("text");
        assert_eq!(output.status.code(), Some(status), "{options:?}: {errors}");
        assert!(errors.contains(expected), "{options:?}: {errors}");
    };
    let fields = ["m1=3", "m2=1", "l1=2", "l2=1", "g=9.81"];
    let all: Vec<_> = fields.iter().flat_map(|field| ["--field", field]).collect();
    let with = |more: &[&'static str]| [all.clone(), more.to_vec()].concat();
    refused(&[], 1, "two_link.toml:");
    refused(&["--field", "m1"], 2, "expected NAME=NUMBER");
    refused(
        &with(&["--field", "m3=1"]),
        2,
        "the field `m3` is never used",
    );
    refused(&with(&["--from", "1"]), 2, "expected 2, one for each joint");
    refused(
        &with(&["--duration", "0"]),
        2,
        "expected a number from 1e-3 to 1000",
    );
    let pose = with(&["--pose", "0,0,1,0,0,0"]);
    refused(&pose, 2, "`--pose` is of a robot whose base moves");
    let velocity = with(&["--velocity", "1"]);
    refused(&velocity, 2, "`--velocity` has 1 number: expected 2");
    let negative = ["m1=3", "m2=-1", "l1=2", "l2=1", "g=9.81"];
    let negative = negative.iter().flat_map(|field| ["--field", field]);
    refused(
        &negative.collect::<Vec<_>>(),
        1,
        "a mass cannot be negative",
    );
}

/// Numbers by the names under which a page shows them.
type Numbers = Vec<(String, f64)>;

fn object<K: AsRef<str>>(entries: impl IntoIterator<Item = (K, String)>) -> String {
    let entries = entries
        .into_iter()
        .map(|(key, value)| format!("{:?}: {value}", key.as_ref()));
    format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
}

fn numbers(numbers: &Numbers) -> String {
    object(numbers.iter().map(|(key, x)| (key, format!("{x:?}"))))
}

/// The largest number of each group, `mass` of `mass-0-1`; of V that of tau too, for the page finds V as a
/// difference of torques.
fn scales<'n>(groups: impl IntoIterator<Item = &'n Numbers>) -> String {
    let mut scales: Vec<(String, f64)> = Vec::new();
    for (key, x) in groups.into_iter().flatten() {
        let group = key.split('-').next().unwrap_or(key);
        match scales.iter_mut().find(|(known, _)| known == group) {
            Some((_, scale)) => *scale = scale.max(x.abs()),
            None => scales.push((group.to_owned(), x.abs().max(1e-3))),
        }
    }
    let of = |group: &str| scales.iter().position(|(known, _)| known == group);
    if let (Some(coriolis), Some(tau)) = (of("coriolis"), of("tau")) {
        scales[coriolis].1 = scales[coriolis].1.max(scales[tau].1);
    }
    numbers(&scales)
}

fn indexed(name: &str, values: &[f64]) -> Numbers {
    let named = values.iter().enumerate();
    named.map(|(i, x)| (format!("{name}-{i}"), *x)).collect()
}

/// A position within what a slider offers, by a share of it.
fn position(row: &Row, share: f64) -> f64 {
    let limits = row.limits.as_ref();
    let [low, high] = match (limits, row.joint_type) {
        (Some(limits), _) => limits.each_ref().map(|limit| limit.to_f64(&[])),
        (None, JointType::Revolute) => [-3.0, 3.0],
        (None, JointType::Prismatic) => [-0.2, 0.2],
    };
    low + share * (high - low)
}

/// A share that differs from joint to joint and from state to state.
fn share(joint: usize, state: usize) -> f64 {
    0.5 + 0.45 * ((3 * joint + 5 * state + 1) as f64).sin()
}

/// A state of a robot: where its base is, if that moves, positions of the joints, velocities and accelerations.
struct State {
    base: Option<[f64; 12]>,
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
}

impl State {
    /// The value of a function.
    fn value(&self, arm: &RuntimeRobot, function: &str) -> Vec<f64> {
        let names = arm.arguments(function).expect("a function");
        let arguments = names.map(|(name, _)| match name {
            "base" => self.base.as_ref().expect("a base that moves").as_slice(),
            "q" => &self.q,
            "qd" => &self.qd,
            _ => &self.qdd,
        });
        let arguments: Vec<_> = arguments.collect();
        match arm.evaluate(function, &arguments).expect("a value") {
            Value::Number(x) => vec![x],
            Value::Matrix(matrix) => matrix.transpose().iter().copied().collect(),
            value => panic!("{value:?}"),
        }
    }
}

/// The twelve numbers of a pose: the rotation by rows, then the position.
fn base_of([x, y, z, roll, pitch, yaw]: [f64; 6]) -> [f64; 12] {
    let rotation = Rotation3::from_euler_angles(roll, pitch, yaw).into_inner();
    let entries = rotation.transpose();
    let entries = entries.iter().copied().chain([x, y, z]);
    let entries: Vec<f64> = entries.collect();
    entries.try_into().expect("twelve numbers")
}

/// Six numbers of a pose that differ from state to state.
fn pose(state: usize) -> [f64; 6] {
    core::array::from_fn(|k| 1.6 * (share(k, state + 3) - 0.5))
}

/// Entries of M, V, G, tau, of the tip and of energies at a state. `tip` is the method of its pose.
fn expected(arm: &RuntimeRobot, tip: &str, state: &State) -> Numbers {
    let evaluate = |function: &str| state.value(arm, function);
    let matrix = |name: &str, rows: usize, values: Vec<f64>| -> Numbers {
        let columns = values.len() / rows;
        let named = values.iter().enumerate();
        named
            .map(|(k, x)| (format!("{name}-{}-{}", k / columns, k % columns), *x))
            .collect()
    };
    let mut found = matrix("mass", state.qd.len(), evaluate("mass_matrix"));
    found.extend(indexed("coriolis", &evaluate("coriolis_vector")));
    found.extend(indexed("gravity", &evaluate("gravity_vector")));
    for (name, values) in [
        ("friction", evaluate("friction_vector")),
        ("spring", evaluate("spring_vector")),
    ] {
        // The page shows the columns that are not zero at all states.
        if values.iter().any(|x| *x != 0.0) {
            found.extend(indexed(name, &values));
        }
    }
    found.extend(indexed("tau", &evaluate("inverse_dynamics")));
    let tip = evaluate(tip);
    found.extend((0..3).map(|k| (format!("tip-{k}-3"), tip[4 * k + 3])));
    found.extend(matrix("T", 4, tip));
    let (kinetic, potential) = (
        evaluate("kinetic_energy")[0],
        evaluate("potential_energy")[0],
    );
    found.push(("kinetic".to_owned(), kinetic));
    found.push(("potential".to_owned(), potential));
    found
}

/// States that are typed into a page, and what it shows then.
fn states(arm: &Arm) -> String {
    let mut robot = arm.robot();
    let rows: Vec<Row> = robot.robot().joints().cloned().collect();
    let of_base = if arm.is_floating { 6 } else { 0 };
    let states = (0..3).map(|state| {
        let each = |scale: f64, seed: usize| -> Vec<f64> {
            let shares = (0..of_base + rows.len()).map(|joint| share(joint, state + seed));
            shares.map(|share| scale * (share - 0.5)).collect()
        };
        let joints = rows.iter().enumerate();
        let q: Vec<f64> = joints
            .map(|(joint, row)| position(row, share(joint, state)))
            .collect();
        let (qd, qdd) = (each(1.5, 7), each(2.5, 13));
        let mut set = [indexed("q", &q), indexed("qd", &qd), indexed("qdd", &qdd)].concat();
        for (k, (name, value)) in arm.fields.iter().enumerate() {
            let value = value * (0.6 + share(k, state));
            robot.set_field(name, value).expect("a field");
            set.push((format!("field-{name}"), value));
        }
        let pose = arm.is_floating.then(|| pose(state));
        set.extend(pose.iter().flat_map(|pose| indexed("pose", pose)));
        let base = pose.map(base_of);
        let mut expected = expected(&robot, arm.tip, &State { base, q, qd, qdd });
        expected.extend(base.iter().flat_map(|base| indexed("base", &base[9..])));
        let entries = [
            ("set", numbers(&set)),
            ("expected", numbers(&expected)),
            ("scale", scales([&expected])),
        ];
        object(entries)
    });
    format!("[{}]", states.collect::<Vec<_>>().join(", "))
}

/// Rows of a table that the command has written: the time, and numbers by the names of a page, of which each group has so
/// many.
fn rows(csv: &str, groups: &[(&str, usize)]) -> Vec<(f64, Numbers)> {
    let rows = csv.lines().skip(1).map(|line| {
        let mut cells = line.split(',').map(|x| x.parse().expect("a number"));
        let t = cells.next().expect("the time");
        let found = groups.iter().flat_map(|(group, count)| {
            let values: Vec<f64> = cells.by_ref().take(*count).collect();
            indexed(group, &values)
        });
        (t, found.collect())
    });
    rows.collect()
}

fn list(values: &[f64]) -> String {
    let values: Vec<_> = values.iter().map(|x| format!("{x:?}")).collect();
    values.join(",")
}

/// A motion of 2 s by the cycloidal profile, on a base that is held: inverse dynamics gives the torques.
fn held(robot: &RuntimeRobot, base: [f64; 12], from: &[f64], to: &[f64]) -> Vec<(f64, Numbers)> {
    use std::f64::consts::TAU;
    let row = |k: usize| {
        let u = k as f64 / 4.0;
        let way = u - (TAU * u).sin() / TAU;
        let rates = [1.0 - (TAU * u).cos(), TAU * (TAU * u).sin()];
        let ways = from.iter().zip(to).map(|(from, to)| to - from);
        let q = from.iter().zip(ways.clone());
        let q = q.map(|(from, all)| from + all * way).collect();
        let behind_base = |rate: f64| -> Vec<f64> {
            let joints = ways.clone().map(|way| way * rate);
            std::iter::repeat_n(0.0, 6).chain(joints).collect()
        };
        let state = State {
            base: Some(base),
            q,
            qd: behind_base(rates[0] / 2.0),
            qdd: behind_base(rates[1] / 4.0),
        };
        let tau = state.value(robot, "inverse_dynamics");
        let named = [
            ("q", &state.q),
            ("qd", &state.qd),
            ("qdd", &state.qdd),
            ("tau", &tau),
        ];
        let found = named.map(|(name, values)| indexed(name, values));
        (
            2.0 * u,
            [
                found.concat(),
                indexed("rotation", &base[..9]),
                indexed("base", &base[9..]),
            ]
            .concat(),
        )
    };
    (0..5).map(row).collect()
}

/// A prescribed motion and a free one, with what the commands `inverse` and `simulate` say of them. The commands know
/// no fields: the arm has numbers in their places. On a base that moves, the free one begins with a spin and a throw.
fn motions(arm: &Arm) -> String {
    let mut text = std::fs::read_to_string(&arm.file).expect("a file");
    let mut file = arm.file.clone();
    if !arm.fields.is_empty() {
        for (name, value) in &arm.fields {
            text = text.replace(&format!("\"{name}\""), &format!("{value:?}"));
            text = text.replace(&format!("\"-{name}\""), &format!("-{value:?}"));
            text = text.replace(&format!("-{name} / 2"), &format!("-{value:?} / 2"));
            text = text.replace(&format!("rod({name})"), &format!("rod({value:?})"));
        }
        let path = folder().join(format!("{}_in_numbers.toml", arm.name));
        std::fs::write(&path, text).expect("a file");
        file = path.to_string_lossy().into_owned();
    }
    let robot = arm.robot();
    let joints = robot.robot().joints().enumerate();
    let (from, to): (Vec<f64>, Vec<f64>) = joints
        .map(|(joint, row)| {
            (
                position(row, share(joint, 2)),
                position(row, share(joint, 4)),
            )
        })
        .unzip();
    let fields: Numbers = arm
        .fields
        .iter()
        .map(|(name, value)| (format!("field-{name}"), *value))
        .collect();
    let motion = |mode: &str, set: Numbers, rows: Vec<(f64, Numbers)>, tolerance: f64| {
        let scale = scales(rows.iter().map(|(_, numbers)| numbers));
        let rows = rows.iter().map(|(t, expected)| {
            object([
                ("t", format!("{t:?}")),
                ("expected", numbers(expected)),
                ("scale", scale.clone()),
            ])
        });
        object([
            ("mode", format!("{mode:?}")),
            ("set", numbers(&[fields.clone(), set].concat())),
            ("rows", format!("[{}]", rows.collect::<Vec<_>>().join(", "))),
            ("tolerance", format!("{tolerance:?}")),
        ])
    };
    let duration = ("duration".to_owned(), 2.0);
    let [from_list, to_list] = [&from, &to].map(|values| list(values));
    let call = |subcommand: &'static str, more: &[&str]| {
        let mut all = vec![subcommand, &file, "--duration", "2", "--samples", "5"];
        // A body without joints has no positions.
        if !from.is_empty() {
            all.extend(["--from", &from_list]);
        }
        all.extend(arm.options.iter().chain(more));
        output(&all)
    };
    let n = from.len();
    let pose = pose(1);
    let (inverse, free, velocity) = if arm.is_floating {
        let joints = (0..n).map(|joint| share(joint, 6) - 0.5);
        let velocity: Vec<f64> = [0.5, -0.4, 3.0, 0.3, 2.5, -0.7]
            .into_iter()
            .chain(joints)
            .collect();
        let [pose_list, velocity_list] = [&pose[..], &velocity].map(list);
        let more = [
            "--tolerance",
            "1e-12",
            "--pose",
            &pose_list,
            "--velocity",
            &velocity_list,
        ];
        let groups = [("rotation", 9), ("base", 3), ("q", n), ("qd", 6 + n)];
        let free = rows(&call("simulate", &more), &groups);
        (held(&robot, base_of(pose), &from, &to), free, velocity)
    } else {
        let inverse = call("inverse", &["--to", &to_list]);
        let simulated = call("simulate", &["--tolerance", "1e-12"]);
        let groups = ["q", "qd", "qdd", "tau"].map(|group| (group, n));
        (
            rows(&inverse, &groups),
            rows(&simulated, &groups[..2]),
            vec![0.0; n],
        )
    };
    let at = if arm.is_floating {
        indexed("pose", &pose)
    } else {
        Vec::new()
    };
    let start = |name: &str, values: &[f64]| {
        let of_joints = indexed("q", &from);
        [at.clone(), of_joints, indexed(name, values)].concat()
    };
    let prescribed = [start("end", &to), vec![duration.clone()]].concat();
    let dropped = [start("qd", &velocity), vec![duration]].concat();
    format!(
        "[{}, {}]",
        motion("motion", prescribed, inverse, 1e-11),
        motion("free", dropped, free, 1e-6)
    )
}

/// Pages in Chromium, by `dynamics-export/page/test/page.mjs`: sliders move the arm, play moves time, and the numbers are those of Rust
/// and of the commands `inverse` and `simulate`. A phone shows all of it, and no error is reported.
#[test]
#[ignore = "needs Chromium and node, and takes two minutes: .ci/run runs it"]
fn pages_do_what_they_should_in_a_browser() {
    if !is_installed("chromium") || !is_installed("node") {
        return;
    }
    let pages = arms().into_iter().map(|arm| {
        object([
            ("name", format!("{:?}", arm.name)),
            ("file", format!("{:?}", arm.page().to_string_lossy())),
            ("states", states(&arm)),
            ("motions", motions(&arm)),
            // Pictures take their time: two arms show what there is to see, one of them with slides.
            ("moves", ["puma560", "cell"].contains(&arm.name).to_string()),
            ("refuses", (arm.name == "two_link").to_string()),
            ("ofBase", if arm.is_floating { "6" } else { "0" }.to_owned()),
            // Two fixed joints lead to it, 0.107 m and 0.1034 m long.
            (
                "tip",
                format!(
                    "{:?}",
                    if arm.name == "panda" {
                        "0, 0, 0.2104"
                    } else {
                        ""
                    }
                ),
            ),
        ])
    });
    let mut cases = String::new();
    let pages: Vec<_> = pages.collect();
    let _ = write!(cases, "{{\"pages\": [\n{}\n]}}\n", pages.join(",\n"));
    let path = folder().join("cases.json");
    std::fs::write(&path, cases).expect("a file");
    let script =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../dynamics-export/page/test/page.mjs");
    let mut node = Command::new("node");
    node.arg(script).arg("chromium").arg(&path);
    let output = node.output().expect("node");
    let told = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    println!("{told}");
    assert!(output.status.success(), "{told}{errors}");
}
