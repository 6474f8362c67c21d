//! The products of two series, all of them side by side.

use super::MAX_TAYLOR_ORDER;
use crate::Scalar;

/// Products whose sums are computed together: the doubles of the widest vector registers.
const LANES: usize = 8;

/// Orders whose sums are begun together.
const GROUP: usize = 4;

type Lanes<T> = [T; LANES];

/// Eight products: the coefficients of their factors.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Block<T> {
    /// The order at hand.
    now: [Lanes<T>; 2],
    /// Order 0.
    lead: [Lanes<T>; 2],
    /// The inner sums of the order at hand.
    sum: Lanes<T>,
    /// What the orders of a group have in common: see [`advance`].
    begun: [Lanes<T>; GROUP],
    /// All orders before.
    left: [Lanes<T>; MAX_TAYLOR_ORDER],
    right: [Lanes<T>; MAX_TAYLOR_ORDER],
}

/// Room for all products of an arm's equations: `8 * BLOCKS` of them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct ProductTable<T, const BLOCKS: usize>([Block<T>; BLOCKS]);

/// A [`ProductTable`] of any size.
#[doc(hidden)]
pub trait Products<T> {
    /// All coefficients zero.
    fn new(zero: T) -> Self;

    /// Stores the factors of a product at the order at hand.
    fn store(&mut self, slot: usize, a: T, b: T);

    /// The factors of order 0, and the inner sum of the order at hand.
    fn lead(&self, slot: usize) -> [T; 3];

    /// Goes on from order k - 1 to order k > 0: keeps the factors, and computes the inner sums.
    fn advance(&mut self, k: usize);
}

impl<T: Scalar, const BLOCKS: usize> Products<T> for ProductTable<T, BLOCKS> {
    fn new(zero: T) -> Self {
        let lanes = [zero; LANES];
        let rows = [lanes; MAX_TAYLOR_ORDER];
        let block = Block {
            now: [lanes; 2],
            lead: [lanes; 2],
            sum: lanes,
            begun: [lanes; GROUP],
            left: rows,
            right: rows,
        };
        ProductTable([block; BLOCKS])
    }

    #[inline(always)]
    fn store(&mut self, slot: usize, a: T, b: T) {
        let (block, lane) = (&mut self.0[slot / LANES], slot % LANES);
        block.now[0][lane] = a;
        block.now[1][lane] = b;
    }

    #[inline(always)]
    fn lead(&self, slot: usize) -> [T; 3] {
        let (block, lane) = (&self.0[slot / LANES], slot % LANES);
        [block.lead[0][lane], block.lead[1][lane], block.sum[lane]]
    }

    #[inline(always)]
    fn advance(&mut self, k: usize) {
        T::advance_products(&mut self.0, k);
    }
}

/// Keeps the factors of order k - 1 of every product, and computes sum_{0<j<k} a_j b_{k-j}.
///
/// Reading the factors takes longer than multiplying them. So a pass over the orders below k begins
/// the sums of orders k to k + 3, which the later ones complete by what was not known then:
///
/// sum_{0<j<k+d} a_j b_{k+d-j} = sum_{d<j<k} a_j b_{k+d-j} + sum_{0<=e<d} a_{k+e} b_{d-e} + a_{d-e} b_{k+e}
///
/// for d < k. Products are rounded before they are added, and added in the same order, on every
/// processor, so that all of them give the same digits.
#[inline(always)]
pub(crate) fn advance<T: Scalar>(blocks: &mut [Block<T>], k: usize) {
    for block in blocks {
        if k == 1 {
            block.lead = block.now;
        }
        // One by one: a pair would be copied by way of the stack.
        block.left[k - 1] = block.now[0];
        block.right[k - 1] = block.now[1];
        let d = (k - 1) % GROUP;
        block.sum = if k <= GROUP {
            block.inner_sum(k)
        } else if d == 0 {
            block.begun = block.begin_group(k);
            block.begun[0]
        } else {
            block.complete(k - d, d)
        };
    }
}

impl<T: Scalar> Block<T> {
    /// sum_{0<j<k} a_j b_{k-j}
    #[inline(always)]
    fn inner_sum(&self, k: usize) -> Lanes<T> {
        let mut sum = [self.sum[0].constant(0.0); LANES];
        for j in 1..k {
            add_products(&mut sum, &self.left[j], &self.right[k - j]);
        }
        sum
    }

    /// sum_{d<j<k} a_j b_{k+d-j} for each d < 4, k > 4.
    #[inline(always)]
    fn begin_group(&self, k: usize) -> [Lanes<T>; GROUP] {
        let mut sums = [[self.sum[0].constant(0.0); LANES]; GROUP];
        let (left, right) = (&self.left[..k], &self.right[..k]);
        let [mut b0, mut b1, mut b2] = [right[1], right[2], right[3]];
        // a_{k-i} with b_i, b_{i+1}, b_{i+2} and b_{i+3}, as far as they are known.
        for (a, b3) in left[4..].iter().rev().zip(&right[4..]) {
            add_products(&mut sums[0], a, &b0);
            add_products(&mut sums[1], a, &b1);
            add_products(&mut sums[2], a, &b2);
            add_products(&mut sums[3], a, b3);
            [b0, b1, b2] = [b1, b2, *b3];
        }
        add_products(&mut sums[0], &left[3], &b0);
        add_products(&mut sums[1], &left[3], &b1);
        add_products(&mut sums[2], &left[3], &b2);
        add_products(&mut sums[0], &left[2], &b1);
        add_products(&mut sums[1], &left[2], &b2);
        add_products(&mut sums[0], &left[1], &b2);
        sums
    }

    /// The sum of order k + d of the group that began at order k.
    #[inline(always)]
    fn complete(&self, k: usize, d: usize) -> Lanes<T> {
        let mut sum = self.begun[d];
        for e in 0..d {
            add_products(&mut sum, &self.left[k + e], &self.right[d - e]);
            add_products(&mut sum, &self.left[d - e], &self.right[k + e]);
        }
        sum
    }
}

#[inline(always)]
fn add_products<T: Scalar>(sum: &mut Lanes<T>, a: &Lanes<T>, b: &Lanes<T>) {
    for lane in 0..LANES {
        sum[lane] = sum[lane] + a[lane] * b[lane];
    }
}
