//! Seeded states, and the magnitudes that errors at them are relative to.

use num_dual::Dual64;
use robot_dynamics::nalgebra::{Dim, Matrix, RawStorage, SVector};
use robot_dynamics::{
    State,
    table::{JointType, Stribeck, Table},
};
use testkit::random::Random;

use super::any_arm::AnyArm;
use super::axes::{Axis, axes};

/// The largest difference of two results, for each joint, relative to their magnitude: the bound of the accuracy tests
/// for both of them, and as much again for the sums of the test itself.
pub(super) const TOLERANCE: f64 = 1.6e-14;

/// Twelve states: joints anywhere, at speeds and accelerations of an arm at work.
pub(super) fn states<const N: usize>() -> impl Iterator<Item = State<N>> {
    let mut random = Random::seeded(2_026);
    (0..12).map(move |_| State {
        q: random.vector(std::f64::consts::PI),
        qd: random.vector(3.0),
        qdd: random.vector(10.0),
    })
}

/// The point `x`, moving at `direction`: what is evaluated there carries its derivative that way.
pub(super) fn along<const N: usize>(
    x: &SVector<f64, N>,
    direction: &SVector<f64, N>,
) -> SVector<Dual64, N> {
    x.zip_map(direction, Dual64::new)
}

/// The natural magnitudes of an arm's quantities at one state.
pub(super) struct Magnitude {
    /// max |M|
    pub(super) inertia: f64,
    /// max |M| max |qd|
    pub(super) coriolis_matrix: f64,
    /// max |M| max |qd|^2
    pub(super) coriolis: f64,
    /// sum m |g| reach
    pub(super) gravity: f64,
    /// max stiffness (|q| + |rest|)
    pub(super) spring: f64,
    /// The energy of all springs, were nothing of q - rest to cancel.
    pub(super) energy_of_springs: f64,
    /// max |M| max |qdd|, with those of the Coriolis terms, gravity, springs and friction.
    pub(super) torque: f64,
    /// The magnitude of tau without friction and springs, for its derivative by an angle, and the largest stiffness. A
    /// weight's lever arm changes by 1 with a displacement.
    pub(super) force_by_position: f64,
    /// 2 max |M| max |qd|, and the largest slope of friction.
    pub(super) force_by_velocity: f64,
    /// Distance of the last frame and the centres of mass from the base, m.
    pub(super) reach: f64,
}

impl Magnitude {
    pub(super) fn at<const N: usize, const P: usize>(
        robot: &dyn AnyArm<N, P>,
        state: &State<N>,
    ) -> Self {
        let table = robot.table();
        let speed = largest(&state.qd);
        let inertia = largest(&robot.mass_matrix(&state.q));
        let reach = reach(&table, &state.q);
        let weight = table.total_mass() * norm(table.gravity);
        let gravity = weight * reach;
        let coriolis = inertia * speed * speed;
        let friction = largest(&robot.friction_vector(&state.qd));
        let axes = axes(&table);
        let stretch = |axis: &Axis| {
            let rest = axis.row.spring.rest.abs() + axis.offset.abs();
            axis.speed(&state.q).abs() + rest
        };
        let spring = |axis: &Axis| axis.factor.abs() * axis.row.spring.stiffness * stretch(axis);
        let spring = axes.iter().map(spring).fold(0.0, f64::max);
        let energy = |axis: &Axis| 0.5 * axis.row.spring.stiffness * stretch(axis).powi(2);
        let energies = axes.iter().map(energy);
        let square = |axis: &Axis| axis.factor * axis.factor;
        let stiffness = axes.iter();
        let stiffness = stiffness.map(|axis| square(axis) * axis.row.spring.stiffness);
        // exp(-x^2) has a slope below 1.
        let slope = |axis: &Axis| {
            let falls = |stribeck: Stribeck| stribeck.friction / stribeck.velocity;
            square(axis) * (axis.row.viscous + axis.row.stribeck.map_or(0.0, falls))
        };
        let slopes = axes.iter().map(slope);
        let inertial = inertia * largest(&state.qdd) + coriolis;
        Magnitude {
            inertia,
            coriolis_matrix: inertia * speed,
            coriolis,
            gravity,
            spring,
            energy_of_springs: energies.sum(),
            torque: inertial + gravity + spring + friction,
            force_by_position: inertial + weight * reach.max(1.0) + stiffness.fold(0.0, f64::max),
            force_by_velocity: 2.0 * inertia * speed + slopes.fold(0.0, f64::max),
            reach,
        }
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn reach<const N: usize>(table: &Table<N>, q: &SVector<f64, N>) -> f64 {
    let link = |axis: Axis| {
        let row = axis.row;
        let travel = match row.joint_type {
            JointType::Revolute => 0.0,
            JointType::Prismatic => axis.position(q).abs(),
        };
        row.a.abs() + row.d.abs() + travel + norm(row.com)
    };
    let tool = norm(table.tool.frame.xyz) + norm(table.tool.com);
    let links: f64 = axes(table).into_iter().map(link).sum();
    norm(table.base.xyz) + links + tool
}

/// The largest absolute value.
pub(super) fn largest<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(
    matrix: &Matrix<f64, R, C, S>,
) -> f64 {
    matrix.iter().map(|x| x.abs()).fold(0.0, f64::max)
}

/// Asserts that `difference` is within [`TOLERANCE`] of `magnitude` for each of `joints`.
#[track_caller]
pub(super) fn assert_small<R: Dim, C: Dim, S: RawStorage<f64, R, C>>(
    difference: &Matrix<f64, R, C, S>,
    magnitude: f64,
    joints: usize,
) {
    let bound = TOLERANCE * joints as f64 * magnitude;
    for (i, x) in difference.iter().enumerate() {
        assert!(x.abs() <= bound, "entry {i} is {x:e}, beyond {bound:e}");
    }
}
