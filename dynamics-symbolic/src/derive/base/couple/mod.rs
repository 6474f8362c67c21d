//! Base parameters of an arm whose joints follow others.
//!
//! Let F_k be what a unit of base parameter k of the arm without couplings adds to the Lagrangian, where
//! the followers move as they have to. Some of the F_k are combinations of others,
//!
//!   F_k = sum_j a_jk F_j + const,
//!
//! because a hand that a parallelogram keeps level does not turn, for example, or because two fingers move at one speed.
//! If the parameters b_k are left out, those that are kept become b_j + sum_k a_jk b_k: the smallest set.
//!
//! Which F_k depend on others is found by elimination at random states of the prime field. The a_jk are
//! rational functions of the geometry, the factors and the offsets. They solve a few equations of energies
//! at states of simple numbers, so that the expressions are short. These coefficients alone may divide by a parameter of
//! the arm.
//!
//! A parameter is kept unless it is a combination of those before it. The parameters of links whose joints move by
//! themselves come first, those of the followers' links after them: then a_jk is the square of a factor, where the other
//! order would divide by it.

mod arm;
mod echelon;
mod equations;

use super::columns;
use crate::derive::symbols::Symbols;
use crate::exact::Rational;
use crate::expr::{Expr, Level};
use crate::mechanism::{Law, Mechanism};
use crate::robot::{Grouping, Parameter};
use arm::{Arm, less};
use echelon::Echelon;
use equations::{Equations, Simple};

/// A base parameter of the arm without couplings that the coupled arm does not have.
pub(crate) struct Dependent<'g> {
    /// Its column.
    pub(crate) column: usize,
    /// The columns of which its own is a combination, and the coefficients.
    pub(crate) terms: Vec<(usize, Expr<'g>)>,
}

/// The columns, among those of the arm without couplings, that the coupled arm keeps.
pub(super) fn independent(symbols: &mut Symbols<'_>, grouping: &Grouping) -> Vec<usize> {
    let arm = Arm::of(symbols, grouping, columns(grouping)).values();
    let mut kept = Echelon::of(&arm, order(symbols.arm(), &arm.columns)).pivots();
    kept.sort_unstable();
    kept
}

/// The columns that it does not keep.
pub(crate) fn dependent<'g>(symbols: &mut Symbols<'g>, grouping: &Grouping) -> Vec<Dependent<'g>> {
    let arm = Arm::of(symbols, grouping, columns(grouping));
    let values = arm.values();
    let echelon = Echelon::of(&values, order(symbols.arm(), &arm.columns));
    let kept = echelon.pivots();
    let equations = Equations::of(&values, &kept);
    let graph = symbols.graph();
    let number = |x: &Rational| graph.rational(x);
    let [_, at_rest] = Simple::rest(&arm).rows(&arm, &number);
    let mut written: Vec<Option<[Vec<Expr<'g>>; 2]>> = vec![None; equations.states.len()];
    let combinations = echelon.combinations().into_iter();
    let combinations = combinations.map(|(column, mut of)| {
        of.sort_unstable();
        let chosen = equations.chosen(&of);
        let equation = |(state, kind): (usize, usize)| {
            let rows = written[state].get_or_insert_with(|| {
                let [kinetic, potential] = equations.states[state].rows(&arm, &number);
                [kinetic, less(potential, &at_rest)]
            });
            let row = &rows[kind];
            let entries = of.iter().chain([&column]);
            entries.map(|&k| row[k]).collect::<Vec<_>>()
        };
        let solution = solve(chosen.into_iter().map(equation).collect());
        Dependent {
            column,
            terms: of.into_iter().zip(solution).collect(),
        }
    });
    combinations.collect()
}

/// The order in which columns are chosen: those of joints that move by themselves, then of followers.
fn order(arm: &Mechanism, columns: &[(usize, Parameter)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..columns.len()).collect();
    order.sort_by_key(|&k| matches!(arm.joints[columns[k].0].law, Law::Following { .. }));
    order
}

/// Solves equations, each with its right side last: by elimination of one unknown after the other, those
/// first that take no division, in the shortest equations.
fn solve<'g>(mut rows: Vec<Vec<Expr<'g>>>) -> Vec<Expr<'g>> {
    let unknowns = rows.len();
    let mut done: Vec<Option<Vec<Expr<'g>>>> = vec![None; unknowns];
    while !rows.is_empty() {
        let entries = |row: &Vec<Expr<'g>>| row.iter().filter(|x| !x.is_zero()).count();
        let pivots = rows.iter().enumerate().flat_map(|(r, row)| {
            let unknown = (0..unknowns).filter(|&k| !row[k].is_zero());
            let entries = entries(row);
            unknown.map(move |k| ((row[k].level() != Level::Constant, entries), (r, k)))
        });
        let (_, (r, k)) = pivots.min().expect("the equations are independent");
        let pivot = rows.swap_remove(r);
        let pivot: Vec<_> = pivot.iter().map(|&x| x / pivot[k]).collect();
        for row in rows.iter_mut().chain(done.iter_mut().flatten()) {
            let factor = row[k];
            if !factor.is_zero() {
                let terms = row.iter_mut().zip(&pivot);
                terms.for_each(|(x, &p)| *x = *x - factor * p);
            }
        }
        done[k] = Some(pivot);
    }
    let solved = done.into_iter().flatten();
    solved.map(|row| row[unknowns]).collect()
}
