//! Reproducible random numbers: a fast generator for samples, and a cryptographic one for proofs.

use keccak::Keccak;

/// A source of random bits.
pub trait Random {
    /// Returns the next 64 bits.
    fn next_u64(&mut self) -> u64;

    /// Draws a number below `bound` uniformly.
    ///
    /// # Panics
    /// If `bound` is zero.
    fn below(&mut self, bound: u64) -> u64 {
        let accepted = u64::MAX - u64::MAX % bound;
        loop {
            let draw = self.next_u64();
            if draw < accepted {
                return draw % bound;
            }
        }
    }
}

/// The hash function SHAKE256 (FIPS 202), whose digest serves as random numbers.
///
/// A generator with a seed of 64 bits would not suffice: it has only 2⁶⁴ sequences of points, so
/// error probabilities would be at least 2⁻⁶⁴. The points of a proof depend on the text of a block.
/// With SHAKE256, only trying many texts can find a text whose points satisfy a false claim.
///
/// The permutation of the state yields 17 numbers in about a microsecond. Unoptimised code takes
/// tens of microseconds.
#[derive(Clone, Debug)]
pub struct Shake256 {
    state: [u64; 25],
    drawn: usize,
}

/// The number of 64-bit words of the state that are read and written directly. The other words, 512
/// bits, are the capacity.
const RATE: usize = 25 - 512 / 64;

impl Shake256 {
    /// Returns the random numbers of a text.
    #[must_use]
    pub fn new(text: &[u8]) -> Self {
        let mut padded = text.to_vec();
        padded.push(0x1f);
        padded.resize(padded.len().next_multiple_of(8 * RATE), 0);
        *padded.last_mut().expect("a byte was pushed") |= 0x80;
        let mut stream = Self { state: [0; 25], drawn: 0 };
        for block in padded.chunks(8 * RATE) {
            for (word, bytes) in stream.state.iter_mut().zip(block.chunks(8)) {
                *word ^= u64::from_le_bytes(bytes.try_into().expect("blocks are whole words"));
            }
            stream.permute();
        }
        stream
    }

    /// Returns the next 256 bits as a seed.
    #[must_use]
    pub fn next_seed(&mut self) -> [u8; 32] {
        let mut seed = [0; 32];
        for bytes in seed.chunks_mut(8) {
            bytes.copy_from_slice(&self.next_u64().to_le_bytes());
        }
        seed
    }

    fn permute(&mut self) {
        Keccak::new().with_f1600(|permutation| permutation(&mut self.state));
        self.drawn = 0;
    }
}

impl Random for Shake256 {
    fn next_u64(&mut self) -> u64 {
        if self.drawn == RATE {
            self.permute();
        }
        self.drawn += 1;
        self.state[self.drawn - 1]
    }
}

/// SplitMix64, a small generator for samples (Steele, Lea, Flood, "Fast splittable pseudorandom
/// number generators", OOPSLA 2014). Proofs draw from [`Shake256`].
#[derive(Clone, Debug)]
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// Returns the random numbers of a seed.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Returns the random numbers of a text. The seed is the 64-bit FNV-1a hash of the text.
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for byte in bytes {
            hash = (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        Self::new(hash)
    }

    /// Returns the next 64 bits.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws a number below `bound` uniformly.
    ///
    /// # Panics
    /// If `bound` is zero.
    pub fn below(&mut self, bound: u64) -> u64 {
        Random::below(self, bound)
    }
}

impl Random for SplitMix64 {
    fn next_u64(&mut self) -> u64 {
        self.next_u64()
    }
}
