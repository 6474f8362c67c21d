//! A simulation allocates its samples at the start and nothing while it runs; a batch nothing.

use allocation_counter::measure;
use robot_dynamics::nalgebra::{SMatrix, SVector, Vector1};
use robot_dynamics::{
    Batch, Certified, Cycloidal, ForwardDynamics, Friction, InverseDynamics, MassMatrix, Method,
    Model, Scalar, Simulation, SingularMassMatrix, certified,
    simulation::{Dop853, DormandPrince, Momenta, Radau5},
    table::{Convention, JointType, Row, Table},
};

/// A pendulum with dry friction.
struct Pendulum(f64);

impl ForwardDynamics<1> for Pendulum {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 1>,
        qd: &SVector<T, 1>,
        tau: &SVector<T, 1>,
    ) -> Result<SVector<T, 1>, SingularMassMatrix> {
        let (sin, _) = q[0].sin_cos();
        Ok(Vector1::new(
            tau[0] - sin - T::from_f64(self.0) * qd[0].sign(),
        ))
    }

    fn momenta(&self) -> Option<&dyn Momenta<1>> {
        Some(self)
    }
}

impl MassMatrix<1> for Pendulum {
    fn mass_matrix<T: Scalar>(&self, _: &SVector<T, 1>) -> SMatrix<T, 1, 1> {
        SMatrix::<T, 1, 1>::new(T::from_f64(1.0))
    }
}

impl InverseDynamics<1> for Pendulum {
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 1>,
        qd: &SVector<T, 1>,
        qdd: &SVector<T, 1>,
    ) -> SVector<T, 1> {
        let (sin, _) = q[0].sin_cos();
        Vector1::new(qdd[0] + sin + T::from_f64(self.0) * qd[0].sign())
    }
}

fn allocations(method: Method) -> u64 {
    let simulation = Simulation::new(&Pendulum(0.0))
        .initial(Vector1::new(1.0), Vector1::new(0.0))
        .torque(|_, _, qd| -qd * 0.1)
        .method(method)
        .samples(11);
    let mut samples = 0;
    let info = measure(|| samples = simulation.run().unwrap().len());
    assert_eq!(samples, 11);
    info.count_total
}

impl Model<1> for Pendulum {
    const JOINT_NAMES: [&'static str; 1] = ["swing"];

    fn table(&self) -> Table<1> {
        let row = Row {
            coulomb: [self.0; 2],
            limits: Some([-0.5, 0.1]),
            ..Row::new(JointType::Revolute)
        };
        Table::new(Convention::Modified, [0.0; 3], [row])
    }
}

/// Stopping, sticking and letting go under a torque that grows.
#[test]
fn events_of_friction_do_not_allocate() {
    let step = 1e-2;
    for method in [
        Method::RungeKutta4 { step },
        Method::GaussLegendre4 { step },
        DormandPrince::default().into(),
        Dop853::default().into(),
        Radau5::default().into(),
    ] {
        let simulation = Simulation::new(&Pendulum(0.1))
            .torque(|t, q, _| q.map(f64::sin).add_scalar(0.3 * (8.0 * t).sin()))
            .friction(Friction::Sticking)
            .method(method);
        let mut stuck = 0;
        let info = measure(|| {
            let run = simulation.run().unwrap();
            stuck = run.qd.iter().filter(|qd| qd[0] == 0.0).count();
        });
        assert!((5..95).contains(&stuck), "{method:?}: {stuck}");
        assert_eq!(info.count_total, LISTS, "{method:?}");
    }
}

/// Times, positions, velocities, accelerations, torques, however many steps there are.
const LISTS: u64 = 5;

#[test]
fn a_run_allocates_its_samples_only() {
    for step in [0.1, 1e-3] {
        assert_eq!(allocations(Method::ExplicitEuler { step }), LISTS);
        assert_eq!(allocations(Method::CraigEuler { step }), LISTS);
        assert_eq!(allocations(Method::SemiImplicitEuler { step }), LISTS);
        assert_eq!(allocations(Method::RungeKutta4 { step }), LISTS);
        assert_eq!(allocations(Method::ImplicitMidpoint { step }), LISTS);
        assert_eq!(allocations(Method::GaussLegendre4 { step }), LISTS);
        assert_eq!(allocations(Method::GaussLegendre6 { step }), LISTS);
    }
    for tolerance in [1e-3, 1e-12] {
        let settings = DormandPrince::with_tolerance(tolerance);
        assert_eq!(allocations(settings.into()), LISTS);
        assert_eq!(allocations(Dop853::with_tolerance(tolerance).into()), LISTS);
        assert_eq!(allocations(Radau5::with_tolerance(tolerance).into()), LISTS);
    }
}

/// Bounces on a stop under a law that is sampled.
#[test]
fn impacts_and_samples_of_a_law_do_not_allocate() {
    for method in [
        Method::RungeKutta4 { step: 1e-2 },
        Method::GaussLegendre4 { step: 1e-2 },
        Dop853::default().into(),
        Radau5::default().into(),
    ] {
        let mut calls = 0;
        let mut simulation = Simulation::new(&Pendulum(0.0))
            .initial(Vector1::new(-0.5), Vector1::new(0.0))
            .control_period(0.1)
            .torque(|_, _, qd| {
                calls += 1;
                qd * 0.1
            })
            .stops(0.7)
            .duration(10.0)
            .method(method);
        let mut least = 0.0;
        let info = measure(|| {
            let run = simulation.run().unwrap();
            least = run.q.iter().map(|q| q[0]).fold(0.0, f64::min);
        });
        assert_eq!(info.count_total, LISTS, "{method:?}");
        assert!(calls == 100 && least >= -0.5, "{calls} {least}");
    }
}

#[test]
fn the_cycloidal_law_does_not_allocate() {
    let law = Cycloidal::new(Vector1::new(0.0), Vector1::new(1.0), 2.0).unwrap();
    let mut state = law.at(0.0);
    let info = measure(|| state = law.at(0.5));
    assert_eq!(info.count_total, 0);
    assert!(state.q[0] > 0.0);
}

#[test]
fn a_batch_does_not_allocate() {
    for count in [0, 3, 8, 100] {
        let [q, qd, tau] = [0.1, 0.2, 0.3].map(|x| vec![Vector1::new(x); count]);
        let mut qdd = vec![Vector1::new(0.0); count];
        let rows = measure(|| {
            let batch = Pendulum(0.0).forward_dynamics_batch(&q, &qd, &tau, &mut qdd);
            batch.unwrap();
        });
        assert_eq!(rows.count_total, 0, "{count} states");
        let [q, qd, tau] = [0.1, 0.2, 0.3].map(|x| vec![x; count]);
        let mut column = vec![0.0; count];
        let columns = measure(|| {
            let (q, qd, tau) = ([&q[..]], [&qd[..]], [&tau[..]]);
            let batch = Pendulum(0.0).forward_dynamics_batch(q, qd, tau, [&mut column[..]]);
            batch.unwrap();
        });
        assert_eq!(columns.count_total, 0, "{count} states");
        assert!(qdd.iter().zip(&column).all(|(a, b)| a[0] == *b));
    }
}

/// The measure itself: it sees an allocation.
#[test]
fn an_allocation_is_counted() {
    let info = measure(|| drop(std::hint::black_box(vec![1.0; 10])));
    assert_eq!(info.count_total, 1);
}

#[test]
fn bounds_by_residuals_allocate_nothing() {
    let [q, qd, tau] = [0.3, 0.5, -2.0].map(|x| Vector1::new(Certified::exact(x)));
    let mut found = None;
    let info = measure(|| found = certified::forward_dynamics(&Pendulum(0.2), &q, &qd, &tau).ok());
    assert_eq!(info.count_total, 0);
    let found = found.expect("regular")[0];
    assert!(found.bound() > 0.0 && found.bound() < 1e-15, "{found}");
}
