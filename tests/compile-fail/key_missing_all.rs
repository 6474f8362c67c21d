use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
}

fn main() {}
