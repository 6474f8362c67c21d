robot_dynamics! { struct Frames; file: "tests/mistakes/files/frames.toml" }
robot_dynamics! { struct Frames; file: "tests/mistakes/files/frames.json" }
// Frames of the call add to those of the file.
robot_dynamics! {
    struct Tips;
    file: "tests/mistakes/files/tips.toml",
    frames: { hand: { on: left_elbow }, palm: { on: "left elbow" }, fist: { on: "right elbow" } },
    functions: [jacobian, jacobian(palm), jacobian("left elbow"), forward_kinematics(hand)],
}
robot_dynamics! { struct Tips; file: "tests/mistakes/files/tips.toml", functions: [jacobian] }
