//! Reasons for refusing a reference trajectory.

use super::PART_OF_TOLERANCE;
use crate::error::{Spelling, by_name};

/// The reason for refusing a reference trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoReference {
    /// The solution escapes to infinity.
    Escapes {
        /// The approximate time of the escape.
        time: f64,
    },
    /// The series needs more memory than its limit allows.
    TooLong {
        /// The time that the series reached.
        reached: f64,
    },
    /// The time limit for the computation was reached.
    NoTime {
        /// The time that the series reached.
        reached: f64,
    },
    /// The two methods disagree.
    Disagree {
        /// The difference, relative to the flow's [`scale`](kahan_dynamics::Flow::scale).
        difference: f64,
        /// The allowed difference.
        allowed: f64,
        /// The time until which they agree.
        until: f64,
    },
}

impl core::fmt::Display for NoReference {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.tell(f, by_name)
    }
}

impl NoReference {
    pub(crate) fn tell(&self, f: &mut core::fmt::Formatter<'_>, spelling: Spelling) -> core::fmt::Result {
        match self {
            Self::Escapes { time } => write!(
                f,
                "the solution through this point escapes to infinity, or beyond the largest double, near t = {}; choose a shorter \
                 horizon",
                DisplayedTime(*time, 6)
            ),
            Self::TooLong { reached } => write!(
                f,
                "the horizon is too long for a reference trajectory: a Taylor series has filled a gibibyte when it reaches \
                 t = {}; choose a shorter horizon, or ask for {}, which takes no reference",
                DisplayedTime(*reached, 4),
                spelling("need", "integrals")
            ),
            Self::NoTime { reached } => write!(
                f,
                "a reference trajectory takes longer than there is time: the series came to t = {}, and a second method has to \
                 agree with it; give more {}, or choose a shorter horizon",
                DisplayedTime(*reached, 4),
                spelling("seconds", "")
            ),
            Self::Disagree { difference, allowed, .. } if *difference < LEAST_DIFFERENCE => write!(
                f,
                "no reference trajectory: in 32 digits, a Taylor series and a second method differ by {difference:.1e} of the \
                 solution's size where {allowed:.1e} is needed; choose a tolerance above {:.0e}",
                difference * (1.0 + 1e-3) / PART_OF_TOLERANCE
            ),
            Self::Disagree { difference, allowed, until } => write!(
                f,
                "no reference trajectory: in 32 digits, a Taylor series and a second method differ by {difference:.1e} of the \
                 solution's size where {allowed:.1e} is needed (they agree until about t = {}); the solution is too \
                 sensitive over this horizon for that tolerance: choose a shorter horizon or a larger tolerance",
                DisplayedTime(*until, 4)
            ),
        }
    }
}

impl core::error::Error for NoReference {}

/// A time, and the number of decimals to display. Very large or small times get an exponent.
struct DisplayedTime(f64, usize);

impl core::fmt::Display for DisplayedTime {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let DisplayedTime(time, decimals) = *self;
        if time == 0.0 || (1e-3..1e7).contains(&time.abs()) {
            write!(f, "{time:.decimals$}")
        } else {
            write!(f, "{time:.decimals$e}")
        }
    }
}

/// Relative differences below this bound may be rounding errors.
pub(super) const LEAST_DIFFERENCE: f64 = 1e-26;
