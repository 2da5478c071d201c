//! Why a step has no value.
//!
//! In: det A and ε as the step met them. Out: a report in the terms of the map.
//! It holds floats only, whatever the scalar, so that it is `Copy` and never allocates; it is a report, not a number
//! to compute with.

use core::fmt;

use crate::Scalar;

/// There is no (finite) step from this point: the point is a pole of the map, or the numbers overflow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SingularStep {
    determinant: f64,
    bound: f64,
    eps: f64,
}

impl SingularStep {
    /// What was met: det A(x,ε) and ε, both rounded to `f64`.
    pub(crate) fn new(determinant: f64, eps: f64) -> Self {
        Self { determinant, bound: f64::INFINITY, eps }
    }

    /// A step whose error is bounded by no less than this multiple of its largest component.
    pub(crate) fn unestablished(determinant: f64, bound: f64, eps: f64) -> Self {
        Self { determinant, bound, eps }
    }

    /// An exact pole, where det A is 0.
    pub(crate) fn pole(eps: f64) -> Self {
        Self::new(0.0, eps)
    }

    /// det A(x,ε) at the point, rounded to `f64`: 0 at an exact pole, not a number where it overflows.
    pub fn determinant(&self) -> f64 {
        self.determinant
    }

    /// The smallest bound on ‖x̃ − exact‖∞/‖exact‖∞ that was reached in any precision: infinite at a pole, and where none was
    /// sought. A bound below 64 u belongs to a result that the scalar cannot hold.
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
        let Self { determinant, bound, eps } = *self;
        if determinant == 0.0 {
            write!(f, "det A = 0: the Kahan map has a pole at this point")?;
        } else if determinant.is_finite() && bound.is_finite() && bound > 1e-30 {
            write!(
                f,
                "det A = {determinant:?}: this point is too near to a pole, the relative error of the step from it is \
                 only known to be at most {bound:.0e}"
            )?;
        } else if determinant.is_finite() {
            write!(
                f,
                "det A = {determinant:?}: the Kahan step from this point is beyond the range of the scalar"
            )?;
        } else {
            write!(f, "det A is not finite: the point, eps or a parameter is too large or not a number")?;
        }
        // A scalar that nothing approximates has no ε to print.
        if eps.is_nan() { Ok(()) } else { write!(f, " (eps = {eps:?}, half the time step)") }
    }
}

impl core::error::Error for SingularStep {}

/// The end of a call that has no way to report a pole.
#[cold]
pub(crate) fn pole<T: Scalar>(eps: &T) -> ! {
    panic!("{}", SingularStep::pole(eps.approximate()))
}
