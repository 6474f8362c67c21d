//! A small deterministic source of numbers.

use core::ops::RangeInclusive;

/// SplitMix64: G. L. Steele, D. Lea, C. H. Flood, *Fast splittable pseudorandom number generators*,
/// OOPSLA 2014. Every seed is good, and the sequence is the same on every machine.
#[derive(Debug)]
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    /// 64 bits.
    #[allow(clippy::should_implement_trait, reason = "it has no end")]
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let first = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let second = (first ^ (first >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        second ^ (second >> 31)
    }

    /// Uniform between the ends.
    pub fn within(&mut self, range: &RangeInclusive<f64>) -> f64 {
        let unit = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        range.start() + unit * (range.end() - range.start())
    }
}

#[cfg(test)]
mod tests {
    use super::SplitMix64;

    /// The first values of the generator's published sequence from seed 1234567.
    #[test]
    fn sequence_is_the_published_one() {
        let mut random = SplitMix64(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
        ];
        assert_eq!(expected.map(|_| random.next()), expected);
    }

    #[test]
    fn values_stay_within_the_range_and_fill_it() {
        let mut random = SplitMix64(0);
        let values: Vec<f64> = (0..1000).map(|_| random.within(&(-2.0..=5.0))).collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!((-2.0..-1.9).contains(&least) && (4.9..=5.0).contains(&greatest));
    }
}
