//! The strata from which points are drawn.

/// The position of a point relative to poles and to the limits of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Regime {
    /// A relative distance between 1 and rounding from a pole of the reduced map.
    NearPole,
    /// A relative distance between 1 and rounding from a zero of det A at which the reduced map has
    /// a value.
    NearRemovablePole,
    /// Components and ε of sizes from the whole range of the format.
    MixedMagnitudes,
    /// Components below 4, ε below 1.
    Ordinary,
    /// An ordinary point with subnormal components, ε or parameters.
    Subnormal,
    /// An ordinary point with infinite or NaN components, ε or parameters.
    NotFinite,
    /// An ordinary point with ε such that ‖εf′‖∞ is roughly between 1 and 1000.
    LargeSteps,
}

impl Regime {
    /// All regimes, in the order of tables.
    pub const ALL: [Self; 7] = [
        Self::NearPole,
        Self::NearRemovablePole,
        Self::MixedMagnitudes,
        Self::Ordinary,
        Self::Subnormal,
        Self::NotFinite,
        Self::LargeSteps,
    ];

    /// Returns the name in tables and in JSON.
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
