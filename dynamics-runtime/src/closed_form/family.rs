//! A joint that a pose leaves free, entirely or as far as rounding goes: which of its positions the later joints can follow.
//!
//! Positions within the slack of the one that was found lead to the pose as well. If the equations of later joints have no
//! solution there, the nearest position is taken at which they have one. Positions are tried on a grid on either side. Where
//! the equations fail least, three tries enclose a maximum, which is narrowed. From a try that is solved the way back to the
//! first one that is solved is halved. No expression of the arm is read, so that this serves every class.

use super::roots::roundings;
use super::{Branches, Found, Real};

/// Tries on either side.
const GRID: i32 = 32;
/// Tries that narrow or halve: the angle is then known to its last digits.
const ROUNDS: u32 = 60;
/// An equation that misses a root by more than so many slacks has none within the slack.
const STEEP: f64 = 8.0;

/// A try: its distance from what was found, and how nearly the equations were solved, at most 0.
type Try<T> = (T, T);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// Before what was found is tried, and behind that.
    Found,
    Tried,
    /// On the grid; between the tries beside the best; between one that is solved and one nearer that is not.
    Grid,
    Narrow(u32),
    Halve(u32),
    /// The nearest that is solved is tried again, and its solutions stay.
    Last,
}

/// The positions of one joint that are to be tried, one after the other.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Family<T> {
    found: [Found<T>; 2],
    phase: Phase,
    /// How many solutions there were before.
    before: usize,
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
    /// How nearly the best was solved, here and before.
    best: T,
    outer: T,
}

impl<T: Real> Family<T> {
    /// The family of a joint, as it was found and on the unit circle.
    #[inline]
    pub fn new(found: [Found<T>; 2]) -> Self {
        let zero = T::from_f64(0.0);
        Family {
            found,
            phase: Phase::Found,
            before: 0,
            side: T::from_f64(1.0),
            number: -1,
            grid: [(zero, zero); 3],
            around: [(zero, zero); 3],
            ends: [zero; 2],
            at: zero,
            nearest: None,
            best: T::from_f64(Branches::<T, 0>::NO_TRY),
            outer: zero,
        }
    }

    /// The next position to be tried, behind whose tries `solutions` has what they found. Solutions of all but the last are
    /// taken away again.
    #[inline]
    pub fn next<const N: usize>(
        &mut self,
        solutions: &mut Branches<T, N>,
    ) -> Option<[Found<T>; 2]> {
        let no_try = T::from_f64(Branches::<T, N>::NO_TRY);
        if self.phase == Phase::Found {
            (self.phase, self.before) = (Phase::Tried, solutions.count);
            self.outer = core::mem::replace(&mut solutions.miss, no_try);
            return Some(self.found);
        }
        let is_done = self.phase == Phase::Tried
            && (solutions.count > self.before || self.is_far(solutions.miss));
        let miss = core::mem::replace(&mut solutions.miss, no_try);
        self.best = if miss > self.best { miss } else { self.best };
        if is_done || !self.is_continued(miss, solutions) {
            let is_better = self.best > self.outer;
            solutions.miss = if is_better { self.best } else { self.outer };
            return None;
        }
        Some([self.found[1].turned(self.at * self.side); 2])
    }

    /// Whether no position within the slack has a solution, if the one that was found has none.
    #[inline]
    fn is_far(&self, miss: T) -> bool {
        let steep = roundings(T::from_f64(STEEP));
        let is_near = miss * miss * self.found[0].length <= steep * steep * self.found[0].size;
        !is_near || miss <= T::from_f64(Branches::<T, 0>::NO_TRY)
    }

    /// Half the range of positions that lead to the pose.
    fn slack(&self) -> T {
        let half_turn = T::from_f64(core::f64::consts::PI);
        let Found { length, size, .. } = self.found[0];
        let slack = roundings((size / length).sqrt());
        if slack < half_turn { slack } else { half_turn }
    }

    /// Reads what the last try has found, and chooses the next one, if there is one.
    #[cold]
    #[inline(never)]
    fn is_continued<const N: usize>(&mut self, miss: T, solutions: &mut Branches<T, N>) -> bool {
        if self.phase == Phase::Last {
            return false;
        }
        let is_solved = solutions.count > self.before;
        solutions.count = self.before;
        self.judge((self.at, miss), is_solved);
        self.phase != Phase::Tried
    }

    /// Takes in a try.
    fn judge(&mut self, (at, miss): Try<T>, is_solved: bool) {
        match self.phase {
            Phase::Tried => (self.phase, self.number) = (Phase::Grid, -1),
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
            Phase::Found | Phase::Last => {}
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
            Phase::Grid => {
                let step = self.slack() * T::from_f64(1.0 / f64::from(GRID));
                self.at = step * T::from_f64(f64::from(self.number));
            }
            Phase::Narrow(_) => {
                let [(before, _), (middle, _), (behind, _)] = self.around;
                let is_before = middle - before > behind - middle;
                self.at = half * (middle + if is_before { before } else { behind });
            }
            Phase::Halve(_) => self.at = half * (self.ends[0] + self.ends[1]),
            Phase::Found | Phase::Tried | Phase::Last => {}
        }
    }

    /// To the other side, and behind both to the nearest that is solved.
    fn turn_round(&mut self) {
        if self.side.is_positive() {
            (self.side, self.number, self.phase) = (-self.side, -1, Phase::Grid);
            self.choose();
            return;
        }
        self.phase = Phase::Tried;
        if let Some(nearest) = self.nearest {
            (self.at, self.side) = nearest;
            self.phase = Phase::Last;
        }
    }
}
