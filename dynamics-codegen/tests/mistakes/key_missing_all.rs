robot_dynamics! {
    pub struct Arm;
}
