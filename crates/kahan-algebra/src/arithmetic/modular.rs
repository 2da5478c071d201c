//! Residues modulo a prime.

use kahan_syntax::rational::Rational;

use crate::prime_field::PrimeField;

use super::Arithmetic;

/// F_p.
#[derive(Clone, Copy, Debug)]
pub struct Modular(pub PrimeField);

impl Arithmetic for Modular {
    type Value = u64;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<u64> {
        self.0.reduce(value)
    }

    fn add(&self, a: &u64, b: &u64) -> u64 {
        self.0.add(*a, *b)
    }

    fn subtract(&self, a: &u64, b: &u64) -> u64 {
        self.0.sub(*a, *b)
    }

    fn multiply(&self, a: &u64, b: &u64) -> u64 {
        self.0.mul(*a, *b)
    }

    fn negate(&self, a: &u64) -> u64 {
        self.0.neg(*a)
    }

    fn divide(&self, a: &u64, b: &u64) -> Option<u64> {
        self.0.inverse(*b).map(|inverse| self.0.mul(*a, inverse))
    }

    fn is_zero(&self, a: &u64) -> bool {
        *a == 0
    }
}
