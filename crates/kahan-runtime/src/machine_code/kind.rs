//! The kinds of step that can be compiled; they are the keys of the code tables.

use kahan_core::Constant;
use kahan_dynamics::Precision;

use crate::engine::RuntimeFloat;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct StepKind {
    /// The precision of stored states, and the precision in which steps are computed.
    pub(crate) precision: Precision,
    pub(crate) compensated: bool,
    /// Whether the step uses the formula that is valid for every scalar and every ε.
    pub(crate) is_general: bool,
    pub(crate) rounds_increments: bool,
    pub(crate) fuses: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum GroupKind {
    Steps(StepKind),
    Carrying(TangentKind),
    /// Code that writes integrals after each point. Its constants are the parameters and ε.
    Integrals,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct TangentKind {
    /// The kind of step, of the field itself or, if `is_variational`, of the variational field.
    pub(crate) kind: StepKind,
    /// Whether `kind` is a step of the variational field. If not, the program of
    /// [`MapObject::Tangent`](crate::engine::MapObject) propagates vectors.
    pub(crate) is_variational: bool,
    pub(crate) vectors: usize,
    pub(crate) has_squares: bool,
}

impl StepKind {
    /// Whether the interpreter, which is compiled by rustc, fuses multiply-adds.
    pub(crate) const INTERPRETER_FUSES: bool = cfg!(target_feature = "fma");

    pub(crate) fn of(precision: Precision, fuses: bool) -> Self {
        StepKind { precision, compensated: false, is_general: false, rounds_increments: false, fuses }
    }

    /// Returns γε, the ε of a stage with coefficient γ.
    pub(crate) fn stage_eps<T: RuntimeFloat>(self, gamma: &Constant<'_>, eps: T) -> T {
        self.stored(self.stored(T::constant(gamma)) * eps)
    }

    pub(crate) fn stored<T: RuntimeFloat>(self, x: T) -> T {
        match self.precision {
            Precision::SingleThroughDouble => T::from(x.approximate() as f32),
            _ => x,
        }
    }
}
