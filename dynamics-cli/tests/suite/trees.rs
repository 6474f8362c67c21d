//! Robots with branches and frames.

use super::calls::{file, output};

/// Two arms on a waist and a lift beside it, with a body in one hand.
pub(crate) const TORSO: &str = r#"
convention = "modified"
gravity = [0, 0, -9.81]
[frame.left_hand]
on = "left_elbow"
xyz = [0.3, 0, 0]
mass = 1.5
com = [0, 0, 0.05]
inertia = { xx = 0.04, yy = 0.04, zz = 0.04 }
[frame."the camera"]
on = "waist"
xyz = [0.1, 0, 0.5]
rpy = [0, 0.3, 0]
[frame.corner]
on = "base"
xyz = [2, 0, 0]
[[joint]]
name = "waist"
type = "revolute"
mass = 9
com = [0, 0, 0.2]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1 }
[[joint]]
name = "left_shoulder"
type = "revolute"
on = "waist"
gamma = "PI/2"
b = 0.4
a = 0.2
alpha = "PI/2"
mass = 2
[[joint]]
name = "left_elbow"
type = "revolute"
a = 0.3
mass = 1
com = [0.1, 0, 0]
[[joint]]
name = "right_shoulder"
type = "revolute"
on = "waist"
gamma = "-PI/2"
b = 0.4
a = 0.2
alpha = "PI/2"
mass = 2
com = [0.1, 0, 0]
[[joint]]
name = "right_elbow"
type = "revolute"
a = 0.3
mass = 1
com = [0.1, 0.02, 0]
[[joint]]
name = "lift"
type = "prismatic"
on = "base"
at = { xyz = [1, 0, 0], rpy = [0, 0, "PI/2"] }
mass = 3
"#;

#[test]
fn show_names_carriers_and_frames() {
    let torso = file("shown_torso.toml", TORSO);
    let text = output(&["show", &torso, "--functions", "mass_matrix"]);
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
    let formulas = output(&["show", &torso, "--functions", asked, "--format", "text"]);
    assert!(formulas.contains("jacobian_left_hand\n"), "{formulas}");
}
