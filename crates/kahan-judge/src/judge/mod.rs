//! Tests float results against the exact step from the given floats.
//!
//! For fields of up to eight variables, the exact step comes from the expanded map in lowest terms,
//! or from elimination in balls if the map has too many terms. Every comparison of an error with a
//! limit is exact. Condition numbers and printed values are rounded.

pub(crate) mod balls;
pub(crate) mod fraction;
mod reduced;

use std::fmt::Debug;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::system::System;

use super::dyadic::Dyadic;
use super::equation::Equation;
use super::float::Format;

use reduced::Reduced;

/// The exact map of a system, with which results are compared.
pub(crate) trait ExactMap: Debug + Send + Sync {
    fn equation(&self) -> &Equation;

    /// Makes the exact step; returns `None` at a pole. A map in lowest terms may have a step even
    /// where the field divides by zero.
    fn step(&self, point: &[Dyadic]) -> Option<Box<dyn ExactStep>>;

    fn condition(&self, point: &[Dyadic]) -> f64 {
        balls::condition(self.equation(), point)
    }

    /// Returns whether det A vanishes at some points where the map in lowest terms is defined.
    fn has_removable_poles(&self) -> bool {
        false
    }

    fn has_poles(&self) -> bool {
        true
    }

    /// Returns the map's denominator as a polynomial in one random variable, with the others as in
    /// `point`. If `is_removable` is true, returns the factor of det A that cancels in the map.
    fn zeros(&self, is_removable: bool, point: &[Dyadic], random: &mut SplitMix64) -> Option<PolePolynomial>;
}

pub(crate) trait ExactStep {
    fn judge(&self, format: &Format, result: &[Dyadic]) -> Verdict;

    /// Returns whether every component of the step is 0 or a normal number of the format.
    fn fits(&self, format: &Format) -> bool;
}

/// The comparison of a finite result with the exact step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// The relative error, or in tests of many variables the backward error, times 2^precision.
    pub(crate) error_u: f64,
    /// Whether the error bound of `try_step` holds.
    pub(crate) keeps_promise: bool,
    /// Whether the result is at least roughly right: its relative error is at most 1e-3.
    pub(crate) is_rough: bool,
}

pub(crate) struct PolePolynomial {
    pub(crate) variable: usize,
    /// The coefficients from the constant term upwards, possibly rounded.
    pub(crate) coefficients: Vec<Dyadic>,
}

/// Returns the exact map of a field of up to eight variables.
pub(crate) fn of(system: &System) -> Box<dyn ExactMap> {
    match Reduced::of(system) {
        Some(reduced) => Box::new(reduced),
        None => Box::new(Equation::of(system)),
    }
}

#[cfg(test)]
mod tests;
