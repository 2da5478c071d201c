//! Which step there is code for.

use kahan_core::Constant;
use kahan_dynamics::Precision;

use crate::engine::RuntimeFloat;

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
    /// The plain step of states in this precision.
    pub(crate) fn of(precision: Precision, fuses: bool) -> Self {
        StepKind { precision, compensated: false, is_general: false, rounds_increments: false, fuses }
    }

    /// ε of a stage with the coefficient γ.
    pub(crate) fn stage_eps<T: RuntimeFloat>(self, gamma: &Constant<'_>, eps: T) -> T {
        self.stored(self.stored(T::constant(gamma)) * eps)
    }

    /// A number as states hold it.
    pub(crate) fn stored<T: RuntimeFloat>(self, x: T) -> T {
        match self.precision {
            Precision::SingleThroughDouble => T::from(x.approximate() as f32),
            _ => x,
        }
    }
}
