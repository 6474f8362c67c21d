//! The tables of `robots` are those of `tests/data/robots`, cell by cell.

use robot_dynamics::table::{Convention, Frame, JointType, Row, Tool};
use robots::*;
use testkit::references::{JointRow, PlacementFile, RobotFile, ToolFile, read};

/// The row that the file describes. A motor without inertia needs no gear.
fn expected(joint: JointRow) -> Row {
    let geared = joint.motor_inertia != 0.0;
    Row {
        joint_type: match joint.joint_type.as_str() {
            "revolute" => JointType::Revolute,
            "prismatic" => JointType::Prismatic,
            other => panic!("{other} is no joint"),
        },
        a: joint.a,
        alpha: joint.alpha,
        d: joint.d,
        theta: joint.theta,
        mass: joint.mass,
        com: joint.com,
        inertia: joint.inertia,
        motor_inertia: joint.motor_inertia,
        gear_ratio: if geared { joint.gear_ratio } else { 0.0 },
        viscous: joint.viscous,
        coulomb: [joint.coulomb; 2],
        ..Row::new(JointType::Revolute)
    }
}

fn frame(PlacementFile { xyz, rpy }: PlacementFile) -> Frame {
    Frame { xyz, rpy }
}

fn tool(tool: ToolFile) -> Tool {
    Tool {
        frame: frame(tool.placement),
        mass: tool.mass,
        com: tool.com,
        inertia: tool.inertia,
    }
}

fn convention(name: &str) -> Convention {
    match name {
        "standard" => Convention::Standard,
        "modified" => Convention::Modified,
        other => panic!("{other} is no convention"),
    }
}

fn is_that_of_its_file<const N: usize, const P: usize, R: Arm<N, P>>(robot: &R) {
    let file: RobotFile = read("robots", R::FILE);
    let table = robot.table();
    assert_eq!(table.convention, convention(&file.convention));
    assert_eq!(table.gravity, file.gravity);
    assert_eq!(table.base, file.base.map_or(Frame::IDENTITY, frame));
    assert_eq!(table.tool, file.tool.map_or(Tool::NONE, tool));
    assert_eq!(file.joints.len(), N);
    for (joint, (row, name)) in file
        .joints
        .into_iter()
        .zip(table.rows.into_iter().zip(R::JOINT_NAMES))
    {
        assert_eq!(row, expected(joint), "joint {name}");
    }
}

macro_rules! tests {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {$(
        #[test]
        fn $file() {
            assert_eq!($robot::DOF, $n);
            is_that_of_its_file(&$robot);
        }
    )*};
}
for_each_robot!(tests);
tests! { tilting_cell: TiltingCell, 4, 6; }

macro_rules! names {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => { vec![$(stringify!($file)),*] };
}

#[test]
#[cfg_attr(
    not(feature = "long_arms"),
    ignore = "arms of ten and twelve joints are compiled with `--all-features`: .ci/run does"
)]
fn every_robot_that_has_a_file_is_compiled() {
    let mut names = for_each_robot!(names);
    names.sort();
    assert_eq!(names, arms::NAMES);
}
