//! A joint that a pose leaves free, entirely or as far as rounding goes: which of its positions the later joints can follow.
//!
//! Positions within the slack of the one that was found lead to the pose as well. If the equations of later joints have no
//! solution there, the nearest position is taken at which they have one. Positions are tried on a grid on either side. Where
//! the equations fail least, three tries enclose a maximum, which is narrowed. From a try that is solved the way back to the
//! first one that is solved is halved. No expression of the arm is read, so that this serves every class.

use super::roots::{NO_TRY, roundings};
use super::{Branches, Found, Real};

/// Tries on either side.
const GRID: i32 = 32;
/// Tries that narrow or halve: the angle is then known to its last digits.
const ROUNDS: u32 = 60;

/// A try: its distance from what was found, and how nearly the equations were solved, at most 0.
type Try<T> = (T, T);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// On the grid; between the tries beside the best; between one that is solved and one nearer that is not.
    Grid,
    Narrow(u32),
    Halve(u32),
    /// The nearest that is solved is tried again, and its solutions stay.
    Last,
    Over,
}

/// The positions of one joint that are to be tried, one after the other.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Family<T> {
    found: [Found<T>; 2],
    /// How many solutions there were before what was found is tried.
    before: Option<usize>,
    /// How nearly equations were solved before.
    outer: T,
    search: Option<Search<T>>,
}

/// The search for another position.
#[derive(Clone, Copy, Debug)]
struct Search<T> {
    phase: Phase,
    /// The distance of two tries on the grid.
    step: T,
    /// 1 or -1, and the number of the try on this side.
    side: T,
    number: i32,
    /// The last three tries on the grid, and those that enclose a maximum.
    grid: [Try<T>; 3],
    around: [Try<T>; 3],
    /// The end that is not solved, and the one that is.
    ends: [T; 2],
    at: T,
    /// The distance of the nearest that is solved, and its side.
    nearest: Option<(T, T)>,
    /// How nearly the best was solved.
    best: T,
}

impl<T: Real> Family<T> {
    /// The family of a joint, as it was found and on the unit circle.
    pub fn new(found: [Found<T>; 2]) -> Self {
        Family {
            found,
            before: None,
            outer: T::from_f64(0.0),
            search: None,
        }
    }

    /// The next position to be tried, behind whose tries `solutions` has what they found. Solutions of all but the last are
    /// taken away again.
    pub fn next<const N: usize>(
        &mut self,
        solutions: &mut Branches<T, N>,
    ) -> Option<[Found<T>; 2]> {
        let Some(before) = self.before else {
            self.before = Some(solutions.count);
            self.outer = core::mem::replace(&mut solutions.miss, T::from_f64(NO_TRY));
            return Some(self.found);
        };
        let is_solved = solutions.count > before;
        if self.search.is_none() && (is_solved || !self.found[0].may_solve(solutions.miss)) {
            solutions.miss = largest(solutions.miss, self.outer);
            return None;
        }
        self.searched(before, solutions)
    }

    /// Reads what the last try has found, and chooses the next one, if there is one.
    fn searched<const N: usize>(
        &mut self,
        before: usize,
        solutions: &mut Branches<T, N>,
    ) -> Option<[Found<T>; 2]> {
        let miss = core::mem::replace(&mut solutions.miss, T::from_f64(NO_TRY));
        let is_solved = solutions.count > before;
        let search = match &mut self.search {
            None => self.search.insert(Search::new(&self.found[0], miss)),
            Some(search) => {
                search.best = largest(miss, search.best);
                if search.phase == Phase::Last {
                    search.phase = Phase::Over;
                } else {
                    solutions.count = before;
                    search.judge((search.at, miss), is_solved);
                }
                search
            }
        };
        if search.phase == Phase::Over {
            solutions.miss = largest(search.best, self.outer);
            return None;
        }
        Some([self.found[1].turned(search.at * search.side); 2])
    }
}

fn largest<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

impl<T: Real> Search<T> {
    /// Around what was found, within half the range of positions that lead to the pose.
    fn new(found: &Found<T>, miss: T) -> Self {
        let (zero, half_turn) = (T::from_f64(0.0), T::from_f64(core::f64::consts::PI));
        let slack = roundings((found.size / found.length).sqrt());
        let slack = if slack < half_turn { slack } else { half_turn };
        let mut search = Search {
            phase: Phase::Grid,
            step: slack * T::from_f64(1.0 / f64::from(GRID)),
            side: T::from_f64(1.0),
            number: -1,
            grid: [(zero, zero); 3],
            around: [(zero, zero); 3],
            ends: [zero; 2],
            at: zero,
            nearest: None,
            best: miss,
        };
        search.choose();
        search
    }

    /// Takes in a try.
    fn judge(&mut self, (at, miss): Try<T>, is_solved: bool) {
        match self.phase {
            Phase::Grid if is_solved && self.number > 0 => self.halve(self.grid[2].0, at),
            Phase::Grid => {
                // On the other side of what was found: its own turn comes.
                let miss = if is_solved { T::from_f64(1.0) } else { miss };
                self.grid = [self.grid[1], self.grid[2], (at, miss)];
                let [(_, before), (_, middle), (_, behind)] = self.grid;
                let is_enclosed = self.number > 0 && middle > before && middle >= behind;
                if is_enclosed {
                    (self.around, self.phase) = (self.grid, Phase::Narrow(ROUNDS));
                } else {
                    self.number += 1;
                }
            }
            Phase::Narrow(_) if is_solved => {
                let nearer = self.around[0].0;
                let least = T::from_f64(0.0);
                self.halve(if nearer < least { least } else { nearer }, at);
            }
            Phase::Narrow(rounds) => {
                let [before, middle, behind] = self.around;
                let one = (at, miss);
                self.around = match (at < middle.0, miss >= middle.1) {
                    (true, true) => [before, one, middle],
                    (true, false) => [one, middle, behind],
                    (false, true) => [middle, one, behind],
                    (false, false) => [before, middle, one],
                };
                self.phase = Phase::Narrow(rounds - 1);
                if rounds == 1 {
                    (self.phase, self.number) = (Phase::Grid, self.number + 1);
                }
            }
            Phase::Halve(rounds) => {
                self.ends[usize::from(is_solved)] = at;
                self.phase = Phase::Halve(rounds - 1);
            }
            Phase::Last | Phase::Over => {}
        }
        self.choose();
    }

    fn halve(&mut self, outside: T, inside: T) {
        (self.ends, self.phase) = ([outside, inside], Phase::Halve(ROUNDS));
    }

    /// The place of the next try.
    fn choose(&mut self) {
        let half = T::from_f64(0.5);
        match self.phase {
            Phase::Halve(0) => {
                let [_, end] = self.ends;
                let is_ahead = end > T::from_f64(0.0);
                let (way, side) = if is_ahead {
                    (end, self.side)
                } else {
                    (-end, -self.side)
                };
                if self.nearest.is_none_or(|(nearest, _)| way < nearest) {
                    self.nearest = Some((way, side));
                }
                self.turn_round();
            }
            Phase::Grid if self.number > GRID => self.turn_round(),
            Phase::Grid => self.at = self.step * T::from_f64(f64::from(self.number)),
            Phase::Narrow(_) => {
                let [(before, _), (middle, _), (behind, _)] = self.around;
                let is_before = middle - before > behind - middle;
                self.at = half * (middle + if is_before { before } else { behind });
            }
            Phase::Halve(_) => self.at = half * (self.ends[0] + self.ends[1]),
            Phase::Last | Phase::Over => {}
        }
    }

    /// To the other side, and behind both to the nearest that is solved.
    fn turn_round(&mut self) {
        if self.side.is_positive() {
            (self.side, self.number, self.phase) = (-self.side, -1, Phase::Grid);
            self.choose();
            return;
        }
        self.phase = Phase::Over;
        if let Some(nearest) = self.nearest {
            (self.at, self.side) = nearest;
            self.phase = Phase::Last;
        }
    }
}
