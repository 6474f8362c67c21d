//! Forward dynamics: by M and one factorisation, or by articulated bodies.

use nalgebra::{Matrix6, Vector3, Vector6};

use super::{NumericFloating, twist};
use crate::factorisation::{factor, solve, substitute};
use crate::newton_euler::articulated::{Acceleration, Articulated, Beyond};
use crate::newton_euler::inertia::Wrench;
use crate::size::Size;
use crate::{Conditioning, Pose, SingularMassMatrix};

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Accelerations a of `M a + V + G + K + F = tau`.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M is not positive definite to working precision, or holds a NaN. Its `joint` counts the
    /// six numbers of the base first.
    pub fn forward_dynamics(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        let available = tau.clone() - self.bias_force(base, q, v);
        solve(self.mass_matrix(q), &available).map_err(named)
    }

    /// How near M(q) is to singular; the base's six numbers count first.
    pub fn conditioning(&self, q: &D::Vector) -> Conditioning {
        Conditioning::of_joints(self.dof(), &self.mass_matrix(q))
    }

    /// The same accelerations by articulated bodies: the time grows with the number of joints, and not with its cube. The
    /// base accelerates as a body whose joints are free (Featherstone 2008, table 9.4).
    ///
    /// # Errors
    ///
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn forward_dynamics_aba(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        if self.arm.count > self.arm.size.value() {
            // Articulated bodies are of joints that move by themselves.
            return self.forward_dynamics(base, q, v, tau);
        }
        let available = tau.clone() - self.arm.joint_forces(q, v);
        let [linear, angular] = twist::<V>(v);
        let mut of_base = Vector6::zeros();
        let accelerations = self.arm.at(q, |joints| {
            self.arm
                .accelerations(joints, v, &available, &angular, |links| {
                    let own = self.held(&angular);
                    let whole = links.map_or(own, |links| links + own);
                    let applied = Vector6::from_fn(|i, _| available[i]);
                    of_base = free(&whole, &applied)?;
                    Ok(Acceleration {
                        linear: of_base.fixed_rows::<3>(0).into_owned(),
                        angular: of_base.fixed_rows::<3>(3).into_owned(),
                    })
                })
        });
        let mut accelerations = accelerations.map_err(named)?;
        // a = dv/dt + w x v - g.
        let apart = self.gravity(base) - angular.cross(&linear);
        for i in 0..3 {
            accelerations[i] = of_base[i] + apart[i];
            accelerations[3 + i] = of_base[3 + i];
        }
        Ok(accelerations)
    }

    /// The base's own body, and the wrench that it needs for its angular velocity.
    fn held(&self, angular: &Vector3<f64>) -> Beyond {
        let inertia = self.body.inertia;
        let body = Articulated::rigid(&inertia);
        Beyond {
            body,
            composite: inertia,
            needed: Wrench {
                force: angular.cross(&angular.cross(&inertia.first_moment)),
                moment: angular.cross(&(body.a * angular)),
            },
        }
    }
}

/// The numbers of the base, before those of the joints.
pub const NAMES_OF_BASE: [&str; 6] = [
    "base vx", "base vy", "base vz", "base wx", "base wy", "base wz",
];

/// Says which number of the base it is.
fn named(error: SingularMassMatrix) -> SingularMassMatrix {
    match NAMES_OF_BASE.get(error.joint) {
        Some(name) => error.named(name),
        None => error,
    }
}

/// Linear and angular acceleration of a base that carries this, under a force and a moment. Pivots are measured by the
/// entries of the composite body, as those of M are.
fn free(whole: &Beyond, applied: &Vector6<f64>) -> Result<Vector6<f64>, SingularMassMatrix> {
    let Articulated { a, b, d } = &whole.body;
    let mut inertia = Matrix6::zeros();
    inertia.fixed_view_mut::<3, 3>(0, 0).copy_from(d);
    inertia.fixed_view_mut::<3, 3>(3, 0).copy_from(b);
    inertia
        .fixed_view_mut::<3, 3>(0, 3)
        .copy_from(&b.transpose());
    inertia.fixed_view_mut::<3, 3>(3, 3).copy_from(a);
    let mut pivots = whole.composite.matrix().diagonal();
    factor(6, &mut inertia, &mut pivots)?;
    let mut acceleration = applied - Vector6::from(whole.needed.entries());
    substitute(6, &inertia, &pivots, &mut acceleration);
    Ok(acceleration)
}
