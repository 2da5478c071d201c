//! A chosen scheme with its ε and number of steps.

use std::fmt;

use kahan_core::Composition;

use super::{Need, Precision, Scene, Scheme};

/// For smaller tolerances, rounding ε to `f64` changes the end time of an orbit too much.
const EPS_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A [`Scheme`] with ε and a number of steps, for the time span of a [`Scene`](crate::Scene).
///
/// `Display` writes a line of Rust in which `map` is the map and `x` the first point, both in the
/// setting's precision.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Setting {
    pub(super) scheme: Scheme,
    pub(super) eps: f64,
    pub(super) steps: u64,
    #[cfg_attr(feature = "serde", serde(with = "expected"))]
    pub(super) error: f64,
}

impl Scene {
    /// Builds a setting of about `steps` steps over the whole time. The error is infinite, because
    /// it is not measured.
    ///
    /// In `Dd`, ε is rounded to `f64`. For a trajectory with a very small tolerance, the number of
    /// steps becomes a power of 2, so that ε is exact.
    ///
    /// # Panics
    /// If the horizon is not finite and positive, or `steps` is 0.
    pub fn setting(&self, scheme: Scheme, steps: u64) -> Setting {
        assert!(
            self.horizon.is_finite() && self.horizon > 0.0,
            "the horizon must be a finite number above 0"
        );
        assert!(steps > 0, "an orbit over a horizon has at least one step");
        let is_finer = (self.need, scheme.precision) == (Need::Trajectory, Precision::DoubleDouble)
            && self.tolerance < EPS_ROUNDING;
        let steps = if is_finer { steps.next_power_of_two() } else { steps };
        let eps = scheme.precision.eps_near(0.5 * self.horizon / steps as f64, self.need);
        let steps = (0.5 * self.horizon / eps).round().max(1.0) as u64;
        Setting { scheme, eps, steps, error: f64::INFINITY }
    }
}

impl Setting {
    /// Returns the scalar, the composition and the compensation.
    #[must_use]
    pub const fn scheme(&self) -> Scheme {
        self.scheme
    }

    /// Returns ε, half the time step. For [`Need::Integrals`], powers of ε are exact
    /// ([`nearest_short_eps`](kahan_core::nearest_short_eps)).
    #[must_use]
    pub const fn eps(&self) -> f64 {
        self.eps
    }

    /// Returns the number of steps n. The horizon is 2εn up to the rounding of ε, or up to half a
    /// step for [`Need::Integrals`].
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.steps
    }

    /// Returns the expected error, including safety factors.
    #[must_use]
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// Returns the line of Rust that runs the setting. `map` and `start` are expressions in the
    /// setting's precision.
    #[must_use]
    pub fn in_rust(&self, map: &str, start: &str) -> String {
        let Self { scheme: Scheme { precision, composition, compensated }, eps, steps, .. } = *self;
        let orbit = match precision {
            Precision::Single | Precision::Double => format!("{map}.orbit({start}, {eps:?})"),
            Precision::SingleThroughDouble => format!("ThroughF64({map}).orbit({start}, {eps:?})"),
            Precision::DoubleDouble => format!("{map}.orbit({start}, Dd::from({eps:?}))"),
        };
        let composed = if composition == Composition::KAHAN {
            String::new()
        } else {
            format!(".composed(Composition::{})", composition.name())
        };
        let compensated = if compensated { ".compensated()" } else { "" };
        // The orbit includes x₀, and so has one point more than steps.
        format!("let orbit = {orbit}{composed}{compensated}.take({});", u128::from(steps) + 1)
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.in_rust("map", "x"))
    }
}

/// Stores an infinite error as `None`, because JSON has no infinity.
#[cfg(feature = "serde")]
mod expected {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(error: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        error.is_finite().then_some(*error).serialize(serializer)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(deserializer: D) -> Result<f64, D::Error> {
        Ok(Option::deserialize(deserializer)?.unwrap_or(f64::INFINITY))
    }
}
