//! The regimes from which points are drawn.

/// The position of a point relative to poles and to the limits of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Regime {
    /// The point is near a pole of the map in lowest terms.
    NearPole,
    /// The point is near a zero of det A at which the map in lowest terms is defined.
    NearRemovablePole,
    /// The sizes of the components and of ε are from the whole range of the format.
    MixedMagnitudes,
    /// All components have absolute values below 4, and |ε| is below 1.
    Ordinary,
    /// The point is ordinary except for subnormal components, ε or parameters.
    Subnormal,
    /// The point is ordinary except for infinite or NaN components, ε or parameters.
    NotFinite,
    /// The point is ordinary, and ‖εf′‖∞ is roughly between 1 and 1000.
    LargeSteps,
}

impl Regime {
    /// All regimes, in the order in which tables list them.
    pub const ALL: [Self; 7] = [
        Self::NearPole,
        Self::NearRemovablePole,
        Self::MixedMagnitudes,
        Self::Ordinary,
        Self::Subnormal,
        Self::NotFinite,
        Self::LargeSteps,
    ];

    /// Returns the name of the regime in tables and in JSON.
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
