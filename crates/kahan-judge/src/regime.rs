//! The strata from which points are drawn.

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Regime {
    /// At a relative distance from 1 down to rounding from a pole of the reduced map.
    NearPole,
    /// The same from a zero of det A where the reduced map has a value.
    NearRemovablePole,
    /// Components and step of sizes that differ by up to the whole range.
    MixedMagnitudes,
    /// Components below 4, steps below 1.
    Ordinary,
    /// An ordinary point with a component or a step below the normal range.
    Subnormal,
    /// An ordinary point with a component or a step that is infinite or not a number.
    NotFinite,
    /// An ordinary point with a step for which ‖εf′‖∞ is from 1 to 1000.
    LargeSteps,
}

impl Regime {
    /// All, in the order of tables.
    pub const ALL: [Self; 7] = [
        Self::NearPole,
        Self::NearRemovablePole,
        Self::MixedMagnitudes,
        Self::Ordinary,
        Self::Subnormal,
        Self::NotFinite,
        Self::LargeSteps,
    ];

    /// Its name in tables and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NearPole => "near pole",
            Self::NearRemovablePole => "near removable pole",
            Self::MixedMagnitudes => "mixed magnitudes",
            Self::Ordinary => "ordinary",
            Self::Subnormal => "subnormal input",
            Self::NotFinite => "infinite or NaN input",
            Self::LargeSteps => "large steps",
        }
    }
}
