//! Tests results by the expanded polynomials of the map in lowest terms.
//!
//! In lowest terms, x̃ᵢ = Nᵢ/d with polynomials Nᵢ and d. The map may be defined where det A = 0.

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::system::System;

use super::fraction::Fraction;
use super::{ExactMap, ExactStep, PolePolynomial};
use crate::dyadic::Dyadic;
use crate::elimination::largest;
use crate::equation::Equation;
use crate::polynomial::{Powers, Terms, Univariate, common_denominator, greatest_power};

#[derive(Debug)]
pub(super) struct Reduced {
    equation: Equation,
    /// The numerators of the map, with integer coefficients.
    numerators: Vec<Terms>,
    denominator: Terms,
    /// The derivatives of numerators and denominator by each state and by ε.
    slopes: Vec<Slopes>,
    /// For each variable in the denominator: the denominator as a polynomial in this variable.
    poles: Vec<Univariate>,
    removable_poles: Vec<Univariate>,
    degree: usize,
}

/// The derivatives of all numerators and of the denominator by one variable.
#[derive(Debug)]
struct Slopes {
    variable: usize,
    numerators: Vec<Terms>,
    denominator: Terms,
}

impl Reduced {
    pub(super) fn of(system: &System) -> Option<Self> {
        let symbols = &system.field.symbols;
        let map = RationalMap::of(&system.field)?.reduced;
        let numerators = map.numerators(symbols);
        let all = || numerators.iter().chain([&map.denominator]);
        let scale = common_denominator(all());
        let terms = |polynomial: &Polynomial| Terms::of(polynomial, &scale);
        let variables = (0..symbols.dimension()).map(|i| symbols.state(i)).chain([symbols.epsilon()]);
        let slopes = variables.map(|variable| Slopes {
            variable: usize::from(variable.0),
            numerators: numerators.iter().map(|n| terms(&n.derivative(variable))).collect(),
            denominator: terms(&map.denominator.derivative(variable)),
        });
        let univariates = |polynomial: &Polynomial| {
            let all = Univariate::all(polynomial, &common_denominator([polynomial]));
            // Parameters are given, so only states or ε are varied to find poles.
            let is_parameter = |v: usize| v >= symbols.dimension() && v != usize::from(symbols.epsilon().0);
            all.into_iter().filter(|one| !is_parameter(one.variable)).collect()
        };
        Some(Self {
            equation: Equation::of(system),
            slopes: slopes.collect(),
            poles: univariates(&map.denominator),
            removable_poles: univariates(&map.common_factor),
            degree: greatest_power(all().chain([&map.common_factor])),
            denominator: terms(&map.denominator),
            numerators: numerators.iter().map(terms).collect(),
        })
    }

    pub(super) fn fraction(&self, point: &[Dyadic]) -> Option<Fraction> {
        let point = Powers::of(point, self.degree);
        let denominator = self.denominator.at(&point);
        let numerators = || self.numerators.iter().map(|n| n.at(&point)).collect();
        (!denominator.is_zero()).then(|| Fraction::of(numerators(), denominator))
    }
}

impl ExactMap for Reduced {
    fn equation(&self) -> &Equation {
        &self.equation
    }

    fn step(&self, point: &[Dyadic]) -> Option<Box<dyn ExactStep>> {
        Some(Box::new(self.fraction(point)?))
    }

    /// Returns max_i Σ_v |∂x̃ᵢ/∂v|·|v| / ‖x̃‖∞, where v runs over the states and ε.
    fn condition(&self, point: &[Dyadic]) -> f64 {
        let Some(Fraction { numerators, denominator, size }) = self.fraction(point) else {
            return f64::INFINITY;
        };
        let point = Powers::of(point, self.degree);
        let mut sums = vec![Dyadic::zero(); numerators.len()];
        for slopes in &self.slopes {
            // Use ∂(N/d) = (∂N·d − N·∂d)/d².
            let slope = slopes.denominator.at(&point);
            for ((sum, terms), n) in sums.iter_mut().zip(&slopes.numerators).zip(&numerators) {
                let change = &(&terms.at(&point) * &denominator) - &(n * &slope);
                *sum = &*sum + &(&change * point.coordinate(slopes.variable)).abs();
            }
        }
        largest(sums.into_iter()).ratio(&(&denominator * &size))
    }

    fn has_removable_poles(&self) -> bool {
        !self.removable_poles.is_empty()
    }

    fn has_poles(&self) -> bool {
        !self.poles.is_empty()
    }

    fn zeros(&self, is_removable: bool, point: &[Dyadic], random: &mut SplitMix64) -> Option<PolePolynomial> {
        let choices = if is_removable { &self.removable_poles } else { &self.poles };
        let count = choices.len() as u64;
        let one = &choices[(count > 0).then(|| random.below(count))? as usize];
        let coefficients = one.at(&Powers::of(point, self.degree));
        Some(PolePolynomial { variable: one.variable, coefficients })
    }
}
