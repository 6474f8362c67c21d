//! The values of all generated functions at a state.

mod value;

use std::collections::BTreeMap;

use nalgebra::{Matrix3, SVector, Vector3, Vector6};

use crate::function::functions;
use crate::{FloatingState, Model, Pose, Scalar, SingularMassMatrix, State};

pub(crate) use value::read;
pub use value::{FunctionValue, Numbers, flat};

/// A trait of robots with so many joints and velocities, which evaluate their functions at such states.
macro_rules! evaluate {
    ($(#[$text:meta])* $name:ident<$($size:ident),+>, $state:ty, $v:ident) => {
        $(#[$text])*
        pub trait $name<$(const $size: usize),+>: Model<$($size),+> {
            /// Every function at one state; without a value where the function was not generated.
            ///
            /// `tau` are the forces at which the forward dynamics is evaluated. By default, the values are those of
            #[doc = concat!("[`evaluate_in`](", stringify!($name), "::evaluate_in): a robot of your own implements one of the two.")]
            fn evaluate(&self, state: &$state, tau: &SVector<f64, $v>) -> Evaluation {
                self.evaluate_in(state, tau, |x| x)
            }

            /// The same in the arithmetic `T`; `real` turns the doubles of the state into its numbers. In
            /// [`Certified`](crate::Certified) numbers the values carry bounds of their rounding errors.
            ///
            /// Generated robots implement it. By default, no function has a value.
            fn evaluate_in<T: Scalar>(
                &self,
                state: &$state,
                tau: &SVector<f64, $v>,
                real: fn(f64) -> T,
            ) -> Evaluation<T> {
                let _ = (state, tau, real);
                Evaluation::default()
            }

            /// Calls `found` for each method that returns several functions, with its name and the values of these
            /// functions at one state.
            fn evaluate_parts(
                &self,
                state: &$state,
                tau: &SVector<f64, $v>,
                found: &mut dyn FnMut(&str, Evaluation),
            ) {
                let _ = (state, tau, found);
            }
        }
    };
}

evaluate! {
    /// An arm that evaluates all of its generated functions at a state, as the checks need it.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` is no robot that `robot_dynamics!` made",
        note = "checks compare what the macro generated with the table that it was generated from"
    )]
    Evaluate<N>, State<N>, N
}

evaluate! {
    /// A robot on a base that moves that evaluates all of its generated functions at a state, as the checks need it. `V` is
    /// 6 + N.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` is no robot with `base: floating` that `robot_dynamics!` made",
        note = "checks compare what the macro generated with the table that it was generated from"
    )]
    FloatingEvaluate<N, V>, FloatingState<N, V>, V
}

/// The arguments of the generated functions at one state, by the names that the methods give them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Arguments<const N: usize, T: Scalar, const V: usize = N> {
    pub base: Pose<T>,
    pub q: SVector<T, N>,
    pub qd: SVector<T, V>,
    pub qdd: SVector<T, V>,
    pub tau: SVector<T, V>,
    pub qd_r: SVector<T, V>,
    pub qdd_r: SVector<T, V>,
    pub jerk: SVector<T, V>,
    pub snap: SVector<T, V>,
    pub wrench: Vector6<T>,
    pub order: usize,
}

/// The arguments of a robot on a base that moves.
#[doc(hidden)]
pub type FloatingArguments<const N: usize, const V: usize, T> = Arguments<N, T, V>;

impl<const N: usize, const V: usize, T: Scalar> Arguments<N, T, V> {
    /// The arguments at a state, in numbers that `real` makes of the state's.
    pub fn new<S>(state: &S, tau: &SVector<f64, V>, real: fn(f64) -> T) -> Self
    where
        S: Copy + Into<FloatingState<N, V>>,
    {
        let state: FloatingState<N, V> = (*state).into();
        let motion = state.motion();
        Arguments {
            base: Pose {
                rotation: Matrix3::from_fn(|i, j| real(state.base.rotation[(i, j)])),
                position: Vector3::from_fn(|i, _| real(state.base.position[i])),
            },
            q: state.q.map(real),
            qd: state.v.map(real),
            qdd: state.a.map(real),
            tau: tau.map(real),
            qd_r: motion.reference_velocity().map(real),
            qdd_r: motion.reference_acceleration().map(real),
            jerk: motion.jerk().map(real),
            snap: motion.snap().map(real),
            wrench: State::<V>::wrench().map(real),
            // The order of a Taylor series: accelerations and jerks are compared.
            order: 3,
        }
    }
}

/// Values of the generated functions at one state, by the names of the functions.
///
/// ```
/// use robot_dynamics::nalgebra::{SMatrix, SVector, Vector1};
/// use robot_dynamics::{SingularMassMatrix, State, robot_dynamics, check::Evaluate};
///
/// robot_dynamics! {
///     struct Pendulum;
///     convention: modified,
///     gravity: [9.81, 0, 0],
///     joints: [pivot: revolute { mass: 2, com: [3, 0, 0] }],
/// }
///
/// let state = State { q: Vector1::new(0.3), qd: Vector1::zeros(), qdd: Vector1::zeros() };
/// let values = Pendulum.evaluate(&state, &Vector1::new(36.0));
/// let mass_matrix: SMatrix<f64, 1, 1> = values.get("mass_matrix").expect("it was generated");
/// assert!((mass_matrix[0] - 18.0).abs() < 1e-12);
/// assert_eq!(values.get::<f64>("kinetic_energy"), Some(0.0));
/// // It was not requested.
/// assert_eq!(values.get::<SMatrix<f64, 6, 1>>("jacobian"), None);
/// // A function that solves with M may refuse.
/// let qdd: Option<Result<SVector<f64, 1>, SingularMassMatrix>> = values.get("forward_dynamics");
/// assert!(qdd.expect("it was generated").is_ok());
/// ```
///
/// Besides the functions there are four forms that two functions make together, if both were generated:
///
/// - `configuration_space_form`, the velocity terms `coriolis_coefficients [qd qd] + centrifugal_coefficients [qd^2]`;
/// - `regressor_form`, `regressor` times `base_parameters`;
/// - `passivity_form`, `passivity_regressor` times `base_parameters`;
/// - `energies_form`, each of the `energy_regressors` times `base_parameters`.
#[derive(Clone, Debug)]
pub struct Evaluation<T: Scalar = f64> {
    /// The numbers of each value, matrices by columns, or why there is none.
    values: BTreeMap<&'static str, Result<Vec<T>, SingularMassMatrix>>,
    /// The values of functions at frames, by the name of the frame in methods and its place in the table.
    frames: BTreeMap<(String, usize), Evaluation<T>>,
}

/// The values that two functions make together.
pub const FORMS: [&str; 4] = [
    "configuration_space_form",
    "regressor_form",
    "passivity_form",
    "energies_form",
];

/// Without any value.
impl<T: Scalar> Default for Evaluation<T> {
    fn default() -> Self {
        Evaluation {
            values: BTreeMap::new(),
            frames: BTreeMap::new(),
        }
    }
}

impl<T: Scalar> Evaluation<T> {
    /// The value of a function or a form, as its method returns it: a number, a matrix, an array or a tuple. `Vec`
    /// stands for an array or for columns whose number need not be known: the `regressor` is a `Vec<SVector<f64, N>>`
    /// too. A function at a frame has the name of its method, `jacobian_left_hand`. `None` if there is no value. A function that solves with M has a `Result`; without it, a refusal is `None`.
    ///
    /// # Panics
    ///
    /// If no function has this name, or if its value has another number of entries.
    #[track_caller]
    pub fn get<V: FunctionValue<T>>(&self, name: &str) -> Option<V> {
        let found = self.of_frame(name);
        let entries = match found.or_else(|| self.entries(known(name)))? {
            Ok(entries) => entries,
            Err(error) => return V::refused(*error),
        };
        let value = read(entries);
        assert!(
            value.is_some(),
            "`{name}` has {} numbers here, which are no `{}`",
            entries.len(),
            core::any::type_name::<V>(),
        );
        value
    }

    /// Gives a function or a form a value, in place of the one that it had.
    ///
    /// # Panics
    ///
    /// If no function has this name.
    #[track_caller]
    pub fn set(&mut self, name: &str, value: impl FunctionValue<T>) {
        let entries = match value.refusal() {
            Some(error) => Err(error),
            None => Ok(flat(&value)),
        };
        self.values.insert(known(name), entries);
    }

    /// Takes the value of a function or a form away.
    ///
    /// # Panics
    ///
    /// If no function has this name.
    #[track_caller]
    pub fn remove(&mut self, name: &str) {
        self.values.remove(known(name));
    }

    /// The numbers of a value, matrices by columns.
    #[doc(hidden)]
    pub fn entries(&self, name: &str) -> Option<&Result<Vec<T>, SingularMassMatrix>> {
        self.values.get(name)
    }

    /// With the forms, where both functions have a value. `qd` are the joint velocities.
    #[doc(hidden)]
    #[must_use]
    pub fn combined(mut self, qd: &[T]) -> Self {
        let forms = [
            self.configuration_space_form(qd),
            self.times_parameters("regressor", qd.len()),
            self.times_parameters("passivity_regressor", qd.len()),
            self.energies_form(),
        ];
        for (name, form) in FORMS.into_iter().zip(forms) {
            if let Some(entries) = form {
                self.set(name, entries);
            }
        }
        self
    }

    /// The values at a frame: the name that it has in methods, and its place among the frames of the table.
    #[doc(hidden)]
    pub fn at_frame(&mut self, name: &str, frame: usize) -> &mut Self {
        self.frames.entry((name.to_owned(), frame)).or_default()
    }

    /// The values at all frames, with the names and the places of these.
    #[doc(hidden)]
    pub fn at_frames(&self) -> impl Iterator<Item = (&str, usize, &Self)> {
        let frames = self.frames.iter();
        frames.map(|((name, frame), values)| (name.as_str(), *frame, values))
    }

    /// The numbers of a function at a frame, by the name of its method.
    fn of_frame(&self, method: &str) -> Option<&Result<Vec<T>, SingularMassMatrix>> {
        self.at_frames().find_map(|(frame, _, values)| {
            let function = method.strip_suffix(frame)?.strip_suffix('_')?;
            values.values.get(function)
        })
    }

    fn numbers(&self, name: &str) -> Option<&[T]> {
        self.entries(name)?.as_deref().ok()
    }

    /// `B [qd qd] + C [qd^2]` (Craig, Introduction to Robotics, 3rd ed., equation 6.63): `[qd qd]` holds the products in
    /// the order (1,2), (1,3), ..., (n-1,n).
    fn configuration_space_form(&self, qd: &[T]) -> Option<Vec<T>> {
        let n = qd.len();
        let products = (0..n).flat_map(|i| (i + 1..n).map(move |j| qd[i] * qd[j]));
        let coriolis = sum_of_columns(self.numbers("coriolis_coefficients")?, n, products);
        let squares = qd.iter().map(|x| *x * *x);
        let centrifugal = sum_of_columns(self.numbers("centrifugal_coefficients")?, n, squares);
        Some(
            coriolis
                .into_iter()
                .zip(centrifugal)
                .map(|(a, b)| a + b)
                .collect(),
        )
    }

    /// A regressor of so many rows times the base parameters.
    fn times_parameters(&self, regressor: &str, rows: usize) -> Option<Vec<T>> {
        let parameters = self.numbers("base_parameters")?;
        let regressor = self.numbers(regressor)?;
        Some(sum_of_columns(regressor, rows, parameters.iter().copied()))
    }

    /// Kinetic and potential energy: each regressor is a row of its own.
    fn energies_form(&self) -> Option<Vec<T>> {
        let parameters = self.numbers("base_parameters")?;
        let regressors = self.numbers("energy_regressors")?;
        let (kinetic, potential) = regressors.split_at(regressors.len() / 2);
        let energy = |regressor| sum_of_columns(regressor, 1, parameters.iter().copied());
        Some([energy(kinetic), energy(potential)].concat())
    }
}

/// The name as the table of functions, or that of the forms, has it.
#[track_caller]
fn known(name: &str) -> &'static str {
    let mut names = functions::NAMES.iter().chain(&FORMS);
    match names.find(|known| **known == name) {
        Some(known) => known,
        None => panic!("`{name}` is not the name of a function"),
    }
}

/// The sum of columns of so many rows, each times its factor.
fn sum_of_columns<T: Scalar>(
    columns: &[T],
    rows: usize,
    factors: impl Iterator<Item = T>,
) -> Vec<T> {
    let mut sum = vec![T::from_f64(0.0); rows];
    for (column, x) in columns.chunks_exact(rows.max(1)).zip(factors) {
        for (sum, entry) in sum.iter_mut().zip(column) {
            *sum = *sum + *entry * x;
        }
    }
    sum
}
