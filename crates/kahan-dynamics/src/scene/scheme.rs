//! What can be chosen besides ε: the numbers, the order, and whether the state carries its rounding
//! error.

use std::fmt;

use kahan_core::{Composition, nearest_short_eps};

use super::Need;

/// The numbers that an orbit is computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// `f32`
    Single,
    /// A state in `f32`, every step computed in `f64` and rounded once:
    /// [`ThroughF64`](kahan_core::ThroughF64).
    SingleThroughDouble,
    /// `f64`
    Double,
    /// [`Dd`](kahan_core::Dd), 32 digits.
    DoubleDouble,
}

impl Precision {
    /// All of them, the cheapest first.
    pub const ALL: [Self; 4] = [Self::Single, Self::SingleThroughDouble, Self::Double, Self::DoubleDouble];

    /// The name in tables: `f32`, `f32-through-f64`, `f64` or `dd`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::SingleThroughDouble => "f32-through-f64",
            Self::Double => "f64",
            Self::DoubleDouble => "dd",
        }
    }

    /// Whether the state is in `f32`.
    #[must_use]
    pub const fn is_single(self) -> bool {
        matches!(self, Self::Single | Self::SingleThroughDouble)
    }

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
    #[must_use]
    pub fn eps_near(self, eps: f64, need: Need) -> f64 {
        match (self.is_single(), need) {
            (true, Need::Integrals) => f64::from(nearest_short_eps(eps as f32)),
            (true, Need::Trajectory) => f64::from(eps as f32),
            (false, Need::Integrals) => nearest_short_eps(eps),
            (false, Need::Trajectory) => eps,
        }
    }
}

/// A way to step, at any ε.
///
/// It is printed as `f64, order 8, compensated`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scheme {
    /// The numbers.
    pub precision: Precision,
    /// The method; [`Composition::KAHAN`] is the map itself.
    pub composition: Composition,
    /// Whether the state carries its rounding error.
    pub compensated: bool,
}

impl Scheme {
    /// The map itself in these numbers, which carry nothing.
    #[must_use]
    pub const fn of(precision: Precision) -> Self {
        Self { precision, composition: Composition::KAHAN, compensated: false }
    }

    /// The same with this method.
    #[must_use]
    pub const fn composed(self, composition: Composition) -> Self {
        Self { composition, ..self }
    }

    /// The same with a state that carries its rounding error.
    #[must_use]
    pub const fn compensated(self) -> Self {
        Self { compensated: true, ..self }
    }

    /// Every one there is of the [best](Composition::BEST) compositions. In `Dd`, whose roundings
    /// are never seen, none is compensated.
    pub fn all() -> impl Iterator<Item = Self> {
        Precision::ALL.into_iter().map(Self::of).flat_map(|plain| {
            Composition::BEST.into_iter().map(move |method| plain.composed(method)).flat_map(|plain| {
                let carried = (plain.precision != Precision::DoubleDouble).then(|| plain.compensated());
                [plain].into_iter().chain(carried)
            })
        })
    }

    /// The order of the method.
    #[must_use]
    pub const fn order(&self) -> u32 {
        self.composition.order()
    }
}

impl fmt::Display for Scheme {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, order {}", self.precision.name(), self.order())?;
        f.write_str(if self.compensated { ", compensated" } else { "" })
    }
}
