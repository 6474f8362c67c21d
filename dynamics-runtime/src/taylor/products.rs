//! The products of two series, all of them side by side.

use super::MAX_TAYLOR_ORDER;
use crate::Scalar;

/// Products whose sums are computed together: two vector registers at most of any processor of
/// today.
const LANES: usize = 8;

/// The coefficients of the factors of eight products, a row for each order.
///
/// `sum` holds the inner sum of the order at hand.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Block<T> {
    left: [[T; LANES]; MAX_TAYLOR_ORDER],
    right: [[T; LANES]; MAX_TAYLOR_ORDER],
    sum: [T; LANES],
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

    /// Stores the factors of order k of a product.
    fn store(&mut self, slot: usize, k: usize, a: T, b: T);

    /// The factors of order 0, and the inner sum of the order at hand.
    fn lead(&self, slot: usize) -> [T; 3];

    /// Computes the inner sums of order k of all products.
    fn convolve(&mut self, k: usize);
}

impl<T: Scalar, const BLOCKS: usize> Products<T> for ProductTable<T, BLOCKS> {
    fn new(zero: T) -> Self {
        let rows = [[zero; LANES]; MAX_TAYLOR_ORDER];
        let block = Block {
            left: rows,
            right: rows,
            sum: [zero; LANES],
        };
        ProductTable([block; BLOCKS])
    }

    #[inline(always)]
    fn store(&mut self, slot: usize, k: usize, a: T, b: T) {
        let (block, lane) = (&mut self.0[slot / LANES], slot % LANES);
        block.left[k][lane] = a;
        block.right[k][lane] = b;
    }

    #[inline(always)]
    fn lead(&self, slot: usize) -> [T; 3] {
        let (block, lane) = (&self.0[slot / LANES], slot % LANES);
        [block.left[0][lane], block.right[0][lane], block.sum[lane]]
    }

    #[inline(always)]
    fn convolve(&mut self, k: usize) {
        T::convolve(&mut self.0, k);
    }
}

/// sum_{0<j<k} a_j b_{k-j} of every product, k > 0. Products are rounded before they are added on
/// every processor, so that all of them give the same digits.
#[inline(always)]
pub(crate) fn convolve<T: Scalar>(blocks: &mut [Block<T>], k: usize) {
    for block in blocks {
        let zero = block.sum[0].constant(0.0);
        let mut sum = [zero; LANES];
        let (left, right) = (&block.left[1..k], &block.right[1..k]);
        for (a, b) in left.iter().zip(right.iter().rev()) {
            for lane in 0..LANES {
                sum[lane] = sum[lane] + a[lane] * b[lane];
            }
        }
        block.sum = sum;
    }
}
