//! Motions on a base that moves.

use std::f64::consts::PI;
use std::path::Path;

use dynamics_runtime::Pose;
use dynamics_runtime::nalgebra::{DVector, Matrix3, Rotation3, Vector3};
use dynamics_symbolic::robot::Robot;

use super::{Motion, not_finite, splines, times};
use crate::csv::{read, shortest};
use crate::failure::Failure;

/// Through the rows of a file, with their velocities and accelerations.
///
/// The position of the base in the world and the joints pass by polynomials of fifth degree; so do, between two rows, the
/// entries of the rotation vector from the first of them.
pub(super) fn through_waypoints(
    path: &Path,
    robot: &Robot,
    samples: usize,
) -> Result<Motion, Failure> {
    let points: Motion = read(path, robot)?;
    let joints = robot.freedoms().joints;
    let of_joints = |list: &[DVector<f64>]| -> Vec<DVector<f64>> {
        list.iter()
            .map(|v| v.rows(6, joints).into_owned())
            .collect()
    };
    let (qd, qdd) = (of_joints(&points.qd), of_joints(&points.qdd));
    let of_joints = splines(&points.t, [&points.q, &qd, &qdd], joints);
    let [positions, slopes, seconds] = in_world(&points);
    let of_position = splines(&points.t, [&positions, &slopes, &seconds], 3);
    let mut motion = Motion::default();
    for t in times(points.t[0], points.t[points.len() - 1], samples) {
        let next = points.t.partition_point(|time| *time <= t);
        let row = next.saturating_sub(1).min(points.len() - 2);
        let [rotation, turn, w] = turned(&points, row, t, path)?;
        let rotation = rotation_of(&points, row, &rotation);
        let of_base: Vec<_> = of_position.iter().map(|spline| spline.at(t)).collect();
        let [position, slope, second] = [0, 1, 2].map(|k| Vector3::from_fn(|i, _| of_base[i][k]));
        let linear = rotation.tr_mul(&slope);
        let rates = rotation.tr_mul(&second) - turn.cross(&linear);
        let states: Vec<_> = of_joints.iter().map(|spline| spline.at(t)).collect();
        let of_joints = |k: usize| states.iter().map(move |state| state[k]);
        let below = |base: [Vector3<f64>; 2], k: usize| -> Vec<f64> {
            let [linear, angular] = base.map(<[f64; 3]>::from);
            [linear, angular]
                .concat()
                .into_iter()
                .chain(of_joints(k))
                .collect()
        };
        let (v, a) = (below([linear, turn], 1), below([rates, w], 2));
        let q: Vec<f64> = of_joints(0).collect();
        let mut numbers = q
            .iter()
            .chain(&v)
            .chain(&a)
            .chain(&rotation)
            .chain(&position);
        if !numbers.all(|x| x.is_finite()) {
            return Err(not_finite(path, t));
        }
        motion.t.push(t);
        motion.base.push(Pose { rotation, position });
        motion.q.push(q.into());
        motion.qd.push(v.into());
        motion.qdd.push(a.into());
    }
    Ok(motion)
}

/// Position, velocity and acceleration of the base in the axes of the world.
fn in_world(points: &Motion) -> [Vec<DVector<f64>>; 3] {
    let vector = |v: &Vector3<f64>| DVector::from_column_slice(v.as_slice());
    let rows = points.base.iter().zip(&points.qd).zip(&points.qdd);
    let mut lists = [Vec::new(), Vec::new(), Vec::new()];
    for ((base, v), a) in rows {
        let (linear, angular) = halves(v);
        let second = halves(a).0 + angular.cross(&linear);
        let world = [
            base.position,
            base.rotation * linear,
            base.rotation * second,
        ];
        for (list, numbers) in lists.iter_mut().zip(&world) {
            list.push(vector(numbers));
        }
    }
    lists
}

/// The linear and the angular numbers of the base.
fn halves(v: &DVector<f64>) -> (Vector3<f64>, Vector3<f64>) {
    (v.fixed_rows::<3>(0).into(), v.fixed_rows::<3>(3).into())
}

/// The rotation of a row, turned by a rotation vector.
fn rotation_of(points: &Motion, row: usize, phi: &Vector3<f64>) -> Matrix3<f64> {
    points.base[row].rotation * Rotation3::new(*phi).into_inner()
}

/// The rotation vector from a row, the angular velocity and its rate at a time before the next row.
fn turned(points: &Motion, row: usize, t: f64, path: &Path) -> Result<[Vector3<f64>; 3], Failure> {
    let ends = [row, row + 1];
    let times = ends.map(|k| points.t[k]);
    let rates = ends.map(|k| [halves(&points.qd[k]).1, halves(&points.qdd[k]).1]);
    let fastest = rates[0][0].norm().max(rates[1][0].norm());
    if fastest * (times[1] - times[0]) > PI {
        let [from, to] = times.map(shortest);
        let message = format!(
            "the base turns by more than half a turn between t = {from} and t = {to}: more rows are needed there"
        );
        return Err(Failure::of_file(path, message));
    }
    let [from, to] = ends.map(|k| Rotation3::from_matrix(&points.base[k].rotation));
    let phi = [Vector3::zeros(), (from.inverse() * to).scaled_axis()];
    let [first, last] = [0, 1].map(|k| in_chart(&phi[k], rates[k]));
    let list = |k: usize| {
        let numbers = [
            &[phi[0], first[0], first[1]][k],
            &[phi[1], last[0], last[1]][k],
        ];
        numbers
            .map(|v| DVector::from_column_slice(v.as_slice()))
            .to_vec()
    };
    let lists = [list(0), list(1), list(2)];
    let entries: Vec<_> = splines(&times, lists.each_ref(), 3)
        .iter()
        .map(|spline| spline.at(t))
        .collect();
    let [phi, slope, second] = [0, 1, 2].map(|k| Vector3::from_fn(|i, _| entries[i][k]));
    let [map, rate] = differential(&phi, &slope);
    Ok([phi, map * slope, map * second + rate * slope])
}

/// The first and second derivatives of a rotation vector, for an angular velocity in the turned axes and its rate.
fn in_chart(phi: &Vector3<f64>, [w, rate]: [Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
    let solve = |map: Matrix3<f64>, v: Vector3<f64>| {
        let unknown = Vector3::repeat(f64::NAN);
        map.lu().solve(&v).unwrap_or(unknown)
    };
    let slope = solve(differential(phi, &Vector3::zeros())[0], w);
    let [map, along] = differential(phi, &slope);
    [slope, solve(map, rate - along * slope)]
}

/// The matrix D of the angular velocity `w = D phi'` of `exp(phi x)` in the turned axes, and its rate: `D = 1 - b phi x + c (phi x)^2`
/// with b = (1 - cos a) / a^2 and c = (a - sin a) / a^3, a the length of phi.
fn differential(phi: &Vector3<f64>, slope: &Vector3<f64>) -> [Matrix3<f64>; 2] {
    let square = phi.norm_squared();
    let rate = 2.0 * phi.dot(slope);
    let ([b, b_rate], [c, c_rate]) = (series(2.0, square), series(3.0, square));
    let (x, y) = (phi.cross_matrix(), slope.cross_matrix());
    [
        Matrix3::identity() - x * b + x * x * c,
        x * x * (c_rate * rate) - x * (b_rate * rate) - y * b + (x * y + y * x) * c,
    ]
}

/// The sum of (-s)^k / (2 k + first)! and its derivative by s. Squares of angles up to two turns need fewer terms.
fn series(first: f64, square: f64) -> [f64; 2] {
    const TERMS: u32 = 40;
    let mut term = 1.0 / (1..=first as u32).map(f64::from).product::<f64>();
    let [mut sum, mut slope] = [term, 0.0];
    let mut next = first;
    for k in 1..TERMS {
        term /= (next + 1.0) * (next + 2.0);
        next += 2.0;
        let power = square.powi(k as i32 - 1);
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        slope += sign * f64::from(k) * term * power;
        sum += sign * term * power * square;
    }
    [sum, slope]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Beside central differences of the rotation, and there and back again.
    #[test]
    fn angular_velocities_are_those_of_rotations() {
        let [slope, second] = [Vector3::new(0.7, -0.4, 1.1), Vector3::new(-0.5, 0.9, 0.3)];
        for angle in [0.0, 1e-6, 0.5, 2.0, 3.0] {
            let phi = Vector3::new(0.6, 0.3, -0.5).normalize() * angle;
            let at = |t: f64| phi + slope * t + second * (0.5 * t * t);
            let w = |t: f64| differential(&at(t), &(slope + second * t))[0] * (slope + second * t);
            let h = 1e-5;
            let [before, after] = [-h, h].map(|t| Rotation3::new(at(t)).into_inner());
            let turn = Rotation3::new(phi).inverse() * ((after - before) / (2.0 * h));
            assert!((turn - w(0.0).cross_matrix()).amax() < 1e-9, "{angle}");
            let [map, rate] = differential(&phi, &slope);
            let acceleration = map * second + rate * slope;
            let difference = (w(h) - w(-h)) / (2.0 * h);
            assert!((acceleration - difference).amax() < 1e-9, "{angle}");
            let [one, two] = in_chart(&phi, [w(0.0), acceleration]);
            assert!((one - slope).amax() < 1e-13 && (two - second).amax() < 1e-12);
        }
    }
}
