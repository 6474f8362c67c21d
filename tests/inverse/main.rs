//! Inverse kinematics in closed form, of an arm of each class.

mod arms;

use arms::*;
use robot_dynamics::closed_form::{Real, Solutions};
use robot_dynamics::nalgebra::{Matrix4, SMatrix, SVector};

/// An arm with a closed form.
trait Inverse<const N: usize> {
    const NAME: &'static str;
    fn pose<T: Real>(&self, q: &SVector<T, N>) -> Matrix4<T>;
    fn jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N>;
    /// The angle of the elbow of seven joints, from their forward kinematics.
    fn elbow(&self, q: &SVector<f64, N>) -> f64 {
        let _ = q;
        0.0
    }
    fn solutions<T: Real>(&self, pose: &Matrix4<T>, elbow: T) -> Solutions<T, N>;
}

/// Seven joints have one more argument.
macro_rules! solutions {
    ($arm:ident, $pose:ident, $elbow:ident, 7) => {
        $arm.inverse_kinematics($pose, $elbow)
    };
    ($arm:ident, $pose:ident, $elbow:ident, $n:tt) => {{
        let _ = $elbow;
        $arm.inverse_kinematics($pose)
    }};
}

macro_rules! inverses {
    ($($name:ident: $n:tt,)*) => {
        $(
            impl Inverse<$n> for $name {
                const NAME: &'static str = stringify!($name);

                fn pose<T: Real>(&self, q: &SVector<T, $n>) -> Matrix4<T> {
                    self.forward_kinematics(q)
                }

                fn jacobian(&self, q: &SVector<f64, $n>) -> SMatrix<f64, 6, $n> {
                    self.jacobian(q)
                }

                fn solutions<T: Real>(&self, pose: &Matrix4<T>, elbow: T) -> Solutions<T, $n> {
                    solutions!(self, pose, elbow, $n)
                }
            }
        )*
    };
}
for_each_arm!(inverses);

/// Numbers of a reproducible sequence from -1 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 11) as f64) / (1u64 << 52) as f64 - 1.0
    }
}

fn survey<const N: usize, A: Inverse<N>>(arm: &A, count: usize) {
    let mut random = Random(7);
    let (mut lost, mut worst_residual, mut none) = (0, 0.0_f64, 0);
    let mut worst = [0.0_f64; 4];
    let mut total = 0;
    for _ in 0..count {
        let q = SVector::<f64, N>::from_fn(|_, _| 3.1 * random.next());
        let pose = arm.pose(&q);
        let solutions = arm.solutions(&pose, arm.elbow(&q));
        total += solutions.len();
        let singular = robot_dynamics::nalgebra::DMatrix::from_iterator(6, N, arm.jacobian(&q).iter().copied());
        let singular = if N <= 3 { singular.rows(0, 3).into_owned() } else { singular };
        let least = singular.svd(false, false).singular_values[N.min(6).min(if N <= 3 { 3 } else { 6 }) - 1];
        let distance = |other: &SVector<f64, N>| {
            (0..N).map(|i| {
                let d = (other[i] - q[i]).abs();
                d.min((d - std::f64::consts::TAU).abs())
            }).fold(0.0, f64::max)
        };
        let nearest = solutions.iter().map(|s| distance(&s.q)).fold(f64::INFINITY, f64::min);
        if solutions.is_empty() { none += 1; }
        if nearest > 1e-6 { lost += 1; if lost < 3 { println!("   lost {q:?} {least:e} {nearest:e} {:?}", solutions.as_slice()); } }
        let class = if least > 1e-1 { 0 } else if least > 1e-2 { 1 } else if least > 1e-3 { 2 } else { 3 };
        worst[class] = worst[class].max(nearest);
        for s in &solutions {
            let reached = arm.pose(&s.q);
            let d = (reached - pose).abs();
            let residual = if N <= 3 && A::NAME != "RrrPlanar" { d.fixed_view::<3, 1>(0, 3).max() } else { d.max() };
            if residual > 1e-14 && A::NAME == "Iiwa14" { println!("{residual:e} {} {d:.1e} {:?} {}", s.q.transpose(), q.transpose(), s.is_singular); }
            worst_residual = worst_residual.max(residual);
        }
    }
    println!("{}: none {none} lost {lost} solutions {:.3} residual {worst_residual:e} angles {worst:?}", A::NAME, total as f64 / count as f64);
}

#[test]
fn survey_all() {
    macro_rules! all {
        ($($name:ident: $n:literal,)*) => { $( survey::<$n, _>(&$name, 10_000); )* };
    }
    for_each_arm!(all);
}
