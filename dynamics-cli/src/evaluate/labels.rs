//! Names of rows and columns.

use dynamics_runtime::NAMES_OF_BASE;
use dynamics_symbolic::function::Size;
use dynamics_symbolic::robot::{JointType, Robot};

/// The names of what values belong to.
pub(super) struct Labels {
    joints: Vec<String>,
    freedoms: Vec<String>,
}

impl Labels {
    pub(super) fn new(robot: &Robot) -> Labels {
        let joints: Vec<String> = robot.joints().map(|row| row.name.clone()).collect();
        let of_base = NAMES_OF_BASE.iter().take(robot.freedoms().base);
        let of_base = of_base.map(|name| (*name).to_owned());
        Labels {
            freedoms: of_base.chain(joints.iter().cloned()).collect(),
            joints,
        }
    }

    /// The names of all degrees of freedom.
    pub(super) fn freedoms(&self) -> &[String] {
        &self.freedoms
    }

    /// The names of so many rows, columns or values of a list; none where their order is said by the quantity.
    pub(super) fn names(&self, size: Size, count: usize) -> Option<Vec<String>> {
        match size {
            Size::One | Size::Fixed(_) => None,
            Size::Joints => Some(self.joints.clone()),
            Size::Freedoms => Some(self.freedoms.clone()),
            Size::Pairs => {
                let n = self.joints.len();
                let pairs = (1..=n).flat_map(|i| (i + 1..=n).map(move |j| format!("({i},{j})")));
                Some(pairs.collect())
            }
            Size::Parameters => Some((1..=count).map(|k| format!("p{k}")).collect()),
        }
    }
}

/// The units of a position, a velocity, an acceleration and a force of each degree of freedom.
pub(super) fn units(robot: &Robot) -> Vec<[&'static str; 4]> {
    const LINEAR: [&str; 4] = ["m", "m/s", "m/s^2", "N"];
    const ANGULAR: [&str; 4] = ["rad", "rad/s", "rad/s^2", "N m"];
    let of_base = (0..robot.freedoms().base).map(|k| if k < 3 { LINEAR } else { ANGULAR });
    let of_joints = robot.joints().map(|row| match row.joint_type {
        JointType::Revolute => ANGULAR,
        JointType::Prismatic => LINEAR,
    });
    of_base.chain(of_joints).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_in_their_order() {
        let labels = Labels {
            joints: ["a", "b", "c"].map(str::to_owned).to_vec(),
            freedoms: Vec::new(),
        };
        let pairs = labels.names(Size::Pairs, 3).expect("names");
        assert_eq!(pairs, ["(1,2)", "(1,3)", "(2,3)"]);
    }
}
