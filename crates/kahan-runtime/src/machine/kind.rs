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
    /// They are stepped.
    Steps(StepKind),
    /// They are stepped, with tangent vectors behind them.
    Carrying(Carrying),
    /// Their integrals are written behind them; constants are the parameters and ε.
    Integrals,
}

/// A step that carries tangent vectors along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Carrying {
    /// The step of the point, or that of the variational field.
    pub(crate) kind: StepKind,
    /// Whether it is the step of the variational field. Otherwise the line of
    /// [`Object::Tangent`](crate::engine::Object) carries the vectors, and its constants, the
    /// parameters and ε, come behind those of the step.
    pub(crate) is_variational: bool,
    /// The number of vectors.
    pub(crate) vectors: usize,
    /// Whether the squares of their lengths come behind them.
    pub(crate) has_squares: bool,
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
