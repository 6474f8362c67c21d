//! Mistakes in the elements of URDF files.

use super::Mistake;
use crate::words::{number, shortened};

mistakes! {
    no_robot(found: &str => shortened) {what: other_format(&found)}
        "expected `<robot>`, found `<{found}>` ({what})";
    /// An element or a text of xacro, where a link, a joint or a number is read.
    xacro(what: &str => shortened)
        "`{what}` is left of xacro, in a place that is read: {EXPANDED}; if that leaves it there, remove it or write \
         its value";
    attribute_missing(element: &str, name: &str) "`<{element}>` has no `{name}`";
    element_missing(element: &str, name: &str)
        {hint: match name {
            "inertia" => ": write the tensor about the centre of mass, kg m^2; that of a mass at one point is zero, \
                `<inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/>`",
            "mass" => ": write it in kg, `<mass value=\"1.5\"/>`, or take the element away",
            _ => "",
        }}
        "`<{element}>` has no `<{name}>`{hint}";
    three_numbers(name: &str, count: usize) "`{name}` has three numbers, found {count}";
    /// Roll, pitch or yaw of many turns, or of whole radians.
    in_degrees(angle: f64) {degrees: number(angle), right: angle.to_radians()} [allow: allow("odd_angle", "in the call")]
        "`rpy` is in radians, and {degrees} degrees are {right:.4} rad ({allow} accepts {degrees} rad)";
    /// An element or attribute in whose place another one was meant.
    misspelled(element: &str, what: &str, word: &str => shortened, right: &str)
        "unknown {what} `{word}` of `<{element}>`: did you mean `{right}`?";
    axis_of_no_length() "the axis vector is zero";
    round_angles() "expected an angle between 0 and 0.1 rad: `round_angles: 1e-4`, for example";
    /// The second of two elements of which only one is read; `place` is that of the first.
    repeated(element: &str, word: &str, place: (usize, usize)) {line: place.0, column: place.1}
        "a second `<{word}>` in one `<{element}>`, the first is in line {line}, column {column}: remove one of them";
}

/// The format of a file by its root element, and how it becomes one in URDF.
fn other_format(root: &str) -> &'static str {
    match root {
        "mujoco" => {
            "this is a file in MJCF, which is not read: take the robot's file in URDF, or write a table"
        }
        "sdf" => {
            "this is a file in SDF, which is not read: take the file in URDF from which it was made, or write a table"
        }
        "html" => "this is a page of the web about the file: download the file itself",
        _ => EXPANDED,
    }
}

/// How a file in the language that URDF is written by becomes one in URDF.
const EXPANDED: &str = "a file in xacro is expanded first: `xacro arm.urdf.xacro > arm.urdf`, \
                        after `pip install xacro` where there is no ROS";
