//! How an orbit ended, and after how many steps: the one definition, for all who follow orbits.

/// How an orbit ended. The number is the steps from its start to its last point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All steps were made.
    Complete,
    /// In floats the next point is not finite: a pole, or numbers too large for the scalar. A start
    /// that is not finite ends so after no step.
    Range(u64),
    /// In exact numbers the next point has no value: det A = 0.
    Pole(u64),
    /// A variable of the last point is larger than the bound that was asked for.
    Escaped(u64),
    /// Symmetric projection onto the relations of a lift did not converge.
    Reembed(u64),
    /// The time was up.
    Time(u64),
    /// An observer had seen all that it wants, or a watch stopped the work.
    Stopped(u64),
}

impl End {
    /// Its name in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Range(_) => "range",
            Self::Pole(_) => "pole",
            Self::Escaped(_) => "escaped",
            Self::Reembed(_) => "reembed",
            Self::Time(_) => "time",
            Self::Stopped(_) => "stopped",
        }
    }

    /// Returns the number of steps to the last point, where `asked` steps were asked for.
    #[must_use]
    pub fn steps(self, asked: u64) -> u64 {
        match self {
            Self::Complete => asked,
            Self::Range(steps)
            | Self::Pole(steps)
            | Self::Escaped(steps)
            | Self::Reembed(steps)
            | Self::Time(steps)
            | Self::Stopped(steps) => steps,
        }
    }

    /// Returns the end of the whole orbit, where `before` steps were made before this part of it.
    #[must_use]
    pub fn after(self, before: u64) -> Self {
        match self {
            Self::Complete => Self::Complete,
            Self::Range(steps) => Self::Range(before + steps),
            Self::Pole(steps) => Self::Pole(before + steps),
            Self::Escaped(steps) => Self::Escaped(before + steps),
            Self::Reembed(steps) => Self::Reembed(before + steps),
            Self::Time(steps) => Self::Time(before + steps),
            Self::Stopped(steps) => Self::Stopped(before + steps),
        }
    }

    /// Whether an answer about the whole orbit has no value: it neither went on to the last step,
    /// nor stopped because somebody had seen enough.
    #[must_use]
    pub fn is_early(self) -> bool {
        !matches!(self, Self::Complete | Self::Stopped(_))
    }
}
