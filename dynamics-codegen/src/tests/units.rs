//! Lengths in mm, masses in g, and gear ratios that were written the wrong way round.

use super::{message, messages, model};

/// A call with those rows and nothing that is allowed.
fn call(rows: &str, entries: &str) -> String {
    format!(
        "struct Arm {{ x: f64 }} convention: standard, gravity: [0, 0, -9.81],
         joints: [first: revolute {{ spring: {{ stiffness: x }} }}, {rows}], {entries}"
    )
}

/// Each is one error, however many numbers are in that unit, and is accepted by its word.
#[test]
fn lengths_in_millimetres_are_reported_once() {
    for (rows, entries, told) in [
        // One cell alone.
        (
            "r: revolute { a: 500, mass: 2, com: [-0.25, 0, 0] }",
            "",
            "a length of 500 m: lengths are in m, and 500 mm are `0.5`",
        ),
        // All of them, of which the longest is named, or the first of the longest.
        (
            "r: revolute { a: -431.8, d: 150, mass: 17, com: [-68, 6, -16] }, s: revolute { a: 431.8 }",
            "tool: { xyz: [0, 0, 90], mass: 1 },",
            "a length of -431.8 m: lengths are in m, and -431.8 mm are `-0.4318`",
        ),
        // Links of a hand beside centres of mass, tensors or masses.
        (
            "r: revolute { a: 50, mass: 0.5, com: [-0.02, 0, 0] }",
            "",
            "a length of 50 m: ",
        ),
        (
            "r: revolute { a: 80, mass: 2, com: [-0.04, 0, 0], inertia: rod(0.08) }",
            "",
            "a length of 80 m: ",
        ),
        (
            "r: revolute { d: 40, mass: 0.02, com: [-20, 0, 0] }, s: revolute { a: 30, mass: 0.01, com: [-15, 0, 0] }",
            "",
            "a length of 40 m: ",
        ),
        // An arm without another length, and one whose tool alone is long.
        (
            "r: revolute { mass: 1, com: [0, 0, -250] }",
            "",
            "a length of -250 m: ",
        ),
        (
            "r: revolute { a: 20, mass: 100, com: [-10, 0, 0] }",
            "tool: { xyz: [0, 0, 101] },",
            "a length of 101 m: ",
        ),
    ] {
        let message = message(&call(rows, entries));
        assert!(message.starts_with(told), "{message}");
        assert!(
            message.ends_with("correct all lengths alike (`allow: [odd_length]` at the end of the table accepts them)"),
            "{message}"
        );
        model(&call(rows, &format!("{entries} allow: [odd_length]")));
    }
}

#[test]
fn masses_in_grams_are_reported_once() {
    for (rows, entries, told, place) in [
        (
            "r: revolute { a: 1, mass: 2000, com: [-0.5, 0, 0] }",
            "",
            "a mass of 2000 kg in an arm whose longest part is 1 m: masses are in kg, and 2000 g are `2`",
            "row",
        ),
        (
            "r: revolute { a: 0.425, mass: 8393, com: [-0.2, 0, 0] }, s: revolute { a: 0.39, mass: 2275 }",
            "",
            "a mass of 8393 kg in an arm whose longest part is 0.425 m: masses are in kg, and 8393 g are `8.393`",
            "row",
        ),
        (
            "r: revolute { a: 0.4, mass: 5 }",
            "tool: { xyz: [0, 0, 0.1], mass: 750 },",
            "a mass of 750 kg in an arm whose longest part is 0.4 m: ",
            "tool",
        ),
        // 654 kg are implausible too.
        (
            "r: revolute { a: 0.4, mass: 654498, com: [-0.2, 0, 0] }",
            "",
            "a mass of 654498 kg in an arm whose longest part is 0.4 m: masses are in kg, and 654498 mg are `0.654498`",
            "row",
        ),
    ] {
        let message = message(&call(rows, entries));
        assert!(message.starts_with(told), "{message}");
        let end = format!("alike (`allow: [odd_mass]` on the {place} accepts it)");
        assert!(message.ends_with(&end), "{message}");
        model(&call(rows, &format!("{entries} allow: [odd_mass]")));
    }
    // The next one is reported where the heaviest is allowed.
    let rows = "r: revolute { a: 1, mass: 9000, allow: [odd_mass] }, s: revolute { mass: 3000 }";
    assert!(message(&call(rows, "")).starts_with("a mass of 3000 kg"));
}

/// Machines of all sizes; what depends on a field is not judged.
#[test]
fn large_and_small_machines_are_accepted() {
    for (rows, entries) in [
        // An excavator of 20 t, an industrial robot for 2 t, a crane, a telescope, a mining shovel.
        (
            "r: revolute { d: 1.5, mass: 15000, com: [-1, 0, 0.5] }, s: revolute { a: 6, mass: 1800, com: [-3, 0, 0] },
             t: revolute { a: 3, mass: 900, com: [-1.5, 0, 0] }",
            "tool: { xyz: [1, 0, 0], mass: 2500 },",
        ),
        (
            "r: revolute { d: 1.1, a: 0.6, mass: 3000 }, s: revolute { a: 1.475, mass: 3500, com: [-0.7, 0, 0] }",
            "tool: { xyz: [0, 0, 0.4], mass: 2300 },",
        ),
        (
            "r: revolute { d: 80, mass: 40000, com: [0, 0, -30] }, s: prismatic { mass: 5000, limits: [3, 70] },
             t: prismatic { mass: 800, limits: [0, 80] }",
            "",
        ),
        (
            "r: revolute { alpha: PI/2, mass: 100000, com: [0, 0, 0.5], inertia: cylinder(4, 3) },
             s: revolute { mass: 150000, com: [0, 0.1, 0], inertia: cylinder(4, 15) }",
            "",
        ),
        ("r: revolute { a: 20, mass: 100000, com: [-10, 0, 0] }", ""),
        // A manipulator of 5 mm, a hand, a small head with a camera, a fishing rod.
        (
            "r: revolute { a: 0.005, mass: 1e-5, com: [-0.0025, 0, 0] }, s: revolute { a: 0.003, mass: 4e-6 }",
            "",
        ),
        (
            "r: revolute { mass: 0.8, com: [0, 0, 0.04] }, s: revolute { a: 0.05, mass: 0.03, com: [-0.02, 0, 0] }",
            "",
        ),
        ("r: revolute { a: 0.02, mass: 4, com: [0, 0, 0.03] }", ""),
        ("r: revolute { a: 12, mass: 0.4, com: [-6, 0, 0] }", ""),
        // Centres of mass at the origins of frames, except for one that was measured.
        (
            "r: revolute { a: 0.4, mass: 2 }, s: revolute { a: 0.3, mass: 1, com: [0, 0, 0.0002] }",
            "",
        ),
        // A rail of half a kilometre, and a base that stands far from the world's origin.
        (
            "r: prismatic { mass: 40, com: [0, 0, 0.1], limits: [0, 500] }, s: revolute { a: 1, mass: 5 }",
            "base: { xyz: [4000, 500, 30] },",
        ),
        ("r: revolute { a: 1, mass: 2000 * x }, s: revolute { a: x, mass: 2000 }", ""),
        ("r: revolute { a: 500 * x, mass: 1, com: [0.25, 0, 0] }", ""),
        ("r: revolute { a: 50, mass: x, com: [0.01, 0, 0] }", ""),
        ("r: revolute { a: 50, mass: 1, com: [0.01 * x, 0, 0] }", ""),
        // A point mass on an axis.
        ("r: revolute { mass: 5000 }", ""),
    ] {
        model(&call(rows, entries));
    }
}

#[test]
fn a_motor_slower_than_its_joint_is_allowed_by_name() {
    let rows = |motor: &str, allow: &str| {
        let row = format!("r: revolute {{ a: 0.4, mass: 1, motor: {{ {motor} }}, {allow} }}");
        call(&row, "")
    };
    for (ratio, told) in [
        (
            "0.01",
            "a gear ratio of 0.01 is below 1, and the motor slower than its joint: motor speed over joint speed, \
                  the inverse, is `100` (`allow: [odd_gear_ratio]` on the row accepts 0.01)",
        ),
        ("-1/160", "a gear ratio of -0.00625 is below 1, "),
        ("0.99", "a gear ratio of 0.99 is below 1, "),
    ] {
        let motor = format!("inertia: 2e-4, gear_ratio: {ratio}");
        let message = message(&rows(&motor, ""));
        assert!(message.starts_with(told), "{message}");
        model(&rows(&motor, "allow: [odd_gear_ratio]"));
        let everywhere = format!("{} allow: [odd_gear_ratio]", rows(&motor, ""));
        model(&everywhere);
    }
    for good in [
        "gear_ratio: 1",
        "gear_ratio: -1",
        "gear_ratio: 100",
        "gear_ratio: 0.01 * x",
    ] {
        model(&rows(&format!("inertia: 2e-4, {good}"), ""));
    }
    model(&rows("inertia: 0, gear_ratio: 0", ""));
    // Each of them has a number of its own to be written.
    let row = "revolute { a: 0.4, mass: 1, motor: { inertia: 1, gear_ratio: 0.1 } }";
    assert_eq!(messages(&call(&format!("r: {row}, s: {row}"), "")).len(), 2);
}

/// The robots of the tests' data, as they are published.
#[cfg(feature = "files")]
#[test]
fn no_robot_of_the_data_is_refused() {
    let mut count = 0;
    for folder in ["tests/data/robots", "tests/data/urdf"] {
        let path = format!("{}/../{folder}", env!("CARGO_MANIFEST_DIR"));
        let entries = std::fs::read_dir(path).expect("the folder");
        let paths = entries.map(|entry| entry.expect("an entry").path());
        for path in paths.filter(|path| path.extension().is_some_and(|e| e == "json")) {
            let name = path.file_name().expect("a name").to_string_lossy();
            let entries = match folder {
                "tests/data/urdf" => arm(&std::fs::read_to_string(&path).expect("a text")),
                _ => format!("file: \"../{folder}/{name}\""),
            };
            model(&format!("struct Arm; {entries}"));
            count += 1;
        }
    }
    assert!(count > 50, "{count}");
    let folder = format!("{}/../tests/data/urdf/trees", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(folder).expect("the folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let names = names.filter_map(|name| {
        name.to_str()
            .filter(|name| name.ends_with(".urdf"))
            .map(str::to_owned)
    });
    let trees = names.map(|name| {
        let file = format!("file: \"../tests/data/urdf/trees/{name}\", gravity: [0, 0, -9.81]");
        model(&format!("struct Tree; {file}, allow: [unphysical_inertia]"));
    });
    assert!(trees.count() >= 5);
}

/// The entries that choose a published arm in its file.
#[cfg(feature = "files")]
fn arm(recorded: &str) -> String {
    let between = |key: &str, [start, end]: [&str; 2]| {
        let (_, behind) = recorded
            .split_once(&format!("\"{key}\": {start}"))
            .expect("the key");
        behind.split_once(end).expect("its end").0.to_owned()
    };
    let file = between("file", ["\"", "\""]);
    let chain = between("chain", ["[", "]"]);
    let lists = [
        ("ignore", between("ignore", ["[", "]"])),
        ("lock", between("lock", ["{", "}"]).replace(':', " =")),
    ];
    let filled = lists.iter().filter(|(_, list)| list.contains('"'));
    let filled: String = filled
        .map(|(key, list)| format!("{key}: [{list}], "))
        .collect();
    format!(
        "file: \"../tests/data/urdf/{file}\", chain: [{chain}], {filled} gravity: [0, 0, -9.81],
         allow: [unphysical_inertia]"
    )
}
