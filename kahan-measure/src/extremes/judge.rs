//! The exact step from a point of floats, and what a float result is worth beside it.
//!
//! x̃ᵢ = xᵢ + 2ε nᵢ/d in lowest terms, so with Nᵢ = xᵢd + 2ε nᵢ the error of a result y is |yᵢd −
//! Nᵢ|/|d|, and it is compared with max |Nᵢ|/|d| without a division: every verdict is exact, only
//! what is printed is rounded.

use std::cmp::Ordering;

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::system::System;
use num_bigint::BigInt;

use super::dyadic::Dyadic;
use super::float::Float;
use super::polynomial::{Powers, Terms, Univariate, common_denominator, greatest_power};

/// The promise of the stable tier: ‖error‖∞ ≤ 64 u ‖exact‖∞.
const PROMISE: i64 = 64;

/// The exact map of a system.
#[derive(Debug)]
pub(crate) struct Judge {
    /// N₁ … N_n and d, over one integer.
    numerators: Vec<Terms>,
    denominator: Terms,
    /// Their derivatives by each state and by ε: of every N, then of d.
    slopes: Vec<Slopes>,
    /// d, and the factor that was divided out, in each of their variables.
    pub(crate) poles: Vec<Univariate>,
    pub(crate) removable_poles: Vec<Univariate>,
    degree: usize,
    states: usize,
    parameters: usize,
}

/// ∂Nᵢ/∂v for every i, and ∂d/∂v.
#[derive(Debug)]
struct Slopes {
    variable: usize,
    numerators: Vec<Terms>,
    denominator: Terms,
}

/// The exact step: Nᵢ and d.
pub(crate) struct Exact {
    point: Powers,
    numerators: Vec<Dyadic>,
    denominator: Dyadic,
    /// max |Nᵢ|.
    size: Dyadic,
}

/// A finite result beside the exact step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// ‖error‖∞/‖exact‖∞ in units u; infinite beside an exact 0.
    pub(crate) error_u: f64,
    /// Whether the error is at most 64 u, exactly.
    pub(crate) keeps_promise: bool,
    /// Whether the error is at most 1e-3.
    pub(crate) is_rough: bool,
}

impl Judge {
    /// `None` where the map is beyond the budget of symbolic reduction.
    pub(crate) fn of(system: &System) -> Option<Self> {
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
            // Parameters are given; a pole is sought by moving the point or the step.
            let is_parameter = |v: usize| v >= symbols.dimension() && v != usize::from(symbols.epsilon().0);
            all.into_iter().filter(|one| !is_parameter(one.variable)).collect()
        };
        Some(Self {
            slopes: slopes.collect(),
            poles: univariates(&map.denominator),
            removable_poles: univariates(&map.common_factor),
            degree: greatest_power(all().chain([&map.common_factor])),
            states: symbols.dimension(),
            parameters: symbols.parameters.len(),
            denominator: terms(&map.denominator),
            numerators: numerators.iter().map(terms).collect(),
        })
    }

    pub(crate) fn dimension(&self) -> usize {
        self.states
    }

    /// The index of ε among the variables.
    pub(crate) fn epsilon(&self) -> usize {
        self.states + self.parameters
    }

    /// The powers of a point: states, parameters, ε.
    pub(crate) fn powers(&self, point: &[Dyadic]) -> Powers {
        Powers::of(point, self.degree)
    }

    /// The exact step; `None` at a pole.
    pub(crate) fn step(&self, point: Powers) -> Option<Exact> {
        let denominator = self.denominator.at(&point);
        if denominator.is_zero() {
            return None;
        }
        let numerators: Vec<Dyadic> = self.numerators.iter().map(|n| n.at(&point)).collect();
        let size = largest(numerators.iter().cloned());
        Some(Exact { point, numerators, denominator, size })
    }

    /// The condition number of the step in (x, ε): max over i of Σ |∂x̃ᵢ/∂v|·|v|, divided by ‖x̃‖∞;
    /// infinite where x̃ is 0.
    pub(crate) fn condition(&self, exact: &Exact) -> f64 {
        let Exact { point, numerators, denominator, size } = exact;
        let mut sums = vec![Dyadic::zero(); self.states];
        for slopes in &self.slopes {
            // ∂(N/d) = (∂N·d − N·∂d)/d²
            let slope = slopes.denominator.at(point);
            for ((sum, terms), n) in sums.iter_mut().zip(&slopes.numerators).zip(numerators) {
                let change = &(&terms.at(point) * denominator) - &(n * &slope);
                *sum = &*sum + &(&change * point.coordinate(slopes.variable)).abs();
            }
        }
        largest(sums.into_iter()).ratio(&(denominator * size))
    }
}

impl Exact {
    /// Judges a finite result of a scalar.
    pub(crate) fn judge<T: Float>(&self, result: &[Dyadic]) -> Verdict {
        let errors = result.iter().zip(&self.numerators).map(|(y, n)| (&(y * &self.denominator) - n).abs());
        let error = largest(errors);
        let within = |bound: &Dyadic| error.compare(bound) != Ordering::Greater;
        Verdict {
            error_u: if error.is_zero() { 0.0 } else { error.clone().scaled(T::PRECISION).ratio(&self.size) },
            keeps_promise: within(&(&self.size * &Dyadic::new(PROMISE, -T::PRECISION))),
            // error·1000 ≤ size
            is_rough: (&error * &Dyadic::new(1000, 0)).compare(&self.size) != Ordering::Greater,
        }
    }

    /// Whether the format holds every component with all of its bits: none beyond its range, none
    /// but 0 below its normal numbers.
    pub(crate) fn fits<T: Float>(&self) -> bool {
        let d = self.denominator.clone().abs();
        // The largest number is (2 − 2^(1−p))·2^greatest.
        let greatest =
            &d * &Dyadic::new((BigInt::from(1) << T::PRECISION) - 1, T::GREATEST_BINADE + 1 - T::PRECISION);
        let least = d.scaled(T::LEAST_BINADE);
        self.numerators.iter().all(|n| {
            let n = n.clone().abs();
            n.is_zero() || (n.compare(&least) != Ordering::Less && n.compare(&greatest) != Ordering::Greater)
        })
    }
}

/// The largest of some magnitudes.
fn largest(values: impl Iterator<Item = Dyadic>) -> Dyadic {
    values.map(Dyadic::abs).fold(Dyadic::zero(), |largest, value| {
        if value.compare(&largest) == Ordering::Greater { value } else { largest }
    })
}

#[cfg(test)]
mod tests;
