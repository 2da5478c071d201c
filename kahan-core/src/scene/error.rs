//! Why no setting serves.

use core::fmt;

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
    /// No order's orbits agree with each other to the horizon, however fine: the solution leaves the finite range, or is chaotic for
    /// longer than `f64` can follow it.
    Lost {
        /// The time until which the best of them agreed to a tenth of the trajectory's size.
        time: f64,
    },
    /// The horizon is too long to be run in pilot orbits, and the errors grow too fast to be continued.
    Unpredictable {
        /// The time that the pilots covered.
        time: f64,
        /// The power of time with which the errors grew at its end.
        power: f64,
    },
    /// No setting is as accurate as that.
    OutOfReach {
        /// The least tolerance that some setting is expected to meet.
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
            Self::Unpredictable { time, power } => write!(
                f,
                "errors grow like t^{power:.1} by the time {time:.3}, too fast to say what they are at the horizon; ask for a \
                 shorter one"
            ),
            Self::OutOfReach { best } => {
                write!(
                    f,
                    "no setting is that accurate here; the least tolerance within reach is about {best:.1e}"
                )
            }
        }
    }
}

impl core::error::Error for NoSetting {}
