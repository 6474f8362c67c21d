//! No generated function allocates, nor do the numeric algorithms, a shared configuration and a batch:
//! on no robot, in no precision, and not on the way to an error either.

use std::hint::black_box;

use allocation_counter::measure;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Batch, CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Model,
    NewtonEuler, Scalar, SharedSines, TaylorSimulation, simulation::Taylor,
};
use robots::*;

/// A vector of one number; what matters is only whether it is finite.
fn vector<T: Scalar, const N: usize>(x: f64) -> SVector<T, N> {
    SVector::repeat(T::from_f64(x))
}

/// Fails where the calls allocate.
fn assert_none(what: &str, calls: impl FnOnce()) {
    let count = measure(calls).count_total;
    assert_eq!(count, 0, "allocations by {what}");
}

/// Calls every function of an arm.
macro_rules! calls {
    ({ $arm:ident, $at:ident, $float:ident } $($name:ident [$($argument:ident),*])*) => {
        $(let _ = black_box($arm.$name::<$float>($($at.$argument),*));)*
    };
}

macro_rules! functions {
    ($robot:ident, $n:literal, $float:ident, $q:expr) => {
        let arm = black_box($robot);
        let [q, qd, qdd] = [$q, 0.5, -2.0].map(vector::<$float, $n>);
        let at = Arguments {
            q: &q,
            qd: &qd,
            qdd: &qdd,
            tau: &qdd,
            qd_r: &qd,
            qdd_r: &qdd,
            jerk: &qd,
            snap: &qdd,
            wrench: &vector::<$float, 6>(0.5),
            order: 10,
        };
        assert_none(stringify!($float), || {
            each_function! { calls { arm, at, $float } }
            black_box(arm.table());
        });
    };
}

macro_rules! allocations {
    ($($test:ident: $robot:ident, $n:literal;)*) => {$(
        #[test]
        fn $test() {
            with_room(|| {
                for q in [0.3, 1e9, f64::NAN] {
                    functions!($robot, $n, f64, q);
                    functions!($robot, $n, f32, q);
                    numeric_algorithms(&$robot, q);
                }
                sines_are_shared(&$robot);
            });
        }
    )*};
}

allocations! {
    moving_mass: MovingMass, 1;
    vertical_mass: VerticalMass, 1;
    geared_link: GearedLink, 1;
    one_link: OneLink, 1;
    two_link_saha: TwoLinkSaha, 2;
    two_link_craig: TwoLinkCraig, 2;
    rrr_planar: RrrPlanar, 3;
    elbow_3r: Elbow3r, 3;
    gantry_ppp: GantryPpp, 3;
    cylindrical_rpp: CylindricalRpp, 3;
    spherical_wrist: SphericalWrist, 3;
    scara: Scara, 4;
    tilting_cell: TiltingCell, 4;
    gripper_arm: GripperArm, 3;
    palletiser: Palletiser, 3;
    puma560: Puma560, 6;
    panda: Panda, 7;
}

/// A run by Taylor series allocates its samples and the room for one series, however many steps it
/// makes.
#[test]
fn taylor_runs_allocate_at_the_start() {
    with_room(|| {
        let allocations = |duration: f64| {
            let settings = Taylor::default().max_step(0.02);
            let simulation = TaylorSimulation::new(&TwoLinkCraig)
                .settings(settings)
                .duration(duration)
                .samples(3);
            let mut steps = 0;
            let info = measure(|| steps = simulation.run().expect("a motion").work.steps);
            (steps, info.count_total)
        };
        let ((few, at_first), (many, at_last)) = (allocations(0.1), allocations(2.0));
        assert!(many > 10 * few && few > 1, "{few} and {many} steps");
        assert_eq!(at_first, at_last);
    });
}

/// On a stack with room: unoptimised, the frame of a long function takes a good part of a thread's
/// usual one.
fn with_room(test: impl FnOnce() + Send) {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(32 << 20);
        let test = thread.spawn_scoped(scope, test).expect("a thread");
        test.join().expect("no allocations");
    });
}

fn numeric_algorithms<const N: usize>(robot: &impl Model<N>, q: f64) {
    let [q, qd, qdd] = [q, 0.5, -2.0].map(vector::<f64, N>);
    assert_none("the numeric algorithms", || {
        let arm = black_box(NewtonEuler::new(&robot.table()));
        black_box(arm.mass_matrix(&q));
        black_box(arm.coriolis_vector(&q, &qd));
        black_box(arm.gravity_vector(&q));
        black_box(arm.friction_vector(&qd));
        black_box(arm.inverse_dynamics(&q, &qd, &qdd));
        let _ = black_box(arm.forward_dynamics(&q, &qd, &qdd));
        black_box(arm.kinetic_energy(&q, &qd));
        black_box(arm.potential_energy(&q));
        black_box(arm.bias_force(&q, &qd));
        black_box(arm.coriolis_matrix(&q, &qd));
        black_box(arm.link_poses(&q));
        black_box(arm.forward_kinematics(&q));
        black_box(arm.jacobian(&q));
        black_box(arm.inverse_dynamics_derivatives(&q, &qd, &qdd));
        black_box(arm.inverse_dynamics_second_derivatives(&q, &qd, &qdd));
    });
}

fn sines_are_shared<const N: usize, R: Model<N> + Programs<N>>(robot: &R) {
    let [q, qd, qdd] = [0.3, 0.5, -2.0].map(vector::<f64, N>);
    assert_none("a configuration", || {
        let arm = black_box(SharedSines::new(robot, &q));
        black_box(arm.mass_matrix());
        black_box(arm.coriolis_vector(&qd));
        black_box(arm.gravity_vector());
        black_box(arm.inverse_dynamics(&qd, &qdd));
        let _ = black_box(arm.forward_dynamics(&qd, &qdd));
    });
}

/// Arms whose batches are compared with single calls too: a batch is compiled for each width of registers.
#[test]
fn batches_do_not_allocate() {
    with_room(|| {
        batches(&Scara);
        batches(&TiltingCell);
        batches(&Puma560);
    });
}

/// Fewer states than lanes, as many, and more; on this core, for a thread needs memory.
fn batches<const N: usize, R: Programs<N>>(robot: &R) {
    for states in [0, 3, 8, 21] {
        let [q, qd, qdd] = [0.3, 0.5, -2.0].map(|x| vec![vector::<f64, N>(x); states]);
        let mut vectors = vec![vector::<f64, N>(0.0); states];
        let mut matrices = vec![SMatrix::<f64, N, N>::zeros(); states];
        assert_none("a batch", || {
            let lengths = [
                robot.mass_matrix_batch(&q, &mut matrices),
                robot.coriolis_vector_batch(&q, &qd, &mut vectors),
                robot.gravity_vector_batch(&q, &mut vectors),
                robot.inverse_dynamics_batch(&q, &qd, &qdd, &mut vectors),
            ];
            assert!(lengths.iter().all(Result::is_ok));
            let _ = black_box(robot.forward_dynamics_batch(&q, &qd, &qdd, &mut vectors));
        });
    }
}

/// The traits of single functions together.
trait Programs<const N: usize>:
    MassMatrix<N> + CoriolisVector<N> + GravityVector<N> + InverseDynamics<N> + ForwardDynamics<N>
{
}

impl<const N: usize, R> Programs<N> for R where
    R: MassMatrix<N>
        + CoriolisVector<N>
        + GravityVector<N>
        + InverseDynamics<N>
        + ForwardDynamics<N>
{
}

/// The measure itself: it sees an allocation.
#[test]
#[should_panic(expected = "allocations by a vector")]
fn an_allocation_is_counted() {
    assert_none("a vector", || drop(black_box(vec![1.0; 10])));
}
