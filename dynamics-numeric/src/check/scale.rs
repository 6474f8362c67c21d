//! The natural magnitude of each quantity at a state: what its error is relative to.

use dynamics_runtime::internal::{DryFriction, Moving};
use dynamics_runtime::table::Arm;
use dynamics_runtime::{JointType, Pose, Row, SizedState, Spring};
use nalgebra::{DMatrix, DVector, Dyn};

/// Magnitudes that a quantity could have at a state of this size, whatever it cancels to there.
///
/// An error relative to the value itself means nothing where the value is the small difference of
/// large terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    /// max|M|: of the coefficients of V too, which are V at velocities of 1.
    pub(super) mass_matrix: f64,
    /// max|M| max|qd|^2, for V and for the kinetic energy.
    pub(super) coriolis_vector: f64,
    /// max|M| max|qd|.
    pub(super) coriolis_matrix: f64,
    /// Weight times lever arm.
    pub(super) gravity_vector: f64,
    /// max of |viscous qd| and the greatest dry friction.
    pub(super) friction_vector: f64,
    /// max of stiffness (|q| + |rest|).
    pub(super) spring_vector: f64,
    /// max|M| max|qdd| and the scales of V, G, K and F.
    pub(super) inverse_dynamics: f64,
    /// The scales of V, G, K and F.
    pub(super) bias_force: f64,
    /// max|M| max|qdd_r|, max|M| max|qd| max|qd_r|, and the scales of G, K and F.
    pub(super) passivity_torque: f64,
    /// The largest slope and curvature of friction, and the largest stiffness.
    slope_of_friction: f64,
    curvature_of_friction: f64,
    stiffness: f64,
    /// The scales of M qdd, V and G, whose derivatives by an angle are as large, and the largest
    /// stiffness.
    pub(super) force_by_position: f64,
    /// Twice the scale of C, and the largest slope of friction.
    pub(super) force_by_velocity: f64,
    /// Weight times distance, and the energy in all springs.
    pub(super) potential_energy: f64,
    /// Distance from the origin of the world, m.
    pub(super) position: f64,
    /// The mass of all links.
    mass: f64,
    /// The largest factor by which a joint is faster than the one that it follows; 1 where none is.
    pub(super) fastest: f64,
}

impl Scale {
    pub(super) fn new(
        table: Arm<'_>,
        mass_matrix: &DMatrix<f64>,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
    ) -> Self {
        let first = state.qd.len() - state.q.len();
        let mass = mass_matrix.amax();
        let speed = state.qd.amax();
        let weight = table.total_mass() * norm(&table.gravity);
        // The largest of these sizes of the joints.
        let largest = |size: &dyn Fn(&Moving<'_>) -> f64| {
            let sizes = table.chain().map(|moving| size(&moving));
            sizes.fold(0.0, f64::max)
        };
        let reach = reach(table, &state.q);
        let position = norm(&table.base.xyz) + base.position.norm() + reach;
        let is_prismatic = |row: &Row| row.joint_type == JointType::Prismatic;
        // It turns a weight into the force or torque of a joint: at a prismatic joint and at a base that moves by a factor of 1.
        let lever_arm = if first > 0 || table.chain().any(|moving| is_prismatic(moving.row)) {
            reach.max(1.0)
        } else {
            reach
        };
        let coriolis_vector = mass * speed * speed;
        let gravity_vector = weight * lever_arm;
        let friction_vector = largest(&|Moving {
                                            row, joint, factor, ..
                                        }| {
            let viscous = row.viscous * factor * state.qd[first + *joint];
            factor.abs() * (viscous.abs() + DryFriction::of(row).greatest())
        });
        let slope_of_friction = largest(&|Moving { row, factor, .. }| {
            factor * factor * (row.viscous.abs() + DryFriction::of(row).greatest_slope())
        });
        let springs = Springs::new(table, &state.q);
        let bias_force = coriolis_vector + gravity_vector + springs.force + friction_vector;
        Scale {
            mass_matrix: mass,
            coriolis_vector,
            coriolis_matrix: mass * speed,
            gravity_vector,
            friction_vector,
            spring_vector: springs.force,
            inverse_dynamics: mass * state.qdd.amax() + bias_force,
            bias_force,
            passivity_torque: mass * state.reference_acceleration().amax()
                + mass * speed * state.reference_velocity().amax()
                + gravity_vector
                + springs.force
                + friction_vector,
            slope_of_friction,
            curvature_of_friction: largest(&|Moving { row, factor, .. }| {
                factor.abs().powi(3) * DryFriction::of(row).greatest_curvature()
            }),
            stiffness: springs.stiffness,
            force_by_position: mass * state.qdd.amax()
                + coriolis_vector
                + gravity_vector
                + springs.stiffness,
            force_by_velocity: 2.0 * mass * speed + slope_of_friction,
            potential_energy: weight * position + springs.energy,
            position,
            mass: table.total_mass(),
            fastest: largest(&|moving| moving.factor.abs()).max(1.0),
        }
    }

    /// The scales of d2 tau/dq dq (without springs and friction), d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq.
    pub(super) fn second_derivatives(&self) -> [f64; 4] {
        [
            self.force_by_position - self.stiffness,
            2.0 * self.mass_matrix + self.curvature_of_friction,
            2.0 * self.coriolis_matrix,
            self.mass_matrix,
        ]
    }

    /// The scales of a linear and of an angular momentum in which the joints' rates have this magnitude, or of what changes
    /// them: mass times lever, and the same times the lever beside max|M|.
    pub(super) fn momentum(&self, rate: f64) -> [f64; 2] {
        let lever = self.position.max(1.0);
        let linear = self.mass * lever;
        [linear, linear * lever + self.mass_matrix].map(|size| size * rate)
    }

    /// The scales of the first and the second derivative of tau along a motion: its terms with all products of the joints'
    /// rates that have the same dimension.
    pub(super) fn rates(&self, state: &SizedState<Dyn>) -> [f64; 2] {
        // The rates of all joints, followers included. M holds how they act on the joints that lead.
        let [v, a] = [&state.qd, &state.qdd].map(|rates| self.fastest * rates.amax());
        let [jerk, snap] = [state.jerk(), state.snap()].map(|rates| self.fastest * rates.amax());
        let mass = self.mass_matrix / self.fastest;
        let inertial = [
            jerk + a * v + v * v * v,
            snap + jerk * v + a * a + a * v * v + v * v * v * v,
        ];
        let weight = [self.gravity_vector * v, self.gravity_vector * (a + v * v)];
        let joint = [
            self.slope_of_friction * a + self.stiffness * v,
            self.slope_of_friction * jerk + self.curvature_of_friction * a * a + self.stiffness * a,
        ];
        [0, 1].map(|k| mass * inertial[k] + weight[k] + joint[k])
    }
}

/// Magnitudes of the springs at a state: the largest stiffness, the largest force and the whole energy
/// that there could be where nothing of q - rest cancels.
struct Springs {
    stiffness: f64,
    force: f64,
    energy: f64,
}

impl Springs {
    fn new(table: Arm<'_>, q: &DVector<f64>) -> Self {
        let none = Springs {
            stiffness: 0.0,
            force: 0.0,
            energy: 0.0,
        };
        table.chain().fold(none, |sum, moving| {
            let Spring { stiffness, rest } = moving.row.spring;
            let (stiffness, factor) = (stiffness.abs(), moving.factor.abs());
            let stretch = factor * q[moving.joint].abs() + moving.offset.abs() + rest.abs();
            Springs {
                stiffness: sum.stiffness.max(factor * factor * stiffness),
                force: sum.force.max(factor * stiffness * stretch),
                energy: sum.energy + 0.5 * stiffness * stretch * stretch,
            }
        })
    }
}

/// A bound of every frame's and every centre of mass's distance from the base.
fn reach(table: Arm<'_>, q: &DVector<f64>) -> f64 {
    // Bounds of each link frame's distance, by the frames that carry it.
    let mut origins: Vec<f64> = Vec::new();
    let mut centre = 0.0_f64;
    for (k, moving) in table.chain().enumerate() {
        let row = moving.row;
        let d = match row.joint_type {
            JointType::Revolute => row.d,
            JointType::Prismatic => row.d + moving.factor * q[moving.joint] + moving.offset,
        };
        let carrier = row.on.of(k).map_or(0.0, |carrier| origins[carrier]);
        let tip = row.tip.map_or(0.0, |tip| norm(&tip.position));
        let places = norm(&row.mount.position) + tip;
        origins.push(carrier + row.a.abs() + d.abs() + places);
        centre = centre.max(norm(&row.com));
    }
    let tool = norm(&table.tool.frame.xyz) + norm(&table.tool.com);
    let frames = table.frames.iter();
    let fixed = frames.map(|frame| norm(&frame.place.position) + norm(&frame.com));
    let of_base = table.floating.map_or(0.0, |base| norm(&base.com));
    origins.into_iter().fold(0.0, f64::max) + centre + fixed.fold(tool, f64::max) + of_base
}

fn norm(vector: &[f64; 3]) -> f64 {
    nalgebra::Vector3::from(*vector).norm()
}

#[cfg(test)]
mod tests {
    use dynamics_runtime::table::AsArm as _;
    use dynamics_runtime::{Convention, JointType, Pose, Row, SizedState, Spring, Table};
    use nalgebra::{DMatrix, DVector};

    use super::Scale;

    #[test]
    fn scales_of_a_small_arm() {
        let slide = Row {
            d: 1.0,
            mass: 2.0,
            com: [0.0, 0.0, -0.5],
            viscous: 3.0,
            spring: Spring {
                stiffness: 7.0,
                rest: -1.0,
            },
            ..Row::new(JointType::Prismatic)
        };
        let turn = Row {
            a: -0.25,
            coulomb: [1.0; 2],
            ..Row::new(JointType::Revolute)
        };
        let table = Table::new(Convention::Standard, [0.0, 0.0, -10.0], [slide, turn]);
        let state = SizedState {
            q: DVector::from_vec(vec![-3.0, 100.0]),
            qd: DVector::from_vec(vec![-2.0, 1.0]),
            qdd: DVector::from_vec(vec![0.0, 5.0]),
        };
        let scale = Scale::new(
            table.arm(),
            &DMatrix::from_row_slice(2, 2, &[4.0, 0.0, 0.0, 1.0]),
            &Pose::identity(),
            &state,
        );

        assert_eq!(scale.position, 2.0 + 0.25 + 0.5);
        assert_eq!(scale.coriolis_vector, 16.0);
        assert_eq!(scale.coriolis_matrix, 8.0);
        assert_eq!(scale.gravity_vector, 20.0 * 2.75);
        assert_eq!(scale.friction_vector, 6.0);
        assert_eq!(scale.spring_vector, 28.0);
        assert_eq!(scale.inverse_dynamics, 20.0 + 16.0 + 55.0 + 28.0 + 6.0);
        assert_eq!(scale.force_by_position, 20.0 + 16.0 + 55.0 + 7.0);
        assert_eq!(scale.potential_energy, 20.0 * 2.75 + 56.0);
        assert_eq!(scale.force_by_velocity, 16.0 + 3.0);
    }
}
