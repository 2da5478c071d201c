//! Why a step has no value.
//!
//! In: det A and ε as the step met them, and what is the case. Out: a report in the terms of the
//! map. It holds floats only, whatever the scalar, so that it is `Copy` and never allocates; it is
//! a report, not a number to compute with.

use core::fmt;

use crate::Scalar;

/// There is no (finite) step from this point: the point is a pole of the map, or the numbers
/// overflow, or their digits run out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SingularStep {
    determinant: f64,
    bound: f64,
    eps: f64,
    reason: Reason,
}

/// The reason why there is no step; see [`SingularStep::reason`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// The map has no value there, exactly.
    Pole,
    /// The point, ε or a parameter is not a finite number.
    NotFinite,
    /// The field has no value at the parameters: it divides by zero.
    NoField,
    /// The step is known, and the scalar does not hold it.
    BeyondRange,
    /// So many digits of 64 bits leave open what the step is.
    Digits(usize),
    /// Elimination and its refinements leave too large a backward error.
    Refined,
    /// Numbers overflowed before anything else was known.
    Overflow,
    /// Along lines through the point the iterates of the map have different limits; orbits through
    /// poles alone meet it.
    Indeterminate,
    /// Lines through the point show no limit; orbits through poles alone meet it.
    Unfollowed,
}

impl SingularStep {
    /// What a step without bounds met: det A(x,ε) and ε, both rounded to `f64`.
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

    /// A step whose error is bounded by no less than this multiple of its largest component, or not
    /// promised for this reason.
    pub(crate) fn because(reason: Reason, determinant: f64, bound: f64, eps: f64) -> Self {
        Self { determinant, bound, eps, reason }
    }

    /// An exact pole, where det A is 0.
    pub(crate) fn pole(eps: f64) -> Self {
        Self::new(0.0, eps)
    }

    /// Returns the reason why there is no step.
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

    /// det A(x,ε) at the point, rounded to `f64`: 0 at an exact pole, not a number where it was not
    /// looked at or overflows.
    pub fn determinant(&self) -> f64 {
        self.determinant
    }

    /// The smallest bound on ‖x̃ − exact‖∞/‖exact‖∞ that was reached in any precision: infinite at
    /// a pole, and where none was sought. In more than eight variables it is the backward error.
    /// A bound below 64 u belongs to a result that the scalar cannot hold.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// ε, half the time step, of the step that failed, rounded to `f64`.
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
        // A scalar that nothing approximates has no ε to print.
        if eps.is_nan() { Ok(()) } else { write!(f, " (eps = {eps:?}, half the time step)") }
    }
}

impl core::error::Error for SingularStep {}

/// The end of a call that has no way to report a pole.
#[cold]
pub fn pole<T: Scalar>(eps: &T) -> ! {
    panic!("{}", SingularStep::pole(eps.approximate()))
}
