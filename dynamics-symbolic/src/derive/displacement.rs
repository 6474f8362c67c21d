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
use crate::robot::Base;

/// The numbers of the rotations among the degrees of freedom.
const ROTATIONS: core::ops::Range<usize> = 3..Base::FREEDOMS;

/// What is constant while velocities change.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Held {
    /// The accelerations of all joints, as in the recursions.
    Accelerations,
    /// The rates of the velocities, as where forces are differentiated on the graph.
    Rates,
}

/// What the derivatives need of a base that moves.
struct Displaced<'g> {
    zero: Expr<'g>,
    half: Expr<'g>,
    /// M of the joints that move by themselves.
    mass_matrix: Matrix<Expr<'g>>,
    /// d(D u)/du: column k for the velocity k; zero where the derivatives have it.
    added: Vec<[Expr<'g>; Base::FREEDOMS]>,
    /// g in the axes of the base.
    gravity: Vector3<Expr<'g>>,
}

impl<'g> Displaced<'g> {
    fn new(symbols: &Symbols<'g>, chain: &Chain<Expr<'g>>, held: Held) -> Self {
        let (zero, one) = (chain.zero, chain.one);
        // D u is a quadratic form, so that its derivative along e is D(w) e + D(w of e) u.
        let u = core::array::from_fn(|k| symbols.joint(k).qd);
        let slope = |k: usize| {
            if held == Held::Rates {
                return [zero; Base::FREEDOMS];
            }
            let unit = core::array::from_fn(|i| if i == k { one } else { zero });
            let own = symbols.base_rate().times(unit);
            let [.., x, y, z] = unit;
            let other = crate::mechanism::BaseRate([x, y, z]).times(u);
            core::array::from_fn(|i| own[i] + other[i])
        };
        Displaced {
            zero,
            half: symbols.graph().half(),
            mass_matrix: Joints::of(symbols).block(composite::mass_matrix(chain)),
            added: (0..Base::FREEDOMS).map(slope).collect(),
            gravity: chain.gravity,
        }
    }

    fn axis(&self, k: usize) -> Vector3<Expr<'g>> {
        let one = self.zero.graph.one();
        Vector3([0, 1, 2].map(|i| if i == k { one } else { self.zero }))
    }

    /// e_k x g
    fn turned(&self, k: usize) -> Vector3<Expr<'g>> {
        self.axis(k).cross(self.gravity)
    }

    /// -1/2 (e_j x (e_k x g) + e_k x (e_j x g))
    fn turned_twice(&self, j: usize, k: usize) -> Vector3<Expr<'g>> {
        let twice = self.axis(j).cross(self.turned(k)) + self.axis(k).cross(self.turned(j));
        -(twice * self.half)
    }
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
    let ForceDerivatives {
        by_position,
        by_velocity,
    } = derivatives;
    for (i, mass) in base.mass_matrix.iter().enumerate() {
        for (k, added) in base.added.iter().enumerate() {
            by_velocity[i][k] = by_velocity[i][k] + sum_of_products(base.zero, mass, added);
            by_position[i][k] = base.zero;
        }
        for k in ROTATIONS {
            by_position[i][k] = sum_of_products(base.zero, mass, &base.turned(k - 3).0);
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
    let zero = base.zero;
    let of_base = 0..Base::FREEDOMS;
    for i in 0..n {
        let mass = &base.mass_matrix[i];
        // dM_ij/dq_k for the columns j of the base.
        let inertia = &mut derivatives.of_inertia[i];
        for k in of_base.clone() {
            inertia.iter_mut().for_each(|row| row[k] = zero);
        }
        let slope =
            |q: usize| -> Vec<_> { (0..6).map(|j| derivatives.of_inertia[i][j][q]).collect() };
        let slopes: Vec<Vec<_>> = (0..n).map(slope).collect();
        for q in 0..n {
            for k in of_base.clone() {
                let by_both = &mut derivatives.by_both[i][q][k];
                *by_both = *by_both + sum_of_products(zero, &slopes[q], &base.added[k]);
                let turned = ROTATIONS.contains(&k) && q >= Base::FREEDOMS;
                let mixed = if turned {
                    sum_of_products(zero, &slopes[q], &base.turned(k - 3).0)
                } else {
                    zero
                };
                derivatives.by_position[i][q][k] = mixed;
                derivatives.by_position[i][k][q] = mixed;
            }
        }
        for (j, k) in of_base
            .clone()
            .flat_map(|j| of_base.clone().map(move |k| (j, k)))
        {
            // d2(D u)/du_j du_k
            let one = zero.graph.one();
            let unit = |k: usize| core::array::from_fn(|i| if i == k { one } else { zero });
            let rate =
                |unit: [Expr<'g>; 6]| crate::mechanism::BaseRate([unit[3], unit[4], unit[5]]);
            let (first, other) = (rate(unit(j)).times(unit(k)), rate(unit(k)).times(unit(j)));
            let added: [_; 6] = core::array::from_fn(|l| first[l] + other[l]);
            if held == Held::Accelerations {
                let by_velocity = &mut derivatives.by_velocity[i][j][k];
                *by_velocity = *by_velocity + sum_of_products(zero, mass, &added);
            }
            if ROTATIONS.contains(&j) && ROTATIONS.contains(&k) {
                let turned = base.turned_twice(j - 3, k - 3);
                derivatives.by_position[i][j][k] = sum_of_products(zero, mass, &turned.0);
            }
        }
        let rows = derivatives.by_both[i].iter_mut().take(Base::FREEDOMS);
        rows.for_each(|row| row.fill(zero));
    }
}
