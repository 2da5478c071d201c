//! Which step there is code for.

use kahan_core::{Precision, Scheme};

/// Which step is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct StepKind {
    /// In what the state is kept, and the step computed.
    pub(crate) precision: Precision,
    /// Whether the state is carried with its rounding error.
    pub(crate) compensated: bool,
    /// Whether it is the form that serves every scalar and every ε, rather than the one for the
    /// orbit of one point at an ordinary ε.
    pub(crate) is_general: bool,
    /// Whether an increment is rounded before it is added, as the general form of a step that has
    /// another one for ordinary ε is.
    pub(crate) rounds_increments: bool,
    /// Whether multiply-adds are fused.
    pub(crate) fuses: bool,
}

/// What is done with points side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum SideBySide {
    /// They are stepped, each with so many tangent vectors; where these are some, the field is a
    /// variational one.
    Steps(StepKind, usize),
    /// Their integrals are written behind them; constants are the parameters and ε.
    Integrals,
}

impl StepKind {
    /// The plain step over T, a float of the machine.
    pub(crate) fn of<T>(fuses: bool) -> Self {
        let precision =
            if size_of::<T>() == size_of::<f32>() { Precision::Single } else { Precision::Double };
        StepKind { precision, compensated: false, is_general: false, rounds_increments: false, fuses }
    }

    /// The step of a scheme, with multiply-adds as everything else in this program has them.
    pub(crate) fn of_scheme(Scheme { precision, compensated, .. }: Scheme) -> Self {
        let fuses = cfg!(target_feature = "fma");
        StepKind { precision, compensated, is_general: false, rounds_increments: false, fuses }
    }

    /// How many numbers a state is.
    pub(crate) fn numbers(self, variables: usize) -> usize {
        match self.precision {
            Precision::DoubleDouble => 2 * variables + 1,
            _ if self.compensated => 2 * variables,
            _ => variables,
        }
    }
}
