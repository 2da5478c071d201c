//! Helpers of tests: claims by name, their functions, a prime field, and a counting watch.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use kahan_algebra::arithmetic::{Arithmetic, Function, Functions};
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::{Claim, System};

use crate::modular::modulus::Modulus;
use crate::watch::{Finding, Progress, Watch};

pub(crate) fn claim<'a>(system: &'a System, name: &str) -> &'a Claim {
    system.claims.iter().find(|claim| claim.name.text == name).expect("the claim exists")
}

/// Returns the functions of a claim. A bracket gives the entries above the diagonal.
pub(crate) fn functions(claim: &Claim) -> Vec<RationalFunction> {
    let arithmetic = Functions::new(Budget::unlimited());
    let values =
        claim.plan.evaluate(&arithmetic, |input| Some(Some(Polynomial::variable(input.variable()?).into())));
    let reduced = |value: Option<Option<Function>>| {
        let Function { numerator, denominator } = value.flatten().expect("a value");
        let below =
            denominator.iter().flat_map(|(factor, power)| std::iter::repeat_n(factor, *power as usize));
        let below = below.fold(Polynomial::one(), |product, factor| &product * factor);
        RationalFunction::new(numerator, below).expect("no division by zero")
    };
    values.into_iter().map(reduced).collect()
}

pub(crate) fn function(claim: &Claim) -> RationalFunction {
    functions(claim).remove(0)
}

impl Arithmetic for Modulus {
    type Value = u64;
    type Constant = Rational;

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

/// A watch whose clock advances by a millisecond at each reading.
#[derive(Debug, Default)]
pub(crate) struct Ticking {
    ticks: AtomicU64,
    looks: AtomicU64,
    findings: AtomicU64,
    last_look: Option<u64>,
}

impl Ticking {
    /// Ends the computation at this call of `look`, counted from 1.
    pub(crate) fn ending_at_look(number: u64) -> Self {
        Ticking { last_look: Some(number), ..Ticking::default() }
    }

    pub(crate) fn ticks(&self) -> u64 {
        self.ticks.load(Ordering::Relaxed)
    }

    pub(crate) fn looks(&self) -> u64 {
        self.looks.load(Ordering::Relaxed)
    }

    pub(crate) fn findings(&self) -> u64 {
        self.findings.load(Ordering::Relaxed)
    }
}

impl Watch for Ticking {
    fn now(&self) -> Option<Duration> {
        Some(Duration::from_millis(self.ticks.fetch_add(1, Ordering::Relaxed)))
    }

    fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
        let look = self.looks.fetch_add(1, Ordering::Relaxed) + 1;
        if self.last_look == Some(look) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn found(&self, _: &Finding) {
        self.findings.fetch_add(1, Ordering::Relaxed);
    }
}
