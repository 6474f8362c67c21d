//! Derivatives of the forces of a robot whose base moves, by the displacement and the velocity of the base in its own axes.
//!
//! The recursions differentiate by the positions of the six joints of the base and by their velocities u, at given
//! accelerations of these joints (see `mechanism::base`). With du/dt given instead, the accelerations change with the
//! velocities, by D u:
//!
//!   d tau/du = (d tau/du) + M d(D u)/du.
//!
//! A displacement of the base by R d and a rotation of it by exp(phi), both in its axes, change nothing but gravity, which
//! is g = R' g_world there. It is an acceleration -g of the base, and g(phi) = g - phi x g + 1/2 phi x (phi x g) + .., so that
//!
//!   d tau/d phi_k = M_lin (e_k x g),   d2 tau/d phi_j d phi_k = -1/2 M_lin (e_j x (e_k x g) + e_k x (e_j x g)),
//!
//! with the first three columns M_lin of M.

use super::chain::Chain;
use super::composite;
use super::derivatives::{ForceDerivatives, Matrix, sum_of_products};
use super::joints::Joints;
use super::second_derivatives::SecondDerivatives;
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::mechanism::BaseRate;
use crate::robot::Base;

/// The numbers of the rotations among the degrees of freedom.
const ROTATIONS: core::ops::Range<usize> = 3..Base::FREEDOMS;

/// The rates that are constant while velocities change.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Held {
    /// The accelerations of all joints, as in the recursions.
    Accelerations,
    /// The rates of the velocities, as where forces are differentiated on the graph.
    Rates,
}

/// Six numbers of the base.
type Six<'g> = [Expr<'g>; Base::FREEDOMS];

/// The quantities of a base that moves which the derivatives need.
struct Displaced<'g> {
    zero: Expr<'g>,
    half: Expr<'g>,
    held: Held,
    /// M of the joints that move by themselves.
    mass_matrix: Matrix<Expr<'g>>,
    /// d(D u)/du: column k for the velocity k; zero where the derivatives have it.
    added: Vec<Six<'g>>,
    /// g in the axes of the base.
    gravity: Vector3<Expr<'g>>,
}

impl<'g> Displaced<'g> {
    fn new(symbols: &Symbols<'g>, chain: &Chain<Expr<'g>>, held: Held) -> Self {
        let mut displaced = Displaced {
            zero: chain.zero,
            half: symbols.graph().half(),
            held,
            mass_matrix: Joints::of(symbols).block(composite::mass_matrix(chain)),
            added: vec![[chain.zero; Base::FREEDOMS]; Base::FREEDOMS],
            gravity: chain.gravity,
        };
        if held == Held::Accelerations {
            // D u is a quadratic form, so that its derivative along e is D(w) e + D(w of e) u.
            let u = core::array::from_fn(|k| symbols.joint(k).qd);
            let slope = |k: usize| polar(u, displaced.unit(k));
            displaced.added = (0..Base::FREEDOMS).map(slope).collect();
        }
        displaced
    }

    fn unit(&self, k: usize) -> Six<'g> {
        let one = self.zero.graph.one();
        core::array::from_fn(|i| if i == k { one } else { self.zero })
    }

    /// e_k x v, about the axis of the rotation of that number.
    fn turned(&self, rotation: usize, v: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        let [.., x, y, z] = self.unit(rotation);
        Vector3([x, y, z]).cross(v)
    }

    /// d tau/d phi_k of a force with this row of M.
    fn by_rotation(&self, mass: &[Expr<'g>], k: usize) -> Expr<'g> {
        sum_of_products(self.zero, mass, &self.turned(k, self.gravity).0)
    }

    /// d2 tau/d phi_j d phi_k likewise.
    fn by_rotations(&self, mass: &[Expr<'g>], j: usize, k: usize) -> Expr<'g> {
        let [first, second] =
            [(j, k), (k, j)].map(|(j, k)| self.turned(j, self.turned(k, self.gravity)));
        let acceleration = -((first + second) * self.half);
        sum_of_products(self.zero, mass, &acceleration.0)
    }

    /// The second derivatives of a force by a position and a displacement or a velocity of the base. `slopes` has for each
    /// position q the derivatives by q of the force's row of M.
    fn mixed(
        &self,
        slopes: &[Vec<Expr<'g>>],
        by_position: &mut Matrix<Expr<'g>>,
        by_both: &mut Matrix<Expr<'g>>,
    ) {
        for (q, slope) in slopes.iter().enumerate() {
            let is_joint = q >= Base::FREEDOMS;
            for k in 0..Base::FREEDOMS {
                by_both[q][k] = by_both[q][k] + sum_of_products(self.zero, slope, &self.added[k]);
                let turned = if is_joint && ROTATIONS.contains(&k) {
                    self.by_rotation(slope, k)
                } else {
                    self.zero
                };
                (by_position[q][k], by_position[k][q]) = (turned, turned);
            }
            if !is_joint {
                // No displacement of the base changes what a velocity does.
                by_both[q].fill(self.zero);
            }
        }
    }

    /// Adds the second derivatives of a force by two velocities of the base, or by two rotations of it. `mass` is the row of M
    /// that belongs to the force.
    fn add_second_derivatives(
        &self,
        mass: &[Expr<'g>],
        by_position: &mut Matrix<Expr<'g>>,
        by_velocity: &mut Matrix<Expr<'g>>,
    ) {
        for (j, k) in (0..36).map(|pair| (pair / 6, pair % 6)) {
            if self.held == Held::Accelerations {
                let added = polar(self.unit(j), self.unit(k));
                by_velocity[j][k] = by_velocity[j][k] + sum_of_products(self.zero, mass, &added);
            }
            if ROTATIONS.contains(&j) && ROTATIONS.contains(&k) {
                by_position[j][k] = self.by_rotations(mass, j, k);
            }
        }
    }
}

/// D(w of a) b + D(w of b) a, the derivative of D u at u = a along b.
fn polar<'g>(a: Six<'g>, b: Six<'g>) -> Six<'g> {
    let rate = |[.., x, y, z]: Six<'g>| BaseRate([x, y, z]);
    let (first, second) = (rate(a).times(b), rate(b).times(a));
    core::array::from_fn(|i| first[i] + second[i])
}

/// The derivatives by the base in place of those by its joints, of the joints that move by themselves.
pub(super) fn first<'g>(
    symbols: &Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    derivatives: &mut ForceDerivatives<Expr<'g>>,
    held: Held,
) {
    if !symbols.arm().freedoms().has_base() {
        return;
    }
    let base = Displaced::new(symbols, chain, held);
    for (i, mass) in base.mass_matrix.iter().enumerate() {
        let by_velocity = &mut derivatives.by_velocity[i];
        for (k, added) in base.added.iter().enumerate() {
            by_velocity[k] = by_velocity[k] + sum_of_products(base.zero, mass, added);
        }
        let by_position = &mut derivatives.by_position[i];
        by_position[..Base::FREEDOMS].fill(base.zero);
        for k in ROTATIONS {
            by_position[k] = base.by_rotation(mass, k);
        }
    }
}

/// The same of second derivatives.
pub(super) fn second<'g>(
    symbols: &Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    derivatives: &mut SecondDerivatives<Expr<'g>>,
    held: Held,
) {
    if !symbols.arm().freedoms().has_base() {
        return;
    }
    let base = Displaced::new(symbols, chain, held);
    let n = base.mass_matrix.len();
    for (i, mass) in base.mass_matrix.iter().enumerate() {
        let inertia = &mut derivatives.of_inertia[i];
        let rows = inertia.iter_mut();
        rows.for_each(|row| row[..Base::FREEDOMS].fill(base.zero));
        let columns = &inertia[..Base::FREEDOMS];
        let slope = |q: usize| columns.iter().map(|column| column[q]).collect();
        let slopes: Vec<Vec<_>> = (0..n).map(slope).collect();
        let by_position = &mut derivatives.by_position[i];
        base.mixed(&slopes, by_position, &mut derivatives.by_both[i]);
        base.add_second_derivatives(mass, by_position, &mut derivatives.by_velocity[i]);
    }
}
