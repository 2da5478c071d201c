//! Tests float results against the exact step from the given floats.
//!
//! For fields of up to eight variables, the exact step is the expanded map in lowest terms. If that
//! map has too many terms, the step is computed by elimination in balls of growing precision. Every
//! verdict is exact; only printed values are rounded.

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

    /// Makes the exact step; `None` at a pole. The map is in lowest terms before parameters get
    /// values. So it may be defined where the field divides by zero: it is the limit in the
    /// parameters, which solves the equations multiplied by their divisors.
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

    /// Returns the map's denominator as a polynomial in a random variable. If `is_removable`,
    /// returns the factor that was divided out of it.
    fn zeros(&self, is_removable: bool, point: &[Dyadic], random: &mut SplitMix64) -> Option<PolePolynomial>;
}

pub(crate) trait ExactStep {
    /// Compares a finite result with the exact step.
    fn judge(&self, format: &Format, result: &[Dyadic]) -> Verdict;

    /// Returns whether the format holds every component of the step with full precision. Each
    /// component must be 0 or a normal number.
    fn fits(&self, format: &Format) -> bool;
}

/// The comparison of a finite result with the exact step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// ‖error‖∞/‖exact‖∞, or the backward error, in multiples of the unit u = 2^−precision. The
    /// value is infinite if the exact step is 0.
    pub(crate) error_u: f64,
    /// Whether the error bound of `try_step` holds. The comparison is exact.
    pub(crate) keeps_promise: bool,
    /// Whether the relative error is at most 1e-3.
    pub(crate) is_rough: bool,
}

pub(crate) struct PolePolynomial {
    pub(crate) variable: usize,
    /// The coefficients from the constant term upwards. Coefficients that come from elimination are
    /// rounded.
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
