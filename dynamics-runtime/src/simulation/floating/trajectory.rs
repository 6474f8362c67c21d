//! The motion of a robot on a base that moves.

use nalgebra::Const;

use crate::Pose;
use crate::equations_of_motion::SizedModel;
use crate::simulation::Work;
use crate::simulation::trajectory::drift;
use crate::size::Size;
use crate::stand::OnBase;

/// A sampled motion on a base that moves: sample k is `(t[k], base[k], q[k], v[k])`, with the accelerations `a[k]` and the forces
/// `tau[k]` there. Velocities, accelerations and forces have the six numbers of the base first, in its own axes.
///
/// Velocities, accelerations and forces that jump at the time of a sample are those after it. The first sample is the
/// initial state as it was given.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound = "")
)]
#[non_exhaustive]
pub struct SizedFloatingTrajectory<D: Size, V: Size> {
    /// Times, s.
    pub t: Vec<f64>,
    /// Where the base stands. Rotations are within 1e-15 of orthogonal, however long the run.
    pub base: Vec<Pose<f64>>,
    /// Joint positions, rad or m.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub q: Vec<D::Vector>,
    /// Velocities, m/s and rad/s.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub v: Vec<V::Vector>,
    /// Accelerations under all forces that act, the rates of the velocities; NaN where they could not be computed.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub a: Vec<V::Vector>,
    /// Forces on the base and of the motors, as the law returns them, N and N m. They do not include forces at frames.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub tau: Vec<V::Vector>,
    /// The work of the run.
    pub work: Work,
}

/// The sampled motion of a robot of `N` joints on a base that moves; `V` is 6 + N.
pub type FloatingTrajectory<const N: usize, const V: usize> =
    SizedFloatingTrajectory<Const<N>, Const<V>>;

/// A sample of a motion on a base that moves.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FloatingSample<D: Size, V: Size> {
    /// The time, s.
    pub t: f64,
    /// Where the base stands.
    pub base: Pose<f64>,
    /// Joint positions, rad or m.
    pub q: D::Vector,
    /// Velocities, m/s and rad/s.
    pub v: V::Vector,
    /// Accelerations; NaN where the trajectory has none.
    pub a: V::Vector,
    /// Forces on the base and of the motors, N and N m; NaN where the trajectory has none.
    pub tau: V::Vector,
}

impl<D: Size, V: Size> Default for SizedFloatingTrajectory<D, V> {
    fn default() -> Self {
        SizedFloatingTrajectory {
            t: Vec::new(),
            base: Vec::new(),
            q: Vec::new(),
            v: Vec::new(),
            a: Vec::new(),
            tau: Vec::new(),
            work: Work::default(),
        }
    }
}

impl<D: Size, V: Size> SizedFloatingTrajectory<D, V> {
    /// The number of samples.
    pub fn len(&self) -> usize {
        self.t.len()
    }

    /// Whether there is no sample.
    pub fn is_empty(&self) -> bool {
        self.t.is_empty()
    }

    /// The samples, one after the other. There are as many as the shortest of the lists `t`, `base`, `q` and `v` has.
    pub fn samples(
        &self,
    ) -> impl DoubleEndedIterator<Item = FloatingSample<D, V>> + ExactSizeIterator {
        let places = self.base.iter().zip(&self.q).zip(&self.v);
        (0..self.t.len().min(places.len())).map(|k| {
            let v = self.v[k].clone();
            let unknown = || V::of(&v).vector_of(|_| f64::NAN);
            let [a, tau] =
                [&self.a, &self.tau].map(|list| list.get(k).cloned().unwrap_or_else(unknown));
            let (t, base, q) = (self.t[k], self.base[k], self.q[k].clone());
            FloatingSample {
                t,
                base,
                q,
                v,
                a,
                tau,
            }
        })
    }

    /// The last sample; `None` where there is none.
    pub fn last(&self) -> Option<FloatingSample<D, V>> {
        self.samples().next_back()
    }
}

impl<D: Size, V: Size> SizedFloatingTrajectory<D, V> {
    /// Kinetic plus potential energy at every sample, J; NaN for a robot without both functions.
    pub fn energies<R: SizedModel<OnBase<D, V>>>(&self, robot: &R) -> Vec<f64> {
        let places = self.base.iter().zip(&self.q).zip(&self.v);
        let energies = places.map(|(place, v)| robot.sized_energies(place, v));
        let sum = |[kinetic, potential]: [f64; 2]| kinetic + potential;
        energies.map(|both| both.map_or(f64::NAN, sum)).collect()
    }

    /// The largest distance of the energy from that of the first sample, J; 0 without samples, NaN where an energy is not a
    /// number. In free motion without friction it is an error of the integration.
    pub fn energy_drift<R: SizedModel<OnBase<D, V>>>(&self, robot: &R) -> f64 {
        drift(&self.energies(robot))
    }
}
