//! What a float result is worth beside the exact step from the very floats that it was given.
//!
//! | a field of | is judged by | the promise |
//! |---|---|---|
//! | up to eight variables, its closed form within the budget of terms | the reduced map | ‖error‖∞ ≤ 64 u ‖x̃‖∞ |
//! | up to eight variables, beyond the budget | elimination in balls of growing precision | the same |
//! | more than eight variables, chains among them | the residual of the defining equation | \|A·x̃ − b\|ᵢ ≤ (k + 8)·u·(\|A\|·\|x̃\| + \|b\|)ᵢ, k entries in a row of A |
//!
//! Every verdict is exact; only what is printed is rounded.

mod balls;
mod fraction;
mod reduced;
mod residual;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::system::System;
use kahan_runtime::interpreted::LARGEST_DIMENSION;

use super::dyadic::Dyadic;
use super::equation::Equation;
use super::float::Float;

use balls::Balls;
use fraction::Fraction;
use reduced::Reduced;
use residual::{Residual, Rows};

/// The exact map of a system.
#[derive(Debug)]
pub(super) struct Judge {
    pub(super) equation: Equation,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    Reduced(Reduced),
    Balls,
    Residual(Rows),
}

/// The exact step from a point.
pub(super) enum Exact {
    Fraction(Fraction),
    Balls(Balls),
    Residual(Residual),
}

/// A finite result beside the exact step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verdict {
    /// ‖error‖∞/‖exact‖∞, or the backward error, in units u; infinite beside an exact 0.
    pub(super) error_u: f64,
    /// Whether the promise holds, exactly.
    pub(super) keeps_promise: bool,
    /// Whether the error is at most 1e-3.
    pub(super) is_rough: bool,
}

/// A polynomial in one of the variables of a point, whose zeros are poles.
pub(super) struct Zeros {
    pub(super) variable: usize,
    /// Its coefficients, the constant term first; about, if they come from elimination.
    pub(super) coefficients: Vec<Dyadic>,
}

impl Judge {
    /// That of a field of whatever number of variables.
    pub(super) fn of(system: &System) -> Self {
        if system.field.dimension() > LARGEST_DIMENSION {
            return Self { equation: Equation::of(system), kind: Kind::Residual(Rows::Widest) };
        }
        let kind = Reduced::of(system).map_or(Kind::Balls, Kind::Reduced);
        Self { equation: Equation::of(system), kind }
    }

    /// That of a chain, which is promised the same whatever its length.
    pub(super) fn of_chain(system: &System) -> Self {
        Self { equation: Equation::of(system), kind: Kind::Residual(Rows::Own) }
    }

    /// The same, judged by elimination in balls.
    #[cfg(test)]
    pub(super) fn in_balls(self) -> Self {
        Self { kind: Kind::Balls, ..self }
    }

    /// The exact step; `None` at a pole.
    ///
    /// The map is reduced before parameters get values. So it may have a value where the field
    /// divides by zero: the one that it tends to as the parameters do, which solves the equations
    /// multiplied by their divisors. A residual has no such meaning, and there is no step then.
    pub(super) fn step(&self, point: &[Dyadic]) -> Option<Exact> {
        let equation = || self.equation.at(point);
        match &self.kind {
            Kind::Reduced(reduced) => reduced.step(point).map(Exact::Fraction),
            Kind::Balls => Balls::of(equation()),
            Kind::Residual(rows) => {
                let equation = equation();
                equation.is_defined().then(|| Exact::Residual(Residual::of(equation, *rows)))
            }
        }
    }

    /// The condition number of the step in (x, ε) where a flag is not right: where the field has a
    /// value, x̃ is a number that the format holds, and the condition number is below `limit`.
    pub(super) fn forbidden_flag<T: Float>(
        &self,
        point: &[Dyadic],
        exact: &Exact,
        limit: f64,
    ) -> Option<f64> {
        let fits = match exact {
            Exact::Fraction(fraction) => fraction.fits::<T>(),
            Exact::Balls(balls) => balls.fits::<T>(),
            Exact::Residual(residual) => residual.fits::<T>(),
        };
        if !fits || !self.equation.at(point).is_defined() {
            return None;
        }
        let condition = self.condition(point, exact);
        (condition < limit).then_some(condition)
    }

    fn condition(&self, point: &[Dyadic], exact: &Exact) -> f64 {
        match (&self.kind, exact) {
            (Kind::Reduced(reduced), Exact::Fraction(fraction)) => reduced.condition(point, fraction),
            _ => balls::condition(&self.equation, point),
        }
    }

    /// Whether det A vanishes somewhere that the reduced map has a value.
    pub(super) fn has_removable_poles(&self) -> bool {
        matches!(&self.kind, Kind::Reduced(reduced) if !reduced.removable_poles.is_empty())
    }

    /// Whether there may be poles.
    pub(super) fn has_poles(&self) -> bool {
        match &self.kind {
            Kind::Reduced(reduced) => !reduced.poles.is_empty(),
            Kind::Balls | Kind::Residual(_) => true,
        }
    }

    /// The denominator, or what was divided out of it, in one of its variables, which is drawn.
    pub(super) fn zeros(
        &self,
        is_removable: bool,
        point: &[Dyadic],
        random: &mut SplitMix64,
    ) -> Option<Zeros> {
        match &self.kind {
            Kind::Reduced(reduced) => reduced.zeros(is_removable, point, random),
            Kind::Balls => Some(balls::zeros(&self.equation, point, random)),
            Kind::Residual(_) => residual::zeros(&self.equation, point, random),
        }
    }
}

impl Exact {
    /// Judges a finite result of a scalar.
    pub(super) fn judge<T: Float>(&self, result: &[Dyadic]) -> Verdict {
        match self {
            Self::Fraction(fraction) => fraction.judge::<T>(result),
            Self::Balls(balls) => balls.judge::<T>(result),
            Self::Residual(residual) => residual.judge::<T>(result),
        }
    }
}

#[cfg(test)]
mod tests;
