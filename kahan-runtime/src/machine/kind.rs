//! Which step there is code for.

#[cfg(feature = "jit")]
use kahan_algebra::plan::StepPlan;
use kahan_core::Precision;

/// Which of the two forms of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Form {
    /// The one that serves the orbit of one point at an ordinary ε.
    Own,
    /// The one that serves every scalar and every ε.
    AnyEps,
}

#[cfg(feature = "jit")]
impl Form {
    /// The plan of this form.
    pub(super) fn of(self, step: &StepPlan) -> &StepPlan {
        match self {
            Form::Own => step,
            Form::AnyEps => step.for_any_step(),
        }
    }
}

/// Which step is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct StepKind {
    /// In what the state is kept, and the step computed.
    pub(crate) precision: Precision,
    /// Whether the state is carried with its rounding error.
    pub(crate) compensated: bool,
    /// Whether an increment is rounded before it is added, as the general form of a step that has
    /// another one for ordinary ε is.
    pub(crate) rounds_increments: bool,
    /// Whether multiply-adds are fused.
    pub(crate) fuses: bool,
}

impl StepKind {
    /// The plain step over T, a float of the machine.
    pub(crate) fn of<T>(fuses: bool) -> Self {
        let precision =
            if size_of::<T>() == size_of::<f32>() { Precision::Single } else { Precision::Double };
        StepKind { precision, compensated: false, rounds_increments: false, fuses }
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
