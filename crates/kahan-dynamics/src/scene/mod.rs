//! The choice of an integrator for a scene: scalar, order, compensation and ε.
//!
//! The choice is the cheapest accurate [`Setting`], by a cost model of counted operations
//! ([`cycles`]). For [`Need::Trajectory`], settings are run over the whole time and compared with
//! the flow ([`trajectory`], [`search`]). No clock is used, so the choice is reproducible. The
//! command `kahan trade` runs the search with measured prices.

mod cycles;
mod error;
mod integrals;
mod run;
mod scheme;
pub mod search;
mod setting;
mod trajectory;

use kahan_core::nalgebra::SVector;

use kahan_core::ExtendScalars;

pub use error::NoSetting;
pub use scheme::{Precision, Scheme};
pub use setting::Setting;

/// The purpose of an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Need {
    /// The orbit follows the flow's trajectory. The error is the largest distance from the
    /// trajectory over all steps in the maximum norm, relative to the trajectory's largest
    /// coordinate.
    Trajectory,
    /// The orbit preserves the integrals. The error is the largest relative change of the map's own
    /// integrals, which only rounding causes ([`Scene::condition`]). For a composition, the error
    /// is the change of the flow's integrals.
    Integrals,
}

/// A time to be simulated, with the purpose and accuracy of the orbit.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_dynamics::Scene;
///
/// kahan! {
///     /// Predator and prey.
///     pub struct LotkaVolterra;
///     xdot = x*(1 - y);
///     ydot = y*(x - 1);
/// }
///
/// // Twenty units of time, to nine digits.
/// let start = vector![1.5, 1.0];
/// let setting = Scene::trajectory(20.0, 1e-9).choose(&LotkaVolterra, &start)?;
/// assert_eq!(setting.scheme().order(), 8);
/// assert!(setting.error() <= 1e-9);
///
/// // x − ln x + y − ln y is constant along the flow.
/// let level = |x: SVector<f64, 2>| x[0] - x[0].ln() + x[1] - x[1].ln();
/// let last = setting.run(&LotkaVolterra, start);
/// assert!((level(last) - level(start)).abs() < 1e-9);
///
/// // As one would write it:
/// println!("{setting}");
/// # Ok::<(), kahan_dynamics::NoSetting>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scene {
    horizon: f64,
    need: Need,
    tolerance: f64,
    condition: f64,
}

impl Scene {
    /// Describes a scene: `horizon` is the time to be simulated, and `tolerance` the largest
    /// accepted error. [`choose`](Self::choose) checks that both are finite and positive.
    #[must_use]
    pub const fn new(horizon: f64, need: Need, tolerance: f64) -> Self {
        Self { horizon, need, tolerance, condition: 4.0 }
    }

    /// Describes a scene in which the orbit follows the trajectory.
    #[must_use]
    pub const fn trajectory(horizon: f64, tolerance: f64) -> Self {
        Self::new(horizon, Need::Trajectory, tolerance)
    }

    /// Describes a scene in which the orbit preserves the integrals.
    #[must_use]
    pub const fn integrals(horizon: f64, tolerance: f64) -> Self {
        Self::new(horizon, Need::Integrals, tolerance)
    }

    /// Sets the condition Σ|xᵢ ∂H/∂xᵢ|/|H| of the integrals H, for [`Need::Integrals`].
    ///
    /// The condition is the factor by which relative changes of the state are amplified. The
    /// default 4 is typical if H is a homogeneous polynomial of degree 2, and |H| is half the sum
    /// of the absolute values of its terms. Near zeros of H the condition is much larger.
    #[must_use]
    pub const fn condition(mut self, condition: f64) -> Self {
        self.condition = condition;
        self
    }

    /// Returns the setting of least modelled cost that meets the tolerance.
    ///
    /// The setting is never in `f32`, because a step of a single orbit takes as long as in `f64`.
    /// For an [`Ensemble`](kahan_core::Ensemble), `f32` saves memory and time.
    ///
    /// # How
    /// For [`Need::Trajectory`], settings are run over the whole horizon and compared with the
    /// [`Flow`](crate::Flow) at every step. The error of the chosen setting, including rounding, is
    /// at most 0.85 of the tolerance. An orbit in [`Dd`](kahan_core::Dd) must agree with the flow
    /// to a tenth of the tolerance. The choice is deterministic, and running the setting gives
    /// exactly its error. Other starts and later times are not covered.
    ///
    /// For [`Need::Integrals`], only Kahan's map itself is considered. ε‖f′‖∞ is at most 1 at the
    /// start, and less if the first steps would otherwise become too large. The rounding errors of
    /// n steps are modelled as a random walk.
    ///
    /// # How good
    /// `cargo test --release -p kahan-study --test scenes -- --ignored` tests choices in random
    /// scenes, whose orbits may be chaotic, stiff or escaping. No choice may exceed its tolerance.
    /// The package `kahan-bench-trade` times choices against all other settings.
    ///
    /// # Cost
    /// A choice takes at most the time of 10⁶ steps of the map, and usually of some 10⁴ steps.
    /// Steps in `Dd` take longer.
    ///
    /// # Errors
    /// Returns [`NoSetting`] for invalid numbers, for a trajectory that cannot be followed to the
    /// horizon, or for a tolerance that no setting reaches.
    pub fn choose<M, const N: usize>(&self, map: &M, x0: &SVector<f64, N>) -> Result<Setting, NoSetting>
    where
        M: ExtendScalars<f64, N>,
    {
        self.check(x0)?;
        match self.need {
            Need::Trajectory => trajectory::choose(self, map, x0),
            Need::Integrals => integrals::choose(self, map, x0),
        }
    }

    /// Returns the time to be simulated.
    #[must_use]
    pub const fn horizon(&self) -> f64 {
        self.horizon
    }

    /// Returns the purpose of the orbit.
    #[must_use]
    pub const fn need(&self) -> Need {
        self.need
    }

    /// Returns the largest accepted error.
    #[must_use]
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    fn check<const N: usize>(&self, x0: &SVector<f64, N>) -> Result<(), NoSetting> {
        let quantities =
            [("horizon", self.horizon), ("tolerance", self.tolerance), ("condition", self.condition)];
        for (name, value) in quantities {
            if !(value.is_finite() && value > 0.0) {
                return Err(NoSetting::NotPositive { name, value });
            }
        }
        match x0.iter().position(|entry| !entry.is_finite()) {
            Some(index) => Err(NoSetting::NotFinite { index }),
            None => Ok(()),
        }
    }
}
