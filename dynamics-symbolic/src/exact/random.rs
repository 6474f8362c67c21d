//! Reproducible pseudo-random numbers.

/// SplitMix64 (Steele, Lea and Flood, 2014): the same seed gives the same
/// numbers on every platform, so that expansion is deterministic.
#[derive(Clone, Debug)]
pub struct SplitMix64(u64);

/// 2^64 over the golden ratio, made odd.
const STEP: u64 = 0x9E37_79B9_7F4A_7C15;

impl SplitMix64 {
    /// A sequence that depends on nothing but `seed`.
    pub fn new(seed: u64) -> Self {
        SplitMix64(seed)
    }

    /// The number of that index, counted from 0, in the sequence that depends on `seed`.
    pub fn number(seed: u64, index: u64) -> u64 {
        SplitMix64(seed.wrapping_add(STEP.wrapping_mul(index))).next_u64()
    }

    /// The next 64 bits.
    pub fn next_u64(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(STEP);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform from 0 to 1, in steps of 2^-53.
    pub fn unit(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers of the authors' own program for the seed 1234567.
    #[test]
    fn known_numbers() {
        let mut random = SplitMix64::new(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(expected.map(|_| random.next_u64()), expected);
        let by_index = [0, 1, 2, 3, 4].map(|index| SplitMix64::number(1_234_567, index));
        assert_eq!(by_index, expected);
    }
}
