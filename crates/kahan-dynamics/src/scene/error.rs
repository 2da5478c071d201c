//! Why no setting serves.

use std::fmt;

/// Why there is no setting for a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoSetting {
    /// A number of the scene is not finite or not above 0.
    NotPositive {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A coordinate of the first point is not finite.
    NotFinite {
        /// Its index.
        index: usize,
    },
    /// The solution leaves the finite range before the horizon, or is so sensitive that not even in
    /// 32 digits two methods agree on it.
    Lost {
        /// The time at which it leaves, or until which an orbit came near to it, to a tenth of the
        /// trajectory's size.
        time: f64,
    },
    /// The horizon takes more than the 10⁶ steps that a choice may cost to be looked at as a whole.
    TooLong {
        /// How far it was followed.
        time: f64,
    },
    /// No setting is as accurate as that, or none that could be found and vouched for in the 10⁶
    /// steps that a choice may cost.
    OutOfReach {
        /// A tolerance that is expected to be met.
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
