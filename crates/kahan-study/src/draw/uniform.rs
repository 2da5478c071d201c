//! Random numbers by a seed: a stream of ChaCha8 for each axis, in which an index has its place.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// The random numbers of one axis.
#[derive(Clone, Debug)]
pub(crate) struct Uniform {
    stream: ChaCha8Rng,
}

impl Uniform {
    /// Those of the axis with this index.
    pub(crate) fn new(seed: u64, axis: usize) -> Self {
        let mut stream = ChaCha8Rng::seed_from_u64(seed);
        stream.set_stream(axis as u64);
        Self { stream }
    }

    /// The number of this index: 53 bits.
    pub(crate) fn at(&self, index: u64) -> f64 {
        let mut stream = self.stream.clone();
        // A number takes two words of 32 bits.
        stream.set_word_pos(2 * u128::from(index));
        (stream.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_gives_what_the_stream_has_there() {
        let uniform = Uniform::new(7, 3);
        let mut stream = ChaCha8Rng::seed_from_u64(7);
        stream.set_stream(3);
        for index in 0..100 {
            assert_eq!(uniform.at(index), (stream.next_u64() >> 11) as f64 / 9_007_199_254_740_992.0);
        }
        assert_ne!(uniform.at(5), Uniform::new(7, 4).at(5));
        assert_ne!(uniform.at(5), Uniform::new(8, 3).at(5));
    }
}
