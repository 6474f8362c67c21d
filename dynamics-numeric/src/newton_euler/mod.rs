//! Dynamics of an arm, numerically, from its table: inverse dynamics by the recursive Newton-Euler
//! algorithm, M by composite bodies, forward dynamics by both and a factorisation, or by articulated
//! bodies.
//!
//! Nothing in here knows of the symbolic derivation: the checks compare the two. [`NewtonEuler::new`] computes all that
//! does not depend on the state. A call evaluates all sines at once, validates nothing and allocates nothing.
//!
//! Sources. John J. Craig, *Introduction to Robotics: Mechanics and Control*, chapter 6: outward
//! iteration (6.31) to (6.37), inward iteration after it, gravity as an acceleration of the base,
//! link transform (3.6). J. Y. S. Luh, M. W. Walker, R. P. C. Paul, *On-line computational scheme
//! for mechanical manipulators*, J. Dyn. Sys. Meas. Control 102 (1980), 69-76. C. A. Balafoutis,
//! R. V. Patel, P. Misra, *Efficient modeling and computation of manipulator dynamics using
//! orthogonal Cartesian tensors*, IEEE J. Robotics and Automation 4 (1988), 665-676: the link's
//! moment from its second moments. R. Featherstone, *Rigid Body Dynamics Algorithms*, Springer
//! 2008: composite bodies (6.2), factorisation (6.5).

mod articulated;
mod base;
mod centroidal;
mod composite;
mod coriolis;
mod derivatives;
mod energy;
mod floating;
mod forward;
mod inertia;
mod kinematics;
mod link;
mod methods;
mod rates;
mod recursion;
mod regressor;
mod second_derivatives;
mod terms;
mod walk;

use dynamics_runtime::table::AsArm as _;
use dynamics_runtime::{Model, Size, SizedKinematics, Table, Tool};
use nalgebra::{Const, Matrix4, SVector, Vector3};

use base::{Body, Footing};
#[cfg(feature = "std")]
use dynamics_runtime::SizedTable;
pub use floating::{FloatingNewtonEuler, NumericFloating};
use link::Link;

/// The numeric dynamics of an arm, read from its [`Table`].
///
/// The methods are named like the generated functions that are compared with them, and take and return the same
/// quantities. Their units are the same too: `q` in rad or m, `qd` and `qdd` per second and per second squared, torques
/// in N m or N, energies in J. Rows may be a tree. Functions of a frame take its index in the table's frames; those of
/// the tip are NaN where several rows carry no other, so that there is no tip.
///
/// No method panics, unless a frame is not there, or allocates, and only the two of forward dynamics can
/// fail; input that is not finite propagates. The rounding error of
/// each result is a few units in the last place of the result's natural scale, held against
/// references of 25 digits by `tests/suite/reference.rs`.
///
/// ```
/// use robot_dynamics::{NewtonEuler, nalgebra::SVector, table::{Convention, JointType, Row, Table}};
///
/// // A mass of 2 kg that hangs 3 m below a horizontal axis.
/// let row = Row { mass: 2.0, com: [3.0, 0.0, 0.0], ..Row::new(JointType::Revolute) };
/// let gravity = [9.81, 0.0, 0.0];
/// let pendulum = NewtonEuler::new(&Table::new(Convention::Modified, gravity, [row]));
///
/// assert_eq!(pendulum.mass_matrix(&SVector::from([0.0]))[0], 18.0);
/// assert_eq!(pendulum.gravity_vector(&SVector::from([0.0]))[0], 0.0);
/// ```
///
/// It can be simulated, so that a table moves too from which no code was generated:
#[cfg_attr(feature = "std", doc = "```")]
#[cfg_attr(not(feature = "std"), doc = "```ignore")]
/// # use robot_dynamics::{NewtonEuler, nalgebra::SVector, table::{Convention, JointType, Row, Table}};
/// # let row = Row { mass: 2.0, com: [3.0, 0.0, 0.0], ..Row::new(JointType::Revolute) };
/// # let gravity = [9.81, 0.0, 0.0];
/// # let pendulum = NewtonEuler::new(&Table::new(Convention::Modified, gravity, [row]));
/// use robot_dynamics::Simulation;
///
/// let swing = Simulation::new(&pendulum).initial(SVector::from([0.1]), SVector::zeros()).run()?;
/// assert!((swing.q[100][0] - 0.1 * f64::cos((9.81_f64 / 3.0).sqrt())).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type NewtonEuler<const N: usize> = NumericArm<Const<N>>;

/// The numeric dynamics of an arm: [`NewtonEuler`] where the compiler knows the number of joints. Where it is known at
/// run time alone, `NumericArm<Dyn>` has the same methods, over `DVector<f64>` and `DMatrix<f64>`, and is read from a
/// `RuntimeTable`. `V` is the number of velocities, as many as joints: [`NumericFloating`] is for a base that moves.
#[derive(Clone, Debug)]
pub struct NumericArm<D: Size, V: Size = D> {
    size: D,
    /// The number of velocities: six more than joints where the base moves.
    freedoms: V,
    table: D::Table,
    /// From the base outwards. The links of joints that follow others are among them.
    links: D::Links<Link>,
    count: usize,
    /// Whether a link is carried by another one than the link before it.
    has_branches: bool,
    /// The link that carries the tip, if there is a tip.
    tip_link: Option<usize>,
    /// In the axes of the world.
    world_gravity: Vector3<f64>,
    /// A base that stands.
    base: Footing,
    /// The body of a base that moves.
    body: Option<Body>,
}

/// A robot whose base is at a place: where the table says that it stands, or where a base that moves is. The algorithms are
/// those of both: the equations of an arm are those without the rows of the base.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed<'a, 'b, D: Size, V: Size> {
    arm: &'a NumericArm<D, V>,
    base: &'b Footing,
}

impl<D: Size> NumericArm<D> {
    /// Reads the table.
    ///
    /// # Panics
    ///
    /// If a row stands on one that is not above it, or a frame on a row that is not there; if there is a tool, but several
    /// rows carry no other, so that there is no tip.
    pub fn new(table: &D::Table) -> Self {
        Self::read(table, D::from_usize(table.arm().rows.len()))
    }
}

#[cfg(feature = "std")]
impl NumericArm<nalgebra::Dyn> {
    /// Reads the table of a robot whose base stands or moves.
    pub(crate) fn on_any_base(table: &dynamics_runtime::RuntimeTable) -> Self {
        Self::read(table, nalgebra::Dyn(table.arm().freedoms()))
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// Reads the table. The joints' velocities are the last ones of all.
    fn read(table: &D::Table, freedoms: V) -> Self {
        let arm = table.arm();
        let size = D::from_usize(arm.rows.len());
        let first = freedoms.value() - size.value();
        let (count, tip_link) = (arm.chain().count(), arm.tip_row());
        let has_place = count == 0 || tip_link.is_some() || *arm.tool == Tool::NONE;
        assert!(
            has_place,
            "a tool stands at the tip, and several rows carry no other: make it a frame of its row"
        );
        arm.frames
            .iter()
            .for_each(|frame| frame.assert_stands_on(count));
        let mut links = size.links(count, Link::NONE);
        for (k, mut link) in Link::all(arm).enumerate() {
            link.joint += first;
            links[k] = link;
        }
        let world_gravity = Vector3::from(arm.gravity);
        let body = arm.base_body().filter(|_| first > 0);
        NumericArm {
            size,
            freedoms,
            table: table.clone(),
            has_branches: (0..count).any(|k| links[k].carrier != k.checked_sub(1)),
            links,
            count,
            tip_link,
            world_gravity,
            base: Footing::new(arm.base.into(), &world_gravity),
            body: body.as_ref().map(Body::from),
        }
    }

    /// The number of its velocities, which is that of its joints.
    pub fn dof(&self) -> usize {
        self.freedoms.value()
    }

    /// How many velocities there are before those of the joints: the compiler knows that an arm has none.
    #[inline(always)]
    fn first(&self) -> usize {
        self.freedoms.value() - self.size.value()
    }

    /// Whether the base moves.
    #[inline(always)]
    fn floats(&self) -> bool {
        self.first() > 0
    }

    /// The body of a base that moves: the compiler knows that an arm has none.
    #[inline(always)]
    fn body(&self) -> Option<&Body> {
        self.body.as_ref().filter(|_| self.floats())
    }

    /// The arm where its table says that it stands.
    #[inline(always)]
    fn standing(&self) -> Placed<'_, '_, D, V> {
        self.placed(&self.base)
    }

    /// Where the base is: there if it moves.
    #[cfg(feature = "std")]
    pub(crate) fn footing(&self, base: &dynamics_runtime::Pose<f64>) -> Footing {
        if self.floats() {
            Footing::new(base.into(), &self.world_gravity)
        } else {
            self.base
        }
    }

    /// The robot with its base there.
    #[inline(always)]
    pub(crate) fn placed<'b>(&self, base: &'b Footing) -> Placed<'_, 'b, D, V> {
        Placed { arm: self, base }
    }
}

/// The table that it was made of. The joints have no names there: they are counted.
impl<const N: usize> Model<N> for NewtonEuler<N> {
    const JOINT_NAMES: [&'static str; N] = numbered();

    fn table(&self) -> Table<N> {
        self.table.clone()
    }

    fn energies(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> Option<[f64; 2]> {
        Some([self.kinetic_energy(q, qd), self.potential_energy(q)])
    }
}

impl<D: Size> SizedKinematics<D> for NumericArm<D> {
    fn tip_pose(&self, q: &D::Vector) -> Matrix4<f64> {
        self.forward_kinematics(q)
    }

    fn tip_jacobian(&self, q: &D::Vector) -> D::Columns<6> {
        self.jacobian(q)
    }
}

#[cfg(feature = "std")]
impl SizedTable<nalgebra::Dyn> for NumericArm<nalgebra::Dyn> {
    fn sized_numbers(&self) -> dynamics_runtime::RuntimeTable {
        self.table.clone()
    }
}

/// `joint_1`, `joint_2`, ... as far as they were written down.
const fn numbered<const N: usize>() -> [&'static str; N] {
    const NAMES: [&str; 16] = [
        "joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6", "joint_7", "joint_8",
        "joint_9", "joint_10", "joint_11", "joint_12", "joint_13", "joint_14", "joint_15",
        "joint_16",
    ];
    let mut names = ["joint"; N];
    let mut i = 0;
    while i < N && i < NAMES.len() {
        names[i] = NAMES[i];
        i += 1;
    }
    names
}

#[cfg(test)]
mod frame_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tree_tests;
