//! Entries beside a file: which add to the file's, which take their place, and which are mistakes.

use crate::description::{Entry, Name, Place, Table};
use crate::files::{Format, Request, model_beside, table};
use crate::{Error, Model};
use dynamics_symbolic::robot::Value;

const FILE: &str = include_str!("../../tests/mistakes/files/locked.toml");

/// The model of the file with entries beside it.
fn beside(entries: &str) -> Result<Model, Vec<Error>> {
    let request = Request::default();
    let entries = table("beside", entries, Format::Toml, &request).expect("entries");
    model_beside("locked", FILE, Format::Toml, entries)
}

fn messages(entries: &str) -> Vec<String> {
    let errors = beside(entries).expect_err("a mistake");
    errors.into_iter().map(|error| error.message).collect()
}

#[test]
fn locks_couplings_and_what_is_allowed_add_up() {
    let entries =
        "lock = { wrist = 0.1 }\ncouple = { thumb = \"2 * finger\" }\nallow = [\"odd_mass\"]";
    let robot = beside(entries).expect("a robot").robot;
    let locked = |name: &str| {
        let row = robot.rows.iter().find(|row| row.name == name);
        row.and_then(|row| Some(row.locked.as_ref()?.to_f64(&[])))
    };
    assert_eq!((locked("elbow"), locked("wrist")), (Some(0.3), Some(0.1)));
    let followers: Vec<_> = robot
        .followers()
        .map(|(row, _)| row.name.as_str())
        .collect();
    assert_eq!(followers, ["jaw", "thumb"]);
    assert_eq!(robot.dof(), 2);
}

#[test]
fn the_other_entries_replace_those_of_the_file() {
    let model = beside(
        "gravity = [0, 0, 0]\nfunctions = [\"jacobian\"]\nbase = { xyz = [1, 0, 0] }\ntool = { xyz = [0, 2, 0] }\n\
         allow = [\"odd_mass\"]",
    );
    let model = model.expect("a robot");
    assert!(model.robot.gravity.iter().all(|g| g.to_f64(&[]) == 0.0));
    assert_eq!(model.requests.len(), 1);
    assert!(model.robot.base.is_some() && model.robot.tool.is_some());
}

/// A joint twice is one lock where the positions agree, however they are written.
#[test]
fn a_joint_is_locked_at_one_position() {
    let allowed = "allow = [\"odd_mass\"]\nlock = ";
    assert!(beside(&format!("{allowed}{{ elbow = 0.3 }}")).is_ok());
    for (position, shown) in [
        ("0.5", "at 0.3 in one place and at 0.5"),
        ("\"PI/8\"", "and at 0.39"),
    ] {
        let messages = messages(&format!("{allowed}{{ elbow = {position} }}"));
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert!(messages[0].contains(shown), "{messages:?}");
    }
}

#[test]
fn what_is_the_file_s_alone_is_a_mistake_beside_it() {
    let row = "[[joint]]\nname = \"a\"\ntype = \"revolute\"\nmass = 1";
    let messages = messages(&format!(
        "convention = \"modified\"\nallow = [\"odd_mass\"]\n{row}"
    ));
    let expected = ["convention", "joint"]
        .map(|word| format!("`{word}` beside a file, which says it itself: remove `{word}`"));
    assert_eq!(messages, expected);
}

/// The rows are those of a file that has the cells itself.
#[test]
fn cells_of_joints_replace_those_of_the_file() {
    let cells = "friction = { viscous = 0.1, coulomb = \"PI/8\" }\nspring = { stiffness = 3 }\nlimits = [-1, 2]\n\
                 motor = { inertia = 1e-3, gear_ratio = 50 }\n";
    let row = "name = \"wrist\"\ntype = \"revolute\"\n";
    let within = FILE.replace(row, &format!("{row}{cells}"));
    assert_ne!(within, FILE);
    let allowed = "allow = [\"odd_mass\"]\n";
    let request = Request::default();
    let entries = table("beside", allowed, Format::Toml, &request).expect("entries");
    let written = model_beside("locked", &within, Format::Toml, entries).expect("a robot");
    let given = beside(&format!("{allowed}[joints.wrist]\n{cells}")).expect("a robot");
    assert_eq!(given.robot.rows, written.robot.rows);
    // A second time in place of the first, cell by cell.
    let entries = format!("{allowed}[joints.wrist]\nfriction = {{ viscous = 7 }}");
    let entries = table("beside", &entries, Format::Toml, &request).expect("entries");
    let replaced = model_beside("locked", &within, Format::Toml, entries).expect("a robot");
    let wrist = &replaced.robot.rows[2];
    assert_eq!(wrist.viscous.to_f64(&[]), 7.0);
    assert!(wrist.coulomb.iter().all(Value::is_zero));
    assert_eq!(wrist.limits, written.robot.rows[2].limits);
}

#[test]
fn mistakes_in_cells_beside_a_file_are_told() {
    let told = |entries: &str| match table("beside", entries, Format::Toml, &Request::default()) {
        Ok(_) => messages(entries),
        Err(errors) => errors.into_iter().map(|error| error.message).collect(),
    };
    for (entries, part) in [
        (
            "[joints.elbo]\nspring = { stiffness = 1 }",
            "unknown joint `elbo`: did you mean `elbow`?",
        ),
        (
            "[joints.elbow]\nmass = 1",
            "`mass` of a joint comes from its file",
        ),
        (
            "[joints.elbow]\nsprng = { stiffness = 1 }",
            "unknown cell `sprng`: did you mean `spring`?",
        ),
        (
            "[joints.elbow]\ngravity = [0, 0, 0]",
            "above the first line `[joints.NAME]`",
        ),
        (
            "[joints.joint.1]\nspring = { stiffness = 1 }",
            "in quotes, `[joints.\"joint.1\"]`",
        ),
        ("[joints]", "no joint is named"),
        (
            "joints.elbow = 3",
            "expected a table for a joint of the file",
        ),
        (
            "[[joints]]\nname = \"elbow\"\ntype = \"revolute\"",
            "unknown key `joints`: did you mean `joint`?",
        ),
    ] {
        let messages = told(&format!("allow = [\"odd_mass\"]\n{entries}"));
        let [message] = &messages[..] else {
            panic!("{entries}: {messages:#?}");
        };
        assert!(message.contains(part), "{entries}: {message}");
    }
}

/// Bodies and angles that are allowed for a joint of a URDF file alone.
#[test]
fn allowances_of_a_joint_are_those_of_its_placement_and_its_bodies() {
    let text = "<robot name='r'><link name='base'/>\
        <joint name='one' type='revolute'><origin rpy='90 0 0'/><parent link='base'/><child link='arm'/></joint>\
        <link name='arm'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='3' ixy='0' iyz='0' ixz='0'/>\
        </inertial></link></robot>";
    let read = |allow: &str| {
        let entries = format!("gravity = [0, 0, -9.81]\n[joints.one]\nallow = [{allow}]");
        let mut beside =
            table("beside", &entries, Format::Toml, &Request::default()).expect("entries");
        let link = |name| Name::new(name, Place::File { line: 1, column: 1 });
        let chain = Entry::Chain(Some(vec![link("base"), link("arm")]));
        beside.entries.push(chain);
        model_beside("r", text, Format::Urdf, beside)
    };
    assert!(read("\"odd_angle\", \"unphysical_inertia\"").is_ok());
    for (allow, part) in [
        ("\"odd_angle\"", "no body has this inertia tensor"),
        ("\"unphysical_inertia\"", "`rpy` is in radians"),
    ] {
        let errors = read(allow).expect_err("a mistake");
        assert!(errors[0].message.contains(part), "{errors:?}");
    }
}

/// Messages about a file of two joints and a finger beside them, with entries beside it.
fn messages_of_chain(entries: &str) -> Vec<String> {
    let joint = |name: &str, parent: &str, child: &str, limit: &str| {
        format!(
            "<joint name='{name}' type='revolute'><parent link='{parent}'/><child link='{child}'/>{limit}</joint>\
             <link name='{child}'/>"
        )
    };
    let swapped = joint("one", "base", "arm", "<limit lower='1' upper='-1'/>");
    let other = joint("two", "arm", "tip", "<limit lower='-1' upper='1'/>");
    let fingers = ["left", "right"].map(|name| joint(name, "arm", &format!("{name}_link"), ""));
    let text = format!(
        "<robot name='r'><link name='base'/>{swapped}{other}{}</robot>",
        fingers.concat()
    );
    let entries = format!("gravity = [0, 0, -9.81]\n{entries}");
    let mut beside = table("beside", &entries, Format::Toml, &Request::default()).expect("entries");
    let link = |name| Name::new(name, Place::File { line: 1, column: 1 });
    let chain = Entry::Chain(Some(vec![link("base"), link("tip")]));
    beside.entries.push(chain);
    let errors = model_beside("r", &text, Format::Urdf, beside).expect_err("a mistake");
    errors.into_iter().map(|error| error.message).collect()
}

#[test]
fn limits_the_wrong_way_round_are_told_beside_links_without_inertia() {
    let messages = messages_of_chain("lock = { left = 0, right = 0 }");
    let count = |part: &str| messages.iter().filter(|text| text.contains(part)).count();
    let counts = [
        count("the links `arm` and `tip` move and have no `<inertial>`"),
        count("`lower` is above `upper`"),
    ];
    assert_eq!((counts, messages.len()), ([1, 1], 2), "{messages:#?}");
}

#[test]
fn a_position_of_the_rest_that_is_no_number_is_told_once() {
    let messages = messages_of_chain("lock = { rest = \"nan\" }\nallow = [\"no_inertia\"]");
    let [message] = &messages[..] else {
        panic!("{messages:#?}");
    };
    assert!(
        message.starts_with("`rest` is all joints beside the chain"),
        "{message}"
    );
}

/// A pendulum whose mass and length are names.
const NAMES: &str = "convention = 'modified'\ngravity = [0, -9.81, 0]\n[[joint]]\nname = 'pivot'\ntype = 'revolute'\nmass = 'm'\n\
                     com = ['2 * l', 0, 0]\n";

/// The fields of the text, where names are fields, or the messages about it.
fn fields(text: &str, entries: &str) -> Result<Vec<String>, Vec<String>> {
    let entries = table("names", entries, Format::Toml, &Request::default()).expect("entries");
    let entries = Table {
        names_are_fields: true,
        ..entries
    };
    let model = model_beside("names", text, Format::Toml, entries);
    let messages = |errors: Vec<Error>| errors.into_iter().map(|error| error.message).collect();
    model.map(|model| model.robot.fields).map_err(messages)
}

/// Names that nothing binds are fields in the order in which they are read; a list gives the order, and is closed.
#[test]
fn names_that_nothing_binds_are_fields() {
    let owned = |names: &[&str]| {
        names
            .iter()
            .map(|name| (*name).to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(fields(NAMES, ""), Ok(owned(&["m", "l"])));
    assert_eq!(fields(NAMES, "let.m = 3"), Ok(owned(&["l"])));
    let listed = |list: &str| format!("fields = {list}\n{NAMES}");
    assert_eq!(fields(&listed("['l', 'm']"), ""), Ok(owned(&["l", "m"])));
    assert_eq!(
        fields(&listed("['l', 'm']"), "let.l = 1"),
        Ok(owned(&["m"]))
    );
    assert_eq!(
        fields(&listed("['l']"), ""),
        Err(owned(&[
            "unknown name `m`: `fields` of the file does not list it"
        ]))
    );
    assert_eq!(
        fields(&listed("['l', 'm', 'load']"), ""),
        Err(owned(&["the field `load` is never used"]))
    );
    // Values beside the file are meant for names of the file.
    let beside = fields(NAMES, "let.m = '2 * mass'").expect_err("a mistake");
    assert!(beside[0].contains("unknown name `mass`"), "{beside:?}");
}

/// The struct of a call has the fields, whatever the file lists.
#[test]
fn a_call_with_a_file_that_lists_fields() {
    let path = std::env::temp_dir().join(format!("listed_{}.toml", std::process::id()));
    std::fs::write(&path, format!("fields = ['l', 'm']\n{NAMES}")).expect("a file");
    let call = |structure: &str| {
        let call = format!("{structure} file: \"{}\"", path.display());
        super::read(call.parse().expect("the source lexes"))
    };
    let (model, _) = call("struct Arm { m: f64, l: f64 }");
    let (none, messages) = call("struct Arm { m: f64 }");
    std::fs::remove_file(&path).expect("the file");
    assert_eq!(model.expect("a robot").robot.fields, ["m", "l"]);
    assert!(
        none.is_none() && messages[0].contains("unknown name `l`"),
        "{messages:?}"
    );
    assert!(!messages[0].contains("does not list it"), "{messages:?}");
}

/// A robot of links: an arm whose hand is fixed to it, and has a body beside that of the arm.
const URDF: &str = r#"<robot name="arm">
<link name="stand"/>
<link name="arm"><inertial><origin xyz="0.1 0 0"/><mass value="2"/>
  <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="hand"><inertial><origin xyz="0 0 0.05" rpy="0 0 1.5707963267948966"/><mass value="0.5"/>
  <inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="empty"/>
<joint name="lift" type="revolute"><parent link="stand"/><child link="arm"/><axis xyz="0 1 0"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/><origin xyz="0.4 0 0"/></joint>
<joint name="end" type="fixed"><parent link="hand"/><child link="empty"/><origin xyz="0 0 0.2"/></joint>
</robot>"#;

fn with_links(entries: &str) -> Result<Model, Vec<Error>> {
    with_links_but(entries, &[])
}

/// The same without some joints.
fn with_links_but(entries: &str, ignored: &[&str]) -> Result<Model, Vec<Error>> {
    let entries = format!("gravity = [0, 0, -9.81]\n{entries}");
    let request = Request::default();
    let mut entries = table("beside", &entries, Format::Toml, &request)?;
    entries.names_are_fields = true;
    let ignored = ignored.iter().map(|name| Name::new(*name, Place::START));
    entries.entries.push(Entry::Ignore(Some(ignored.collect())));
    model_beside("arm", URDF, Format::Urdf, entries)
}

/// A link with cells beside the file stands by itself, on its frame; its other cells are those of the file.
#[test]
fn cells_of_links_replace_those_of_the_file() {
    let model = with_links("[links.hand]\nmass = \"load\"\ncom = [0, 0, \"z\"]").expect("a robot");
    assert_eq!(model.robot.fields, ["load", "z"]);
    let arm = model.robot.rows[0].body();
    assert_eq!(arm.mass.to_f64(&[]), 2.0);
    let [hand] = &model.robot.frames[..] else {
        panic!("{:?}", model.robot.frames)
    };
    let body = hand.body.as_ref().expect("a body");
    assert_eq!(body.mass.to_f64(&[3.0, 0.2]), 3.0);
    assert_eq!(body.com[2].to_f64(&[3.0, 0.2]), 0.2);
    // Turned by a quarter, the axes x and y have changed places.
    let [xx, yy, zz] = [0, 1, 2].map(|k| body.inertia[k].to_f64(&[]));
    assert_eq!([xx, yy, zz], [0.02, 0.01, 0.02]);
    // With the file's own mass it is the robot of the file.
    let same = with_links("[links.hand]\nmass = 0.5")
        .expect("a robot")
        .robot;
    let (lift, whole) = (same.rows[0].body(), with_links("").expect("a robot").robot);
    let masses = [
        &lift.mass,
        &same.frames[0].body.as_ref().expect("a body").mass,
    ];
    let sum: f64 = masses.iter().map(|mass| mass.to_f64(&[])).sum();
    assert_eq!(sum, whole.rows[0].body().mass.to_f64(&[]));
    assert!(whole.frames.is_empty());
    // A link without a body has one then, and needs no other.
    let load = with_links("[links.empty]\nmass = 1")
        .expect("a robot")
        .robot;
    assert_eq!(load.frames.len(), 1);
}

#[test]
fn mistakes_in_cells_of_links_are_told() {
    for (entries, part) in [
        (
            "[links.hnd]\nmass = 1",
            "unknown link `hnd`: did you mean `hand`?",
        ),
        (
            "[links.hand]\nmas = 1",
            "unknown cell `mas`: did you mean `mass`?",
        ),
        ("[links.hand]\nmass = -1", "a mass cannot be negative"),
        (
            "links = [1]",
            "expected a table with the cells of each link",
        ),
        ("links = {}", "no link is named"),
    ] {
        let errors = with_links(entries).expect_err("a mistake");
        let told: Vec<_> = errors.iter().map(|error| &error.message).collect();
        assert!(told.len() == 1 && told[0].contains(part), "{told:?}");
    }
    let errors = with_links_but("[links.hand]\nmass = 1", &["wrist"]).expect_err("a mistake");
    assert!(
        errors[0]
            .message
            .contains("`hand` is none of the robot's links")
    );
    let told = messages("allow = [\"odd_mass\"]\n[links.hand]\nmass = 1");
    assert!(
        told.len() == 1 && told[0].contains("the links of a URDF file"),
        "{told:?}"
    );
}
