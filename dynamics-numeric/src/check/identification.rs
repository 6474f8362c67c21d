//! From the inertial parameters of links to the base parameters, the combinations that a motion shows.

use dynamics_runtime::internal::SplitMix64;
use dynamics_runtime::{Pose, RuntimeTable, SizedState};
use nalgebra::{Const, DMatrix, DVector, Dyn, OMatrix};

use super::{Checkable, Checked};
use crate::NumericArm;

/// The matrix K of `b = K x`: the base parameters b of `base_parameters` and `regressor` as combinations of the
/// links' standard parameters x.
///
/// K is P x 11 (N + F) for P base parameters, N joints, and F joints that follow others. x holds, in this order,
///
/// - the ten [standard parameters](dynamics_runtime::Table::standard_parameters) of each joint's link, from the base outwards;
/// - [those of the followers' links](dynamics_runtime::Table::standard_parameters_of_followers);
/// - the reflected inertia `gear_ratio^2 inertia` of each joint's motor, and of each follower's.
///
/// Where the base moves, the ten [standard parameters of the base](dynamics_runtime::Table::standard_parameters_of_base) come before all
/// of these, and K has ten more columns.
///
/// K depends on the geometry alone. Torques cannot tell two sets of links with the same K x apart.
///
/// K is the least-squares solution of Y_b K = Y_x over random states, where Y_b is the generated regressor and Y_x the
/// numeric one of the table. The error of an entry is about 1e-13 of the largest one; entries below 1e-11 of it are
/// zero.
///
/// `None` where `regressor` was not generated, and where its columns are dependent, so that more than one K fits, as
/// for fields that make the arm a special one: a factor of zero by which a joint follows another.
///
/// ```
/// use robot_dynamics::{robot_dynamics, check::base_parameter_map};
///
/// robot_dynamics! {
///     /// A rod: its torque shows the moment m c_x and the inertia J_zz with that of the motor.
///     struct Rod;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [
///         pivot: revolute {
///             mass: 3, com: [1, 0, 0], inertia: rod(2), motor: { inertia: 1e-4, gear_ratio: 50 },
///         },
///     ],
///     functions: [regressor, base_parameters],
/// }
///
/// let map = base_parameter_map(&Rod).unwrap();
/// let table = Rod.table();
/// let mut x = table.standard_parameters()[0].as_slice().to_vec();
/// x.push(table.rows[0].reflected_inertia());
/// let b = map * robot_dynamics::nalgebra::DVector::from(x);
/// assert!((b - Rod.base_parameters::<f64>()).amax() < 1e-12);
/// ```
pub fn base_parameter_map<R: Checkable<K>, K>(robot: &R) -> Option<DMatrix<f64>> {
    base_parameter_map_any(&*robot.checked())
}

/// [`base_parameter_map`] of a robot whose number of joints is known at run time alone.
pub fn base_parameter_map_any(robot: &dyn Checked) -> Option<DMatrix<f64>> {
    let table = robot.runtime_table();
    let numeric = NumericArm::on_any_base(&table);
    let mut random = SplitMix64(1);
    let of_base = if table.floating.is_some() { 6 } else { 0 };
    let freedoms = of_base + table.rows.len();
    let links = of_base / 6 + table.rows.len() + table.followers().count();
    let state = |random: &mut SplitMix64| {
        let mut vector =
            |count: usize| DVector::from_fn(count, |_, _| random.within(&(-2.0..=2.0)));
        SizedState {
            q: vector(table.rows.len()),
            qd: vector(freedoms),
            qdd: vector(freedoms),
        }
    };
    let rest = DVector::zeros(freedoms);
    let regressor = |state: &SizedState<Dyn>| -> Option<Vec<f64>> {
        robot
            .values(&Pose::identity(), state, &rest)
            .get("regressor")
    };
    let first = state(&mut random);
    let count = regressor(&first)?.len() / freedoms.max(1);
    // Four times as many equations as the least.
    let states = 4 * count.div_ceil(freedoms.max(1)) + 4;
    let mut base = DMatrix::zeros(states * freedoms, count);
    let mut standard = DMatrix::zeros(states * freedoms, 11 * links);
    for k in 0..states {
        let state = state(&mut random);
        let rows = k * freedoms;
        let columns = DMatrix::from_vec(freedoms, count, regressor(&state)?);
        base.rows_mut(rows, freedoms).copy_from(&columns);
        for (link, block) in standard_regressors(&numeric, &state).iter().enumerate() {
            standard
                .view_mut((rows, 10 * link), (freedoms, 10))
                .copy_from(block);
        }
        for (motor, (joint, factor)) in motors(&table).enumerate() {
            standard[(rows + of_base + joint, 10 * links + motor)] =
                factor * factor * state.qdd[of_base + joint];
        }
    }
    let factors = base.qr();
    let right = factors.q().tr_mul(&standard);
    let triangle = factors.r();
    let pivots = triangle.diagonal().abs();
    if pivots.min() < 1e-9 * pivots.max() {
        return None;
    }
    let mut map = triangle.solve_upper_triangular(&right)?;
    let least = 1e-11 * map.amax();
    map.apply(|entry| {
        if entry.abs() < least {
            *entry = 0.0;
        }
    });
    Some(map)
}

/// The standard regressor at a base that is not turned, a block of ten columns for each body: that of a base that moves, those
/// of the joints' links and of the followers'.
fn standard_regressors(
    numeric: &NumericArm<Dyn>,
    SizedState { q, qd, qdd }: &SizedState<Dyn>,
) -> Vec<OMatrix<f64, Dyn, Const<10>>> {
    let footing = numeric.footing(&Pose::identity());
    let there = numeric.placed(&footing);
    let of_base = (qd.len() > q.len()).then(|| there.standard_regressor_of_base(qd, qdd));
    let own = there.standard_regressor(q, qd, qdd);
    let of_followers = there.standard_regressor_of_followers(q, qd, qdd);
    of_base.into_iter().chain(own).chain(of_followers).collect()
}

/// The joint that feels the motor of each joint, then of each follower, and the factor.
fn motors(table: &RuntimeTable) -> impl Iterator<Item = (usize, f64)> {
    let rows = table.followers();
    let followers = rows.map(|follower| (follower.leader, follower.factor));
    (0..table.rows.len())
        .map(|joint| (joint, 1.0))
        .chain(followers)
}
