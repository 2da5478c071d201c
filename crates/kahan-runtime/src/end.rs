//! The ends of orbits.

/// The reason why an orbit ended, with the number of steps to its last point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All requested steps were made.
    Complete,
    /// The next point is not finite in floats, because of a pole or overflow. An orbit with a
    /// nonfinite start ends after 0 steps.
    Range(u64),
    /// In exact numbers the next point does not exist, since the matrix of the step is singular.
    Pole(u64),
    /// A variable of the last point exceeds the requested bound.
    Escaped(u64),
    /// Projection onto the equations that define a lifted field's new variables did not converge.
    Reembed(u64),
    /// The time limit was reached.
    Time(u64),
    /// The observers needed no further points, or the caller stopped the run.
    Stopped(u64),
}

impl End {
    /// Returns the name of this reason, as results contain it.
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

    /// Returns the number of steps to the last point, if `asked` steps were requested.
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

    /// Adds to the number of steps the `before` steps that an earlier run made.
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

    /// Returns whether the orbit ended early, for a reason other than [`Stopped`](Self::Stopped).
    #[must_use]
    pub fn is_early(self) -> bool {
        !matches!(self, Self::Complete | Self::Stopped(_))
    }
}
