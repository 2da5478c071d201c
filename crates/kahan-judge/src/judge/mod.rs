//! Verdicts on a float result: it is compared with the exact step from the very floats that it was
//! given.
//!
//! | a field of up to eight variables is judged by | where |
//! |---|---|
//! | the reduced map | its closed form is within the budget of terms |
//! | elimination in balls of growing precision | it is beyond |
//!
//! Every verdict is exact; only what is printed is rounded.

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

/// The exact map of a system.
pub(crate) trait Judge: Debug + Send + Sync {
    /// The equation of its steps.
    fn equation(&self) -> &Equation;

    /// The exact step; `None` at a pole.
    ///
    /// The map is reduced before parameters get values. So it may have a value where the field
    /// divides by zero: the one that it tends to as the parameters do, which solves the equations
    /// multiplied by their divisors.
    fn step(&self, point: &[Dyadic]) -> Option<Box<dyn Exact>>;

    /// The condition number of the step in (x, ε).
    fn condition(&self, point: &[Dyadic]) -> f64 {
        balls::condition(self.equation(), point)
    }

    /// Whether det A vanishes somewhere that the reduced map has a value.
    fn has_removable_poles(&self) -> bool {
        false
    }

    /// Whether there may be poles.
    fn has_poles(&self) -> bool {
        true
    }

    /// The denominator, or what was divided out of it, in one of its variables, which is drawn.
    fn zeros(&self, is_removable: bool, point: &[Dyadic], random: &mut SplitMix64) -> Option<Zeros>;
}

/// The exact step from a point.
pub(crate) trait Exact {
    /// Judges a finite result of a scalar.
    fn judge(&self, format: &Format, result: &[Dyadic]) -> Verdict;

    /// Whether the format holds every component with all of its bits: none beyond its range, none
    /// but 0 below its normal numbers.
    fn fits(&self, format: &Format) -> bool;
}

/// A finite result beside the exact step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// ‖error‖∞/‖exact‖∞, or the backward error, in units u; infinite beside an exact 0.
    pub(crate) error_u: f64,
    /// Whether the promise holds, exactly.
    pub(crate) keeps_promise: bool,
    /// Whether the error is at most 1e-3.
    pub(crate) is_rough: bool,
}

/// A polynomial in one of the variables of a point, whose zeros are poles.
pub(crate) struct Zeros {
    pub(crate) variable: usize,
    /// Its coefficients, the constant term first; about, if they come from elimination.
    pub(crate) coefficients: Vec<Dyadic>,
}

/// That of a field of up to eight variables.
pub(crate) fn of(system: &System) -> Box<dyn Judge> {
    match Reduced::of(system) {
        Some(reduced) => Box::new(reduced),
        None => Box::new(Equation::of(system)),
    }
}

#[cfg(test)]
mod tests;
