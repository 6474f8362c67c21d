//! The columns of a table: their names and units.

/// The columns of a joint: the symbol, and the unit of a revolute and of a prismatic one.
pub(super) const QUANTITIES: [(&str, [&str; 2]); 4] = [
    ("q", ["rad", "m"]),
    ("qd", ["rad/s", "m/s"]),
    ("qdd", ["rad/s^2", "m/s^2"]),
    ("tau", ["N m", "N"]),
];

/// The columns of the base before those of the joints: the place, then velocities, accelerations and forces.
pub(super) const BASE_COLUMNS: [&[&str]; 4] = [
    &[
        "base.r11",
        "base.r12",
        "base.r13",
        "base.r21",
        "base.r22",
        "base.r23",
        "base.r31",
        "base.r32",
        "base.r33",
        "base.x [m]",
        "base.y [m]",
        "base.z [m]",
    ],
    &[
        "base.vx [m/s]",
        "base.vy [m/s]",
        "base.vz [m/s]",
        "base.wx [rad/s]",
        "base.wy [rad/s]",
        "base.wz [rad/s]",
    ],
    &[
        "base.vxd [m/s^2]",
        "base.vyd [m/s^2]",
        "base.vzd [m/s^2]",
        "base.wxd [rad/s^2]",
        "base.wyd [rad/s^2]",
        "base.wzd [rad/s^2]",
    ],
    &[
        "base.fx [N]",
        "base.fy [N]",
        "base.fz [N]",
        "base.nx [N m]",
        "base.ny [N m]",
        "base.nz [N m]",
    ],
];

/// The columns of the base before those of the joints: none of a base that stands.
pub(super) fn of_base(moves: bool, quantity: usize) -> &'static [&'static str] {
    let columns = BASE_COLUMNS.get(quantity).filter(|_| moves);
    columns.copied().unwrap_or_default()
}
