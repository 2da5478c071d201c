//! The error of a step that has no finite result, or none of proved accuracy.
//!
//! The error stores floats for every scalar, and therefore is `Copy`.

use core::fmt;

use crate::Scalar;

/// The error of a step without a finite result: a pole, an overflow, or insufficient precision.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SingularStep {
    determinant: f64,
    bound: f64,
    eps: f64,
    reason: Reason,
}

/// The reason why a step failed; see [`SingularStep::reason`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// The point is an exact pole of the map.
    Pole,
    /// The point, ε or a parameter is infinite or NaN.
    NotFinite,
    /// The field divides by zero at these parameters.
    NoField,
    /// The result is known, but lies beyond the range of the scalar.
    BeyondRange,
    /// Numbers with this many 64-bit digits do not determine the step.
    Digits(usize),
    /// After elimination with iterative refinement, the backward error was too large.
    Refined,
    /// Numbers overflowed before any other reason was found.
    Overflow,
    /// Limits along different lines through the point differ; only orbits through poles return
    /// this.
    Indeterminate,
    /// No limit along lines through the point was found; only orbits through poles return this.
    Unfollowed,
}

impl SingularStep {
    /// Creates an error from det A(x,ε) and ε, for a step without an error bound.
    pub(crate) fn new(determinant: f64, eps: f64) -> Self {
        let reason = if determinant == 0.0 {
            Reason::Pole
        } else if determinant.is_finite() {
            Reason::BeyondRange
        } else {
            Reason::Overflow
        };
        Self::because(reason, determinant, f64::INFINITY, eps)
    }

    /// Creates the error for a reason, with the smallest relative error bound that was reached.
    pub(crate) fn because(reason: Reason, determinant: f64, bound: f64, eps: f64) -> Self {
        Self { determinant, bound, eps, reason }
    }

    pub(crate) fn pole(eps: f64) -> Self {
        Self::new(0.0, eps)
    }

    /// Returns the reason why the step failed.
    ///
    /// ```
    /// use kahan_core::Reason;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! { pub struct Riccati; xdot = x^2; }
    ///
    /// // x̃ = x/(1 − 2εx)
    /// assert_eq!(Riccati.try_step(&vector![1.0], 0.5).unwrap_err().reason(), Reason::Pole);
    /// let unknown = Riccati.try_step(&vector![f64::NAN], 0.5).unwrap_err();
    /// assert_eq!(unknown.reason(), Reason::NotFinite);
    /// ```
    pub fn reason(&self) -> Reason {
        self.reason
    }

    /// Returns det A(x,ε) rounded to `f64`, which is 0 at an exact pole and NaN if unknown.
    pub fn determinant(&self) -> f64 {
        self.determinant
    }

    /// Returns the smallest bound on ‖x̃ − exact‖∞/‖exact‖∞ that any precision level reached.
    ///
    /// The bound is infinite at a pole, and if no bound was computed. In more than eight variables,
    /// the bound of the backward error is returned.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Returns ε, half the time step of the failed step, rounded to `f64`.
    pub fn eps(&self) -> f64 {
        self.eps
    }
}

impl fmt::Display for SingularStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { determinant, bound, eps, reason } = *self;
        if determinant.is_finite() && !matches!(reason, Reason::Pole | Reason::NotFinite) {
            write!(f, "det A = {determinant:?}: ")?;
        }
        match reason {
            Reason::Pole => write!(f, "det A = 0: the Kahan map has a pole at this point")?,
            Reason::NotFinite => write!(f, "the point, eps or a parameter is not a finite number")?,
            Reason::NoField => write!(f, "the field divides by zero at these parameters")?,
            Reason::BeyondRange => {
                write!(f, "the Kahan step from this point is beyond the range of the scalar")?;
            }
            Reason::Digits(count) if bound.is_finite() => write!(
                f,
                "{count} digits of 64 bits settle the step from this point no better than to a relative error of {bound:.0e}"
            )?,
            Reason::Digits(count) => {
                write!(f, "{count} digits of 64 bits do not tell whether this point is a pole")?;
            }
            Reason::Refined if bound.is_infinite() => write!(
                f,
                "elimination leaves the range of the scalar, or its digits do not tell the backward error"
            )?,
            Reason::Refined => {
                write!(f, "the refined step leaves a backward error of {bound:.0e}")?;
            }
            Reason::Overflow => {
                write!(f, "det A is not finite: the point, eps or a parameter is too large or not a number")?;
            }
            Reason::Indeterminate => write!(
                f,
                "the iterates of the map have no value at this point, not even at infinity: lines through it lead to different points"
            )?,
            Reason::Unfollowed => {
                write!(
                    f,
                    "a pole has brought many points to this one, and series or digits end before they come apart"
                )?;
            }
        }
        // ε is NaN if the scalar has no `f64` approximation.
        if eps.is_nan() { Ok(()) } else { write!(f, " (eps = {eps:?}, half the time step)") }
    }
}

impl core::error::Error for SingularStep {}

/// Panics with the report of a pole. Functions that cannot return an error call this.
#[cold]
pub fn pole<T: Scalar>(eps: &T) -> ! {
    panic!("{}", SingularStep::pole(eps.approximate()))
}
