//! What tests share: the claims of a block as reduced rational functions, and the plans of a
//! system modulo a prime.

use kahan_algebra::arithmetic::{Arithmetic, Function, Functions};
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::{Claim, System};

use crate::modulus::Modulus;

/// A claim by its name.
pub(crate) fn claim<'a>(system: &'a System, name: &str) -> &'a Claim {
    system.claims.iter().find(|claim| claim.name.text == name).expect("the claim exists")
}

/// What a claim states: one function, or the entries of a bracket above the diagonal.
pub(crate) fn functions(claim: &Claim) -> Vec<RationalFunction> {
    let arithmetic = Functions::new(Budget::unlimited());
    let values =
        claim.plan.evaluate(&arithmetic, |variable| Function::polynomial(Polynomial::variable(variable)));
    let reduced = |value: Option<Function>| {
        let Some(Function::Known { numerator, denominator }) = value else { panic!("a value") };
        let below =
            denominator.iter().flat_map(|(factor, power)| std::iter::repeat_n(factor, *power as usize));
        let below = below.fold(Polynomial::one(), |product, factor| &product * factor);
        RationalFunction::new(numerator, below).expect("no division by zero")
    };
    values.into_iter().map(reduced).collect()
}

/// What an integral or a density states.
pub(crate) fn function(claim: &Claim) -> RationalFunction {
    functions(claim).remove(0)
}

impl Arithmetic for Modulus {
    type Value = u64;

    fn constant(&self, value: &Rational) -> Option<u64> {
        self.rational(value)
    }

    fn add(&self, a: &u64, b: &u64) -> u64 {
        self.plus(*a, *b)
    }

    fn subtract(&self, a: &u64, b: &u64) -> u64 {
        self.minus(*a, *b)
    }

    fn multiply(&self, a: &u64, b: &u64) -> u64 {
        self.times(*a, *b)
    }

    fn negate(&self, a: &u64) -> u64 {
        self.opposite(*a)
    }

    fn divide(&self, a: &u64, b: &u64) -> Option<u64> {
        self.inverse(*b).map(|inverse| self.times(*a, inverse))
    }

    fn is_zero(&self, a: &u64) -> bool {
        *a == 0
    }
}
