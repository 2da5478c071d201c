//! The norm ‖f′(x)‖∞ of a field's Jacobian, and [`CannotRun`], the error for fields without a map.

use kahan_runtime::interpreted::UnsupportedDimension;
use kahan_runtime::{MapAt, ParameterError};

/// The reason why a system cannot be run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CannotRun {
    /// The system has too many variables.
    Dimension(UnsupportedDimension),
    /// The system is undefined at the given parameters.
    Parameters(ParameterError),
}

impl core::fmt::Display for CannotRun {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Dimension(why) => why.fmt(f),
            Self::Parameters(why) => why.fmt(f),
        }
    }
}

impl core::error::Error for CannotRun {}

/// Returns the norm ‖f′(x)‖∞ of the Jacobian of the field f that `at` discretises.
pub(crate) fn rate(at: &MapAt<f64>, x: &[f64]) -> f64 {
    let mut jacobian = vec![0.0; x.len() * x.len()];
    // Both slices have the lengths that the field requires, so the call succeeds.
    let _ = at.field_jacobian(x, &mut jacobian);
    let rows = jacobian.chunks(x.len().max(1));
    rows.map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max)
}
