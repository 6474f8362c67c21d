//! The mass matrix by the composite-rigid-body algorithm, and gravity by composite first moments.
//!
//! Source: R. Featherstone, *Rigid Body Dynamics Algorithms*, Springer 2008, section 6.2.

use core::ops::Add;

use dynamics_runtime::internal::geometry::Joint;
use dynamics_runtime::{JointType, Size};
use nalgebra::Vector3;

use super::NumericArm;
use super::inertia::{Inertia, Wrench};
use super::walk::Place;

impl Inertia {
    /// The wrench of a unit acceleration of the body's own joint, at rest: with `U = [z]x` and
    /// `a = 0` (revolute) or `U = 0` and `a = z` (prismatic).
    #[inline(always)]
    pub(super) fn unit_wrench(&self, joint_type: JointType) -> Wrench {
        let (h, s) = (&self.first_moment, &self.second_moment);
        match joint_type {
            JointType::Revolute => Wrench {
                force: Vector3::new(-h.y, h.x, 0.0),
                moment: Vector3::new(-s.m13, -s.m23, s.m11 + s.m22),
            },
            JointType::Prismatic => Wrench {
                force: Vector3::new(0.0, 0.0, self.mass),
                moment: Vector3::new(h.y, -h.x, 0.0),
            },
        }
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// M at the joints' positions (Featherstone 2008, table 6.2). The rows of a base that moves have the wrenches that it needs
    /// for a unit acceleration of each joint. All links and the base as one body resist its own acceleration.
    #[inline(always)]
    pub(super) fn composite_bodies(&self, joints: &D::Links<Joint>) -> V::Matrix {
        let mut mass_matrix = self.freedoms.matrix();
        let links = self.inward(
            #[inline(always)]
            |place| place.link.solid.inertia,
            #[inline(always)]
            |place, body| {
                let Place { joint, factor, .. } = place;
                let mut wrench = body.unit_wrench(place.link.joint_type);
                let own = wrench.along_joint(place.link.joint_type) + place.link.reflected_inertia;
                mass_matrix[(joint, joint)] += factor * factor * own;
                let mut from = place.k;
                self.walk_carriers(
                    place.k,
                    #[inline(always)]
                    |carrier| {
                        wrench = wrench.inward(&joints[from]);
                        from = carrier.k;
                        let along = wrench.along_joint(carrier.link.joint_type);
                        let entry = factor * carrier.factor * along;
                        mass_matrix[(joint, carrier.joint)] += entry;
                        mass_matrix[(carrier.joint, joint)] += entry;
                    },
                );
                if self.floats() {
                    let of_base = wrench.inward(&joints[from]).entries();
                    for (i, entry) in of_base.into_iter().enumerate() {
                        mass_matrix[(joint, i)] += factor * entry;
                        mass_matrix[(i, joint)] += factor * entry;
                    }
                }
                place.hand_on(|| body.inward(&joints[place.k]))
            },
        );
        if let Some(body) = self.body() {
            let own = body.solid.inertia;
            let whole = links.map_or(own, |links| links + own).matrix();
            for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
                mass_matrix[(i, j)] = whole[(i, j)];
            }
        }
        mass_matrix
    }

    /// G at the joints' positions under a gravity in the axes of the base. The weight `m g` of all links beyond a joint acts at
    /// their centre of mass: joint i carries `-(h x g)_z` (revolute) or `-m g_z` (prismatic), and a base that moves carries
    /// `f = -m g`, `n = -h x g` of all bodies.
    #[inline(always)]
    pub(super) fn weights(&self, joints: &D::Links<Joint>, of_base: &Vector3<f64>) -> V::Vector {
        let mut gravity = self.per_link(Vector3::zeros());
        self.outward(
            *of_base,
            #[inline(always)]
            |Place { k, .. }, carried| {
                gravity[k] = joints[k].outward(carried);
                gravity[k]
            },
        );
        let mut torques = self.freedoms.vector();
        let carried = self.inward(
            #[inline(always)]
            |place| Moments {
                mass: place.link.solid.inertia.mass,
                first: place.link.solid.inertia.first_moment,
            },
            #[inline(always)]
            |place, Moments { mass, first: h }| {
                let (joint, g) = (&joints[place.k], &gravity[place.k]);
                let own = match place.link.joint_type {
                    JointType::Revolute => h.y * g.x - h.x * g.y,
                    JointType::Prismatic => -mass * g.z,
                };
                place.add(&mut torques, own);
                place.hand_on(|| Moments {
                    mass,
                    first: joint.inward(&h) + joint.origin * mass,
                })
            },
        );
        if let Some(body) = self.body() {
            let own = Moments {
                mass: body.solid.mass,
                first: body.solid.inertia.first_moment,
            };
            let Moments { mass, first } = carried.map_or(own, |links| links + own);
            let weight = Wrench {
                force: of_base * -mass,
                moment: of_base.cross(&first),
            };
            weight.set(&mut torques);
        }
        torques
    }
}

/// The mass of bodies, and their first moment about the origin of a frame.
#[derive(Clone, Copy, Debug)]
struct Moments {
    mass: f64,
    first: Vector3<f64>,
}

impl Add for Moments {
    type Output = Moments;

    #[inline(always)]
    fn add(self, other: Moments) -> Moments {
        Moments {
            mass: self.mass + other.mass,
            first: self.first + other.first,
        }
    }
}
