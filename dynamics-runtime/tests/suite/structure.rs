//! Energy in long runs: methods that preserve the structure of a motion, and those that do not.

use dynamics_runtime::nalgebra::{SMatrix, SVector, Vector1};
use dynamics_runtime::{
    ForwardDynamics, InverseDynamics, MassMatrix, Method, Momenta, Scalar, Simulation,
    SingularMassMatrix, Trajectory,
};

use crate::arms::{OneLink, TwoLink};

/// An arm whose velocities stand in for its momenta: a method that is symplectic in (q, p) then
/// works in (q, qd).
struct InVelocities<'a, R>(&'a R);

impl<R, const N: usize> MassMatrix<N> for InVelocities<'_, R> {
    fn mass_matrix<T: Scalar>(&self, _: &SVector<T, N>) -> SMatrix<T, N, N> {
        SMatrix::from_fn(|i, j| T::from_f64(f64::from(u8::from(i == j))))
    }
}

impl<R: ForwardDynamics<N>, const N: usize> InverseDynamics<N> for InVelocities<'_, R> {
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        _: &SVector<T, N>,
    ) -> SVector<T, N> {
        let free = SVector::from_fn(|_, _| T::from_f64(0.0));
        let qdd = self.0.forward_dynamics(q, qd, &free).unwrap();
        qdd.map(|entry| -entry)
    }
}

impl<R: ForwardDynamics<N>, const N: usize> ForwardDynamics<N> for InVelocities<'_, R> {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<SVector<T, N>, SingularMassMatrix> {
        self.0.forward_dynamics(q, qd, tau)
    }

    fn momenta(&self) -> Option<&dyn Momenta<N>> {
        Some(self)
    }
}

/// What the two links exchange between kinetic and potential energy, J.
const EXCHANGED: f64 = 54.0;

/// The fall of the two links from the horizontal.
fn fall(arm: &impl ForwardDynamics<2>, method: Method, duration: f64) -> Trajectory<2> {
    let run = Simulation::new(arm).duration(duration).samples(1001);
    run.method(method).run().unwrap()
}

/// Semi-implicit Euler is symplectic where M is constant: the energy of one link stays near. That of
/// an arm does not, or the arm flies away: which of both hangs on the last digit.
#[test]
fn semi_implicit_euler_does_not_keep_the_energy_of_an_arm() {
    let method = Method::SemiImplicitEuler { step: 0.01 };
    let two = Simulation::new(&TwoLink).duration(100.0).method(method);
    let drift = match two.run() {
        Ok(run) => run.energy_drift(&TwoLink),
        Err(error) => error.trajectory.energy_drift(&TwoLink),
    };
    assert!(drift > 0.3 * EXCHANGED, "{drift} J");

    let one = Simulation::new(&OneLink).initial(Vector1::new(2.0), Vector1::new(0.0));
    let run = one.duration(100.0).method(method).run().unwrap();
    let drift = run.energy_drift(&OneLink);
    assert!(drift < 0.03 * 9.81, "{drift} J");
}

/// Twenty seconds of chaos; errors are those of the steps, and do not grow.
#[test]
fn structure_preserving_methods_keep_the_energy() {
    let step = 0.01;
    for (method, bound) in [
        (Method::ImplicitMidpoint { step }, 4e-3),
        (Method::GaussLegendre4 { step }, 5e-6),
        (Method::GaussLegendre6 { step }, 2e-8),
    ] {
        let run = fall(&TwoLink, method, 20.0);
        let drift = run.energy_drift(&TwoLink) / EXCHANGED;
        assert!(drift < bound, "{method:?}: {drift:e}");
    }
}

/// The furthest that the energy, averaged over each twentieth of a run, is from where it was, over
/// what is exchanged. The average takes out what comes back.
fn wandering(arm: &impl ForwardDynamics<2>, method: Method, duration: f64) -> f64 {
    let energies = fall(arm, method, duration).energies(&TwoLink);
    let means = energies[1..]
        .chunks(50)
        .map(|part| part.iter().sum::<f64>() / 50.0);
    means.fold(0.0, |furthest: f64, mean| furthest.max(mean.abs())) / EXCHANGED
}

/// A million steps: in (q, p) the energy comes back, in (q, qd) the same method walks away from it.
#[test]
#[ignore = "5 s in a release build"]
fn energy_walks_away_in_velocities_and_not_in_momenta() {
    let method = Method::GaussLegendre4 { step: 0.01 };
    let in_momenta = wandering(&TwoLink, method, 1e4);
    assert!(in_momenta < 3e-7, "{in_momenta:e}");
    let in_velocities = wandering(&InVelocities(&TwoLink), method, 1e4);
    assert!(in_velocities > 5e-7, "{in_velocities:e}");
}

/// A swing of 2 rad for 10^4 s in a million steps: what remains is rounding.
#[test]
#[ignore = "1 s in a release build"]
fn a_million_steps_of_gauss_legendre_6_keep_the_energy() {
    let method = Method::GaussLegendre6 { step: 0.01 };
    let one = Simulation::new(&OneLink).initial(Vector1::new(2.0), Vector1::new(0.0));
    let run = one
        .duration(1e4)
        .samples(1001)
        .method(method)
        .run()
        .unwrap();
    let drift = run.energy_drift(&OneLink) / 9.81;
    assert!(drift < 1e-12, "{drift:e}");
}
