//! Reduction of an angle of any magnitude (Payne and Hanek 1983).

use crate::sine::lanes::Reduced;

/// The bits of 2/pi behind 64 zeros, the binary point behind these.
const TWO_OVER_PI: [u64; 20] = [
    0,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
];

/// pi/2 in units of 2^-62.
const HALF_PI: u64 = 0x6487_ed51_10b4_611a;

/// Reduces a finite angle of at least 2^16.
///
/// x = m 2^e with a whole m below 2^53. Multiples of four in x 2/pi are whole turns, so only the 192 bits of 2/pi from
/// the weight 2^(1 - e) on can matter. Their product with m, modulo four, has 190 bits behind the point,
/// of which 126 are kept. No such angle is as near to a multiple of pi/2 as 2^-62 of it (Muller 2016, 11.3.2): 64 bits
/// are left where most digits cancel, and less than a 128th of a unit in the last place is lost.
#[cold]
pub(super) fn reduce(x: f64) -> Reduced<f64> {
    let bits = x.to_bits();
    let m = bits & 0xf_ffff_ffff_ffff | 0x10_0000_0000_0000;
    // 64 zeros, and e - 2.
    let start = (bits >> 52) - 1013;
    // An index is never beyond the table, which the compiler cannot know: it would write a panic.
    let bits_at = |at: usize| u128::from(TWO_OVER_PI.get(at).copied().unwrap_or(0));
    let window = |word: u64| {
        let at = (start / 64 + word) as usize;
        let both = bits_at(at) << 64 | bits_at(at + 1);
        (both << (start % 64) >> 64) as u64
    };
    let product = |a: u64, b: u64| u128::from(a) * u128::from(b);
    let middle = product(m, window(1)) + (product(m, window(2)) >> 64);
    // Two bits of whole quarter turns, and 126 behind the point.
    let quarters = (u128::from(m.wrapping_mul(window(0))) << 64).wrapping_add(middle);
    let n = quarters.wrapping_add(1 << 125) >> 126;
    let fraction = quarters.wrapping_sub(n << 126).cast_signed();
    let magnitude = fraction.unsigned_abs();
    let zeros = magnitude.leading_zeros();
    // 63 bits of |fraction| pi/2, in units of 2^-(60 + zeros).
    let product = (product((magnitude << zeros >> 64) as u64, HALF_PI) >> 64) as i64;
    let unit = f64::from_bits(u64::from(1023 - 60 - zeros) << 52);
    let nearest = product as f64;
    let signed = |size: f64| {
        if fraction < 0 {
            -size * unit
        } else {
            size * unit
        }
    };
    Reduced {
        n: f64::from_bits(n as u64),
        rest: signed(nearest),
        excess: signed((nearest as i64 - product) as f64),
    }
}
