//! The products of two series, all of them side by side.

use super::MAX_TAYLOR_ORDER;
use crate::Scalar;

/// Products whose sums are computed together: the doubles of the widest vector registers.
const LANES: usize = 8;

/// Orders whose sums are begun together.
const GROUP: usize = 4;

type Lanes<T> = [T; LANES];

/// The left factors of eight products: one for each, or one for all.
#[doc(hidden)]
pub trait Factor<T>: Copy {
    fn repeat(x: T) -> Self;
    fn of(&self, lane: usize) -> T;
    fn set(&mut self, lane: usize, x: T);
}

impl<T: Scalar> Factor<T> for Lanes<T> {
    fn repeat(x: T) -> Self {
        [x; LANES]
    }

    #[inline(always)]
    fn of(&self, lane: usize) -> T {
        self[lane]
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, x: T) {
        self[lane] = x;
    }
}

/// A factor that eight products have in common: rotations have the same sine in many.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Common<T>(T);

impl<T: Scalar> Factor<T> for Common<T> {
    fn repeat(x: T) -> Self {
        Common(x)
    }

    #[inline(always)]
    fn of(&self, _: usize) -> T {
        self.0
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, x: T) {
        if lane == 0 {
            self.0 = x;
        }
    }
}

/// Eight products: the coefficients of their factors.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Block<T, L> {
    /// The order at hand.
    now: Lanes<T>,
    now_left: L,
    /// Order 0.
    lead: Lanes<T>,
    lead_left: L,
    /// The inner sums of the order at hand.
    sum: Lanes<T>,
    /// The sums that the orders of a group have in common: see [`advance`].
    begun: [Lanes<T>; GROUP],
    /// All orders before.
    right: [Lanes<T>; MAX_TAYLOR_ORDER],
    left: [L; MAX_TAYLOR_ORDER],
}

/// Room for all products of an arm's equations, eight in a block, those of the first blocks with a common factor; and for
/// sine and cosine of each angle that is a multiple of a joint's.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct ProductTable<T, const COMMON: usize, const SINGLE: usize, const MULTIPLES: usize> {
    common: [Block<T, Common<T>>; COMMON],
    single: [Block<T, Lanes<T>>; SINGLE],
    multiples: [(T, T); MULTIPLES],
}

/// A [`ProductTable`] of any size.
#[doc(hidden)]
pub trait Products<T> {
    /// All coefficients zero.
    fn new(zero: T) -> Self;

    /// Stores the factors of a product at the order at hand.
    fn store(&mut self, slot: usize, a: T, b: T);

    /// The factors of order 0, and the inner sum of the order at hand.
    fn lead(&self, slot: usize) -> [T; 3];

    /// Sines and cosines of the angles that are multiples of joints', at the order at hand.
    fn multiples(&mut self) -> &mut [(T, T)];

    /// Goes on from order k - 1 to order k > 0: keeps the factors, and computes the inner sums.
    fn advance(&mut self, k: usize);
}

impl<T: Scalar, const COMMON: usize, const SINGLE: usize, const MULTIPLES: usize> Products<T>
    for ProductTable<T, COMMON, SINGLE, MULTIPLES>
{
    fn new(zero: T) -> Self {
        ProductTable {
            common: [Block::new(zero); COMMON],
            single: [Block::new(zero); SINGLE],
            multiples: [(zero, zero); MULTIPLES],
        }
    }

    #[inline(always)]
    fn store(&mut self, slot: usize, a: T, b: T) {
        let (block, lane) = (slot / LANES, slot % LANES);
        if block < COMMON {
            self.common[block].store(lane, a, b);
        } else {
            self.single[block - COMMON].store(lane, a, b);
        }
    }

    #[inline(always)]
    fn lead(&self, slot: usize) -> [T; 3] {
        let (block, lane) = (slot / LANES, slot % LANES);
        if block < COMMON {
            self.common[block].lead(lane)
        } else {
            self.single[block - COMMON].lead(lane)
        }
    }

    #[inline(always)]
    fn multiples(&mut self) -> &mut [(T, T)] {
        &mut self.multiples
    }

    #[inline(always)]
    fn advance(&mut self, k: usize) {
        T::vectorized(
            #[inline(always)]
            || {
                advance(&mut self.common, k);
                advance(&mut self.single, k);
            },
        );
    }
}

impl<T: Scalar, L: Factor<T>> Block<T, L> {
    fn new(zero: T) -> Self {
        let (lanes, left) = ([zero; LANES], L::repeat(zero));
        Block {
            now: lanes,
            now_left: left,
            lead: lanes,
            lead_left: left,
            sum: lanes,
            begun: [lanes; GROUP],
            right: [lanes; MAX_TAYLOR_ORDER],
            left: [left; MAX_TAYLOR_ORDER],
        }
    }

    #[inline(always)]
    fn store(&mut self, lane: usize, a: T, b: T) {
        self.now_left.set(lane, a);
        self.now[lane] = b;
    }

    #[inline(always)]
    fn lead(&self, lane: usize) -> [T; 3] {
        [self.lead_left.of(lane), self.lead[lane], self.sum[lane]]
    }
}

/// Keeps the factors of order k - 1 of every product, and computes sum_{0<j<k} a_j b_{k-j}.
///
/// Reading the factors takes longer than multiplying them. So a pass over the orders below k begins
/// the sums of orders k to k + 3, which the later ones complete by what was not known then:
///
/// sum_{0<j<k+d} a_j b_{k+d-j} = sum_{d<j<k} a_j b_{k+d-j} + sum_{0<=e<d} a_{k+e} b_{d-e} + a_{d-e} b_{k+e}
///
/// for d < k.
#[inline(always)]
fn advance<T: Scalar, L: Factor<T>>(blocks: &mut [Block<T, L>], k: usize) {
    for block in blocks {
        if k == 1 {
            (block.lead, block.lead_left) = (block.now, block.now_left);
        }
        block.right[k - 1] = block.now;
        block.left[k - 1] = block.now_left;
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

impl<T: Scalar, L: Factor<T>> Block<T, L> {
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
fn add_products<T: Scalar>(sum: &mut Lanes<T>, a: &impl Factor<T>, b: &Lanes<T>) {
    for lane in 0..LANES {
        sum[lane] = a.of(lane).mul_add(b[lane], sum[lane]);
    }
}
