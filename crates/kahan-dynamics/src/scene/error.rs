//! The reasons why no setting can be chosen.

use std::fmt;

/// The reason why no setting was chosen for a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoSetting {
    /// A number of the scene is not finite or not positive.
    NotPositive {
        /// The name of the number.
        name: &'static str,
        /// The rejected value, for example 0 or NaN.
        value: f64,
    },
    /// A coordinate of the first point is not finite.
    NotFinite {
        /// The index of the coordinate.
        index: usize,
    },
    /// The solution escapes before the end of the scene, or no orbit in `Dd` confirms the solution.
    Lost {
        /// The time of the escape, or the time until which the distance of an orbit from the
        /// trajectory stayed below a tenth of the trajectory's size.
        time: f64,
    },
    /// The solution cannot be followed to the end of the scene at a cost of at most 10⁶ steps.
    TooLong {
        /// The time that the computation reached.
        time: f64,
    },
    /// No setting meets the tolerance, or none could be checked at a cost of at most 10⁶ steps.
    OutOfReach {
        /// A tolerance that can probably be met.
        best: f64,
    },
}

impl fmt::Display for NoSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotPositive { name, value } => {
                write!(f, "the {name} of a scene must be a finite number above 0, not {value:?}")
            }
            Self::NotFinite { index } => {
                write!(f, "coordinate {index} of the first point is not a finite number")
            }
            Self::Lost { time } => write!(
                f,
                "the trajectory cannot be followed beyond the time {time:.3}: there it leaves the finite range, or its errors \
                 grow as large as itself; ask for a shorter horizon"
            ),
            Self::TooLong { time } => write!(
                f,
                "a choice looks at the whole horizon, in 10^6 steps at most, and these came to the time {time:.3}; ask for a shorter \
                 horizon, or try a setting of your own (`Scene::setting`)"
            ),
            Self::OutOfReach { best } => {
                write!(
                    f,
                    "no setting that is that accurate here was found in the 10^6 steps that a choice may cost; the least tolerance \
                     within reach is about {best:.1e}"
                )
            }
        }
    }
}

impl std::error::Error for NoSetting {}
