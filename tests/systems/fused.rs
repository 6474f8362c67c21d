//! Several functions as one program: the values are those of each function, to rounding and in 31
//! digits, and nothing is allocated.

use allocation_counter::measure;
use robot_dynamics::nalgebra::{Matrix4, SMatrix, SVector};
use robot_dynamics::{
    DoubleDouble, Scalar, SingularMassMatrix, check::Check, check_against_rnea, robot_dynamics,
};
use robots::{Panda, Puma560, Scara, TwoLinkSaha};
use testkit::random::Random;

/// A state in any arithmetic.
struct At<T, const N: usize> {
    q: SVector<T, N>,
    qd: SVector<T, N>,
    qdd: SVector<T, N>,
    tau: SVector<T, N>,
}

/// Entries, one part after the other, and after each part how many there are.
type Entries<T> = Vec<Vec<T>>;

/// The tuples of an arm of the test kit, and the same functions one by one.
trait Tuples<const N: usize> {
    fn together<T: Scalar>(&self, at: &At<T, N>) -> Result<Entries<T>, SingularMassMatrix>;
    fn one_by_one<T: Scalar>(&self, at: &At<T, N>) -> Result<Entries<T>, SingularMassMatrix>;
}

fn entries<T: Scalar, const R: usize, const C: usize>(matrix: SMatrix<T, R, C>) -> Vec<T> {
    matrix.iter().copied().collect()
}

macro_rules! tuples {
    ($($robot:ident, $n:literal;)*) => {$(
        impl Tuples<$n> for $robot {
            fn together<T: Scalar>(&self, at: &At<T, $n>) -> Result<Entries<T>, SingularMassMatrix> {
                let At { q, qd, qdd, tau } = at;
                let (m, v, g) = $robot::control_terms(self, q, qd);
                let (force, (by_position, by_velocity)) = $robot::linearised(self, q, qd, qdd);
                let motion: (_, _, Matrix4<T>) = $robot::motion(self, q, qd, tau)?;
                let (acceleration, energy, pose) = motion;
                Ok(vec![
                    entries(m), entries(v), entries(g), entries(force), entries(by_position),
                    entries(by_velocity), entries(acceleration), vec![energy], entries(pose),
                ])
            }

            fn one_by_one<T: Scalar>(&self, at: &At<T, $n>) -> Result<Entries<T>, SingularMassMatrix> {
                let At { q, qd, qdd, tau } = at;
                let (by_position, by_velocity) = $robot::inverse_dynamics_derivatives(self, q, qd, qdd);
                Ok(vec![
                    entries($robot::mass_matrix(self, q)),
                    entries($robot::coriolis_vector(self, q, qd)),
                    entries($robot::gravity_vector(self, q)),
                    entries($robot::inverse_dynamics(self, q, qd, qdd)),
                    entries(by_position),
                    entries(by_velocity),
                    entries($robot::forward_dynamics(self, q, qd, tau)?),
                    vec![$robot::kinetic_energy(self, q, qd)],
                    entries($robot::forward_kinematics(self, q)),
                ])
            }
        }
    )*};
}

robot_dynamics! {
    /// Three joints with fields in all cells, so that no constant of a program is rounded.
    struct Binary { m: f64, l: f64, j: f64, g: f64 }
    convention: modified,
    gravity: [0, 0, -g],
    joints: [
        waist: revolute { d: l, mass: m, com: [0, l, 0], inertia: { xx: j, yy: j, zz: j } },
        shoulder: revolute { alpha: PI/2, mass: m, com: [l, 0, 0], inertia: { yy: j, zz: j } },
        elbow: revolute { a: l, mass: m, com: [l, 0, 0], inertia: { yy: j, zz: j } },
    ],
    functions: [
        default, forward_kinematics, inverse_dynamics_derivatives,
        control_terms = (mass_matrix, coriolis_vector, gravity_vector),
        linearised = (inverse_dynamics, inverse_dynamics_derivatives),
        motion = (forward_dynamics, kinetic_energy, forward_kinematics),
    ],
}

const BINARY: Binary = Binary {
    m: 3.0,
    l: 0.5,
    j: 0.25,
    g: 9.8125,
};

tuples! { Binary, 3; TwoLinkSaha, 2; Scara, 4; Puma560, 6; Panda, 7; }

/// Seeded states, the same numbers in any arithmetic.
fn states<T: Scalar, const N: usize>() -> impl Iterator<Item = At<T, N>> {
    let mut random = Random::seeded(7);
    (0..20).map(move |_| {
        let [q, qd, qdd, tau] = [3.0, 2.0, 5.0, 20.0].map(|size| {
            let vector: SVector<f64, N> = random.vector(size);
            vector.map(T::from_f64)
        });
        At { q, qd, qdd, tau }
    })
}

/// The largest difference of an entry, over the largest entry of its part; `size` is the magnitude of a
/// number.
fn difference<T: Scalar, const N: usize>(robot: &impl Tuples<N>, size: impl Fn(T) -> f64) -> f64 {
    let mut worst = 0.0_f64;
    for at in states::<T, N>() {
        let [together, one_by_one] = [robot.together(&at), robot.one_by_one(&at)]
            .map(|entries| entries.expect("the mass matrix is positive definite"));
        assert_eq!(together.len(), one_by_one.len());
        for (together, one_by_one) in together.iter().zip(&one_by_one) {
            assert_eq!(together.len(), one_by_one.len());
            let largest = one_by_one.iter().map(|x| size(*x)).fold(0.0, f64::max);
            for (a, b) in together.iter().zip(one_by_one) {
                let difference = size(*a - *b);
                assert!(
                    difference <= largest || difference == 0.0,
                    "{difference:e} of {largest:e}"
                );
                if difference > 0.0 {
                    worst = worst.max(difference / largest);
                }
            }
        }
    }
    worst
}

/// Both are within some roundings for each joint of the true value; accelerations lose what M's
/// condition costs, at most three digits for these arms. In 31 digits the difference is that of the
/// constants of the two programs, which are doubles.
fn agrees<const N: usize>(robot: &impl Tuples<N>) {
    let doubles = difference::<f64, N>(robot, f64::abs);
    let extended = difference::<DoubleDouble, N>(robot, |x| x.high().abs());
    println!("{N} joints: {doubles:.1e} in doubles, {extended:.1e} in 31 digits");
    let bound = 1e3 * N as f64 * f64::EPSILON;
    assert!(
        doubles < bound && extended < bound,
        "{doubles:e} {extended:e}"
    );
}

/// A robot whose constants are all exact in binary: in 31 digits nothing is left but their rounding.
#[test]
fn exact_constants_leave_nothing_but_rounding() {
    let extended = difference::<DoubleDouble, 3>(&BINARY, |x| x.high().abs());
    assert!(extended < 1e-27, "{extended:e}");
    check_against_rnea(&BINARY).assert_ok();
}

#[test]
fn tuples_hold_what_each_function_gives() {
    agrees(&TwoLinkSaha);
    agrees(&Scara);
    agrees(&Puma560);
    agrees(&Panda);
}

/// Each part of each tuple is compared with recursive Newton-Euler, beside the functions themselves.
#[test]
fn parts_are_checked_as_functions_are() {
    let report = Check::new().samples(5).run(&Puma560);
    report.assert_ok();
    let of = |method: Option<&str>| {
        let functions = report
            .functions
            .iter()
            .filter(|f| f.method.as_deref() == method);
        functions.map(|f| f.function).collect::<Vec<_>>()
    };
    let control = ["mass_matrix", "coriolis_vector", "gravity_vector"];
    assert_eq!(of(Some("control_terms")), control);
    assert_eq!(
        of(Some("linearised")),
        ["inverse_dynamics", "inverse_dynamics_derivatives"]
    );
    assert_eq!(
        of(Some("motion")),
        ["forward_dynamics", "kinetic_energy", "forward_kinematics"]
    );
    assert!(control.iter().all(|name| of(None).contains(name)));
    assert!(
        report
            .to_string()
            .contains("gravity_vector of control_terms")
    );
}

#[test]
fn nothing_is_allocated() {
    let [q, qd, qdd] = [0.3, 0.5, -2.0].map(SVector::<f64, 6>::repeat);
    let count = measure(|| {
        let arm = std::hint::black_box(Puma560);
        std::hint::black_box(arm.control_terms(&q, &qd));
        std::hint::black_box(arm.linearised(&q, &qd, &qdd));
        let _ = std::hint::black_box(arm.motion(&q, &qd, &qdd));
    });
    assert_eq!(count.count_total, 0);
}

/// The constant has the operations that the documentation lists.
#[test]
fn operations_of_a_tuple_are_known() {
    let total = |name: &str| {
        let mut operations = Puma560::OPERATIONS.iter();
        let found = operations.find(|(of, _)| *of == name);
        found.expect("the method").1
    };
    let parts = ["mass_matrix", "coriolis_vector", "gravity_vector"].map(total);
    let together = total("control_terms");
    assert!(together.total() < parts.iter().map(|o| o.total()).sum());
    assert_eq!(together.sin_cos, 4);
}
