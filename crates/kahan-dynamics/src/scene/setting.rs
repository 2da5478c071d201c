//! A way to step an orbit, chosen.

use std::fmt;

use kahan_core::Composition;

use super::{Need, Precision, Scene, Scheme};

/// Below this tolerance the rounding of ε, which moves the end by as much of the horizon, is felt.
const EPS_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A way to step an orbit over the horizon of a [`Scene`](crate::Scene): a [`Scheme`], ε and a
/// number of steps; [`Scene::choose`](crate::Scene::choose) makes the cheapest that serves.
///
/// It is printed as a line of Rust, with `map` for the map and `x` for the first point, both of its
/// precision.
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
    /// A setting of one's own choosing over this scene's horizon, of about so many steps; what
    /// error to expect of it is not known, and is said to be infinite.
    ///
    /// In `Dd` it is the next power of 2 where the horizon is to be met more accurately than an ε
    /// that is rounded, to an `f64` in every precision, has it.
    ///
    /// # Panics
    /// If the horizon is not a finite number above 0, or `steps` is 0.
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
    /// The numbers, the method, and whether the state carries its rounding error.
    #[must_use]
    pub const fn scheme(&self) -> Scheme {
        self.scheme
    }

    /// ε, half the time step; for [`Need::Integrals`] one of so few bits that its powers are exact
    /// ([`nearest_short_eps`](kahan_core::nearest_short_eps)).
    #[must_use]
    pub const fn eps(&self) -> f64 {
        self.eps
    }

    /// The number of steps: 2ε times this is the horizon, but for the rounding of ε; for
    /// [`Need::Integrals`], whose ε has few bits, but for less than half a step.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.steps
    }

    /// The error to expect, with the safety factors in it: of what was chosen, at most the scene's
    /// tolerance.
    #[must_use]
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// The line of Rust that runs it, from a map and a first point of its precision as they are
    /// written there.
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
        // x₀ and every step after it.
        format!("let orbit = {orbit}{composed}{compensated}.take({});", u128::from(steps) + 1)
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.in_rust("map", "x"))
    }
}

/// The error of a setting as data: `None` where it is not known, as JSON has no infinite numbers.
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
