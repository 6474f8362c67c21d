//! Seeded states, and the magnitudes that errors at them are relative to.

use robot_dynamics::nalgebra::{DVector, Dim, Matrix, RawStorage, Rotation3, Vector3};
use robot_dynamics::{
    Pose,
    table::{JointType, RuntimeTable, Stribeck},
};
use testkit::random::Random;

use super::any_robot::AnyRobot;
use super::axes::{Axis, axes};
use super::place::{Place, State};

/// The largest difference of two results, for each joint, relative to their magnitude: the bound of the accuracy tests
/// for both of them, and as much again for the sums of the test itself.
pub(super) const TOLERANCE: f64 = 1.6e-14;

/// Twelve states: joints anywhere, at speeds and accelerations of an arm at work.
pub(super) fn states(robot: &dyn AnyRobot) -> impl Iterator<Item = State> {
    let mut random = Random::seeded(2_026);
    let [joints, freedoms] = [robot.table().rows.len(), robot.freedoms()];
    (0..12).map(move |_| state(&mut random, joints, freedoms))
}

/// A base that moves is turned anywhere, within a metre.
pub(super) fn state(random: &mut Random, joints: usize, freedoms: usize) -> State {
    let mut vector =
        |count, limit: f64| DVector::from_fn(count, |_, _| random.between(-limit, limit));
    let q = vector(joints, std::f64::consts::PI);
    let (qd, qdd) = (vector(freedoms, 3.0), vector(freedoms, 10.0));
    let base = (freedoms > joints).then(|| {
        let [turn, position] = [3.0, 1.0].map(|limit| {
            let x = vector(3, limit);
            Vector3::new(x[0], x[1], x[2])
        });
        Pose {
            rotation: Rotation3::new(turn).into_inner(),
            position,
        }
    });
    let q = Place { base, q };
    State { q, qd, qdd }
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
    pub(super) fn at(robot: &dyn AnyRobot, state: &State) -> Self {
        let table = robot.table();
        let speed = largest(&state.qd);
        let inertia = largest(&robot.mass_matrix(&state.q));
        let reach = reach(&table, &state.q);
        let axes = axes(&table);
        let weight = mass(&table, &axes) * norm(table.gravity);
        let gravity = weight * reach;
        let coriolis = inertia * speed * speed;
        let friction = largest(&robot.friction_vector(&state.qd));
        let stretch = |axis: &Axis| {
            let rest = axis.row.spring.rest.abs() + axis.offset.abs();
            axis.factor.abs() * state.q.q[axis.joint].abs() + rest
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

/// The mass of all bodies that move.
fn mass(table: &RuntimeTable, axes: &[Axis]) -> f64 {
    let body = table.floating.map_or(0.0, |body| body.mass);
    let frames = table.frames.iter();
    let frames = frames.filter(|frame| frame.on.is_some() || table.floating.is_some());
    let frames: f64 = frames.map(|frame| frame.mass).sum();
    let links: f64 = axes.iter().map(|axis| axis.row.mass).sum();
    body + links + table.tool.mass + frames
}

fn reach(table: &RuntimeTable, q: &Place<f64>) -> f64 {
    let link = |axis: Axis| {
        let row = axis.row;
        let travel = match row.joint_type {
            JointType::Revolute => 0.0,
            JointType::Prismatic => axis.position(&q.q).abs(),
        };
        row.a.abs() + row.d.abs() + travel + norm(row.com) + norm(row.mount.position)
    };
    let tool = norm(table.tool.frame.xyz) + norm(table.tool.com);
    let links: f64 = axes(table).into_iter().map(link).sum();
    let frames = table.frames.iter();
    let frames: f64 = frames
        .map(|frame| norm(frame.place.position) + norm(frame.com))
        .sum();
    let body = table.floating.map_or(0.0, |body| norm(body.com));
    let base = q
        .base
        .map_or(norm(table.base.xyz), |base| base.position.norm());
    base + links + tool + frames + body
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
