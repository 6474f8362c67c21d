//! The constants of a program: exact until they are rounded, once, at emission.

use core::cmp::Ordering;

use super::{Approximation, Arithmetic, Real};
use crate::exact::Rational;
use crate::robot::Symbol;

/// The index of a constant in its pool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ConstantId(u32);

impl ConstantId {
    /// The index as a number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// An exact constant: a number, a symbol, or an operation on earlier constants of its pool.
#[derive(Clone, Debug, PartialEq)]
pub enum Constant {
    /// A rational number.
    Rational(Rational),
    /// Pi, or the sine or cosine of a constant angle.
    Symbol(Symbol),
    /// The negative.
    Neg(ConstantId),
    /// The sum.
    Add(ConstantId, ConstantId),
    /// The product.
    Mul(ConstantId, ConstantId),
    /// The quotient.
    Div(ConstantId, ConstantId),
}

/// Constants, each defined from earlier ones.
#[derive(Clone, Debug, Default)]
pub struct ConstantPool(Vec<Constant>);

impl ConstantPool {
    /// Adds a constant.
    pub fn push(&mut self, constant: Constant) -> ConstantId {
        self.0.push(constant);
        ConstantId(self.0.len() as u32 - 1)
    }

    /// The constant of that index.
    pub fn get(&self, id: ConstantId) -> &Constant {
        &self.0[id.index()]
    }

    /// All constants, in order.
    pub fn iter(&self) -> core::slice::Iter<'_, Constant> {
        self.0.iter()
    }

    /// The values of all constants.
    pub fn evaluate<A: Arithmetic>(&self, arithmetic: &mut A) -> Vec<A::Number> {
        let mut values: Vec<A::Number> = Vec::with_capacity(self.0.len());
        for constant in &self.0 {
            let at = |id: &ConstantId| values[id.index()].clone();
            let value = match constant {
                Constant::Rational(x) => arithmetic.rational(x),
                Constant::Symbol(symbol) => arithmetic.symbol(symbol),
                Constant::Neg(a) => arithmetic.neg(at(a)),
                Constant::Add(a, b) => arithmetic.add(at(a), at(b)),
                Constant::Mul(a, b) => arithmetic.mul(at(a), at(b)),
                Constant::Div(a, b) => arithmetic.div(at(a), at(b)),
            };
            values.push(value);
        }
        values
    }

    /// The constants that `needed` requests as correctly rounded doubles (the others as NaN).
    ///
    /// The precision is raised until every rounding is certain. A tie that the engine cannot know to be one, such as
    /// 2 cos(pi/3) (1 + 2^-53), rounds to either side. Numbers beyond the largest double, quotients by zero and sines of
    /// angles beyond 2^`MOST_BITS` are infinite.
    pub fn round(&self, needed: impl Fn(ConstantId) -> bool) -> Vec<f64> {
        until_certain(|real, is_last| {
            let values = self.evaluate(real);
            let round = |(index, value): (usize, &Option<Approximation>)| {
                if needed(ConstantId(index as u32)) {
                    Approximation::rounded(value, is_last)
                } else {
                    Some(f64::NAN)
                }
            };
            values.iter().enumerate().map(round).collect()
        })
    }

    /// The singles nearest to the constants if their correctly rounded `doubles` round to others: a double lies in the
    /// middle between two singles, and the constant beside it.
    pub fn singles(&self, doubles: &[f64]) -> Vec<Option<f32>> {
        let middles: Vec<usize> = (0..doubles.len())
            .filter(|index| neighbours_of_middle(doubles[*index]).is_some())
            .collect();
        let mut singles = vec![None; doubles.len()];
        if middles.is_empty() {
            return singles;
        }
        let sides = until_certain(|real, is_last| {
            let values = self.evaluate(real);
            let side = |&index: &usize| {
                let known = values[index].as_ref();
                let side = known.and_then(|value| value.compare(doubles[index]));
                side.or(is_last.then_some(Ordering::Equal))
            };
            middles.iter().map(side).collect::<Option<Vec<_>>>()
        });
        for (index, side) in middles.into_iter().zip(sides) {
            let double = doubles[index];
            let nearest = neighbours_of_middle(double).and_then(|[below, above]| match side {
                Ordering::Less => Some(below),
                Ordering::Equal => None,
                Ordering::Greater => Some(above),
            });
            singles[index] = nearest.filter(|nearest| *nearest != double as f32);
        }
        singles
    }
}

/// The two singles between which a double lies in the middle.
fn neighbours_of_middle(double: f64) -> Option<[f32; 2]> {
    let nearest = double as f32;
    let neighbours = match f64::from(nearest).partial_cmp(&double)? {
        Ordering::Less => [nearest, nearest.next_up()],
        Ordering::Equal => return None,
        Ordering::Greater => [nearest.next_down(), nearest],
    };
    let [below, above] = neighbours.map(f64::from);
    (double - below == above - double).then_some(neighbours)
}

/// Raises the precision until `attempt` succeeds. Its second argument says that the precision will not be raised any
/// more: then it must succeed.
pub(super) fn until_certain<T>(mut attempt: impl FnMut(&mut Real, bool) -> Option<T>) -> T {
    let mut precision = FEWEST_BITS;
    loop {
        let is_last = 2 * precision > MOST_BITS;
        if let Some(found) = attempt(&mut Real::new(precision), is_last) {
            return found;
        }
        precision *= 2;
    }
}

/// The precision that is enough nearly always.
const FEWEST_BITS: usize = 160;

/// The precision beyond which no rounding is pursued.
const MOST_BITS: usize = 2_560;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::Value;

    fn rational(pool: &mut ConstantPool, numerator: i64, denominator: u64) -> ConstantId {
        let x = Rational::from_parts(numerator.into(), denominator.into());
        pool.push(Constant::Rational(x))
    }

    /// 2 cos(pi/3), which is 1.
    fn hidden_one(pool: &mut ConstantPool) -> ConstantId {
        let third = Value::Rational(Rational::from_parts(1.into(), 3_u32.into()));
        let angle = Value::Pi * third;
        let cosine = pool.push(Constant::Symbol(Symbol::AngleCosine(angle)));
        pool.push(Constant::Add(cosine, cosine))
    }

    #[test]
    fn a_constant_is_rounded_once() {
        let mut pool = ConstantPool::default();
        let tenth = rational(&mut pool, 1, 10);
        let fifth = rational(&mut pool, 2, 10);
        let sum = pool.push(Constant::Add(tenth, fifth));
        let product = pool.push(Constant::Mul(sum, sum));
        let opposite = pool.push(Constant::Neg(product));
        let quotient = pool.push(Constant::Div(tenth, sum));
        let rounded = pool.round(|_| true);
        assert_eq!(rounded[sum.index()], 0.3);
        assert_eq!(rounded[product.index()], 0.09);
        assert_eq!(rounded[opposite.index()], -0.09);
        assert_eq!(rounded[quotient.index()], 1.0 / 3.0);
    }

    /// 1 + 2^-24 is the middle between two singles, and a double.
    #[test]
    fn a_constant_beside_the_middle_of_two_singles_is_rounded_once() {
        let mut pool = ConstantPool::default();
        let middle = rational(&mut pool, (1 << 24) + 1, 1 << 24);
        let tenth = rational(&mut pool, 1, 10);
        let [mut below, mut above] = [
            rational(&mut pool, -1, 1 << 60),
            rational(&mut pool, 1, 1 << 60),
        ];
        [below, above] = [below, above].map(|little| pool.push(Constant::Add(middle, little)));
        let doubles = pool.round(|_| true);
        assert_eq!(doubles[below.index()], doubles[middle.index()]);
        assert_eq!(doubles[above.index()], doubles[middle.index()]);
        let singles = pool.singles(&doubles);
        let [middle, tenth, below, above] =
            [middle, tenth, below, above].map(|id| singles[id.index()]);
        // A tie goes to the even one, which is the one below.
        assert_eq!([middle, tenth, below], [None; 3]);
        assert_eq!(above, Some(1.0_f32.next_up()));
    }

    #[test]
    fn constants_that_nothing_needs_are_not_rounded() {
        let mut pool = ConstantPool::default();
        let (a, b) = (rational(&mut pool, 1, 2), rational(&mut pool, 3, 2));
        let rounded = pool.round(|id| id == b);
        assert!(rounded[a.index()].is_nan());
        assert_eq!(rounded[b.index()], 1.5);
    }

    /// 2 cos(pi/3) - 1 is no exact zero to the engine, and rounds to zero.
    #[test]
    fn a_hidden_zero_rounds_to_zero() {
        let mut pool = ConstantPool::default();
        let one = hidden_one(&mut pool);
        let minus_one = rational(&mut pool, -1, 1);
        let zero = pool.push(Constant::Add(one, minus_one));
        let rounded = pool.round(|_| true);
        assert_eq!(rounded[one.index()], 1.0);
        assert_eq!(rounded[zero.index()].to_bits(), 0.0_f64.to_bits());
    }

    #[test]
    fn a_hidden_tie_rounds_to_either_side() {
        let mut pool = ConstantPool::default();
        let one = hidden_one(&mut pool);
        let tie = rational(&mut pool, (1 << 53) + 1, 1);
        let product = pool.push(Constant::Mul(one, tie));
        let rounded = pool.round(|_| true)[product.index()];
        let neighbours = [(1_u64 << 53) as f64, ((1_u64 << 53) + 2) as f64];
        assert!(neighbours.contains(&rounded));
    }

    #[test]
    fn what_has_no_double_is_infinite() {
        let mut pool = ConstantPool::default();
        let one = hidden_one(&mut pool);
        let minus_one = rational(&mut pool, -1, 1);
        let zero = pool.push(Constant::Add(one, minus_one));
        let quotient = pool.push(Constant::Div(minus_one, zero));
        let mut large = rational(&mut pool, 2, 1);
        for _ in 0..11 {
            large = pool.push(Constant::Mul(large, large));
        }
        let opposite = pool.push(Constant::Neg(large));
        let rounded = pool.round(|_| true);
        assert_eq!(rounded[quotient.index()], f64::INFINITY);
        assert_eq!(rounded[large.index()], f64::INFINITY);
        assert_eq!(rounded[opposite.index()], f64::NEG_INFINITY);
    }
}
