robot_dynamics! {
    struct Joined;
    file: "tests/mistakes/files/locked.toml",
    lock: [wrist = 0.1, elbow = 0.3],
    couple: [thumb = finger],
    allow: [odd_mass],
}
robot_dynamics! {
    struct Elsewhere;
    file: "tests/mistakes/files/locked.toml",
    lock: [wrist = 0.1, elbow = 0.5],
    couple: [jaw = finger],
}
robot_dynamics! {
    struct Before { angle: f64 }
    lock: [elbow = angle],
    file: "tests/mistakes/files/locked.toml",
    allow: [odd_mass],
}
