//! Reduction of an angle of any magnitude (Payne and Hanek 1983).

use crate::sine::lanes::Reduced;

/// The bits of 2/pi behind 32 zeros, the binary point behind these.
const TWO_OVER_PI: [u32; 8] = [
    0,
    0xa2f9_836e,
    0x4e44_1529,
    0xfc27_57d1,
    0xf534_ddc0,
    0xdb62_9599,
    0x3c43_9041,
    0xfe51_63ab,
];

/// pi/2 in units of 2^-31.
const HALF_PI: u64 = 0xc90f_daa2;

/// Reduces a finite angle of at least 2^13.
///
/// x = m 2^e with a whole m below 2^24. Multiples of four in x 2/pi are whole turns, so only the 96 bits of
/// 2/pi from the weight 2^(2 - e) on can matter. Their product with m, modulo four, has 94 bits behind the
/// point, the last 24 of which lack what was cut off; no such angle is as near to a multiple of pi/2 as 2^-31.
#[cold]
pub(super) fn reduce(x: f32) -> Reduced<f32> {
    let bits = x.to_bits();
    let m = u64::from(bits & 0x7f_ffff | 0x80_0000);
    // 32 zeros, and e - 2.
    let start = 32 + (bits >> 23) - 152;
    // An index is never beyond the table, which the compiler cannot know: it would write a panic.
    let bits_at = |at: usize| u64::from(TWO_OVER_PI.get(at).copied().unwrap_or(0));
    let window = |word: u32| {
        let at = (start / 32 + word) as usize;
        let both = bits_at(at) << 32 | bits_at(at + 1);
        both << (start % 32) >> 32
    };
    let low = m * window(2);
    let middle = m * window(1) + (low >> 32);
    let high = m * window(0) + (middle >> 32);
    // Two bits of whole quarter turns, and 62 behind the point.
    let quarters = high << 32 | middle & 0xffff_ffff;
    let n = quarters.wrapping_add(1 << 61) >> 62;
    let fraction = quarters.wrapping_sub(n << 62).cast_signed();
    let magnitude = fraction.unsigned_abs();
    let zeros = magnitude.leading_zeros();
    // 64 bits of |fraction| pi/2, in units of 2^-(61 + zeros).
    let product = (magnitude << zeros >> 32) * HALF_PI;
    let part = |bits: u64, shift: i32| {
        let unit = f32::from_bits(((127 - 61 - zeros as i32 + shift) as u32) << 23);
        let size = (bits & 0xff_ffff) as i32 as f32 * unit;
        if fraction < 0 { -size } else { size }
    };
    Reduced {
        n: f32::from_bits(n as u32),
        rest: part(product >> 40, 40),
        excess: -part(product >> 16, 16),
    }
}
