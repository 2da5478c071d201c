//! What every search asks of a map modulo a prime: the map itself, on a leaf of it, or composed
//! with itself.

use kahan_algebra::prime_field::Random;

use crate::modular::modulus::Modulus;

/// A map that can be stepped, modulo a prime.
pub trait Stepping {
    /// The field that it works in.
    fn modulus(&self) -> &Modulus;

    /// The number of states n.
    fn dimension(&self) -> usize;

    /// The image of a point; `None` at a pole.
    fn next(&self, point: &[u64]) -> Option<Vec<u64>>;

    /// Generators of the sign changes of states that carry orbits to orbits, as far as they are
    /// known: each as the set of states whose sign it changes, one bit a state.
    fn sign_changes(&self) -> Vec<u64> {
        Vec::new()
    }

    /// A uniformly sampled point.
    fn point(&self, random: &mut dyn Random) -> Vec<u64> {
        (0..self.dimension()).map(|_| self.modulus().sample(random)).collect()
    }

    /// The orbit of `length` points from `start`, which is the first; shorter where it ends at a
    /// pole.
    fn orbit(&self, start: Vec<u64>, length: usize) -> Vec<Vec<u64>> {
        let mut orbit = vec![start];
        while orbit.len() < length {
            let Some(next) = self.next(&orbit[orbit.len() - 1]) else { break };
            orbit.push(next);
        }
        orbit
    }
}
