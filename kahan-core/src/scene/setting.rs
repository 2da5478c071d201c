//! A way to step an orbit, chosen.

use core::fmt;

use crate::{Composition, Lift, PreparedStep, nearest_short_eps};

use super::{Need, Scene, price};

/// The numbers that an orbit is computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// `f32`
    Single,
    /// A state in `f32`, every step computed in `f64` and rounded once:
    /// [`ThroughF64`](crate::ThroughF64).
    SingleThroughDouble,
    /// `f64`
    Double,
    /// [`Dd`](crate::Dd), 32 digits.
    DoubleDouble,
}

impl Precision {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Single, Self::SingleThroughDouble, Self::Double, Self::DoubleDouble];

    /// u, the relative error of one rounding (of the state).
    #[must_use]
    pub const fn unit(self) -> f64 {
        match self {
            Self::Single | Self::SingleThroughDouble => f32::EPSILON as f64 / 2.0,
            Self::Double => f64::EPSILON / 2.0,
            Self::DoubleDouble => f64::EPSILON * f64::EPSILON,
        }
    }

    /// The ε to take for this one: to keep integrals the nearest [short](nearest_short_eps) one, in
    /// `Dd` one that is short for `f64`; to follow a trajectory, which must end at its horizon, the
    /// nearest number.
    pub(super) fn eps_near(self, eps: f64, need: Need) -> f64 {
        let is_short = need == Need::Integrals;
        match self {
            Self::Single | Self::SingleThroughDouble if is_short => f64::from(nearest_short_eps(eps as f32)),
            Self::Single | Self::SingleThroughDouble => f64::from(eps as f32),
            Self::Double | Self::DoubleDouble if is_short => nearest_short_eps(eps),
            Self::Double | Self::DoubleDouble => eps,
        }
    }
}

/// Numbers, and whether the state carries its rounding error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mode {
    pub(super) precision: Precision,
    pub(super) compensated: bool,
}

impl Mode {
    const fn new(precision: Precision, compensated: bool) -> Self {
        Self { precision, compensated }
    }

    pub(super) const PLAIN: Self = Self::new(Precision::Double, false);
    pub(super) const COMPENSATED: Self = Self::new(Precision::Double, true);

    /// `Dd`, whose roundings are never seen.
    pub(super) const WIDE: Self = Self::new(Precision::DoubleDouble, false);

    /// What a single orbit may be chosen to run in besides plain `f64`. Not `f32`, for which it
    /// waits as long; and compensation makes no sense where no rounding is ever seen.
    pub(super) const OTHERS: [Self; 2] = [Self::WIDE, Self::COMPENSATED];

    /// Those of them in `f64`.
    pub(super) const OF_DOUBLE: [Self; 1] = [Self::COMPENSATED];

    /// This mode of a composition.
    pub(super) const fn kind(self, composition: Composition) -> Kind {
        Kind { precision: self.precision, composition, compensated: self.compensated }
    }
}

/// A way to step, at any ε.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Kind {
    pub(super) precision: Precision,
    pub(super) composition: Composition,
    pub(super) compensated: bool,
}

/// The cheapest way to step an orbit that serves a [`Scene`](crate::Scene); made by
/// [`Scene::choose`](crate::Scene::choose).
///
/// It is printed as a line of Rust, with `map` for the map and `x` for the first point, both of its
/// precision.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Setting {
    pub(super) precision: Precision,
    pub(super) composition: Composition,
    pub(super) compensated: bool,
    pub(super) eps: f64,
    pub(super) steps: u64,
    pub(super) error: f64,
    pub(super) cost: f64,
}

impl Setting {
    /// About so many steps over a scene's horizon, priced; nothing is known of its error.
    pub(super) fn over<M, const N: usize>(_map: &M, scene: &Scene, kind: Kind, steps: f64) -> Self
    where
        M: Lift<f64, N>,
    {
        let Kind { precision, composition, compensated } = kind;
        let eps = precision.eps_near(0.5 * scene.horizon / steps, scene.need);
        let steps = (0.5 * scene.horizon / eps).round().max(1.0);
        let stage = <M::Prepared as PreparedStep<f64, N>>::COST;
        let cost = steps * price::of_step(stage, kind);
        Self { precision, composition, compensated, eps, steps: steps as u64, error: f64::INFINITY, cost }
    }

    /// The numbers.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// The composition; [`Composition::KAHAN`] is the map itself.
    pub fn composition(&self) -> Composition {
        self.composition
    }

    /// Whether the state carries its rounding error.
    pub fn is_compensated(&self) -> bool {
        self.compensated
    }

    /// ε, half the time step; for [`Need::Integrals`] one of so few bits that its powers are exact
    /// ([`nearest_short_eps`]).
    pub fn eps(&self) -> f64 {
        self.eps
    }

    /// The number of steps: 2ε times this is the horizon, but for the rounding of ε; for
    /// [`Need::Integrals`], whose ε has few bits, but for less than half a step.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The error to expect, with the safety factors in it: at most the scene's tolerance.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// The modelled cost of the whole orbit in cycles of a core of today: steps × stages × the
    /// cycles of a stage in `f64` × what the numbers and the compensation cost more. Only ratios
    /// are meant.
    pub fn cost(&self) -> f64 {
        self.cost
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { precision, composition, compensated, eps, steps, .. } = self;
        match precision {
            Precision::Single | Precision::Double => write!(f, "let orbit = map.orbit(x, {eps:?})")?,
            Precision::SingleThroughDouble => write!(f, "let orbit = ThroughF64(map).orbit(x, {eps:?})")?,
            Precision::DoubleDouble => write!(f, "let orbit = map.orbit(x, Dd::from({eps:?}))")?,
        }
        if *composition != Composition::KAHAN {
            write!(f, ".composed(Composition::{})", composition.name())?;
        }
        if *compensated {
            f.write_str(".compensated()")?;
        }
        // x₀ and every step after it.
        write!(f, ".take({});", u128::from(*steps) + 1)
    }
}
