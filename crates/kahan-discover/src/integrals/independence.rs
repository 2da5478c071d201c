//! Tests independence of quotients of polynomials by the rank of gradients at a random point.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;

use crate::claims::proved::Formula;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{Sample, SampledStep, SearchField};
use crate::modular::matrix::Echelon;

/// Returns ∇(P/Q) Q² at a point modulo a prime. Returns `None` if the prime divides a denominator
/// of the coefficients.
#[must_use]
pub fn quotient_gradient(
    searched: &SearchField,
    sample: &Sample,
    point: &[u64],
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Option<Vec<u64>> {
    let modulus = sample.map.modulus();
    let value = |polynomial: &Polynomial| searched.evaluate(polynomial, sample, point);
    let (above, below) = (value(numerator)?, value(denominator)?);
    let symbols = searched.family().symbols();
    (0..symbols.dimension())
        .map(|i| {
            let rising = value(&numerator.derivative(symbols.state(i)))?;
            let falling = value(&denominator.derivative(symbols.state(i)))?;
            Some(modulus.minus(modulus.times(rising, below), modulus.times(above, falling)))
        })
        .collect()
}

/// The gradients of accepted functions at a random point modulo a prime. Gradients that are
/// independent modulo a prime are independent over ℚ.
#[derive(Debug)]
pub struct IndependentGradients<'a> {
    searched: &'a SearchField,
    step: Option<SampledStep>,
    gradients: Vec<Vec<u64>>,
}

impl<'a> IndependentGradients<'a> {
    /// Chooses a random point, and starts without accepted functions.
    pub fn new(searched: &'a SearchField, random: &mut SplitMix64) -> Self {
        IndependentGradients { searched, step: searched.step(random), gradients: Vec::new() }
    }

    pub(crate) fn of(searched: &'a SearchField, known: &[Formula], random: &mut SplitMix64) -> Self {
        let mut independent = Self::new(searched, random);
        known.iter().for_each(|formula| independent.keep(&formula.numerator, &formula.denominator));
        independent
    }

    fn gradient(&self, numerator: &Polynomial, denominator: &Polynomial) -> Option<Vec<u64>> {
        let step = self.step.as_ref()?;
        quotient_gradient(self.searched, &step.sample, &step.here, numerator, denominator)
    }

    /// Returns whether P/Q is independent of the accepted functions.
    #[must_use]
    pub fn admits(&self, numerator: &Polynomial, denominator: &Polynomial) -> bool {
        let Some(gradient) = self.gradient(numerator, denominator) else { return false };
        self.rank_with(vec![gradient]) == self.gradients.len() + 1
    }

    pub(crate) fn step(&self) -> Option<&SampledStep> {
        self.step.as_ref()
    }

    /// Returns the rank of the accepted gradients together with the gradients `further`.
    pub(crate) fn rank_with(&self, further: Vec<Vec<u64>>) -> usize {
        let Some(step) = &self.step else { return 0 };
        let rows = [self.gradients.clone(), further].concat();
        Echelon::of(step.sample.map.modulus(), rows, self.searched.dimension()).rank()
    }

    /// Accepts the function P/Q.
    pub fn keep(&mut self, numerator: &Polynomial, denominator: &Polynomial) {
        self.gradients.extend(self.gradient(numerator, denominator));
    }
}
