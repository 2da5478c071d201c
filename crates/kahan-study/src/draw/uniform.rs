//! Random numbers by seed: each axis has a stream of ChaCha8 with direct access by index.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

#[derive(Clone, Debug)]
pub(crate) struct Uniform {
    seed: u64,
    axis: usize,
}

impl Uniform {
    pub(crate) fn new(seed: u64, axis: usize) -> Self {
        Self { seed, axis }
    }

    /// Returns the number at `index`, with 53 bits.
    pub(crate) fn at(&self, index: u64) -> f64 {
        let mut stream = self.stream();
        // A number takes two words of 32 bits.
        stream.set_word_pos(2 * u128::from(index));
        (stream.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn stream(&self) -> ChaCha8Rng {
        let mut stream = ChaCha8Rng::seed_from_u64(self.seed);
        stream.set_stream(self.axis as u64);
        stream
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_gives_what_the_stream_has_there() {
        let uniform = Uniform::new(7, 3);
        let mut stream = uniform.stream();
        for index in 0..100 {
            assert_eq!(uniform.at(index), (stream.next_u64() >> 11) as f64 / 9_007_199_254_740_992.0);
        }
        assert_eq!(uniform.at(123_456), 0.8431035305340336);
        assert_ne!(uniform.at(5), Uniform::new(7, 4).at(5));
        assert_ne!(uniform.at(5), Uniform::new(8, 3).at(5));
    }
}
