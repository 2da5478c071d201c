//! The interface of maps modulo a prime.

use kahan_algebra::prime_field::Random;

use crate::modular::modulus::Modulus;

/// A map that acts on points modulo a prime.
pub trait ModularStep {
    /// Returns the prime field.
    fn modulus(&self) -> &Modulus;

    /// Returns the number of states n.
    fn dimension(&self) -> usize;

    /// Returns the image of a point, or `None` at a pole.
    fn next(&self, point: &[u64]) -> Option<Vec<u64>>;

    /// Returns generators of a group of sign changes that map every orbit to an orbit. Each
    /// generator is the bit set of the states whose signs change.
    fn sign_changes(&self) -> Vec<u64> {
        Vec::new()
    }

    /// Samples a point uniformly.
    fn point(&self, random: &mut dyn Random) -> Vec<u64> {
        (0..self.dimension()).map(|_| self.modulus().sample(random)).collect()
    }

    /// Returns the orbit of `length` points from `start`. The orbit is shorter if it meets a pole.
    fn orbit(&self, start: Vec<u64>, length: usize) -> Vec<Vec<u64>> {
        let mut orbit = vec![start];
        while orbit.len() < length {
            let Some(next) = self.next(&orbit[orbit.len() - 1]) else { break };
            orbit.push(next);
        }
        orbit
    }
}
