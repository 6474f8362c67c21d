//! Arms for tests of the crates that generated code needs: one whose equations of motion are printed in a book, tables
//! with everything, and robots of the data files.

pub mod data;

use dynamics_runtime::internal::SplitMix64;
use dynamics_runtime::{
    Carrier, Convention, Energy, Evaluate, Evaluation, FixedFrame, FloatingBase, ForwardDynamics,
    Frame, JointType, Model, Placement, Pose, Row, Scalar, SingularMassMatrix, Spring, State,
    Table, Tool,
};
use nalgebra::{Matrix2, Rotation3, SVector, Vector2};

/// The two-link arm with point masses at the ends of its links, Craig (6.60) to (6.62).
#[derive(Clone, Copy, Debug)]
pub struct CraigArm {
    /// Mass of the first point, kg.
    pub m1: f64,
    /// Mass of the second point, kg.
    pub m2: f64,
    /// Length of the first link, m.
    pub l1: f64,
    /// Length of the second link, m.
    pub l2: f64,
    /// Gravity, m/s^2.
    pub g: f64,
}

/// Such an arm with numbers.
pub const CRAIG_ARM: CraigArm = CraigArm {
    m1: 4.6,
    m2: 2.3,
    l1: 0.5,
    l2: 0.3,
    g: 9.81,
};

impl CraigArm {
    fn constants<T: Scalar>(&self) -> [T; 5] {
        [self.m1, self.m2, self.l1, self.l2, self.g].map(T::from_f64)
    }

    /// (6.60).
    pub fn mass_matrix<T: Scalar>(&self, q: &SVector<T, 2>) -> Matrix2<T> {
        let [m1, m2, l1, l2, _] = self.constants::<T>();
        let (_, c2) = q[1].sin_cos();
        let far = l2 * l2 * m2;
        let mixed = l1 * l2 * m2 * c2;
        let m11 = far + mixed + mixed + l1 * l1 * (m1 + m2);
        Matrix2::new(m11, far + mixed, far + mixed, far)
    }

    /// (6.61).
    pub fn coriolis_vector<T: Scalar>(&self, q: &SVector<T, 2>, qd: &SVector<T, 2>) -> Vector2<T> {
        let [_, m2, l1, l2, _] = self.constants::<T>();
        let (s2, _) = q[1].sin_cos();
        let h = m2 * l1 * l2 * s2;
        let two = T::from_f64(2.0);
        Vector2::new(
            -h * qd[1] * qd[1] - two * h * qd[0] * qd[1],
            h * qd[0] * qd[0],
        )
    }

    /// (6.62).
    pub fn gravity_vector<T: Scalar>(&self, q: &SVector<T, 2>) -> Vector2<T> {
        let [m1, m2, l1, l2, g] = self.constants::<T>();
        let ((s1, c1), (s2, c2)) = (q[0].sin_cos(), q[1].sin_cos());
        let outer = m2 * l2 * g * (c1 * c2 - s1 * s2);
        Vector2::new(outer + (m1 + m2) * l1 * g * c1, outer)
    }
}

impl Model<2> for CraigArm {
    const JOINT_NAMES: [&'static str; 2] = ["shoulder", "elbow"];

    fn table(&self) -> Table<2> {
        let revolute = Row::new(JointType::Revolute);
        Table::new(
            Convention::Modified,
            [0.0, -self.g, 0.0],
            [
                Row {
                    mass: self.m1,
                    com: [self.l1, 0.0, 0.0],
                    ..revolute
                },
                Row {
                    a: self.l1,
                    mass: self.m2,
                    com: [self.l2, 0.0, 0.0],
                    ..revolute
                },
            ],
        )
    }

    fn energies(&self, q: &SVector<f64, 2>, qd: &SVector<f64, 2>) -> Option<[f64; 2]> {
        Some([self.kinetic_energy(q, qd), self.potential_energy(q)])
    }
}

impl ForwardDynamics<2> for CraigArm {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 2>,
        qd: &SVector<T, 2>,
        tau: &SVector<T, 2>,
    ) -> Result<SVector<T, 2>, SingularMassMatrix> {
        let m = self.mass_matrix(q);
        let (v, g) = (self.coriolis_vector(q, qd), self.gravity_vector(q));
        let pivot = m[(0, 0)] - m[(0, 1)] * m[(0, 1)] / m[(1, 1)];
        if !pivot.is_positive() {
            return Err(SingularMassMatrix::new(0, pivot.ratio_to_f64(m[(0, 0)])));
        }
        let f1 = tau[0] - v[0] - g[0];
        let f2 = tau[1] - v[1] - g[1];
        let qdd1 = (f1 - m[(0, 1)] / m[(1, 1)] * f2) / pivot;
        let qdd2 = (f2 - m[(0, 1)] * qdd1) / m[(1, 1)];
        Ok(Vector2::new(qdd1, qdd2))
    }
}

impl Energy<2> for CraigArm {
    fn kinetic_energy<T: Scalar>(&self, q: &SVector<T, 2>, qd: &SVector<T, 2>) -> T {
        let m = self.mass_matrix(q);
        let momentum = m[(0, 1)] * qd[0] * qd[1];
        let squares = m[(0, 0)] * qd[0] * qd[0] + m[(1, 1)] * qd[1] * qd[1];
        T::from_f64(0.5) * squares + momentum
    }

    fn potential_energy<T: Scalar>(&self, q: &SVector<T, 2>) -> T {
        let [m1, m2, l1, l2, g] = self.constants::<T>();
        let ((s1, c1), (s2, c2)) = (q[0].sin_cos(), q[1].sin_cos());
        g * ((m1 + m2) * l1 * s1 + m2 * l2 * (s1 * c2 + c1 * s2))
    }
}

impl Evaluate<2> for CraigArm {
    fn evaluate(&self, state: &State<2>, tau: &SVector<f64, 2>) -> Evaluation {
        let State { q, qd, qdd } = state;
        let mass_matrix = self.mass_matrix(q);
        let bias_force = self.coriolis_vector(q, qd) + self.gravity_vector(q);
        let mut values = Evaluation::default();
        values.set("mass_matrix", mass_matrix);
        values.set("coriolis_vector", self.coriolis_vector(q, qd));
        values.set("gravity_vector", self.gravity_vector(q));
        values.set("inverse_dynamics", mass_matrix * qdd + bias_force);
        values.set("forward_dynamics", self.forward_dynamics(q, qd, tau));
        values.set("kinetic_energy", self.kinetic_energy(q, qd));
        values.set("potential_energy", self.potential_energy(q));
        values.set("bias_force", bias_force);
        values
    }
}

/// An arm with joints of both types and no zero cell.
pub fn general_table<const N: usize>(convention: Convention, seed: u64) -> Table<N> {
    let mut random = SplitMix64(seed);
    let mut gravity = [0.0; 3];
    gravity.fill_with(|| random.within(&(-9.0..=9.0)));
    Table::new(
        convention,
        gravity,
        core::array::from_fn(|_| general_row(&mut random)),
    )
}

/// As [`general_table`], on a base and with a tool.
pub fn mounted_table<const N: usize>(convention: Convention, seed: u64) -> Table<N> {
    let mut random = SplitMix64(!seed);
    let mut within = |size: f64| [(); 3].map(|()| random.within(&(-size..=size)));
    let mut frame = || Frame {
        xyz: within(1.0),
        rpy: within(3.0),
    };
    let (base, tool) = (frame(), frame());
    let body = general_row(&mut random);
    Table {
        base,
        tool: Tool {
            frame: tool,
            mass: body.mass,
            com: body.com,
            inertia: body.inertia,
        },
        ..general_table(convention, seed)
    }
}

fn general_row(random: &mut SplitMix64) -> Row {
    let joint_type = match random.next() % 3 {
        0 => JointType::Prismatic,
        _ => JointType::Revolute,
    };
    let mut within = |low, high| random.within(&(low..=high));
    Row {
        joint_type,
        a: within(-0.5, 0.5),
        alpha: within(-3.0, 3.0),
        d: within(-0.5, 0.5),
        theta: within(-3.0, 3.0),
        mass: within(0.5, 4.0),
        com: [within(-0.2, 0.2), within(-0.2, 0.2), within(-0.2, 0.2)],
        inertia: [
            within(0.02, 0.03),
            within(0.02, 0.03),
            within(0.02, 0.03),
            within(-0.002, 0.002),
            within(-0.002, 0.002),
            within(-0.002, 0.002),
        ],
        motor_inertia: within(1e-4, 3e-4),
        gear_ratio: within(-60.0, 60.0),
        viscous: within(0.1, 0.3),
        coulomb: [within(0.1, 0.3); 2],
        spring: Spring {
            stiffness: 3.0,
            rest: 0.4,
        },
        ..Row::new(JointType::Revolute)
    }
}

/// A tree of at least four rows on a base that moves: branches on the base and on row 0, frames with bodies on the base, on row 1
/// and on the last row.
pub fn floating_table<const N: usize>(convention: Convention, seed: u64) -> Table<N> {
    let table = mounted_table::<N>(convention, seed);
    let others: [Table<1>; 4] =
        core::array::from_fn(|i| mounted_table(convention, 9 * seed + i as u64));
    let mut rows = table.rows;
    for (k, row) in rows.iter_mut().enumerate() {
        row.on = [
            Carrier::Above,
            Carrier::Row(0),
            Carrier::Row(0),
            Carrier::Base,
        ][k % 4];
        if k % 4 != 0 {
            row.mount = Placement::of_frames(&[others[k % 4].base]);
        }
    }
    let frame = |on: Option<usize>| FixedFrame {
        mass: 0.7,
        com: others[0].tool.com,
        inertia: [0.02, 0.03, 0.02, 0.001, -0.002, 0.0],
        ..FixedFrame::new(on, Placement::of_frames(&[others[1].tool.frame]))
    };
    Table {
        base: Frame::IDENTITY,
        floating: Some(FloatingBase {
            mass: 5.0,
            com: others[2].rows[0].com,
            inertia: [0.3, 0.4, 0.5, 0.02, -0.01, 0.03],
        }),
        rows,
        frames: [frame(None), frame(Some(1)), frame(N.checked_sub(1))][..].into(),
        tool: Tool::NONE,
        ..table
    }
}

/// A base somewhere, turned by some angles.
pub fn random_pose(seed: u64) -> Pose<f64> {
    let State { q, qd, .. } = random_state::<3>(seed ^ 77);
    Pose {
        rotation: Rotation3::from_euler_angles(q.x, q.y, q.z).into_inner(),
        position: qd,
    }
}

/// A state of moderate size.
pub fn random_state<const N: usize>(seed: u64) -> State<N> {
    let mut random = SplitMix64(seed);
    let mut vector = || SVector::from_fn(|_, _| random.within(&(-3.0..=3.0)));
    State {
        q: vector(),
        qd: vector(),
        qdd: vector(),
    }
}
