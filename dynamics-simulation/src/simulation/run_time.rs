//! Simulations of robots that are known at run time: whether the base moves is a matter of the place.

use dynamics_runtime::Place;
use nalgebra::{DVector, Dyn, Matrix4, Matrix6xX, Vector6};

use super::wrench::HeldWrench;
use super::{Sampled, Simulation, WithoutPeriod, WrenchAt};

/// Laws of a robot that is known at run time are given its place: q, and the pose of a base that moves. Velocities,
/// accelerations and forces have the six numbers of such a base first.
impl<'a, R: 'a, L, S> Simulation<'a, R, L, Dyn, S> {
    /// The place and the velocities at t = 0; m, rad, and per second. A base that moves begins in the world's frame if the
    /// place has no pose; a pose of a base that stands is not read.
    pub fn initial(self, place: Place<Dyn>, velocities: DVector<f64>) -> Self {
        self.starting(place, velocities)
    }

    /// A force of the surroundings at a frame, besides those that were given before. `place` returns the pose and the
    /// Jacobian of the frame. `law` returns the wrench (fx fy fz nx ny nz), N and N m, at the frame's origin in the
    /// axes of the world, as a function of t in s, that pose and the frame's twist.
    pub fn wrench_at<P, F>(self, place: P, law: F) -> Self
    where
        P: Fn(&R, &Place<Dyn>) -> (Matrix4<f64>, Matrix6xX<f64>) + 'a,
        F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> + 'a,
    {
        self.with_wrench(WrenchAt::new(place, law))
    }
}

impl<'a, R, L, S: WithoutPeriod> Simulation<'a, R, L, Dyn, S> {
    /// The forces at the joints, behind those on a base that moves, as a function of t in s, the place and the velocities;
    /// N m or N.
    ///
    /// The law must be a function of its arguments alone, unless it is given after
    /// [`control_period`](Simulation::control_period).
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, Dyn, S>
    where
        F: Fn(f64, &Place<Dyn>, &DVector<f64>) -> DVector<f64>, // with a memory: `.control_period(1e-3).torque(law)`
    {
        self.with_laws(|_, asked| (law, asked))
    }
}

impl<'a, R: 'a, L> Simulation<'a, R, L, Dyn, Sampled> {
    /// The forces, which are held for a period. The law may have a memory: it is called once each period, in order.
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, Dyn, Sampled>
    where
        F: FnMut(f64, &Place<Dyn>, &DVector<f64>) -> DVector<f64>,
    {
        self.with_laws(|_, asked| (law, asked))
    }

    /// A force of the surroundings at a frame, sampled with the torques and held for a period in the axes of the world,
    /// besides those that were given before. The law may have a memory.
    pub fn held_wrench_at<P, F>(self, place: P, law: F) -> Self
    where
        P: Fn(&R, &Place<Dyn>) -> (Matrix4<f64>, Matrix6xX<f64>) + 'a,
        F: FnMut(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> + 'a,
    {
        self.with_wrench(HeldWrench::new(place, law))
    }
}
