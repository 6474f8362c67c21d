//! Forces of contacts: a linear complementarity problem with bounds.
//!
//! Stops and dry friction act on joints with forces f that have bounds. They change rates x = x0 + W f, which are
//! velocities and f impulses at an impact, accelerations and f forces between impacts. For each joint with a contact
//!
//! `low <= f <= high`, with `x = 0` between the bounds, `x >= 0` at the lower one, `x <= 0` at the upper one:
//!
//! a stop cannot pull, friction has its greatest value, and where the force does not suffice the joint moves against
//! it (Ch. Glocker, F. Pfeiffer, *Dynamical systems with unilateral contacts*, Nonlinear Dynamics 3 (1992); without
//! friction P. Lötstedt, *Mechanical systems of rigid bodies subject to unilateral constraints*, SIAM J. Appl. Math. 42
//! (1982)). These are the conditions of a least value of `f.W f / 2 + x0.f` within the bounds. W = M^-1 is positive
//! definite, so that there is one solution. Pivots of least index end at it from wherever they start (K. G. Murty,
//! *Note on a Bard-type scheme for solving the complementarity problem*, Opsearch 11 (1974); with bounds J. J. Júdice,
//! F. M. Pires, *Basic-set algorithm for a generalized linear complementarity problem*, J. Optim. Theory Appl. 74
//! (1992)).

use dynamics_runtime::{JointMatrix as _, JointVector as _, Size};

use crate::integrate::Lu;

/// The place of a contact's force among its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    Low,
    Between,
    High,
}

/// The forces of contacts and the rates under them.
#[derive(Clone, Debug)]
pub(super) struct Balance<D: Size> {
    pub(super) places: D::Each<Place>,
    pub(super) forces: D::Vector,
    pub(super) rates: D::Vector,
    responses: D::Matrix,
    between: D::Each<bool>,
}

/// The worst case of ten joints, 3^10. A search takes about as many pivots as there are contacts.
const MOST_PIVOTS: usize = 60_000;

/// A force or a rate within this share of its terms of the bound is at the bound. Without that, rounding could turn a
/// pivot back and forth.
const ROUNDING: f64 = 1e-13;

/// The balance of the contacts that have bounds `[low, high]`, searched from `start`, whose forces are finite. `None` if
/// rounding keeps the pivots from ending.
///
/// `rates` are those without forces of contacts; `responses` holds the columns of W of the joints with bounds.
pub(super) fn balanced<D: Size>(
    rates: &D::Vector,
    responses: &D::Matrix,
    bounds: &D::Each<Option<[f64; 2]>>,
    start: D::Each<Place>,
) -> Option<Balance<D>> {
    let mut places = start;
    for _ in 0..MOST_PIVOTS {
        let balance = Balance::new(rates, responses, bounds, places.clone());
        let turned = |i: usize| balance.turned(i, rates[i], bounds[i]?);
        match D::of(rates).joints().find_map(|i| Some((i, turned(i)?))) {
            Some((i, place)) => places[i] = place,
            None => return Some(balance),
        }
    }
    None
}

impl<D: Size> Balance<D> {
    /// Forces at their bounds, and between them those that leave no rates.
    fn new(
        free: &D::Vector,
        responses: &D::Matrix,
        bounds: &D::Each<Option<[f64; 2]>>,
        places: D::Each<Place>,
    ) -> Self {
        let size = D::of(free);
        let between = size.each(|i| bounds[i].is_some() && places[i] == Place::Between);
        let at_bounds = size.vector_of(|i| match (bounds[i], places[i]) {
            (Some([low, _]), Place::Low) => low,
            (Some([_, high]), Place::High) => high,
            _ => 0.0,
        });
        let rates = free.plus(1.0, &responses.times(&at_bounds));
        let wanted = size.vector_of(|i| if between[i] { -rates[i] } else { 0.0 });
        let forces = at_bounds + block(size, responses, &between).solve_vector(&wanted);
        let mut rates = free.plus(1.0, &responses.times(&forces));
        for i in size.joints().filter(|i| between[*i]) {
            rates[i] = 0.0;
        }
        Balance {
            places,
            forces,
            rates,
            responses: responses.clone(),
            between,
        }
    }

    /// Another place for the force of joint `i`, where it is wrong at its own.
    fn turned(&self, i: usize, free: f64, [low, high]: [f64; 2]) -> Option<Place> {
        let joints = D::of(&self.forces).joints();
        let terms = joints.map(|j| (self.responses[(i, j)] * self.forces[j]).abs());
        let rounding = ROUNDING * (free.abs() + terms.sum::<f64>());
        let of_force = rounding / self.responses[(i, i)];
        match self.places[i] {
            Place::Between if self.forces[i] < low - of_force => Some(Place::Low),
            Place::Between if self.forces[i] > high + of_force => Some(Place::High),
            Place::Low if self.rates[i] < -rounding => Some(Place::Between),
            Place::High if self.rates[i] > rounding => Some(Place::Between),
            _ => None,
        }
    }

    /// The inertia of joint `i`, whose force is between its bounds, if it alone is let go: `(W_bb^-1)_ii`, with b the
    /// joints whose forces are between their bounds.
    pub(super) fn inertia(&self, i: usize) -> f64 {
        let size = D::of(&self.forces);
        let unit = size.vector_of(|j| f64::from(u8::from(i == j)));
        block(size, &self.responses, &self.between).solve_vector(&unit)[i]
    }
}

/// The factors of the rows and columns of some joints; those of the others are the unit matrix's.
pub(super) fn block<D: Size>(size: D, matrix: &D::Matrix, joints: &D::Each<bool>) -> Lu<f64, D> {
    Lu::new(size, |i, j| {
        if joints[i] && joints[j] {
            matrix[(i, j)]
        } else {
            f64::from(u8::from(i == j))
        }
    })
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, Matrix3, Vector3};

    use super::{Balance, Place, balanced};

    /// A matrix as an arm has it, symmetric and positive definite.
    const W: Matrix3<f64> = Matrix3::new(2.0, -1.5, 0.3, -1.5, 3.0, -0.4, 0.3, -0.4, 1.0);

    /// A joint at its lower stop with friction, one that sticks, one at its upper stop.
    const BOUNDS: [Option<[f64; 2]>; 3] = [
        Some([-0.5, f64::INFINITY]),
        Some([-1.0, 0.7]),
        Some([f64::NEG_INFINITY, 0.0]),
    ];

    fn is_solution(balance: &Balance<Const<3>>) -> bool {
        let is_right = |i: usize| {
            let [low, high] = BOUNDS[i].unwrap();
            let (force, rate) = (balance.forces[i], balance.rates[i]);
            match balance.places[i] {
                Place::Low => force == low && rate > -1e-12,
                Place::Between => force > low - 1e-12 && force < high + 1e-12 && rate == 0.0,
                Place::High => force == high && rate < 1e-12,
            }
        };
        (0..3).all(is_right)
    }

    /// From each place where the search may begin it ends at the one solution, whatever the joints do.
    #[test]
    fn there_is_one_balance_wherever_the_search_begins() {
        use Place::{Between, High, Low};
        let mut found = [0; 3];
        for k in 0..300 {
            let free = Vector3::from_fn(|i, _| 3.0 * (f64::from(k) * 1.7 + i as f64 * 2.3).sin());
            let begun = |start| balanced::<Const<3>>(&free, &W, &BOUNDS, start).unwrap();
            let first = begun([Between; 3]);
            assert!(is_solution(&first), "{k}: {first:?}");
            for start in [
                [Low, Low, High],
                [Between, High, High],
                [Low, Between, Between],
            ] {
                let other = begun(start);
                assert!(
                    (other.forces - first.forces).amax() < 1e-12,
                    "{k}: {other:?}"
                );
            }
            for (i, free) in found.iter_mut().enumerate() {
                *free += u32::from(first.places[i] != Between);
            }
        }
        assert!(
            found.iter().all(|count| (50..250).contains(count)),
            "{found:?}"
        );
    }

    /// Let go, a joint accelerates by its force over its inertia while the others are held.
    #[test]
    fn a_force_over_the_inertia_is_the_acceleration_without_it() {
        let free = Vector3::new(-1.0, 0.2, 1.5);
        let held = [Some([f64::NEG_INFINITY, f64::INFINITY]); 3];
        let start = [Place::Between; 3];
        let all = balanced::<Const<3>>(&free, &W, &held, start).unwrap();
        for i in 0..3 {
            let mut others = held;
            others[i] = None;
            let let_go = balanced::<Const<3>>(&free, &W, &others, start).unwrap();
            let expected = -all.forces[i] / all.inertia(i);
            assert!((let_go.rates[i] - expected).abs() < 1e-14, "{i}");
        }
    }
}
