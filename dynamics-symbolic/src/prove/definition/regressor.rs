//! The regressors of the standard inertial parameters, and the base parameters among them.
//!
//! The column of a parameter is what it demands of the joints, if it is 1 and the others are 0. A parameter is a
//! base parameter if its column, at enough random states, is no combination of the columns before it. That gives
//! the columns of Y, and, with tau - F at the same states, the only values that the base parameters can have.
//!
//! The base parameters of an arm whose joints follow others are chosen among those of the arm in which nothing is
//! coupled: links that move by themselves come first, then the followers' links.

use super::super::assignment::{HALF, Number};
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::equations::product;
use super::{Definition, Matrix, Vector};
use crate::exact::SplitMix64;
use crate::robot::Parameter;

impl Definition {
    /// Y by rows, or `None` where the table's forces are not those of its parameters.
    pub(super) fn regressor(&self) -> Option<Vector> {
        self.passivity_regressor_by(&self.qd, &self.qdd)
    }

    /// By rows, as [`Definition::regressor`], for the reference motion.
    pub(super) fn passivity_regressor(&self) -> Option<Vector> {
        self.passivity_regressor_by(&self.qd_r, &self.qdd_r)
    }

    fn passivity_regressor_by(&self, v: &[Number], a: &[Number]) -> Option<Vector> {
        let kept = self.base()?.0;
        let rows = self.unit_forces(&self.q, &self.qd, [v, a]);
        Some(rows.iter().flat_map(|row| pick(row, &kept)).collect())
    }

    /// The base parameters.
    pub(super) fn base_parameters(&self) -> Option<Vector> {
        self.base().map(|(_, values)| values)
    }

    /// T of a unit of each base parameter, then U = -m g.p - g.R h with p from the origin of frame 0 where that stands;
    /// `None` where the table's forces are not those of its parameters.
    pub(super) fn energy_regressors(&self) -> Option<Vector> {
        let kept = self.base()?.0;
        let twists = self.twists(&self.q, &self.qd);
        let forms = self.inertia_forms(&twists, &twists);
        let kinetic = forms.iter().map(|&twice| HALF * twice).collect();
        let base = match self.floating {
            Some(_) => Number::ZERO,
            None => self.gravity.dot(self.q.base.origin),
        };
        let frame_0 = self.columns(|_| {
            let mut weights = [Number::ZERO; 11];
            weights[9] = base;
            weights
        });
        let potential = super::equations::sum(&self.unit_potentials(&self.q), &frame_0);
        Some([pick(&kinetic, &kept), pick(&potential, &kept)].concat())
    }

    /// A list over all parameters with the values of some base parameters, and zeros; `None` where one of them is
    /// no base parameter of the arm in which nothing is coupled.
    pub(super) fn values_of(&self, parameters: &[(usize, Parameter)]) -> Option<Vector> {
        let (kept, values) = self.uncoupled.as_deref().unwrap_or(self).base()?;
        let mut columns = vec![Number::ZERO; self.first_column(self.rows.len())];
        for &(link, parameter) in parameters {
            let column = self.first_column(link) + parameter.index();
            columns[column] = values[kept.iter().position(|&k| k == column)?];
        }
        Some(columns)
    }

    /// The base parameters: columns among all parameters, and values.
    fn base(&self) -> Option<(Vec<usize>, Vector)> {
        let parameters = self.standard_parameters();
        let here = self.unit_forces(&self.q, &self.qd, [&self.qd, &self.qdd]);
        if product(&here, &parameters) != self.link_forces() {
            return None;
        }
        let candidates = self.candidates()?;
        let mut random = SplitMix64::new(self.states);
        let multiples = self.multiples();
        let mut equations = Equations::default();
        loop {
            let q = self.random_configuration(&multiples, &mut random);
            let mut numbers = || -> Vector {
                let numbers = (0..self.dof()).map(|_| Number::random(&mut random));
                numbers.collect()
            };
            let (qd, qdd) = (numbers(), numbers());
            let rows = self.unit_forces(&q, &qd, [&qd, &qdd]);
            let forces = product(&rows, &parameters);
            let before = equations.0.len();
            for (row, force) in rows.iter().zip(forces) {
                // Where all base parameters are accounted for nothing must be left of the force.
                equations.add(pick(row, &candidates), force)?;
            }
            // A state that adds nothing might have been any: no state does.
            if equations.0.len() == before {
                break;
            }
        }
        let solved = equations.0.into_iter();
        let mut base: Vec<_> = solved
            .map(|equation| (candidates[equation.column], equation.value))
            .collect();
        base.sort_unstable_by_key(|(column, _)| *column);
        Some(base.into_iter().unzip())
    }

    /// The columns among which base parameters are, in the order in which they are chosen.
    fn candidates(&self) -> Option<Vec<usize>> {
        let Some(uncoupled) = &self.uncoupled else {
            return Some((0..self.first_column(self.rows.len())).collect());
        };
        let mut columns = uncoupled.base()?.0;
        let follows = |column: usize| {
            let row = (0..self.rows.len()).rfind(|&i| self.first_column(i) <= column);
            row.is_some_and(|i| !self.rows[i].joint.is_free)
        };
        columns.sort_by_key(|&column| follows(column));
        Some(columns)
    }

    /// M a + C(q, qd) v + G of a unit of each parameter, for each degree of freedom.
    fn unit_forces(
        &self,
        q: &Configuration<Number>,
        qd: &[Number],
        [v, a]: [&[Number]; 2],
    ) -> Matrix {
        let accelerations = self.twists(q, a);
        let coriolis = self.unit_coriolis_forces(q, qd, v).into_iter().enumerate();
        let row = |(i, coriolis): (usize, Vector)| -> Vector {
            let unit = self.unit(i);
            let inertial = self.inertia_forms(&self.twists(q, &unit), &accelerations);
            let potential = self.unit_potentials(&self.moving(q, &unit));
            let forces = inertial.iter().zip(coriolis).zip(potential);
            let force = |((&inertial, coriolis), potential): ((&_, _), Dual<_>)| {
                inertial + coriolis + potential.derivative
            };
            forces.map(force).collect()
        };
        coriolis.map(row).collect()
    }
}

/// The entries of those columns.
fn pick(row: &Vector, columns: &[usize]) -> Vector {
    columns.iter().map(|&k| row[k]).collect()
}

/// Equations in reduced echelon form: the columns of their pivots are no combinations of those before them.
#[derive(Default)]
struct Equations(Vec<Equation>);

struct Equation {
    /// The first entry that is not zero: it is 1, and that of all others is 0 there.
    column: usize,
    row: Vector,
    value: Number,
}

impl Equations {
    /// Adds row . x = value; `None` where that contradicts the others.
    fn add(&mut self, mut row: Vector, mut value: Number) -> Option<()> {
        for known in &self.0 {
            let factor = row[known.column];
            subtract(&mut row, factor, &known.row);
            value = value - factor * known.value;
        }
        let Some(column) = row.iter().position(|x| !x.is_zero()) else {
            return value.is_zero().then_some(());
        };
        let inverse = row[column].inverse()?;
        let row: Vector = row.iter().map(|&x| x * inverse).collect();
        let value = value * inverse;
        for known in &mut self.0 {
            let factor = known.row[column];
            subtract(&mut known.row, factor, &row);
            known.value = known.value - factor * value;
        }
        self.0.push(Equation { column, row, value });
        Some(())
    }
}

/// row - factor other
fn subtract(row: &mut [Number], factor: Number, other: &[Number]) {
    if !factor.is_zero() {
        let terms = row.iter_mut().zip(other);
        terms.for_each(|(x, &y)| *x = *x - factor * y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_columns_are_left_out() {
        let row = |entries: [u64; 4]| entries.map(Number::new).to_vec();
        // The second column is twice the first, the fourth the sum of the first and the third: 5 times the
        // first and 2 times the third make the values.
        let mut equations = Equations::default();
        for (entries, value) in [([0, 0, 3, 3], 6), ([1, 2, 0, 1], 5), ([2, 4, 1, 3], 12)] {
            assert_eq!(equations.add(row(entries), Number::new(value)), Some(()));
        }
        let solved = equations.0.iter().map(|e| (e.column, e.value.get()));
        assert_eq!(solved.collect::<Vec<_>>(), [(2, 2), (0, 5)]);
        assert_eq!(equations.add(row([1, 2, 0, 1]), Number::new(4)), None);
    }
}
