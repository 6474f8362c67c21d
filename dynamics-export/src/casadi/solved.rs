//! Second derivatives of forward dynamics, of those of inverse dynamics.
//!
//! Accelerations a(x) solve tau = f(q, qd, a) for x of q, qd and tau. With M = df/da and weights w, differentiating twice and
//! multiplying by mu = M^-1 w gives
//!
//!   w^T d2 a/(dx dy) = -mu^T (d2 f/(dx dy) + dM/dx da/dy + dM/dy da/dx),
//!
//! where d2 f/(dx dy) and dM/dx are taken at a. M depends on q alone.

use super::derivatives::second_derivative;
use dynamics_symbolic::function::Argument;

/// The first derivatives by an argument: its degree of freedom in the first column, and the matrix by columns.
pub(super) type First = (Argument, usize, Vec<Option<String>>);

/// The values that the formula reads.
pub(super) struct Solved<'v> {
    pub(super) freedoms: usize,
    pub(super) first: Vec<First>,
    /// The values of `inverse_dynamics_second_derivatives`.
    pub(super) second: &'v [Option<String>],
}

impl Solved<'_> {
    /// The statements of mu, and of mu^T dM/dq, whose entry (j, k) is that of acceleration j and position k.
    pub(super) fn statements(&self, weights: &str) -> Vec<String> {
        let all = 0..self.freedoms;
        let solutions = all.clone().map(|j| {
            let products = all.clone().filter_map(|i| {
                let inverse = self.first((i, (Argument::Force, j)))?;
                Some(format!("{inverse} * {weights}[{i}]"))
            });
            let sum = sum(products.collect()).unwrap_or_else(|| "0.0".to_owned());
            format!("const double mu_{j} = {sum};")
        });
        let rates = all.clone().flat_map(|j| {
            let columns = all.clone();
            columns.filter_map(move |k| {
                let sum = self.weighted((3, j, k))?;
                Some(format!("const double mass_{j}_{k} = {sum};"))
            })
        });
        solutions.chain(rates).collect()
    }

    /// The weighted second derivative by two entries of arguments.
    pub(super) fn second(
        &self,
        one: (Argument, usize),
        other: (Argument, usize),
    ) -> Option<String> {
        // The same sum in both triangles.
        let (one, other) = match one.0 == other.0 && one.1 > other.1 {
            true => (other, one),
            false => (one, other),
        };
        let mut terms = Vec::new();
        terms.extend(second_derivative(one, other).and_then(|place| self.weighted(place)));
        for (x, y) in [(one, other), (other, one)] {
            if x.0 != Argument::Position {
                continue;
            }
            terms.extend((0..self.freedoms).filter_map(|j| {
                self.weighted((3, j, x.1))?;
                let first = self.first((j, y))?;
                Some(format!("mass_{j}_{} * {first}", x.1))
            }));
        }
        sum(terms).map(|sum| format!("-({sum})"))
    }

    /// The derivative of an acceleration by an entry of an argument.
    fn first(&self, (row, (argument, freedom)): (usize, (Argument, usize))) -> Option<&String> {
        let mut first = self.first.iter();
        let (_, start, places) = first.find(|(known, ..)| *known == argument)?;
        places[(freedom - start) * self.freedoms + row].as_ref()
    }

    /// The sum of products of mu and second derivatives.
    fn weighted(&self, (array, row, column): (usize, usize, usize)) -> Option<String> {
        let count = self.freedoms;
        let products = (0..count).filter_map(|i| {
            let value = &self.second[((array * count + i) * count + row) * count + column];
            Some(format!("mu_{i} * {}", value.as_ref()?))
        });
        sum(products.collect())
    }
}

fn sum(terms: Vec<String>) -> Option<String> {
    (!terms.is_empty()).then(|| terms.join(" + "))
}
