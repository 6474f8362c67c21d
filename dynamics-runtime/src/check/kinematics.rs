//! Differences of poses and Jacobians: directions are of size 1.

use nalgebra::{Matrix4, SMatrix, Vector6};

use super::deviation::{Entry, Measured};
use crate::{JointType, Table};

/// Entries of a transform's difference: those of the rotation are of size 1.
pub(super) fn pose_entries<T: Measured>(
    joint: Option<usize>,
    difference: Matrix4<T>,
    position: f64,
) -> impl Iterator<Item = Entry> {
    (0..4).flat_map(move |row| {
        (0..4).map(move |column| {
            let is_position = row < 3 && column == 3;
            let scale = if is_position { position } else { 1.0 };
            Entry::new(joint, difference[(row, column)], scale)
        })
    })
}

/// Entries of a Jacobian's difference: axes are of size 1, velocities of revolute joints as large
/// as the distance from their axis.
pub(super) fn jacobian_entries<T: Measured, const N: usize>(
    table: &Table<N>,
    difference: &SMatrix<T, 6, N>,
    position: f64,
) -> impl Iterator<Item = Entry> {
    (0..N).flat_map(move |joint| {
        let revolute = table.rows[joint].joint_type == JointType::Revolute;
        (0..6).map(move |row| {
            let scale = if row < 3 && revolute { position } else { 1.0 };
            Entry::new(Some(joint), difference[(row, joint)], scale)
        })
    })
}

/// Entries of a matrix of which no row or column belongs to a joint.
pub(super) fn in_space<T: Measured, const R: usize, const C: usize>(
    difference: SMatrix<T, R, C>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    let places = (0..R).flat_map(|row| (0..C).map(move |column| (row, column)));
    places.map(move |place| Entry::new(None, difference[place], scale))
}

/// Entries of a motion of the tip for joints that move by so much: its linear part is as large as the
/// distance from the base besides, and as what a prismatic joint moves itself.
pub(super) fn tip_entries<T: Measured>(
    difference: Vector6<T>,
    size: f64,
    position: f64,
) -> impl Iterator<Item = Entry> {
    let linear = size * position.max(1.0);
    (0..6).map(move |row| {
        let scale = if row < 3 { linear } else { size };
        Entry::new(None, difference[row], scale)
    })
}
