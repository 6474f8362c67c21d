//! The options that say what a URDF file does not.

use dynamics_evaluation::{ReadOptions, RuntimeRobot};
use dynamics_simulation::Simulation;

use super::calls::{assert_has, data, errors, file, folder, output, refused, run};

/// A turntable with an arm, a gripper's finger at its end, and a camera whose mast turns.
fn turntable(angle: &str) -> String {
    format!(
        r#"<robot name="turntable">
  <link name="base"/>
  <joint name="turn" type="continuous">
    <parent link="base"/><child link="table"/><axis xyz="0 0 1"/>
    <dynamics damping="0.5" friction="0.25"/>
  </joint>
  <link name="table"><inertial><mass value="5"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.15" ixy="0" iyz="0" ixz="0"/></inertial></link>
  <joint name="mast" type="revolute">
    <parent link="table"/><child link="camera"/><origin xyz="0.3 0 0"/><axis xyz="0 1 0"/>
  </joint>
  <link name="camera"><inertial><origin xyz="0 0 0.5"/><mass value="1"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" iyz="0" ixz="0"/></inertial></link>
  <joint name="lift" type="revolute">
    <parent link="table"/><child link="arm"/>
    <origin xyz="0 0 0.4" rpy="{angle} 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="2" effort="1" velocity="1"/>
  </joint>
  <link name="arm"><inertial><origin xyz="0.25 0 0"/><mass value="2"/>
    <inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" iyz="0" ixz="0"/></inertial></link>
  <joint name="flange_joint" type="fixed">
    <parent link="arm"/><child link="flange"/><origin xyz="0.5 0 0"/>
  </joint>
  <link name="flange"/>
</robot>
"#
    )
}

const GRAVITY: &str = "--gravity 0,0,-9.81";

/// The lines of `show --format text` about M of the turntable.
fn mass_matrix(file: &str, options: &str) -> String {
    let call = format!("show {file} --functions mass_matrix --format text");
    output(format!("{call} {GRAVITY} {options}"))
}

#[test]
fn the_chain_ends_where_it_is_told() {
    let file = file("turntable.urdf", turntable("1.5707963267948966"));
    let ignore = "--ignore mast";
    let whole = mass_matrix(&file, &format!("--chain base,flange {ignore}"));
    // 0.15 + 0.01 s2^2 + (0.02 + 2 0.25^2) c2^2, and 0.02 + 2 0.25^2.
    assert_has(&whole, ["M11 = 0.16 + 0.135 c2^2\nM12 = 0\n"]);
    assert!(whole.contains("M22 = 0.145\n"), "{whole}");
    let ignore = format!("{ignore} --ignore lift");
    let table = output(format!("show {file} --chain base,table {GRAVITY} {ignore}"));
    assert!(table.contains("1 joint that moves"), "{table}");
    assert!(!table.contains("lift"), "{table}");
    let told = |options: &str| errors(format!("show {file} {options}"), 2);
    let gravity = |options: &str| format!("{options} {GRAVITY}");
    // The whole tree, and all that a link carries.
    for chain in ["", "--chain base"] {
        let options = format!("--ignore mast {chain}");
        assert_eq!(mass_matrix(&file, &options), whole);
    }
    let message = told(&gravity("--chain base,"));
    assert!(message.contains("expected BASE,TIP"), "{message}");
    let message = told(&gravity("--chain base,flang"));
    assert!(message.contains("`flange`"), "{message}");
    let message = told(&gravity("--chain base,base"));
    assert_has(&message, ["`base` is in `--chain` twice"]);
    refused(
        format!("show {file} --chain base,flange {GRAVITY}"),
        1,
        ["name a tip behind it in `--chain`, lock it"],
    );
    let message = told("--chain base,table");
    assert!(message.contains("`--gravity X,Y,Z`"), "{message}");
}

/// Angles that were perhaps meant as quarter turns are counted, with the option that takes them for it.
#[test]
fn angles_near_a_quarter_turn_are_shown() {
    let file = file("nearly.urdf", turntable("1.5708"));
    let chain = "--chain base,flange --ignore rest";
    let shown = |options: &str| output(format!("show {file} {chain} {GRAVITY} {options}"));
    let note = "As multiples, `--round-angles 1e-5` takes 1 of them.";
    assert!(shown("").contains(note), "{}", shown(""));
    let rounded = shown("--round-angles 1e-5");
    let note =
        "One angle of the file is taken as multiples of a quarter turn: `--round-angles 1e-5`.";
    assert!(rounded.contains(note), "{rounded}");
}

/// A file without a robot is told as that, and not what its robot would need.
#[test]
fn a_file_without_joints_is_told_before_options_that_are_missing() {
    let links = "<robot name='x'><link name='base'/></robot>";
    for (name, text, expected) in [
        ("empty_tree.urdf", "", "not XML"),
        ("no_links.urdf", "<robot name='x'/>", "no joints"),
        ("no_joints.urdf", links, "no joints"),
    ] {
        let file = file(name, text);
        for options in ["", "--chain base,tip", GRAVITY] {
            refused(
                format!("show {file} {options}"),
                1,
                [&format!("{name}:1:1: {expected}")],
            );
        }
    }
}

/// A joint off the chain is left out with what hangs on it, or stands still with it.
#[test]
fn joints_off_the_chain_are_left_out_or_locked() {
    let file = file("mast.urdf", turntable("1.5707963267948966"));
    let call = format!(
        "show {file} --chain base,table --ignore lift --functions mass_matrix --format text"
    );
    let call = |options: &str| format!("{call} {GRAVITY} {options}");
    let message = errors(call(""), 1);
    assert_has(
        &message,
        ["mast.urdf:9:3: ", "`--lock mast=0`", "`--ignore mast`"],
    );
    assert!(output(call("--ignore mast")).contains("M11 = 0.15\n"));
    // The camera is above a point 0.3 m from the axis, or a quarter turn leans it outwards to 0.8 m.
    assert!(output(call("--lock mast=0")).contains("M11 = 0.24\n"));
    assert!(output(call("--lock mast=PI/2")).contains("M11 = 0.79\n"));
    // A slip is told alone, without the joint that it leaves.
    for slip in ["--ignore mst", "--lock mst=0"] {
        let message = errors(call(slip), 2);
        assert!(
            message.contains("unknown joint `mst`: did you mean `mast`?")
                && !message.contains("mast.urdf"),
            "{message}"
        );
    }
}

#[test]
fn angles_are_rounded_where_that_is_asked_for() {
    let file = file("rounded.urdf", turntable("1.5708"));
    let chain = "--chain base,flange --ignore mast";
    // A little of the arm's inertia is about the first axis besides.
    let written = mass_matrix(&file, chain);
    assert!(!written.contains("M12 = 0\n"), "{written}");
    let rounded = mass_matrix(&file, &format!("{chain} --round-angles 1e-4"));
    assert!(rounded.contains("M12 = 0\n"), "{rounded}");
    let still = mass_matrix(&file, &format!("{chain} --round-angles 1e-6"));
    assert_eq!(still, written);
    for wrong in ["1", "-1", "small"] {
        let option = format!("--round-angles={wrong}");
        refused(
            format!("show {file} {option} {chain} {GRAVITY}"),
            2,
            ["from 0 to 0.1 rad"],
        );
    }
}

/// Friction, a motor, a spring and limits beside the file: the arm of a table that is written by hand.
#[test]
fn cells_beside_a_file_are_those_of_a_table() {
    let path = file("lacking.urdf", turntable("1.5707963267948966"));
    let turn = "friction = { viscous = 0.75 }\nmotor = { inertia = 1e-3, gear_ratio = 20 }\ntorque_limit = 9\n";
    let lift = "spring = { stiffness = 3, rest = 0.5 }\nlimits = [-2, 2]\n";
    let options = ReadOptions::new()
        .chain(["base", "flange"])
        .ignore(["mast"])
        .entries("gravity = [0, 0, -9.81]")
        .entries(&format!("[joints.turn]\n{turn}[joints.lift]\n{lift}"));
    let options = options.functions(RuntimeRobot::simulation_functions());
    let given = RuntimeRobot::from_file(&path, &options).expect("the file");
    let table = format!(
        "convention = 'modified'\ngravity = [0, 0, -9.81]\n\
         [[joint]]\nname = 'turn'\ntype = 'revolute'\nd = 0.4\nmass = 5\ncom = [0, 0, -0.4]\n\
         inertia = {{ xx = 0.1, yy = 0.1, zz = 0.15 }}\n{turn}\
         [[joint]]\nname = 'lift'\ntype = 'revolute'\nalpha = 'PI/2'\nmass = 2\ncom = [0.25, 0, 0]\n\
         inertia = {{ xx = 0.01, yy = 0.02, zz = 0.02 }}\ntorque_limit = 1\nvelocity_limit = 1\n{lift}"
    );
    let by_hand = RuntimeRobot::from_toml(&table, &ReadOptions::new()).expect("the table");
    for (q, qd, qdd) in [
        ([0.3, -0.7], [0.0; 2], [0.0; 2]),
        ([1.0, 2.0], [-3.0, 0.4], [5.0, 6.0]),
    ] {
        let torques = |arm: &RuntimeRobot| arm.inverse_dynamics(&q, &qd, &qdd).expect("torques");
        let difference = torques(&given) - torques(&by_hand);
        assert!(difference.amax() < 1e-13, "{difference}");
    }
    let limits = |arm: &RuntimeRobot| {
        let rows = arm.table().rows.into_iter();
        let limits = rows.map(|row| (row.limits, row.torque_limit, row.velocity_limit));
        limits.collect::<Vec<_>>()
    };
    assert_eq!(limits(&given), limits(&by_hand));
    let dynamics = given.dynamics().expect("functions of simulations");
    let strong = Simulation::new(&dynamics).torque(|_, _, v| v.map(|_| -50.0));
    let motion = strong.saturate().duration(0.1).run().expect("a motion");
    assert_eq!(motion.tau[0].as_slice(), [-9.0, -1.0]);
}

/// Efforts and velocities that bound something; written as URDF they are there again.
#[test]
fn greatest_torques_and_velocities_are_those_of_the_file() {
    let limits = [
        ("87", "2.5", true),
        ("0", "-1", false),
        ("1e9", "1e12", false),
    ];
    for (index, (effort, velocity, is_bound)) in limits.into_iter().enumerate() {
        let limit = format!("effort=\"{effort}\" velocity=\"{velocity}\"");
        let text = turntable("0").replace("effort=\"1\" velocity=\"1\"", &limit);
        let path = file(&format!("greatest_{index}.urdf"), text);
        let options = "--chain base,flange --ignore mast --gravity 0,0,-9.81";
        let converted = |format: &str| output(format!("convert {path} --to {format} {options}"));
        let (table, urdf) = (converted("toml"), converted("urdf"));
        let is_in_table = table.contains("torque_limit = 87\nvelocity_limit = 2.5");
        assert_eq!(is_in_table, is_bound, "{table}");
        assert_eq!(table.contains("_limit"), is_bound, "{table}");
        let again = if is_bound {
            limit
        } else {
            "effort=\"1000000000\" velocity=\"1000000000\"".to_owned()
        };
        assert!(urdf.contains(&again), "{urdf}");
    }
}

/// Elements and attributes that other programs read may have any prefix, and xacro may have left something in them.
#[test]
fn what_is_not_read_does_no_harm() {
    let plain = turntable("1.5707963267948966");
    let left = plain
        .replace("<inertial>", "<visual><xacro:grey/><origin xyz=\"${x} 0 0\"/></visual><inertial>")
        .replace("</robot>", "<gazebo><sensor:camera name=\"${name}\"/></gazebo><xacro:property name=\"x\"/></robot>")
        .replace("effort=\"1\"", "effort=\"1\" drake:acceleration=\"${acceleration}\"");
    assert!(left.contains("drake") && left.contains("grey") && left.contains("sensor"));
    let chain = "--chain base,flange --ignore mast";
    let expected = mass_matrix(&file("without.urdf", plain), chain);
    assert_eq!(mass_matrix(&file("left.urdf", &left), chain), expected);
    let wrong = left.replace("0 0 0.4", "0 0 ${height}");
    let path = file("left_number.urdf", wrong);
    let call = format!("show {path} {chain} {GRAVITY}");
    let message = errors(&call, 1);
    assert_has(
        &message,
        [
            "left_number.urdf:16:18: `0 0 ${height}` is left of xacro",
            "`xacro arm.urdf.xacro > arm.urdf`",
        ],
    );
}

/// Doubles that were computed have noise: without it M is as short as that of the arm that was meant.
#[test]
fn noise_is_taken_for_zero() {
    let exact = file("exact.urdf", turntable("0"));
    let noisy = turntable("2.7629E-18")
        .replace(
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"-6.1e-16 9.9e-17 1\"/>",
        )
        .replace("xyz=\"0 0 0.4\"", "xyz=\"1.1e-16 0 0.4\"");
    let chain = "--chain base,flange --ignore mast";
    let found = mass_matrix(&file("noisy.urdf", &noisy), chain);
    assert_eq!(found, mass_matrix(&exact, chain));
    let tilted = file(
        "tilted_axis.urdf",
        noisy.replace("-6.1e-16 9.9e-17 1", "0.0001 0 1"),
    );
    assert_ne!(mass_matrix(&tilted, chain), found);
    let rounded = format!("{chain} --round-angles 1e-3");
    assert_eq!(mass_matrix(&tilted, &rounded), found);
    let call = format!("convert {tilted} {chain} {GRAVITY}");
    let text = output(&call);
    assert_has(
        &text,
        [
            "# 2 numbers of the file are noise and taken as zero",
            "# 2 angles of the file are within 0.01 rad of a multiple of a quarter turn",
            "`--round-angles 1e-4` takes 2 of them",
        ],
    );
}

/// Each subcommand takes the options: an arm of a robot with many others.
#[test]
fn every_subcommand_reads_a_chain() {
    let file = data("urdf/anymal.urdf");
    let out = folder("chain");
    let out = out.to_string_lossy();
    let chain = "--chain base,LF_FOOT --ignore RF_HAA --ignore LH_HAA --ignore RH_HAA";
    for call in [
        format!("show {file} --functions gravity_vector"),
        format!("check {file} --functions gravity_vector --samples 2"),
        format!("generate {file} --functions gravity_vector --lang js --out {out}"),
        format!("simulate {file} --duration 0.01 --samples 2"),
        format!("inverse {file} --to 0.1,0.2,0.3 --samples 2"),
        format!("measure {file} --functions gravity_vector"),
        format!("convert {file}"),
    ] {
        let odd = "--allow unphysical_inertia";
        let text = output(format!("{call} {chain} {GRAVITY} {odd}"));
        assert!(!text.is_empty(), "{call:?}");
    }
}

/// A tensor that no body can have is taken as it is if that is requested.
#[test]
fn odd_files_are_accepted_where_that_is_asked_for() {
    let odd = turntable("0").replace("izz=\"0.15\"", "izz=\"0.25\"");
    let file = file("odd.urdf", odd);
    let call = format!("show {file} --chain base,flange --ignore mast --functions gravity_vector");
    let call = format!("{call} {GRAVITY}");
    refused(&call, 1, ["`--allow unphysical_inertia`"]);
    output(format!("{call} --allow unphysical_inertia"));
}

/// A word that is nearly one of URDF's would leave something of the arm out, if it were passed over; other words mean
/// something to other programs.
#[test]
fn misspelled_words_are_told() {
    let right = turntable("0");
    let call = |name: &str, text: String| {
        let file = file(name, text);
        let options = "--chain base,flange --ignore mast";
        run(format!("show {file} {GRAVITY} {options}"))
    };
    for (wrong, expected) in [
        (
            ("<origin xyz=\"0.25", "<orgin xyz=\"0.25"),
            ":19:30: unknown element `orgin` of `<inertial>`: did you mean `origin`?",
        ),
        (
            ("damping=\"0.5\"", "dampng=\"0.5\""),
            ":5:15: unknown attribute `dampng` of `<dynamics>`: did you mean `damping`?",
        ),
        (
            ("rpy=\"0 0 0\"", "rpY=\"0 0 0\""),
            ":16:27: unknown attribute `rpY` of `<origin>`: did you mean `rpy`?",
        ),
        (
            ("<limit lower", "<limits lower"),
            ":17:5: unknown element `limits` of `<joint>`: did you mean `limit`?",
        ),
        (
            ("lower=\"-1\" upper=\"2\"", "lower=\"-90\" upper=\"90\""),
            "`<limit>` is in radians, and 90 rad are more than five turns: 90 degrees are 1.5708 rad",
        ),
    ] {
        let text = right.replace(wrong.0, wrong.1);
        assert_ne!(text, right);
        let told = String::from_utf8_lossy(&call("misspelled.urdf", text).stderr).into_owned();
        assert!(told.contains(expected), "{wrong:?}: {told}");
        assert_eq!(told.matches(expected).count(), 1, "{told}");
    }
    let turns = right.replace("lower=\"-1\" upper=\"2\"", "lower=\"-90\" upper=\"90\"");
    let refused = String::from_utf8_lossy(&call("turns.urdf", turns.clone()).stderr).into_owned();
    assert_has(&refused, ["as which `--allow odd_limits` takes it"]);
    let turns = file("turns.urdf", turns);
    output(format!("show {turns} --gravity 0,0,0 --allow odd_limits"));
    let others = right
        .replace(
            "<limit lower",
            "<safety_controller k_velocity=\"1\"/><limit acceleration=\"2\" lower",
        )
        .replace(
            "<link name=\"flange\"/>",
            "<link name=\"flange\"><visual/><sensor/></link><gazebo/>",
        );
    assert_eq!(call("others.urdf", others).status.code(), Some(0));
}

/// The numbers in brackets behind each place of a word in a text.
fn lists(text: &str, word: &str) -> Vec<String> {
    let start = format!("{word} [");
    let lists = text.split(&start).skip(1);
    let list = |rest: &str| rest.split(']').next().unwrap_or_default().replace(',', "");
    lists.map(list).collect()
}

/// The URDF file that somebody types who reads the table of `show`: its last link is `tip`.
fn typed_in(shown: &str) -> String {
    let mut text = "<robot name=\"typed\"><link name=\"l0\"/>".to_owned();
    let mut links = 0;
    let mut joint = |head: &str, kind: &str, more: &str, body: &str| {
        let mut words = head.split_whitespace();
        let name = words.next().expect("a name").to_owned();
        let places: Vec<_> = lists(head, "xyz")
            .into_iter()
            .zip(lists(head, "rpy"))
            .collect();
        let last = places.len() - 1;
        for (k, (xyz, rpy)) in places.iter().enumerate() {
            let (kind, more, body, label) = match k == last {
                true => (kind, more, body, name.clone()),
                false => ("fixed", "", "", format!("{name}_{k}")),
            };
            let link = match name == "tip" && k == last {
                true => "tip".to_owned(),
                false => format!("l{}", links + 1),
            };
            text += &format!(
                "<joint name=\"{label}\" type=\"{kind}\"><parent link=\"l{links}\"/><child link=\"{link}\"/>\
                 <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>{more}</joint><link name=\"{link}\">{body}</link>\n"
            );
            links += 1;
        }
    };
    let table = shown
        .split("Denavit-Hartenberg table.\n\n")
        .nth(1)
        .expect("a table");
    let table = table.split("\n\n").next().expect("its end");
    let lines: Vec<&str> = table.lines().collect();
    for pair in lines.chunks(2) {
        let [head, body] = pair else {
            joint(pair[0], "fixed", "", "");
            continue;
        };
        let kind = match head.split_whitespace().nth(1) {
            Some("revolute") => "continuous",
            Some("prismatic") => "prismatic",
            other => panic!("{other:?}"),
        };
        let axis = format!(
            "<axis xyz=\"{}\"/><limit lower=\"-9\" upper=\"9\"/>",
            lists(head, "axis")[0]
        );
        let mass = body.split_whitespace().nth(1).expect("a mass");
        let inertia = lists(body, "inertia");
        let inertia = inertia.first().map_or("0 0 0 0 0 0", String::as_str);
        let entries: Vec<&str> = inertia.split(' ').collect();
        let body = format!(
            "<inertial><origin xyz=\"{}\"/><mass value=\"{mass}\"/><inertia ixx=\"{}\" iyy=\"{}\" izz=\"{}\" \
             ixy=\"{}\" iyz=\"{}\" ixz=\"{}\"/></inertial>",
            lists(body, "com")[0],
            entries[0],
            entries[1],
            entries[2],
            entries[3],
            entries[4],
            entries[5]
        );
        joint(head, kind, &axis, &body);
    }
    text + "</robot>"
}

/// The table that `show` prints of a URDF file is the arm: typed in again, it has the same M, G and tip. The Panda's hand is
/// fixed by three joints behind each other, the turntable's `lift` stands askew.
#[test]
fn the_table_that_is_shown_is_the_arm() {
    let turntable = file("askew.urdf", turntable("0.3"));
    let panda = data("urdf/panda.urdf");
    let fingers = "--lock panda_finger_joint1=0.02 --lock panda_finger_joint2=0.01";
    for (of, chain, locks) in [
        (&turntable, "base,flange", "--lock mast=0.4"),
        (&panda, "panda_link0,panda_hand_tcp", fingers),
    ] {
        let functions = "--functions mass_matrix,gravity_vector,forward_kinematics";
        let options = format!("{GRAVITY} {functions} {locks}");
        let shown = output(format!("show {of} --chain {chain} {options}"));
        let typed = file("typed.urdf", typed_in(&shown));
        let compared =
            format!("check {typed} --chain l0,tip --against {of} --against-chain {chain}");
        let more = "--samples 5 --allow odd_angle";
        output(format!("{compared} {more} {options}"));
    }
}

/// An arm of two links, of which nothing is said, or whose elements these are.
fn bare(name: &str, inertial: [&str; 2]) -> String {
    let [first, second] = inertial;
    let text = format!(
        r#"<robot name="bare">
  <link name="base"/>
  <link name="upper">{first}</link>
  <link name="lower">{second}</link>
  <joint name="one" type="continuous">
    <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="two" type="continuous">
    <parent link="upper"/><child link="lower"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/>
  </joint>
</robot>
"#
    );
    file(name, text)
}

const POINT: &str = r#"<inertial><origin xyz="0.25 0 0"/><mass value="2"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" iyz="0" ixz="0"/></inertial>"#;
const ZEROS: &str = r#"<inertial><mass value="0"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" iyz="0" ixz="0"/></inertial>"#;

/// A call of a subcommand about a file of `bare`.
fn of_bare(subcommand: &str, file: &str, options: &str) -> String {
    format!("{subcommand} {file} --chain base,lower {GRAVITY} {options}")
}

/// Functions of the geometry do not ask for masses. All others name every link of which nothing is said, in one line, and
/// what takes it as massless; then their values are those of a file that says zero.
#[test]
fn links_without_inertia_matter_where_masses_are_read() {
    let neither = bare("neither.urdf", ["", ""]);
    let zeros = bare("zeros.urdf", [ZEROS, ZEROS]);
    let geometry = "--functions forward_kinematics,jacobian,friction_vector";
    let of_geometry = |file| output(of_bare("show", file, geometry));
    assert_eq!(
        of_geometry(&neither).replace("neither", "zeros"),
        of_geometry(&zeros)
    );
    for functions in ["default", "jacobian,mass_matrix", "center_of_mass"] {
        let message = errors(
            of_bare("show", &neither, &format!("--functions {functions}")),
            1,
        );
        for expected in [
            "neither.urdf:3:3: the links `upper` and `lower` move",
            "no mass moves with `one` and `two`",
            "`--allow no_inertia`",
        ] {
            assert!(message.contains(expected), "{functions}: {message}");
        }
    }
    // A file that says nothing of any inertia is one of geometry, if no function needs it.
    let converted = output(of_bare("convert", &neither, "--to toml"));
    assert!(!converted.contains("mass"), "{converted}");
    let page = folder("neither").join("page.html");
    let page = format!("--out {}", page.to_string_lossy());
    output(of_bare("page", &neither, &page));
    let first = bare("first.urdf", [POINT, ""]);
    assert!(errors(of_bare("convert", &first, "--to toml"), 1).contains("`lower` moves"));
    let message = errors(of_bare("show", &first, ""), 1);
    assert!(!message.contains("`upper`"), "{message}");
    assert!(message.contains("the link `lower` moves"), "{message}");
    assert!(message.contains("no mass moves with `two`"), "{message}");
    let massless = "--functions mass_matrix,gravity_vector --format text";
    let allowed = format!("{massless} --allow no_inertia");
    let shown = output(of_bare("show", &first, &allowed));
    assert!(shown.contains("M11 = 1/8\nM12 = 0\n"), "{shown}");
    let said = bare("said.urdf", [POINT, ZEROS]);
    assert_eq!(output(of_bare("show", &said, massless)), shown);
    // The mass on the second link moves with the first one, too.
    let second = bare("second.urdf", ["", POINT]);
    assert!(errors(of_bare("show", &second, ""), 1).contains("`upper` moves"));
    let bent = "--allow no_inertia --from 0,1 --samples 2";
    output(of_bare("simulate", &second, bent));
}

/// A subcommand that reads masses asks for them whatever `--functions` says, and of a table, too.
#[test]
fn subcommands_ask_for_the_masses_that_they_read() {
    let neither = bare("without.urdf", ["", ""]);
    let table = "convention = 'standard'\ngravity = [0, 0, 0]\nfunctions = ['jacobian']\n\
        [[joint]]\nname = 'one'\ntype = 'revolute'\na = 1\n";
    let table = file("without.toml", table);
    let page = folder("without").join("page.html");
    let page = page.to_string_lossy();
    for (subcommand, options) in [
        ("simulate", ""),
        ("inverse", "--to 1,1"),
        ("page", &format!("--out {page}")),
    ] {
        let functions = format!("{options} --functions jacobian");
        let of_file = of_bare(subcommand, &neither, &functions);
        let of_table = format!("{subcommand} {table} {options}");
        for call in [of_file, of_table] {
            // A page shows the poses of a robot in which nothing has a mass.
            if subcommand == "page" {
                output(&call);
                continue;
            }
            refused(&call, 1, ["`--allow no_inertia`"]);
        }
    }
    refused(
        of_bare("simulate", &neither, "--allow no_inertia"),
        1,
        ["not positive definite"],
    );
    // A converted file can be read back, with the entry that it needs.
    for (options, expected) in [
        ("--functions jacobian", "functions = [\"jacobian\"]"),
        ("--allow no_inertia", "allow = [\"no_inertia\"]"),
    ] {
        for format in ["toml", "json"] {
            let options = format!("{options} --to {format}");
            let text = output(of_bare("convert", &neither, &options));
            let expected = match format {
                "toml" => expected.to_owned(),
                _ => format!("\"{}", expected.replace(" =", "\":")),
            };
            assert!(text.contains(&expected), "{text}");
            output(&["check", &file(&format!("converted.{format}"), text)]);
        }
    }
}

/// A robot at run time, whose functions are those of the request.
#[test]
fn a_robot_at_run_time_asks_for_the_masses_that_its_functions_read() {
    let neither = bare("at_run_time.urdf", ["", ""]);
    let arm = |entries: &str| {
        let options = ReadOptions::new().chain(["base", "lower"]);
        let options = options.entries("gravity = [0, 0, 0]").entries(entries);
        RuntimeRobot::from_file(&neither, &options)
    };
    let message = arm("").map_err(|error| error.to_string()).unwrap_err();
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(message.contains("`allow = [\"no_inertia\"]`"), "{message}");
    let geometry = arm("functions = ['forward_kinematics']").expect("geometry");
    let pose = geometry.forward_kinematics(&[0.0; 2]).expect("a pose");
    assert_eq!(pose[(0, 3)], 0.5);
    let massless = arm("allow = ['no_inertia']").expect("a massless arm");
    assert_eq!(massless.mass_matrix(&[0.0; 2]).map(|m| m.amax()), Ok(0.0));
    assert!(
        massless
            .forward_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2])
            .is_err()
    );
}

/// An arm behind a joint of some kind, with a declaration of XML.
fn behind(name: &str, kind: &str, declaration: &str) -> String {
    let text = format!(
        r#"{declaration}<robot name="behind"><link name="world"/><link name="trunk">{POINT}</link><link name="arm">{POINT}</link>
        <joint name="root" type="{kind}"><parent link="world"/><child link="trunk"/></joint>
        <joint name="elbow" type="continuous"><parent link="trunk"/><child link="arm"/><axis xyz="0 0 1"/></joint></robot>"#
    );
    file(name, text)
}

/// Joints of other kinds are told with a way out that works.
#[test]
fn joints_of_other_kinds_have_a_way_out() {
    for (kind, expected) in [
        ("floating", "on a base that moves, `--base floating`"),
        (
            "planar",
            "two prismatic ones and a revolute one, with links without mass between them",
        ),
        (
            "spherical",
            "three revolute ones, with links without mass between them",
        ),
        ("ball", "three revolute ones"),
    ] {
        let kinds = behind("kinds.urdf", kind, "");
        refused(
            format!("show {kinds} {GRAVITY}"),
            1,
            [
                &format!("the joint `root` is {kind}"),
                expected,
                "`--chain trunk`",
            ],
        );
    }
    let floating = behind("floats.urdf", "floating", "");
    let way_out = "--chain trunk --base floating";
    let shown = output(format!("show {floating} {GRAVITY} {way_out}"));
    assert!(shown.contains("elbow"), "{shown}");
    let kinds = behind("kinds.urdf", "revolut", "");
    refused(
        format!("show {kinds} {GRAVITY}"),
        1,
        ["did you mean `revolute`?"],
    );
}

/// Files in other formats are called by their names, and a declaration may stand behind a blank line.
#[test]
fn formats_of_robots_are_told_apart() {
    for (text, expected) in [
        ("<mujoco model='a'/>", "a file in MJCF"),
        ("<sdf version='1.9'/>", "a file in SDF"),
        ("<html><head/></html>", "download the file itself"),
        ("<xacro/>", "is expanded first"),
    ] {
        let other = file("other.urdf", text);
        refused(format!("show {other} --gravity 0,0,0"), 1, [expected]);
    }
    let of = |declaration: &str| {
        let declared = behind("declared.urdf", "fixed", declaration);
        output(format!("show {declared} {GRAVITY}"))
    };
    let late = "\n  <?xml version=\"1.0\"\n encoding=\"utf-8\"?>\n";
    assert_eq!(of(late), of(""));
    let misspelled = behind("late.urdf", "revolut", late);
    refused(
        format!("show {misspelled} {GRAVITY}"),
        1,
        ["late.urdf:7:34"],
    );
}

/// A hand: two fingers, of which one follows, a thumb and a joint with another name.
fn hand(name: &str, thumb: &str) -> String {
    let finger = |name: &str, more: &str| {
        format!(
            r#"  <link name="{name}_link">{POINT}</link>
  <joint name="{name}" type="prismatic">
    <parent link="arm"/><child link="{name}_link"/><axis xyz="1 0 0"/>{more}
  </joint>
"#
        )
    };
    let fingers = finger("left", r#"<limit lower="-1" upper="1"/>"#)
        + &finger(
            "right",
            r#"<mimic joint="left" multiplier="-1" offset="0.5"/>"#,
        )
        + &finger(thumb, "")
        + &finger("4", "");
    let text = format!(
        r#"<robot name="hand">
  <link name="base"/>
  <link name="arm">{POINT}</link>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 0 1"/><limit lower="1" upper="-1"/>
  </joint>
{fingers}</robot>
"#
    );
    file(name, text)
}

/// `rest` is all joints beside the chain that are not named; what follows one that stands still stands where that says.
#[test]
fn the_rest_of_the_joints_has_a_name() {
    let hand = |name: &str, thumb: &str| (self::hand(name, thumb), "base,arm");
    let (plain, chain) = hand("hand.urdf", "thumb");
    let inertia = |file: &str, options: &str| {
        let chain = format!("--chain {chain} --allow odd_limits");
        mass_matrix(file, &format!("{chain} {options}"))
    };
    // 2 kg at 0.25 m from where each finger is: 0.125, 0.125, 2 0.75^2, 0.125, 0.125.
    assert!(inertia(&plain, "--lock rest=0").contains("M11 = 13/8\n"));
    let named = "--lock left=0 --lock thumb=0 --lock 4=0";
    assert!(inertia(&plain, named).contains("M11 = 13/8\n"));
    for none in [
        "--ignore rest",
        "--ignore left,right,thumb,4",
        "--ignore left,right --ignore rest",
        "--ignore left,right,4 --ignore=thumb",
    ] {
        assert!(inertia(&plain, none).contains("M11 = 1/8\n"), "{none:?}");
    }
    // The left finger at 0.25 m, and so the right one; the others are left out, or at 0.
    let left = "--lock left=0.25 --ignore rest";
    assert!(inertia(&plain, left).contains("M11 = 9/8\n"));
    let left = "--lock left=0.25,rest=0";
    assert!(inertia(&plain, left).contains("M11 = 11/8\n"));
    // A joint that has this name is meant by it alone.
    let (named, _) = hand("hand_at_rest.urdf", "rest");
    let all = "--lock left=0.25 --lock rest=0 --ignore 4";
    assert!(inertia(&named, all).contains("M11 = 5/4\n"));
    let call = format!("--chain {chain} --allow odd_limits --ignore rest");
    refused(
        format!("show {named} {GRAVITY} {call}"),
        1,
        ["the joint `left` moves"],
    );
    // The same options may be about a table besides.
    let table = output(format!("convert {plain} {GRAVITY} {call}"));
    let table = file("hand.toml", table);
    output(format!("check {table} --against {plain} {GRAVITY} {call}"));
    let locked = format!("--chain {chain} --allow odd_limits --lock rest=0");
    let table = output(format!("convert {plain} {GRAVITY} {locked}"));
    let table = file("hand.toml", table);
    output(format!(
        "check {table} --against {plain} {GRAVITY} {locked}"
    ));
}

/// A locked joint stands within its limits. Limits the wrong way round are none if that is requested.
#[test]
fn limits_hold_beside_the_chain() {
    let hand = hand("limits.urdf", "thumb");
    let told = |options: &str, status| {
        let call = format!("show {hand} --chain base,arm --ignore thumb,4");
        errors(format!("{call} {GRAVITY} {options}"), status)
    };
    let message = told("--lock left=0", 1);
    assert_has(
        &message,
        [
            "limits.urdf:6:78: `lower` is above `upper`",
            "`--allow odd_limits`",
        ],
    );
    let message = told("--allow odd_limits --lock left=1.5", 2);
    assert_has(
        &message,
        ["`left` would stand still at 1.5, outside of its limits, -1 to 1: `--lock left=0` is"],
    );
    // A joint of the chain that follows a locked one.
    let follower = r#"<mimic joint="one" multiplier="3"/><limit lower="-1" upper="1"/>"#;
    let text = std::fs::read_to_string(bare("followed.urdf", [POINT, POINT])).expect("the file");
    let text = text.replace(
        "0.5 0 0\"/><axis xyz=\"0 0 1\"/>",
        &format!("0.5 0 0\"/>{follower}"),
    );
    let text = text.replace("\"two\" type=\"continuous\"", "\"two\" type=\"revolute\"");
    let tip = r#"<link name="tip"/><joint name="tip" type="continuous">
        <parent link="lower"/><child link="tip"/></joint></robot>"#;
    let followed = file("followed.urdf", text.replace("</robot>", tip));
    let show = |lock: &str| {
        let options = format!("--chain base,tip --functions jacobian --lock {lock}");
        run(format!("show {followed} {GRAVITY} {options}"))
    };
    assert!(show("one=0.3").status.success());
    let message = String::from_utf8_lossy(&show("one=0.5").stderr).into_owned();
    assert_has(
        &message,
        [
            "followed.urdf:11:",
            "1.5 is outside of the limits of `two`, -1 to 1",
        ],
    );
}

/// An arm is the same whether its file is read whole or from its root to its tip.
#[test]
fn arms_need_no_chain() {
    let urdf = |name: &str| {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/urdf");
        folder.join(name).to_string_lossy().into_owned()
    };
    for (name, chain) in [
        ("z1.urdf", "world,gripperMover"),
        ("xarm7.urdf", "world,link_eef"),
        ("double_pendulum.urdf", "base_link,link2"),
        ("TwoDofs.urdf", "world,Tip"),
        ("finger_edu.urdf", "base_link,finger_tip_link"),
        ("so100.urdf", "base,jaw"),
    ] {
        let file = urdf(name);
        let functions = "--functions default,jacobian,forward_kinematics";
        let show = format!("show {file} --allow no_inertia {GRAVITY} {functions}");
        let with_chain = format!("{show} --chain {chain}");
        assert_eq!(output(&show), output(&with_chain), "{name}");
    }
}
