//! What random fields are drawn from.

use kahan_algebra::prime_field::SplitMix64;

use super::tree::{Tree, literal, negated, quotient};

/// The most variables that a random field has.
pub const DIMENSIONS: usize = 6;

/// Names of states.
pub(super) const PLAIN: [&str; DIMENSIONS] = ["x", "y", "z", "u", "v", "w"];
/// Names that collide with what generated code says.
pub(super) const AWKWARD: [&str; DIMENSIONS] = ["T", "h", "x_", "in", "N", "Vec"];

/// A source of small choices.
#[derive(Debug)]
pub struct Draw(SplitMix64);

impl Draw {
    /// The source that a text seeds.
    #[must_use]
    pub fn seeded(text: &str) -> Self {
        Draw(SplitMix64::from_bytes(text.as_bytes()))
    }

    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0.below(bound as u64) as usize
    }

    pub(super) fn one<'a, V>(&mut self, choices: &'a [V]) -> &'a V {
        &choices[self.below(choices.len())]
    }

    /// ±1 … ±9, as `n` or, one time in three, as `n/d`.
    pub(super) fn coefficient(&mut self) -> Tree {
        let size = literal(&(self.below(9) + 1).to_string());
        let size =
            if self.below(3) == 0 { quotient(size, literal(&(self.below(6) + 2).to_string())) } else { size };
        if self.below(2) == 0 { negated(size) } else { size }
    }

    pub(super) fn state(&mut self, states: &[&'static str]) -> Tree {
        Tree::Name(states[self.below(states.len())])
    }
}
