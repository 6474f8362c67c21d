//! TOML and JSON.

use std::fmt::Write;

use arms::{MOUNTED, NAMES};
use dynamics_codegen::files::Format;
use dynamics_symbolic::robot::{Convention, JointType, Placement, Robot, Value};
use robot_dynamics::nalgebra::Vector3;
use robot_dynamics::robot_dynamics;

use super::{robot, text};

mod from_file {
    use super::robot_dynamics;

    robot_dynamics! {
        /// Every entry and cell, in TOML.
        #[derive(Clone, Copy)]
        pub(super) struct Everything { pub(super) load: f64 }
        file: "../data/files/everything.toml",
    }

    robot_dynamics! {
        /// A published table.
        pub(super) struct Puma560;
        file: "../data/robots/puma560.json",
        functions: [inverse_dynamics],
    }
}

mod typed {
    use super::robot_dynamics;

    robot_dynamics! {
        /// Every entry and cell, in the macro's own form.
        #[derive(Clone, Copy)]
        pub(super) struct Everything { pub(super) load: f64 }

        let l = 0.25;
        let turn = PI / 2;
        convention: modified,
        gravity: [0, 0, -9.81],
        lock: [brake = deg(-30)],
        functions: [default, jacobian, control_terms = (mass_matrix, bias_force)],
        base: { xyz: [0, 0, l + 0.55], rpy: [0, deg(30), 0] },
        tool: {
            xyz: [0, 0, 0.1], rpy: [0, 0, turn / 2], mass: load, com: [0, 0, 0.05], inertia: sphere(0.04),
        },
        joints: [
            lift: prismatic {
                d: 0.1, mass: 3, inertia: cuboid(0.1, 0.2, 0.3), spring: { stiffness: 200, rest: 0.1 },
                limits: [-0.5, 0.5],
            },
            brake: revolute { a: l, alpha: -turn, theta: 0.3, mass: 1.5, com: [0.1, 0, -l / 10] },
            turn: revolute {
                a: 2 * l, alpha: 1.5707963267948966, mass: 10.5e-1, com: [1e-2, -0.02, 0.03],
                inertia: { xx: 0.01, yy: 0.012, zz: 0.013, xy: 1e-4, yz: -2e-4, xz: 3e-4 },
                motor: { inertia: 200e-6, gear_ratio: -62.6111 },
                limits: [-2 * PI, 2 * PI],
                friction: {
                    viscous: 0.1, coulomb: { positive: 0.5, negative: 0.4 },
                    stribeck: { static: 0.8, velocity: 0.01 },
                },
            },
            published: revolute {
                d: -0.1, mass: 1, inertia: { xx: 1, yy: 1, zz: 3 }, allow: [unphysical_inertia],
                friction: { coulomb: 0.2 },
            },
        ],
    }

    robot_dynamics! {
        /// The PUMA's waist alone.
        pub(super) struct Waist;
        convention: standard,
        gravity: [0, 0, -9.81],
        joints: [
            waist: revolute {
                d: 0.67183, alpha: PI/2,
                inertia: { yy: 0.35 },
                motor: { inertia: 200e-6, gear_ratio: -62.6111 },
                friction: { viscous: 5.80182176795, coulomb: 25.9836065 },
            },
        ],
    }
}

#[test]
fn every_entry_and_cell_can_stand_in_a_file() {
    let (file, typed) = (
        from_file::Everything { load: 2.5 },
        typed::Everything { load: 2.5 },
    );
    assert_eq!(
        from_file::Everything::JOINT_NAMES,
        typed::Everything::JOINT_NAMES
    );
    assert_eq!(
        from_file::Everything::OPERATIONS,
        typed::Everything::OPERATIONS
    );
    assert_eq!(file.table(), typed.table());
    let (q, qd, qdd) = (
        Vector3::new(0.2, -1.1, 0.4),
        Vector3::new(-0.5, 0.9, 1.3),
        Vector3::new(0.3, 0.6, -0.8),
    );
    assert_eq!(
        file.inverse_dynamics(&q, &qd, &qdd),
        typed.inverse_dynamics(&q, &qd, &qdd)
    );
    assert_eq!(file.control_terms(&q, &qd), typed.control_terms(&q, &qd));
    assert_eq!(file.jacobian(&q), typed.jacobian(&q));
}

#[test]
fn a_published_table_is_read_as_it_is() {
    let row = from_file::Puma560.table().rows[0];
    assert_eq!(row, typed::Waist.table().rows[0]);
    assert_eq!(from_file::Puma560::JOINT_NAMES[5], "joint6");
}

/// The compiler expands a call again where a file that it includes has changed: the call includes its own.
#[test]
fn a_call_depends_on_its_file() {
    let call = "struct Everything { load: f64 } file: \"../data/files/everything.toml\"";
    let tokens = dynamics_codegen::outline(call.parse().expect("the call lexes"));
    let folder = env!("CARGO_MANIFEST_DIR");
    let include = format!("include_bytes ! (\"{folder}/../data/files/everything.toml\")");
    assert!(tokens.to_string().contains(&include));
}

/// All robots of the project's data, as JSON and as TOML.
#[test]
fn robots_of_files_are_those_of_their_data() {
    for name in NAMES.into_iter().chain([MOUNTED]) {
        let expected = arms::robot(name);
        let json = text(&format!("robots/{name}.json"));
        for (text, format) in [(json, Format::Json), (toml(&expected), Format::Toml)] {
            let found = robot(name, &text, format);
            assert_eq!(found.rows, expected.rows, "{name} {format:?}");
            assert_eq!(found.convention, expected.convention);
            assert_eq!(found.gravity, expected.gravity);
            assert_eq!(found.base, expected.base);
            assert_eq!(found.tool, expected.tool);
        }
    }
}

/// The robot in TOML, all numbers as quotients of whole numbers.
fn toml(robot: &Robot) -> String {
    let convention = match robot.convention {
        Convention::Standard => "standard",
        Convention::Modified => "modified",
    };
    let mut text = format!(
        "convention = '{convention}'\ngravity = {}\n",
        list(&robot.gravity)
    );
    for row in &robot.rows {
        let joint_type = match row.joint_type {
            JointType::Revolute => "revolute",
            JointType::Prismatic => "prismatic",
        };
        writeln!(
            text,
            "[[joint]]\nname = '{}'\ntype = '{joint_type}'",
            row.name
        )
        .unwrap();
        let cells = [
            ("a", &row.a),
            ("alpha", &row.alpha),
            ("d", &row.d),
            ("theta", &row.theta),
            ("mass", &row.mass),
            ("motor.inertia", &row.motor_inertia),
            ("motor.gear_ratio", &row.gear_ratio),
            ("friction.viscous", &row.viscous),
            ("friction.coulomb", &row.coulomb[0]),
        ];
        for (word, value) in cells {
            writeln!(text, "{word} = {}", cell(value)).unwrap();
        }
        body(&mut text, &row.com, &row.inertia);
        writeln!(text, "allow = ['unphysical_inertia']").unwrap();
    }
    if let Some(base) = robot.placement() {
        text.push_str("[base]\n");
        placement(&mut text, base);
    }
    if let Some(tool) = &robot.tool {
        writeln!(text, "[tool]\nmass = {}", cell(&tool.body.mass)).unwrap();
        placement(&mut text, &tool.placement);
        body(&mut text, &tool.body.com, &tool.body.inertia);
    }
    text
}

fn placement(text: &mut String, placement: &Placement) {
    let (xyz, rpy) = (list(&placement.xyz), list(&placement.rpy));
    writeln!(text, "xyz = {xyz}\nrpy = {rpy}").unwrap();
}

fn body(text: &mut String, com: &[Value; 3], inertia: &[Value; 6]) {
    writeln!(text, "com = {}", list(com)).unwrap();
    let entries = ["xx", "yy", "zz", "xy", "yz", "xz"].iter().zip(inertia);
    for (word, value) in entries {
        writeln!(text, "inertia.{word} = {}", cell(value)).unwrap();
    }
}

fn cell(value: &Value) -> String {
    format!("'{}'", value.as_rational().expect("a number"))
}

fn list(values: &[Value; 3]) -> String {
    format!("[{}]", values.each_ref().map(cell).join(", "))
}
