//! Every function of some arms beside the same program in 31 digits, constants as they are written.

use super::{Certified, DoubleDouble, Ratios, State, exactly};
use robot_dynamics::nalgebra::{SMatrix, SVector, Vector6};
use robot_dynamics::{Scalar, SingularMassMatrix};
use robots::*;
use testkit::random::Random;

type Double = Certified<f64>;
type Single = Certified<f32>;

/// Numbers in some shape.
trait Numbers {
    type Number;

    fn tell(&self, tell: &mut dyn FnMut(Self::Number));
}

macro_rules! of_one_shape {
    ($([$($generic:tt)*] $shape:ty: $number:ty, |$value:ident, $tell:ident| $do:expr;)*) => {$(
        impl<$($generic)*> Numbers for $shape {
            type Number = $number;

            fn tell(&self, $tell: &mut dyn FnMut(Self::Number)) {
                let $value = self;
                $do;
            }
        }
    )*};
}

of_one_shape! {
    [] Double: Double, |value, tell| tell(*value);
    [] Single: Single, |value, tell| tell(*value);
    [] DoubleDouble: DoubleDouble, |value, tell| tell(*value);
    [T: Numbers + Scalar, const R: usize, const C: usize] SMatrix<T, R, C>: T::Number,
        |value, tell| value.iter().for_each(|x| x.tell(tell));
    [V: Numbers, const K: usize] [V; K]: V::Number, |value, tell| value.iter().for_each(|x| x.tell(tell));
    [V: Numbers] Result<V, SingularMassMatrix>: V::Number,
        |value, tell| value.as_ref().expect("regular").tell(tell);
    [A: Numbers, B: Numbers<Number = A::Number>] (A, B): A::Number, |value, tell| {
        value.0.tell(tell);
        value.1.tell(tell);
    };
    [A: Numbers, B: Numbers<Number = A::Number>, C: Numbers<Number = A::Number>] (A, B, C): A::Number,
        |value, tell| {
            value.0.tell(tell);
            value.1.tell(tell);
            value.2.tell(tell);
        };
    [A: Numbers, B: Numbers<Number = A::Number>, C: Numbers<Number = A::Number>,
        D: Numbers<Number = A::Number>] (A, B, C, D): A::Number, |value, tell| {
            value.0.tell(tell);
            value.1.tell(tell);
            value.2.tell(tell);
            value.3.tell(tell);
        };
}

fn all<V: Numbers>(value: V) -> Vec<V::Number> {
    let mut numbers = Vec::new();
    value.tell(&mut |x| numbers.push(x));
    numbers
}

/// The numbers of every function of an arm, with its name.
macro_rules! values {
    ({ $arm:ident, $at:ident, $number:ident } $($name:ident [$($argument:ident),*])*) => {
        [$((stringify!($name), all($arm.$name::<$number>($($at.$argument),*)))),*]
    };
}

/// The same in one kind of numbers, made of doubles by a function.
macro_rules! functions {
    ($robot:ident, $n:literal, $number:ident, $state:ident, $from:expr) => {{
        let (arm, from) = ($robot, $from);
        let State { q, qd, qdd } = &$state;
        let [q, qd, qdd]: [SVector<_, $n>; 3] = [q, qd, qdd].map(from);
        let wrench: Vector6<_> = Vector6::repeat(qdd[0]);
        let at = Arguments {
            q: &q,
            qd: &qd,
            qdd: &qdd,
            tau: &qdd,
            qd_r: &qd,
            qdd_r: &qdd,
            jerk: &qd,
            snap: &qdd,
            wrench: &wrench,
            order: 6,
        };
        each_function! { values { arm, at, $number } }
    }};
}

macro_rules! every_function {
    ($($test:ident: $robot:ident, $n:literal, $number:ident;)*) => {$(
        #[test]
        fn $test() {
            let mut random = Random::seeded(29);
            let mut means: Vec<(&str, Ratios)> = Vec::new();
            for number in 0..16 {
                let state = State::<$n>::random(&mut random, number).in_single_precision();
                let found = functions!($robot, $n, $number, state, exactly);
                let exact = functions!($robot, $n, DoubleDouble, state, |x: &SVector<f64, $n>| {
                    x.map(DoubleDouble::from)
                });
                means.resize(found.len(), ("", Ratios::default()));
                for ((mean, found), exact) in means.iter_mut().zip(&found).zip(&exact) {
                    let size = exact.1.iter().map(|x| x.high().abs()).fold(0.0, f64::max);
                    assert_eq!(found.1.len(), exact.1.len());
                    mean.0 = found.0;
                    mean.1.add(&found.1, &exact.1, size);
                }
            }
            for (name, ratios) in &means {
                println!("{name:38} {:.4} in the mean, {:.3} at most", ratios.mean(), ratios.largest);
            }
            let of_all: f64 = means.iter().map(|(_, ratios)| ratios.mean()).sum();
            let of_all = of_all / means.len() as f64;
            println!("{of_all:.4} in the mean of all functions");
            assert!(of_all >= super::LEAST_MEAN);
        }
    )*};
}

every_function! {
    tilting_cell: TiltingCell, 4, Double;
    sprung_arm: SprungArm, 3, Double;
    sprung_arm_in_single_precision: SprungArm, 3, Single;
    puma560: Puma560, 6, Double;
    stanford: Stanford, 6, Double;
}
