//! Joints that follow others.
//!
//! With positions q = S q_j + c of all joints, q_j those that move by themselves, the dynamics are those of
//! the whole arm by virtual work: M_j = S' M S, tau_j = S' tau, J_j = J S.

use nalgebra::{Matrix4, SMatrix, SVector, Vector3};

use super::NewtonEuler;
use super::angle::SinCos;
use super::link::Link;
use super::lock::without_locked;
use super::sum::Sum;
use crate::table::MOST_FOLLOWERS;
use crate::{
    Convention, Follower, Followers, JointMotion, JointType, Row, SecondDerivatives, Table,
};

impl<const N: usize> Table<N> {
    /// The table of an arm some of whose joints follow others; joints may be locked too, as in
    /// [`Table::lock`]. `motions` says for each of the L rows how its joint moves. N joints must move by
    /// themselves, at most 8 may follow one of those, and both together may be at most 32: otherwise this panics.
    pub fn couple<const L: usize>(
        convention: Convention,
        gravity: [f64; 3],
        rows: [Row; L],
        motions: [JointMotion; L],
    ) -> Self {
        Self::couple_rows(convention, gravity, &rows, &motions)
    }

    /// [`Table::couple`] with a slice of rows.
    #[doc(hidden)]
    pub fn couple_rows(
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        motions: &[JointMotion],
    ) -> Self {
        let positions = motions.iter().map(|motion| match motion {
            JointMotion::Locked(position) => Some(*position),
            _ => None,
        });
        let mut whole = [Row::new(JointType::Revolute); MOST_ROWS];
        let count = without_locked(convention, rows, positions, &mut whole);
        let rows = whole;
        let is_free = |motion: &JointMotion| *motion == JointMotion::Free;
        let joint_of = |row: usize| motions[..row].iter().filter(|m| is_free(m)).count();
        let moving = motions
            .iter()
            .filter(|motion| !matches!(motion, JointMotion::Locked(_)));
        let mut joints = [Row::new(JointType::Revolute); N];
        let mut followers = Followers::NONE;
        let mut free = 0;
        for (row, motion) in rows[..count].iter().zip(moving) {
            match *motion {
                JointMotion::Follows {
                    leader,
                    factor,
                    offset,
                } => {
                    let is_placed = followers.push(Follower {
                        row: *row,
                        place: free,
                        leader: joint_of(leader),
                        factor,
                        offset,
                    });
                    assert!(is_placed, "at most {MOST_FOLLOWERS} joints follow others");
                }
                _ => {
                    joints[free] = *row;
                    free += 1;
                }
            }
        }
        assert_eq!(free, N, "so many joints move by themselves");
        Table {
            followers,
            ..Table::new(convention, gravity, joints)
        }
    }
}

impl<const N: usize> Table<N> {
    /// The whole arm, each row a joint of its own, and how many rows it has. Rows beyond [`MOST_ROWS`] are
    /// none of it.
    fn uncoupled(&self) -> (Table<MOST_ROWS>, usize) {
        let mut rows = [Row::new(JointType::Prismatic); MOST_ROWS];
        let mut used = 0;
        for (row, moving) in rows.iter_mut().zip(self.chain()) {
            *row = *moving.row;
            used += 1;
        }
        let table = Table {
            base: self.base,
            tool: self.tool,
            ..Table::new(self.convention, self.gravity, rows)
        };
        (table, used)
    }
}

/// An arm some of whose joints follow others.
#[derive(Clone, Debug)]
pub(super) struct Coupled<const N: usize> {
    table: Table<N>,
}

impl<const N: usize> Coupled<N> {
    /// That of a table; `None` where nothing is coupled.
    pub(super) fn of(table: &Table<N>) -> Option<Self> {
        (!table.followers.is_empty()).then_some(Coupled { table: *table })
    }

    /// The whole arm. Offsets are a part of each row: its coordinate is the factor times the leader's.
    pub(super) fn whole(&self) -> Whole {
        let (table, used) = self.table.uncoupled();
        let mut whole = read(&table, used);
        for (link, moving) in whole.links.iter_mut().zip(self.table.chain()) {
            link.shift(moving.offset);
        }
        whole
    }

    /// S x
    pub(super) fn spread(&self, x: &SVector<f64, N>) -> Rows {
        let mut spread = Rows::zeros();
        for (entry, moving) in spread.iter_mut().zip(self.table.chain()) {
            *entry = moving.factor * x[moving.joint];
        }
        spread
    }

    /// A S
    pub(super) fn columns<const R: usize>(
        &self,
        matrix: &SMatrix<f64, R, MOST_ROWS>,
    ) -> SMatrix<f64, R, N> {
        let mut columns = SMatrix::<f64, R, N>::zeros();
        for (column, moving) in matrix.column_iter().zip(self.table.chain()) {
            let mut sum = columns.column_mut(moving.joint);
            sum += column * moving.factor;
        }
        columns
    }

    /// S' x
    pub(super) fn felt(&self, forces: &Rows) -> SVector<f64, N> {
        self.columns(&forces.transpose()).transpose()
    }

    /// S' A S
    pub(super) fn block(&self, matrix: &Square) -> SMatrix<f64, N, N> {
        self.columns(&self.columns(matrix).transpose()).transpose()
    }

    /// Of what belongs to the links of all rows, what belongs to those of the joints.
    pub(super) fn of_joints<X: Copy>(&self, of_rows: &[X; MOST_ROWS]) -> [X; N] {
        let mut of_joints = [of_rows[0]; N];
        for (row, moving) in of_rows.iter().zip(self.table.chain()) {
            if !moving.is_follower {
                of_joints[moving.joint] = *row;
            }
        }
        of_joints
    }
}

impl<const N: usize> Coupled<N> {
    pub(super) fn mass_matrix(&self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.block(&self.whole().whole_mass_matrix(&self.spread(q)))
    }

    pub(super) fn coriolis_vector(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let whole = self.whole();
        self.felt(&whole.whole_coriolis_vector(&self.spread(q), &self.spread(qd)))
    }

    pub(super) fn gravity_vector(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        self.felt(&self.whole().whole_gravity_vector(&self.spread(q)))
    }

    pub(super) fn friction_vector(&self, qd: &SVector<f64, N>) -> SVector<f64, N> {
        self.felt(&self.whole().whole_friction_vector(&self.spread(qd)))
    }

    pub(super) fn spring_vector(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        self.felt(&self.whole().whole_spring_vector(&self.spread(q)))
    }

    pub(super) fn inverse_dynamics(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let [q, qd, qdd] = [q, qd, qdd].map(|x| self.spread(x));
        self.felt(&self.whole().whole_inverse_dynamics(&q, &qd, &qdd))
    }

    /// The blocks of the links of the joints, and those of the followers' links.
    pub(super) fn standard_regressor(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> (Blocks<N>, [Option<Block<N>>; MOST_FOLLOWERS]) {
        let [q, qd, qdd] = [q, qd, qdd].map(|x| self.spread(x));
        let blocks = self.whole().whole_standard_regressor(&q, &qd, &qdd);
        let felt = blocks.map(|block| self.columns(&block.transpose()).transpose());
        let mut of_followers = [None; MOST_FOLLOWERS];
        let rows = felt.iter().zip(self.table.chain());
        let followers = rows.filter(|(_, moving)| moving.is_follower);
        for (place, (block, _)) in of_followers.iter_mut().zip(followers) {
            *place = Some(*block);
        }
        (self.of_joints(&felt), of_followers)
    }

    pub(super) fn kinetic_energy(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> f64 {
        let whole = self.whole();
        whole.whole_kinetic_energy(&self.spread(q), &self.spread(qd))
    }

    pub(super) fn potential_energy(&self, q: &SVector<f64, N>) -> f64 {
        self.whole().whole_potential_energy(&self.spread(q))
    }

    pub(super) fn derivatives(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> (SMatrix<f64, N, N>, SMatrix<f64, N, N>) {
        let [q, qd, qdd] = [q, qd, qdd].map(|x| self.spread(x));
        let (by_position, by_velocity) = self.whole().whole_derivatives(&q, &qd, &qdd);
        (self.block(&by_position), self.block(&by_velocity))
    }

    pub(super) fn second_derivatives(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SecondDerivatives<f64, N> {
        let [q, qd, qdd] = [q, qd, qdd].map(|x| self.spread(x));
        let whole = self.whole();
        let mut all = Sum::default();
        for (row, moving) in self.table.chain().enumerate() {
            let (slopes, curvature) = whole.whole_slopes_by(row, &q, [&qd, &qdd]);
            let slopes = slopes.map(|slopes| self.block(&slopes));
            let (k, factor) = (moving.joint, moving.factor);
            all.add(k, factor, slopes);
            all.0.1[k][(k, k)] += factor * factor * factor * curvature;
        }
        all.0
    }

    pub(super) fn rates(
        &self,
        motion: [&SVector<f64, N>; 3],
        rates: [&SVector<f64, N>; 2],
    ) -> (SVector<f64, N>, SVector<f64, N>) {
        let (motion, rates) = (
            motion.map(|x| self.spread(x)),
            rates.map(|x| self.spread(x)),
        );
        let whole = self.whole();
        let (first, second) = whole.whole_rates(motion.each_ref(), rates.each_ref());
        (self.felt(&first), self.felt(&second))
    }

    pub(super) fn forward_kinematics(&self, q: &SVector<f64, N>) -> Matrix4<f64> {
        self.whole().whole_forward_kinematics(&self.spread(q))
    }

    pub(super) fn link_poses(&self, q: &SVector<f64, N>) -> [Matrix4<f64>; N] {
        self.of_joints(&self.whole().whole_link_poses(&self.spread(q)))
    }

    pub(super) fn jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N> {
        self.columns(&self.whole().whole_jacobian(&self.spread(q)))
    }

    pub(super) fn jacobian_rate(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
    ) -> SMatrix<f64, 6, N> {
        let whole = self.whole();
        self.columns(&whole.whole_jacobian_rate(&self.spread(q), &self.spread(qd)))
    }

    pub(super) fn link_jacobians(&self, q: &SVector<f64, N>) -> [SMatrix<f64, 6, N>; N] {
        let of_rows = self.whole().whole_link_jacobians(&self.spread(q));
        self.of_joints(&of_rows)
            .map(|jacobian| self.columns(&jacobian))
    }

    pub(super) fn center_of_mass(&self, q: &SVector<f64, N>) -> Vector3<f64> {
        self.whole().whole_center_of_mass(&self.spread(q))
    }

    pub(super) fn center_of_mass_jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 3, N> {
        self.columns(&self.whole().whole_center_of_mass_jacobian(&self.spread(q)))
    }
}

impl Link {
    /// Tells the position of the joint from an offset.
    fn shift(&mut self, offset: f64) {
        match self.joint_type {
            JointType::Revolute => self.theta = self.theta.plus(SinCos::of_constant(offset)),
            JointType::Prismatic => self.d += offset,
        }
        self.spring.rest -= offset;
    }
}

// The functions of an arm with room for as many rows as an arm with followers may have: compiled here once, and
// not with every robot that is checked. Loops end with the last row that it has.

/// The most rows of an arm with followers, joints included.
pub(super) const MOST_ROWS: usize = 32;

/// The arm in which every row is a joint of its own.
pub(super) type Whole = NewtonEuler<MOST_ROWS>;

/// What belongs to the rows.
pub(super) type Rows = SVector<f64, MOST_ROWS>;

/// The columns of the standard regressor of one link.
type Block<const N: usize> = SMatrix<f64, N, 10>;
type Blocks<const N: usize> = [Block<N>; N];

/// What belongs to pairs of rows.
pub(super) type Square = SMatrix<f64, MOST_ROWS, MOST_ROWS>;

/// Reads so many rows of a table.
pub(super) fn read(table: &Table<MOST_ROWS>, used: usize) -> Whole {
    NewtonEuler::of_rows(table, used)
}

impl Whole {
    pub(super) fn whole_mass_matrix(&self, q: &Rows) -> Square {
        self.mass_matrix(q)
    }

    pub(super) fn whole_coriolis_vector(&self, q: &Rows, qd: &Rows) -> Rows {
        self.coriolis_vector(q, qd)
    }

    pub(super) fn whole_gravity_vector(&self, q: &Rows) -> Rows {
        self.gravity_vector(q)
    }

    pub(super) fn whole_friction_vector(&self, qd: &Rows) -> Rows {
        self.friction_vector(qd)
    }

    pub(super) fn whole_spring_vector(&self, q: &Rows) -> Rows {
        self.spring_vector(q)
    }

    pub(super) fn whole_inverse_dynamics(&self, q: &Rows, qd: &Rows, qdd: &Rows) -> Rows {
        self.inverse_dynamics(q, qd, qdd)
    }

    pub(super) fn whole_standard_regressor(
        &self,
        q: &Rows,
        qd: &Rows,
        qdd: &Rows,
    ) -> [Block<MOST_ROWS>; MOST_ROWS] {
        self.standard_regressor(q, qd, qdd)
    }

    pub(super) fn whole_kinetic_energy(&self, q: &Rows, qd: &Rows) -> f64 {
        self.kinetic_energy(q, qd)
    }

    pub(super) fn whole_potential_energy(&self, q: &Rows) -> f64 {
        self.potential_energy(q)
    }

    pub(super) fn whole_derivatives(&self, q: &Rows, qd: &Rows, qdd: &Rows) -> (Square, Square) {
        self.inverse_dynamics_derivatives(q, qd, qdd)
    }

    /// What row k does, and the curvature of its friction.
    pub(super) fn whole_slopes_by(
        &self,
        k: usize,
        q: &Rows,
        rates: [&Rows; 2],
    ) -> ([Square; 4], f64) {
        let slopes = self.slopes_by(k, &self.joints(q), rates);
        (slopes, self.curvature_of_friction(k, rates[0][k]))
    }

    pub(super) fn whole_rates(
        &self,
        [q, qd, qdd]: [&Rows; 3],
        [jerk, snap]: [&Rows; 2],
    ) -> (Rows, Rows) {
        self.inverse_dynamics_rates(q, qd, qdd, jerk, snap)
    }

    pub(super) fn whole_forward_kinematics(&self, q: &Rows) -> Matrix4<f64> {
        self.forward_kinematics(q)
    }

    pub(super) fn whole_link_poses(&self, q: &Rows) -> [Matrix4<f64>; MOST_ROWS] {
        self.link_poses(q)
    }

    pub(super) fn whole_jacobian(&self, q: &Rows) -> SMatrix<f64, 6, MOST_ROWS> {
        self.jacobian(q)
    }

    pub(super) fn whole_jacobian_rate(&self, q: &Rows, qd: &Rows) -> SMatrix<f64, 6, MOST_ROWS> {
        self.jacobian_rate(q, qd)
    }

    pub(super) fn whole_link_jacobians(&self, q: &Rows) -> [SMatrix<f64, 6, MOST_ROWS>; MOST_ROWS] {
        self.link_jacobians(q)
    }

    pub(super) fn whole_center_of_mass(&self, q: &Rows) -> Vector3<f64> {
        self.center_of_mass(q)
    }

    pub(super) fn whole_center_of_mass_jacobian(&self, q: &Rows) -> SMatrix<f64, 3, MOST_ROWS> {
        self.center_of_mass_jacobian(q)
    }
}
