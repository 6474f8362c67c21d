//! Robots with branches and frames.

use dynamics_evaluation::{ReadOptions, RuntimeRobot};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use super::calls::{assert_has, errors, file, output, refused};
use super::convert::{Draws, TURNS, converted, largest, read};

/// Two arms on a waist and a lift beside it, with a body in one hand.
pub(crate) const TORSO: &str = r#"
convention = "modified"
gravity = [0, 0, -9.81]
frame.left_hand = { on = "left_elbow", xyz = [0.3, 0, 0], mass = 1.5, com = [0, 0, 0.05], inertia = { xx = 0.04, yy = 0.04, zz = 0.04 } }
frame."the camera" = { on = "waist", xyz = [0.1, 0, 0.5], rpy = [0, 0.3, 0] }
frame.corner = { on = "base", xyz = [2, 0, 0] }
joint = [
    { name = "waist", type = "revolute", mass = 9, com = [0, 0, 0.2], inertia = { xx = 0.1, yy = 0.1, zz = 0.1 } },
    { name = "left_shoulder", type = "revolute", on = "waist", gamma = "PI/2", b = 0.4, a = 0.2, alpha = "PI/2", mass = 2 },
    { name = "left_elbow", type = "revolute", a = 0.3, mass = 1, com = [0.1, 0, 0] },
    { name = "right_shoulder", type = "revolute", on = "waist", gamma = "-PI/2", b = 0.4, a = 0.2, alpha = "PI/2", mass = 2, com = [0.1, 0, 0] },
    { name = "right_elbow", type = "revolute", a = 0.3, mass = 1, com = [0.1, 0.02, 0] },
    { name = "lift", type = "prismatic", on = "base", at = { xyz = [1, 0, 0], rpy = [0, 0, "PI/2"] }, mass = 3 },
]
"#;

#[test]
fn show_names_carriers_and_frames() {
    let torso = file("shown_torso.toml", TORSO);
    let text = output(format!("show {torso} --functions mass_matrix"));
    for expected in [
        "shown_torso: 6 joints that move",
        "joint           type       on                       a",
        "waist           revolute   base                     0",
        "left_shoulder   revolute   waist                  0.2  1.570796",
        "  at xyz [0, 0, 0.4]  rpy [0, 0, 1.5707963267948966]\n",
        "right_elbow     revolute   right_shoulder         0.3",
        "lift            prismatic  base                     0",
        "left_hand       frame      on left_elbow  xyz [0.3, 0, 0]  rpy [0, 0, 0]  mass 1.5  com [0, 0, 0.05]",
        "the camera      frame      on waist  xyz [0.1, 0, 0.5]  rpy [0, 0.3, 0]\n",
        "corner          frame      on base  xyz [2, 0, 0]",
        "M14, M15, M16, M24, M25, M26, M34, M35, M36, M46, M56 are zero",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    let asked = "mass_matrix,jacobian(left_hand)";
    let formulas = output(format!("show {torso} --functions {asked} --format text"));
    assert!(formulas.contains("jacobian_left_hand\n"), "{formulas}");
}

/// Places of a file that change nothing are not shown.
#[test]
fn show_places_links_of_files() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/urdf/trees");
    let urdf = folder
        .join("parallel_gripper.urdf")
        .to_string_lossy()
        .into_owned();
    let functions =
        "mass_matrix,jacobian(left_pad),forward_kinematics(right_finger),forward_kinematics(mount)";
    let gravity = format!("--gravity 0,0,-9.81 --functions {functions}");
    let text = output(format!("show {urdf} {gravity}"));
    for expected in [
        "right_knuckle_joint  revolute   wrist",
        "right_finger         frame      on right_finger_joint  xyz [0, 0, 0]  rpy [0, 0, 0]\n",
        "left_pad             frame      on left_finger_joint  xyz [-0.01, 0, 0.04]  rpy [0, -1.5707963267948966, 0]\n",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    assert!(
        !text.contains("then xyz [0, 0, 0]  rpy [0, 0, 0]"),
        "{text}"
    );
}

/// A column with a hand, and a mast beside it whose joint can be locked. The link `tool` is where its joint says.
fn fork(tool: &str) -> String {
    let body = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
    let joint = |name: &str, kind: &str, parent: &str, child: &str| {
        format!(
            "<joint name='{name}' type='{kind}'><parent link='{parent}'/><child link='{child}'/>\
             <origin xyz='0.2 0 0.1'/></joint>"
        )
    };
    format!(
        "<robot name='fork'><link name='root'/><link name='left'>{body}</link><link name='right'>{body}</link>\
         <link name='hand'/><link name='tool'/>{}{}{}{}</robot>",
        joint("one", "continuous", "root", "left"),
        joint("two", "continuous", "root", "right"),
        joint("three", "fixed", "left", "hand"),
        joint("four", "fixed", tool, "tool"),
    )
}

/// The tip is the only link that ends on the last one that moves, whatever stands still beside it: it is shown, compared
/// with Newton-Euler, and where the chain to it ends.
#[test]
fn a_branch_that_stands_still_leaves_the_tip_where_it_is() {
    let urdf = file("fork_with_tip.urdf", fork("hand"));
    let common = "--gravity 0,0,-9.81 --lock two=0.2";
    let text = output(format!("show {urdf} {common}"));
    let tip = text.lines().find(|line| line.starts_with("tip "));
    let words: Vec<_> = tip.expect("a tip").split_whitespace().collect();
    assert_eq!(words[1..3], ["fixed", "one"], "{text}");
    let functions = "--functions forward_kinematics,jacobian,tool_velocity";
    let text = output(format!("check {urdf} {common} {functions}"));
    assert_eq!(text.matches("jacobian").count(), 1, "{text}");
    let pose = |options: ReadOptions| {
        let options = options.functions(["forward_kinematics"]);
        let options = options.entries("gravity = [0, 0, -9.81]\nlock = { two = 0.2 }");
        let arm = RuntimeRobot::from_file(&urdf, &options).expect("an arm with a tip");
        let pose = arm.forward_kinematics(&[0.7]);
        pose.expect("a pose").as_slice().to_vec()
    };
    let of_tree = pose(ReadOptions::new());
    assert_eq!(of_tree, pose(ReadOptions::new().chain(["root", "tool"])));
    // Three places of 0.2 along x, about which the joint turns.
    assert!((of_tree[12] - 0.6).abs() < 1e-15, "{of_tree:?}");
}

/// Two links that end on the last one that moves are no tip: functions are asked for at frames, or the tip is named.
#[test]
fn two_ends_on_the_last_link_are_no_tip() {
    let urdf = file("fork_with_two_ends.urdf", fork("left"));
    let common = "--gravity 0,0,-9.81 --ignore two";
    let call = |function: &str| format!("show {urdf} {common} --functions {function}");
    let text = output(call("mass_matrix"));
    assert!(!text.contains("\ntip "), "{text}");
    let refused = errors(call("jacobian"), 2);
    assert_has(
        &refused,
        ["several links end on that of `one`: request it at a frame"],
    );
    let named = format!("{} --chain root,tool", call("jacobian"));
    assert!(output(&named).contains("\ntip "), "the tip is named");
}

/// A finger that follows another one on the link of an arm, a locked joint that carries a branch, and axes that are
/// parallel, on a base that stands askew. The rows are not in the order of a walk along the branches.
const WORKSHOP: &str = r#"
convention = "standard"
gravity = [0.5, 0, -9.8]
lock = { turret = 0.4 }
couple = { right_finger = "-1 * left_finger + 0.02" }
base = { xyz = [0.1, 0.2, 0.8], rpy = [0.3, -0.2, "PI/2"] }
frame.tool = { on = "right_finger", xyz = [0, 0.1, 0.2], rpy = [0.1, "PI/2", 0.3] }
frame.camera = { on = "turret", xyz = [0, 0.1, 0.2], mass = 0.4, com = [0, 0.01, 0.02] }
frame."base plate" = { on = "base", xyz = [0.5, 0, 0], mass = 30 }
joint = [
    { name = "shoulder", type = "revolute", a = 0.1, alpha = "PI/2", d = 0.3, mass = 4, com = [0, 0.1, 0], motor = { inertia = 0.0002, gear_ratio = 100 }, limits = [-2, 2] },
    { name = "table", type = "prismatic", on = "base", at = { xyz = [0, 1, 0], rpy = [0.2, 0, 0] }, mass = 5, friction = { viscous = 0.1, coulomb = 0.2 } },
    { name = "elbow", type = "revolute", on = "shoulder", a = 0.4, mass = 2, com = [-0.2, 0, 0.01], inertia = { xx = 0.01, yy = 0.02, zz = 0.03, xy = 0.001 } },
    { name = "turret", type = "revolute", on = "table", a = 0.2, alpha = 0.5, d = 0.1, mass = 1 },
    { name = "left_finger", type = "prismatic", on = "elbow", at = { xyz = [0, 0, 0.05], rpy = ["PI/2", 0, 0] }, mass = 0.1, limits = [0, 0.04] },
    { name = "right_finger", type = "prismatic", on = "elbow", at = { xyz = [0, 0, 0.05], rpy = ["PI/2", 0, 0] }, mass = 0.1 },
    { name = "lid", type = "revolute", on = "turret", d = 0.3, a = 0.1, mass = 0.5, com = [0.1, 0, 0] },
    { name = "handle", type = "revolute", on = "elbow", at = { xyz = [0, 0, -0.1] }, alpha = "-PI/2", mass = 0.3, com = [0.05, 0, 0.1] },
]
"#;

/// Four fingers of two parallel joints on a palm.
fn hand() -> String {
    let row = |name: String, cells: &str| {
        format!(
            "[[joint]]\nname = \"{name}\"\ntype = \"revolute\"\nmass = 0.1\ncom = [0.02, 0.001, 0]\n{cells}"
        )
    };
    let mut text = "convention = \"modified\"\ngravity = [0, 0, -9.81]\n".to_owned()
        + &row("palm".to_owned(), "");
    for finger in 1..=4 {
        let on = format!(
            "on = \"palm\"\ngamma = 0.{finger}\nb = 0.0{finger}\na = 0.09\nalpha = \"PI/2\"\n"
        );
        text += &row(format!("knuckle_{finger}"), &on);
        text += &row(format!("tip_{finger}"), "a = 0.04\n");
    }
    text
}

/// A tree with noise in the places and the angles of its rows.
fn noisy_tree(draws: &mut Draws, joints: usize, convention: &str) -> String {
    let mut text = format!(
        "convention = \"{convention}\"\ngravity = [0, 0, -9.81]\nallow = [\"odd_angle\"]\n"
    );
    for index in 0..joints {
        let kind = draws.of(&["revolute", "revolute", "prismatic"]);
        let [a, d, b] = [(); 3].map(|()| draws.noisy(-40.0, &[0.0, 0.3]));
        let [alpha, theta, gamma] = [(); 3].map(|()| draws.noisy(-40.0, &TURNS));
        let carriers: Vec<_> = (0..index).collect();
        let on = match index {
            0 => "base".to_owned(),
            _ => format!("j{}", draws.of(&carriers)),
        };
        let at = match convention {
            "modified" => format!("gamma = {gamma}\nb = {b}"),
            _ => format!("at = {{ xyz = [{a}, {b}, 0.1], rpy = [{gamma}, 0, {alpha}] }}"),
        };
        text += &format!(
            "[[joint]]\nname = \"j{index}\"\ntype = \"{kind}\"\non = \"{on}\"\n{at}\na = {a}\nd = {d}\nalpha = {alpha}\n\
             theta = {theta}\nmass = 1\ncom = [0.02, 0.01, 0.03]\ninertia = {{ xx = 0.1, yy = 0.15, zz = 0.2 }}\n\
             allow = [\"odd_com\"]\n"
        );
    }
    text
}

/// The names of the joints that move by themselves.
fn names(robot: &Robot) -> Vec<&str> {
    robot.joints().map(|row| row.name.as_str()).collect()
}

/// M, tau and the poses of some frames at random states of the joints in the order of some names.
fn values(robot: &Robot, order: &[&str], frames: &[&str]) -> [Vec<f64>; 3] {
    let found = |frame: &&str| robot.frames.iter().position(|known| known.name == *frame);
    let poses = frames.iter().map(|name| {
        let frame = found(name).unwrap_or_else(|| panic!("{name}"));
        Request::of_frame(Function::ForwardKinematics, frame, name)
    });
    let poses: Vec<Request> = poses.collect();
    let functions = [Function::MassMatrix, Function::InverseDynamics];
    let requests: Vec<Request> = functions
        .map(Request::from)
        .into_iter()
        .chain(poses.clone())
        .collect();
    let arm = RuntimeRobot::new(robot.clone(), requests).expect("functions");
    let here = names(robot);
    let place = |name: &str| order.iter().position(|known| *known == name).expect(name);
    let places: Vec<usize> = here.iter().map(|name| place(name)).collect();
    let mut values: [Vec<f64>; 3] = Default::default();
    for state in 0..12 {
        let vector = |seed: usize, range: f64| -> Vec<f64> {
            let entry = |i: &usize| range * ((1 + 31 * state + 7 * seed + 13 * i) as f64).sin();
            places.iter().map(entry).collect()
        };
        let (q, qd, qdd) = (vector(0, 3.0), vector(1, 3.0), vector(2, 10.0));
        let of = |name: &str, arguments: &[&[f64]]| -> Vec<f64> {
            arm.evaluate_in(name, arguments).expect("values")
        };
        let (mass, tau) = (
            of("mass_matrix", &[&q]),
            of("inverse_dynamics", &[&q, &qd, &qdd]),
        );
        let row = |name: &&str| {
            here.iter()
                .position(|known| known == name)
                .expect("a joint")
        };
        for i in order.iter().map(row) {
            let entries = order.iter().map(row).map(|j| mass[i * here.len() + j]);
            values[0].extend(entries);
            values[1].push(tau[i]);
        }
        values[2].extend(poses.iter().flat_map(|pose| of(pose.name(), &[&q])));
    }
    values
}

/// The largest difference of M, tau and the poses of a robot's frames, relative to the largest entry.
fn difference(source: &Robot, other: &Robot) -> f64 {
    let order = names(source);
    assert_eq!(order.len(), other.dof());
    let frames: Vec<&str> = source.frames.iter().map(|frame| &*frame.name).collect();
    let [one, other] = [source, other].map(|robot| values(robot, &order, &frames));
    let relative = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        assert_eq!(a.len(), b.len());
        let size = a.iter().fold(1e-300_f64, |size, x| size.max(x.abs()));
        largest(a.iter().zip(b).map(|(a, b)| (a - b).abs())) / size
    };
    largest(one.iter().zip(&other).map(relative))
}

/// All trees that are written here, and as many with noise.
fn trees(noisy: usize) -> Vec<(String, String)> {
    let mut trees = vec![
        ("torso".to_owned(), TORSO.to_owned()),
        ("workshop".to_owned(), WORKSHOP.to_owned()),
        ("hand".to_owned(), hand()),
    ];
    for case in 0..noisy {
        let mut draws = Draws(0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(1 + case as u64));
        let convention = ["standard", "modified"][case % 2];
        let text = noisy_tree(&mut draws, 3 + case % 3, convention);
        trees.push((format!("noisy_tree_{case}"), text));
    }
    trees
}

/// Converts trees to both conventions, from one to the other, and compares what is read of them.
fn convert_trees(noisy: usize) {
    let none = ReadOptions::new();
    for (name, text) in trees(noisy) {
        let mut path = file(&format!("{name}.toml"), text);
        let source = read(&path, &none);
        for (step, convention) in ["modified", "standard", "modified"].into_iter().enumerate() {
            let format = if step == 1 { "json" } else { "toml" };
            let to = format!("--convention {convention} --to {format}");
            let file = format!("{name}_{step}.{format}");
            let (next, table) = converted(&path, &to, &file, &none);
            assert_eq!(names(&table), names(&source), "{name} {convention}");
            let difference = difference(&source, &table);
            println!("{name:<20} {convention:<10} {difference:.1e}");
            assert!(difference < 1e-12, "{name} {convention}: {difference:e}");
            path = next;
        }
    }
}

/// The tables of trees in both conventions are those of the same robot.
#[test]
fn trees_are_the_same_in_both_conventions() {
    convert_trees(10);
}

mod release {
    #[test]
    #[ignore = "a minute: run before a release"]
    fn many_trees_are_the_same_in_both_conventions() {
        super::convert_trees(100);
    }
}

/// A tree written as a URDF file is the same robot, frames as links. URDF has no words for motors.
#[test]
fn trees_are_written_as_urdf() {
    for (name, text) in trees(2) {
        let text = text.replace("motor = { inertia = 0.0002, gear_ratio = 100 }, ", "");
        let path = file(&format!("{name}_to_urdf.toml"), text);
        let source = read(&path, &ReadOptions::new());
        let gravity = source.gravity.each_ref().map(|g| g.to_f64(&[]));
        let allow = "allow = [\"no_inertia\", \"odd_com\", \"unphysical_inertia\"]";
        let poses = source.frames.iter();
        let poses = poses.map(|frame| format!("forward_kinematics({:?})", frame.name));
        let functions = poses.chain(["inverse_dynamics".to_owned()]);
        let entries = format!("gravity = {gravity:?}\n{allow}");
        let besides = ReadOptions::new().entries(&entries).functions(functions);
        let to = format!("{name}.urdf");
        let (_, urdf) = converted(&path, "--to urdf", &to, &besides);
        let difference = difference(&source, &urdf);
        println!("{name:<20} {difference:.1e}");
        assert!(difference < 1e-12, "{name}: {difference:e}");
    }
}

/// A tree falls: its lift by g t^2 / 2, and all of it without a change of energy.
#[test]
fn a_tree_is_simulated() {
    let torso = file("simulated_torso.toml", TORSO);
    let from = "--from 0.1,0.2,0.3,-0.4,0.5,0";
    let text = output(format!(
        "simulate {torso} --duration 0.4 --samples 3 {from}"
    ));
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a head").split(',').collect();
    let column = |name: &str| names.iter().position(|known| *known == name).expect(name);
    let rows = lines.map(|line| line.split(',').map(|cell| cell.parse().expect("a number")));
    let rows: Vec<Vec<f64>> = rows.map(Iterator::collect).collect();
    let energy =
        |row: &[f64]| row[column("kinetic energy [J]")] + row[column("potential energy [J]")];
    let fall = rows[2][column("q.lift [m]")] + 0.5 * 9.81 * 0.16;
    assert!(fall.abs() < 1e-9, "{text}");
    for row in &rows {
        let drift = energy(row) - energy(&rows[0]);
        assert!(drift.abs() < 1e-6, "{drift:e}");
    }
    assert!(rows[2][column("q.right_elbow [rad]")] != 0.5, "{text}");
}

/// Files of trees are compared without a tip, and by their frames if these are asked for.
#[test]
fn trees_are_compared_with_other_files() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/urdf/trees");
    let urdf = folder.join("panda_erd.urdf").to_string_lossy().into_owned();
    let gravity = "--gravity 0,0,-9.81";
    let table = output(format!("convert {urdf} --to toml {gravity}"));
    let table = file("panda_compared.toml", table);
    let compared = output(format!("check {table} --against {urdf} {gravity}"));
    assert!(compared.contains("inverse_dynamics"), "{compared}");
    let other = "panda_finger_joint1";
    refused(
        &[
            "check",
            &table,
            "--functions",
            &format!("jacobian({other})"),
        ],
        2,
        [other],
    );
    let torso = file("compared_torso.toml", TORSO);
    let standard = output(format!("convert {torso} --to toml --convention standard"));
    let standard = file("compared_standard.toml", standard);
    let functions = "--functions mass_matrix,jacobian(left_hand)";
    let text = output(format!("check {torso} --against {standard} {functions}"));
    assert!(text.contains("jacobian_left_hand"), "{text}");
}

/// The links of a tree are frames of its table, where they stood and with their names. Comments tell what is left out.
#[test]
fn links_of_a_tree_are_kept() {
    let link = |name: &str, body: bool| {
        let inertial = "<inertial><origin xyz=\"0.1 0 0.02\"/><mass value=\"1\"/>\
            <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" iyz=\"0\" ixz=\"0\"/></inertial>";
        format!(
            "<link name=\"{name}\">{}</link>\n",
            if body { inertial } else { "" }
        )
    };
    let joint = |name: &str, kind: &str, [parent, child]: [&str; 2], xyz: &str| {
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"{xyz}\" rpy=\"0.3 0.1 -0.2\"/><axis xyz=\"0 1 0\"/></joint>\n"
        )
    };
    let mut text =
        "<robot name=\"legs\">\n".to_owned() + &link("base", false) + &link("lock", true);
    text += &joint("wing", "revolute", ["base", "lock"], "0 0 0.2");
    for side in ["left", "right"] {
        let [hip, shank, foot] = ["hip", "shank", "foot"].map(|part| format!("{side}_{part}"));
        text += &(link(&shank, true) + &link(&foot, false));
        text += &joint(&hip, "continuous", ["base", &shank], "0 0.1 0");
        text += &joint(
            &format!("{foot}_fixed"),
            "fixed",
            [&shank, &foot],
            "0.3 0 0",
        );
    }
    let path = file("legs.urdf", text + "</robot>\n");
    let beside = "--gravity 0,0,-9.81 --lock wing=0.4";
    let names = [
        "base",
        "lock",
        "left_shank",
        "left_foot",
        "right_shank",
        "right_foot",
    ];
    for to in ["legs.toml", "legs.json", "legs_again.urdf"] {
        let is_urdf = to.ends_with("urdf");
        let poses = names.map(|name| match (name, is_urdf) {
            ("base", false) => "forward_kinematics('base_link')".to_owned(),
            _ => format!("forward_kinematics('{name}')"),
        });
        let besides = ReadOptions::new().functions(poses.clone());
        let besides = match is_urdf {
            true => besides.entries("gravity = [0, 0, -9.81]"),
            false => besides,
        };
        let (written, same) = converted(&path, beside, to, &besides);
        let of_file =
            ReadOptions::new().functions(names.map(|name| format!("forward_kinematics('{name}')")));
        let mut source = read(
            &path,
            &of_file.entries("gravity = [0, 0, -9.81]\nlock = { wing = 0.4 }"),
        );
        if !is_urdf {
            source.frames[0].name = "base_link".to_owned();
        }
        assert_eq!((source.frames.len(), same.frames.len()), (6, 6), "{to}");
        assert!(difference(&source, &same) < 1e-12, "{to}");
        let text = std::fs::read_to_string(written).expect("a file");
        assert_has(&text, ["Left out: the names of its fixed joints"]);
        assert_has(&text, ["Left out: the joints that are locked, `wing`."]);
        let renamed = "The link `base` is the frame `base_link`.";
        assert_eq!(text.contains(renamed), !is_urdf, "{text}");
    }
}

/// All links are frames of the table.
#[test]
fn links_are_frames() {
    let path = super::calls::data("urdf/trees/anymal_erd.urdf");
    let call = format!("convert {path} --gravity 0,0,-9.81 --allow unphysical_inertia");
    let text = output(&call);
    let urdf = output(format!("{call} --to urdf"));
    let links = std::fs::read_to_string(&path).expect("the file");
    let links = links
        .split("<link name=\"")
        .skip(1)
        .map(|rest| rest.split('"').next());
    for name in links.flatten() {
        assert!(urdf.contains(&format!("<link name=\"{name}\"")), "{name}");
        // `base` is a word of tables.
        let frame = if name == "base" { "base_link" } else { name };
        assert!(text.contains(&format!("[frame.{frame}]")), "{name}: {text}");
    }
}

/// A table that stays in its convention keeps its rows, frames and functions; a modified one has `gamma` and `b`.
#[test]
fn the_cells_of_a_tree_are_kept() {
    let none = ReadOptions::new();
    let asked = "functions = [\"mass_matrix\", \"jacobian(left_hand)\", { seen = [\"center_of_mass\", \"forward_kinematics('the camera')\"] }]\n";
    for (name, text) in [
        ("kept_torso", asked.to_owned() + TORSO),
        ("kept_workshop", WORKSHOP.to_owned()),
    ] {
        let path = file(&format!("{name}.toml"), text);
        let source = read(&path, &none);
        for format in ["toml", "json"] {
            let to = format!("{name}.{format}");
            let (_, same) = converted(&path, &format!("--to {format}"), &to, &none);
            assert_eq!(same.rows, source.rows, "{to}");
            assert_eq!(same.frames, source.frames, "{to}");
        }
    }
    let torso = file("kept_torso.toml", asked.to_owned() + TORSO);
    let standard = output(format!("convert {torso} --to toml --convention standard"));
    let standard = file("standard_torso.toml", standard);
    for path in [&torso, &standard] {
        let text = output(format!("convert {path} --to toml --convention modified"));
        for expected in [
            "functions = [\"mass_matrix\", \"jacobian(left_hand)\", { seen = [\"center_of_mass\", \"forward_kinematics(the camera)\"] }]",
            "\n[frame.left_hand]\non = \"left_elbow\"\nxyz = [0.3, 0, 0]\nmass = 1.5\n",
            "\n[frame.\"the camera\"]\non = \"waist\"\n",
            "name = \"right_shoulder\"\ntype = \"revolute\"\non = \"waist\"\n",
        ] {
            assert!(text.contains(expected), "{expected}: {text}");
        }
        // The frame of the waist may be turned, so that one of its arms needs neither.
        let is_same = *path == torso;
        assert_eq!(
            text.contains("on = \"waist\"\ngamma = \"-PI / 2\"\nb = 0.4\n"),
            is_same,
            "{text}"
        );
    }
}
