//! The options that say what a URDF file does not.

use super::calls::{data, errors, file, folder, output, run};

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

const GRAVITY: [&str; 2] = ["--gravity", "0,0,-9.81"];

/// The lines of `show --format text` about M of the turntable.
fn mass_matrix(file: &str, options: &[&str]) -> String {
    let call = [
        "show",
        file,
        "--functions",
        "mass_matrix",
        "--format",
        "text",
    ];
    output(&[&call[..], &GRAVITY[..], options].concat())
}

#[test]
fn the_chain_ends_where_it_is_told() {
    let file = file("turntable.urdf", turntable("1.5707963267948966"));
    let ignore = ["--ignore", "mast"];
    let whole = mass_matrix(
        &file,
        &[&["--chain", "base,flange"][..], &ignore[..]].concat(),
    );
    // 0.15 + 0.01 s2^2 + (0.02 + 2 0.25^2) c2^2, and 0.02 + 2 0.25^2.
    assert!(
        whole.contains("M11 = 0.16 + 0.135 c2^2\nM12 = 0\n"),
        "{whole}"
    );
    assert!(whole.contains("M22 = 0.145\n"), "{whole}");
    let ignore = [&ignore[..], &["--ignore", "lift"]].concat();
    let table = output(
        &[
            &["show", &file, "--chain", "base,table"][..],
            &GRAVITY[..],
            &ignore[..],
        ]
        .concat(),
    );
    assert!(table.contains("1 joint that moves"), "{table}");
    assert!(!table.contains("lift"), "{table}");
    let told = |options: &[&str]| errors(&[&["show", &file][..], options].concat(), 2);
    let gravity = |options: &[&'static str]| [options, &GRAVITY[..]].concat();
    let message = told(&gravity(&[]));
    assert!(message.contains("`--chain BASE,TIP`"), "{message}");
    let message = told(&gravity(&["--chain", "base"]));
    assert!(message.contains("expected BASE,TIP"), "{message}");
    let message = told(&gravity(&["--chain", "base,flang"]));
    assert!(message.contains("`flange`"), "{message}");
    let message = told(&gravity(&["--chain", "base,base"]));
    assert!(
        message.contains("no joint between `base` and `base` moves"),
        "{message}"
    );
    let message = told(&["--chain", "base,table"]);
    assert!(message.contains("`--gravity X,Y,Z`"), "{message}");
    // Both at once, and where the tree begins and ends.
    let message = told(&[]);
    for expected in [
        "`--chain BASE,TIP`",
        "begins at `base`",
        "`flange`",
        "`--gravity X,Y,Z`",
    ] {
        assert!(message.contains(expected), "{message}");
    }
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
        for options in [&[][..], &["--chain", "base,tip"], &GRAVITY] {
            let message = errors(&[&["show", &file][..], options].concat(), 1);
            assert!(
                message.contains(&format!("{name}:1:1: {expected}")),
                "{message}"
            );
        }
    }
}

/// A joint off the chain is left out with what hangs on it, or stands still with it.
#[test]
fn joints_off_the_chain_are_left_out_or_locked() {
    let file = file("mast.urdf", turntable("1.5707963267948966"));
    let call = [
        "show",
        &file,
        "--chain",
        "base,table",
        "--ignore",
        "lift",
        "--functions",
        "mass_matrix",
        "--format",
        "text",
    ];
    let call = |options: &[&'static str]| [&call[..], &GRAVITY[..], options].concat();
    let message = errors(&call(&[]), 1);
    assert!(
        message.contains("mast.urdf:9:3: ")
            && message.contains("`--lock mast=0`")
            && message.contains("`--ignore mast`"),
        "{message}"
    );
    assert!(output(&call(&["--ignore", "mast"])).contains("M11 = 0.15\n"));
    // The camera is above a point 0.3 m from the axis, or a quarter turn leans it outwards to 0.8 m.
    assert!(output(&call(&["--lock", "mast=0"])).contains("M11 = 0.24\n"));
    assert!(output(&call(&["--lock", "mast=PI/2"])).contains("M11 = 0.79\n"));
    let message = errors(&call(&["--ignore", "mst"]), 1);
    assert!(
        message.contains("`mst`") && message.contains("mast"),
        "{message}"
    );
}

#[test]
fn angles_are_rounded_where_that_is_asked_for() {
    let file = file("rounded.urdf", turntable("1.5708"));
    let chain = ["--chain", "base,flange", "--ignore", "mast"];
    // A little of the arm's inertia is about the first axis besides.
    let written = mass_matrix(&file, &chain);
    assert!(!written.contains("M12 = 0\n"), "{written}");
    let rounded = mass_matrix(
        &file,
        &[&chain[..], &["--round-angles", "1e-4"][..]].concat(),
    );
    assert!(rounded.contains("M12 = 0\n"), "{rounded}");
    let still = mass_matrix(
        &file,
        &[&chain[..], &["--round-angles", "1e-6"][..]].concat(),
    );
    assert_eq!(still, written);
    for wrong in ["1", "-1", "small"] {
        let option = format!("--round-angles={wrong}");
        let message = errors(
            &[&["show", &file, &option][..], &chain[..], &GRAVITY[..]].concat(),
            2,
        );
        assert!(message.contains("from 0 to 0.1 rad"), "{message}");
    }
}

/// Each subcommand takes the options: an arm of a robot with many others.
#[test]
fn every_subcommand_reads_a_chain() {
    let file = data("urdf/anymal.urdf");
    let out = folder("chain");
    let out = out.to_string_lossy();
    let chain = [
        "--chain",
        "base,LF_FOOT",
        "--ignore",
        "RF_HAA",
        "--ignore",
        "LH_HAA",
        "--ignore",
        "RH_HAA",
    ];
    for call in [
        vec!["show", &file, "--functions", "gravity_vector"],
        vec![
            "check",
            &file,
            "--functions",
            "gravity_vector",
            "--samples",
            "2",
        ],
        vec![
            "generate",
            &file,
            "--functions",
            "gravity_vector",
            "--lang",
            "js",
            "--out",
            &out,
        ],
        vec!["simulate", &file, "--duration", "0.01", "--samples", "2"],
        vec!["inverse", &file, "--to", "0.1,0.2,0.3", "--samples", "2"],
        vec!["measure", &file, "--functions", "gravity_vector"],
        vec!["convert", &file],
    ] {
        let odd = ["--allow", "unphysical_inertia"];
        let text = output(&[&call[..], &chain[..], &GRAVITY[..], &odd[..]].concat());
        assert!(!text.is_empty(), "{call:?}");
    }
}

/// What no body can have is taken as it is where that is asked for.
#[test]
fn odd_files_are_accepted_where_that_is_asked_for() {
    let odd = turntable("0").replace("izz=\"0.15\"", "izz=\"0.25\"");
    let file = file("odd.urdf", odd);
    let call = [
        "show",
        &file,
        "--chain",
        "base,flange",
        "--ignore",
        "mast",
        "--functions",
        "gravity_vector",
    ];
    let call = [&call[..], &GRAVITY[..]].concat();
    let message = errors(&call, 1);
    assert!(
        message.contains("`--allow unphysical_inertia`"),
        "{message}"
    );
    output(&[&call[..], &["--allow", "unphysical_inertia"][..]].concat());
}

/// A word that is nearly one of URDF's would leave something of the arm out, if it were passed over; other words mean
/// something to other programs.
#[test]
fn misspelled_words_are_told() {
    let right = turntable("0");
    let call = |name: &str, text: String| {
        let file = file(name, text);
        let options = ["--chain", "base,flange", "--ignore", "mast"];
        run(&[&["show", &file][..], &GRAVITY, &options].concat())
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
    }
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
    let fingers = ["panda_finger_joint1=0.02", "panda_finger_joint2=0.01"];
    for (of, chain, locks) in [
        (&turntable, "base,flange", &["mast=0.4"][..]),
        (&panda, "panda_link0,panda_hand_tcp", &fingers[..]),
    ] {
        let locks: Vec<_> = locks.iter().flat_map(|lock| ["--lock", lock]).collect();
        let functions = [
            "--functions",
            "mass_matrix,gravity_vector,forward_kinematics",
        ];
        let options = [&GRAVITY[..], &functions[..], &locks[..]].concat();
        let shown = output(&[&["show", of, "--chain", chain][..], &options].concat());
        let typed = file("typed.urdf", typed_in(&shown));
        let compared = [
            "check",
            &typed,
            "--chain",
            "l0,tip",
            "--against",
            of,
            "--against-chain",
            chain,
        ];
        let more = ["--samples", "5", "--allow", "odd_angle"];
        output(&[&compared[..], &more[..], &options].concat());
    }
}
