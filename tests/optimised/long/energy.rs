//! The energy of motions of a million steps.

use robot_dynamics::nalgebra::{SMatrix, SVector, Vector1};
use robot_dynamics::{
    ForwardDynamics, InverseDynamics, MassMatrix, Method, Scalar, Simulation, SingularMassMatrix,
    Trajectory, robot_dynamics, simulation::Momenta,
};

robot_dynamics! {
    /// A slender rod of 1 kg and 1 m, which hangs at q = 0.
    struct OneLink;

    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [link: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) }],
    functions: [default],
}

robot_dynamics! {
    /// Slender rods of 3 kg and 2 m, and of 1 kg and 1 m, the first horizontal at q = 0.
    struct TwoLink;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        first: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        second: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [default],
}

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

/// The energy that the two links exchange between kinetic and potential, J.
const EXCHANGED: f64 = 54.0;

/// The fall of the two links from the horizontal.
fn fall(arm: &impl ForwardDynamics<2>, method: Method, duration: f64) -> Trajectory<2> {
    let run = Simulation::new(arm).duration(duration).samples(1001);
    run.method(method).run().unwrap()
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
