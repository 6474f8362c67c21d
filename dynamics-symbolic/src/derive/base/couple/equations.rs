//! Equations of energies at states of simple numbers, by which coefficients become short expressions.

use super::arm::{Arm, State, less};
use super::echelon::Echelon;
use crate::exact::{Rational, SplitMix64};
use crate::expr::Fingerprint;
use crate::linear::Ring;
use crate::spatial::Turn;

/// The equations are chosen from this many times as many states as there are columns.
const CHOICE: usize = 4;

/// Tangents of half the angles at simple states, as fractions: none, a quarter turn either way, a half turn,
/// and those whose sines and cosines are the shortest fractions.
const TANGENTS: [(i64, i64); 7] = [(0, 1), (1, 1), (-1, 1), (1, 0), (1, 2), (-1, 3), (2, 3)];

/// A state of simple numbers.
#[derive(Clone)]
pub(super) struct Simple {
    /// Tangents of half the angles.
    angles: Vec<(i64, i64)>,
    q: Vec<i64>,
    qd: Vec<i64>,
}

impl Simple {
    pub(super) fn rest<R>(arm: &Arm<R>) -> Self {
        Simple {
            angles: vec![TANGENTS[0]; arm.angles],
            q: vec![0; arm.joints],
            qd: vec![0; arm.joints],
        }
    }

    /// Any numbers of that size.
    fn random<R>(arm: &Arm<R>, size: i64, random: &mut SplitMix64) -> Self {
        let mut number = |from: i64| from + (random.next_u64() % (size - from + 1) as u64) as i64;
        let angles = (0..arm.angles).map(|_| (number(-size), number(1)));
        let angles = angles.collect();
        let mut numbers = || (0..arm.joints).map(|_| number(-size)).collect();
        Simple {
            angles,
            q: numbers(),
            qd: numbers(),
        }
    }

    /// One joint or two moving, at rest or with one of all angles and positions elsewhere.
    fn simplest<R>(arm: &Arm<R>) -> Vec<Self> {
        let rest = Simple::rest(arm);
        let mut places = vec![rest.clone()];
        for (choice, tangent) in TANGENTS.into_iter().enumerate().skip(1) {
            for angle in 0..arm.angles {
                let mut place = rest.clone();
                place.angles[angle] = tangent;
                places.push(place);
            }
            for joint in (0..arm.joints).filter(|_| choice <= 2) {
                let mut place = rest.clone();
                place.q[joint] = if choice == 1 { 1 } else { -1 };
                places.push(place);
            }
        }
        let pairs = (0..arm.joints).flat_map(|j| (j..arm.joints).map(move |k| (j, k)));
        let moving = |place: &Simple| {
            let place = place.clone();
            pairs.clone().map(move |(j, k)| {
                let mut state = place.clone();
                (state.qd[j], state.qd[k]) = (1, 1);
                state
            })
        };
        places.iter().flat_map(moving).collect()
    }

    /// 2 T and U.
    pub(super) fn rows<R: Ring>(
        &self,
        arm: &Arm<R>,
        number: &impl Fn(&Rational) -> R,
    ) -> [Vec<R>; 2] {
        arm.energies(&self.state(number))
    }

    fn state<R: Ring>(&self, number: &impl Fn(&Rational) -> R) -> State<R> {
        let fraction = |n: i64, d: u64| number(&Rational::from_parts(n.into(), d.into()));
        // sin = 2 t / (1 + t^2), cos = (1 - t^2) / (1 + t^2), t = p / r
        let angles = self.angles.iter().map(|&(p, r)| {
            let square = (p * p + r * r).unsigned_abs();
            Turn {
                s: fraction(2 * p * r, square),
                c: fraction(r * r - p * p, square),
            }
        });
        let whole = |x: &Vec<i64>| x.iter().map(|&x| fraction(x, 1)).collect();
        State {
            angles: angles.collect(),
            q: whole(&self.q),
            qd: whole(&self.qd),
        }
    }
}

/// Equations at simple states.
pub(super) struct Equations {
    pub(super) states: Vec<Simple>,
    /// State and kind of energy, and the row.
    rows: Vec<((usize, usize), Vec<Fingerprint>)>,
}

impl Equations {
    /// As many as it takes to tell the kept columns apart.
    pub(super) fn of(arm: &Arm<Fingerprint>, kept: &[usize]) -> Self {
        let number = |x: &Rational| Fingerprint::from_rational(x).expect("a small number");
        let mut random = SplitMix64::new(0x0073_696d_706c);
        let mut echelon = Echelon::new(kept.to_vec());
        let mut equations = Equations {
            states: Vec::new(),
            rows: Vec::new(),
        };
        let mut simplest = Simple::simplest(arm).into_iter();
        let mut size = 2;
        let [_, at_rest] = Simple::rest(arm).rows(arm, &number);
        let enough = CHOICE * kept.len();
        while equations.states.len() < enough || echelon.rank() < kept.len() {
            let next = simplest.next();
            // Sines of high multiples of an angle take many different angles: of larger and larger numbers.
            let state = next.unwrap_or_else(|| {
                size += 1;
                Simple::random(arm, size, &mut random)
            });
            let [kinetic, potential] = state.rows(arm, &number);
            let rows = [kinetic, less(potential, &at_rest)];
            for (kind, row) in rows.into_iter().enumerate() {
                echelon.add(row.clone());
                equations.rows.push(((equations.states.len(), kind), row));
            }
            equations.states.push(state);
        }
        equations
    }

    /// The equations with the fewest entries among all that tell some columns apart.
    pub(super) fn chosen(&self, columns: &[usize]) -> Vec<(usize, usize)> {
        let entries =
            |row: &Vec<Fingerprint>| columns.iter().filter(|&&k| !row[k].is_zero()).count();
        let mut rows: Vec<_> = self.rows.iter().map(|row| (entries(&row.1), row)).collect();
        rows.sort_by_key(|(entries, _)| *entries);
        let mut echelon = Echelon::new(columns.to_vec());
        let independent = rows.into_iter().filter(|(entries, (_, row))| {
            *entries > 0 && echelon.rank() < columns.len() && echelon.add(row.clone())
        });
        independent.map(|(_, (place, _))| *place).collect()
    }
}
