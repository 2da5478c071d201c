//! The stepper for a scene: which numbers, which order, compensated or not, and which ε.
//!
//! In: a map, a first point, a time to be simulated, what the orbit is for and how accurate it must
//! be. Out: the [`Setting`] that serves at the least modelled cost. Nothing is timed, so the answer
//! is the same on every machine of one kind, and every time: a trajectory is compared with the flow
//! itself ([`trajectory`]), setting by setting ([`search`]), and the plan's own count of operations
//! gives the price ([`cycles`]). The command `kahan trade` makes the search with prices that it
//! measures. Deliberately absent: extrapolation. What is chosen has been run, over the whole
//! horizon.

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

/// What an orbit is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Need {
    /// To follow the flow's trajectory: the error is the largest distance from it over the horizon,
    /// at the times of the steps and with the last point standing for the horizon, in the maximum
    /// norm, relative to the largest coordinate of the trajectory.
    Trajectory,
    /// To keep the integrals: the error is the largest change of the map's own, those at its ε,
    /// over the horizon, relative to the value at the beginning. The discretisation does nothing to
    /// them, only roundings do ([`Scene::condition`]). A composition has none of its own, so its
    /// error is that of the flow's.
    Integrals,
}

/// A time to be simulated, and what is needed of the orbit.
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
    /// The scene with this need: `horizon` is the time to be simulated, `tolerance` the largest
    /// error accepted, as [`Need`] defines it. Both must be finite and above 0, which
    /// [`choose`](Self::choose) checks.
    #[must_use]
    pub const fn new(horizon: f64, need: Need, tolerance: f64) -> Self {
        Self { horizon, need, tolerance, condition: 4.0 }
    }

    /// A scene whose trajectory must be followed.
    #[must_use]
    pub const fn trajectory(horizon: f64, tolerance: f64) -> Self {
        Self::new(horizon, Need::Trajectory, tolerance)
    }

    /// A scene whose integrals must be kept.
    #[must_use]
    pub const fn integrals(horizon: f64, tolerance: f64) -> Self {
        Self::new(horizon, Need::Integrals, tolerance)
    }

    /// The same scene with integrals H of this condition: Σ|xᵢ ∂H/∂xᵢ|/|H|, by how much a relative
    /// change of the state is magnified in them. Without it, it is taken to be 4: a polynomial of
    /// degree 2 whose terms cancel to a half. Where the value is near zero it is much larger. Only
    /// [`Need::Integrals`] asks for it.
    #[must_use]
    pub const fn condition(mut self, condition: f64) -> Self {
        self.condition = condition;
        self
    }

    /// The cheapest setting, by the model of cost, that meets the tolerance. It is never one in
    /// `f32`: a step of a single orbit takes as long in `f32` as in `f64`. What `f32` saves is
    /// memory, and time in an [`Ensemble`](kahan_core::Ensemble).
    ///
    /// # How
    /// For [`Need::Trajectory`] the [`Flow`](crate::Flow) itself is computed over the whole
    /// horizon, and settings are run and compared with it at every one of their steps: the one that
    /// is chosen was seen to err by at most 0.85 of the tolerance, roundings among it. An orbit in
    /// [`Dd`](kahan_core::Dd) that came to within a tenth of the tolerance vouches for the flow. All
    /// of this is deterministic, so the choice run again from the same point errs by the same. What is
    /// known of it ends with the horizon, and with the point.
    ///
    /// For [`Need::Integrals`] no composition is considered. ε‖f′‖∞ is at most 1 at the start, and
    /// less if the beginning of the orbit then is not as large as it should be; the roundings of n
    /// steps are taken to be those of a random walk.
    ///
    /// # How good
    /// Seeded scenes of many fields, chaotic, stiff, escaping and beside equilibria, are chosen for
    /// by `cargo test --release -p kahan-study --test scenes -- --ignored`: none that is accepted
    /// may be beyond its tolerance, and few may be refused that some setting serves. In `benches/`
    /// the package `kahan-bench-trade` times the choice against every other setting.
    ///
    /// # Cost
    /// As much as 10⁶ steps of the map at most, most often some 10⁴; a part of them in `Dd`, whose
    /// steps take longer. It pays where a setting is run for long or used for many
    /// orbits.
    ///
    /// # Errors
    /// [`NoSetting`]: numbers that make no sense, a trajectory that cannot be followed to the
    /// horizon, a tolerance that no setting reaches.
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

    /// The time to be simulated.
    #[must_use]
    pub const fn horizon(&self) -> f64 {
        self.horizon
    }

    /// What the orbit is for.
    #[must_use]
    pub const fn need(&self) -> Need {
        self.need
    }

    /// The largest error accepted.
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
