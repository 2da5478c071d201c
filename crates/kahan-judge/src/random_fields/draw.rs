//! The random choices from which random fields are made.

use kahan_algebra::prime_field::SplitMix64;

use super::tree::{Tree, literal, negated, quotient};

/// The greatest number of variables of a random field.
pub const DIMENSIONS: usize = 6;

pub(super) const PLAIN_STATE_NAMES: [&str; DIMENSIONS] = ["x", "y", "z", "u", "v", "w"];
/// State names that collide with names in generated code.
pub(super) const COLLIDING_STATE_NAMES: [&str; DIMENSIONS] = ["T", "h", "x_", "in", "N", "Vec"];

/// A source of random choices.
#[derive(Debug)]
pub struct Draw(SplitMix64);

impl Draw {
    /// Creates a source whose seed is a text.
    #[must_use]
    pub fn seeded(text: &str) -> Self {
        Draw(SplitMix64::from_bytes(text.as_bytes()))
    }

    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0.below(bound as u64) as usize
    }

    pub(super) fn choose<'a, V>(&mut self, choices: &'a [V]) -> &'a V {
        &choices[self.below(choices.len())]
    }

    /// Draws a number ±1 … ±9, sometimes divided by 2 … 7.
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
