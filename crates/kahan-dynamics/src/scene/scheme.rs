//! The scalar, order and compensation of a setting.

use std::fmt;

use kahan_core::{Composition, nearest_short_eps};

use super::Need;

/// The scalar type of an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// A state and steps in `f32`.
    Single,
    /// A state in `f32`, with steps in `f64` that are rounded once
    /// ([`ThroughF64`](kahan_core::ThroughF64)).
    SingleThroughDouble,
    /// A state and steps in `f64`.
    Double,
    /// A state and steps in [`Dd`](kahan_core::Dd), with 32 digits.
    DoubleDouble,
}

impl Precision {
    /// All precisions, cheapest first.
    pub const ALL: [Self; 4] = [Self::Single, Self::SingleThroughDouble, Self::Double, Self::DoubleDouble];

    /// Returns the name in tables: `f32`, `f32-through-f64`, `f64` or `dd`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::SingleThroughDouble => "f32-through-f64",
            Self::Double => "f64",
            Self::DoubleDouble => "dd",
        }
    }

    /// Returns whether the state is in `f32`.
    #[must_use]
    pub const fn is_single(self) -> bool {
        matches!(self, Self::Single | Self::SingleThroughDouble)
    }

    /// Returns the unit roundoff: the largest relative error of one rounding of the state.
    #[must_use]
    pub const fn unit(self) -> f64 {
        match self {
            Self::Single | Self::SingleThroughDouble => f32::EPSILON as f64 / 2.0,
            Self::Double => f64::EPSILON / 2.0,
            Self::DoubleDouble => f64::EPSILON * f64::EPSILON,
        }
    }

    /// Returns an ε near `eps` in this precision.
    ///
    /// For [`Need::Trajectory`], ε is the representable number nearest to `eps`, because the steps
    /// must end at the given time. For [`Need::Integrals`], ε has so few bits that its powers are
    /// exact ([`nearest_short_eps`]). In `Dd`, ε is also an `f64`.
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

/// A method of stepping that may run at any ε, displayed like `f64, order 8, compensated`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scheme {
    /// The scalar type.
    pub precision: Precision,
    /// The composition, which is [`Composition::KAHAN`] for Kahan's map itself.
    pub composition: Composition,
    /// Whether the sum of increments is compensated (Kahan summation).
    pub compensated: bool,
}

impl Scheme {
    /// Returns the scheme of Kahan's map itself in this precision, without compensation.
    #[must_use]
    pub const fn of(precision: Precision) -> Self {
        Self { precision, composition: Composition::KAHAN, compensated: false }
    }

    /// Replaces the composition.
    #[must_use]
    pub const fn composed(self, composition: Composition) -> Self {
        Self { composition, ..self }
    }

    /// Adds compensated summation of the increments.
    #[must_use]
    pub const fn compensated(self) -> Self {
        Self { compensated: true, ..self }
    }

    /// Iterates over the schemes of the [best](Composition::BEST) compositions, with and without
    /// compensation. In `Dd` rounding errors are negligible, and compensation is omitted.
    pub fn all() -> impl Iterator<Item = Self> {
        Precision::ALL.into_iter().map(Self::of).flat_map(|plain| {
            Composition::BEST.into_iter().map(move |method| plain.composed(method)).flat_map(|plain| {
                let carried = (plain.precision != Precision::DoubleDouble).then(|| plain.compensated());
                [plain].into_iter().chain(carried)
            })
        })
    }

    /// Returns the order of the method.
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
