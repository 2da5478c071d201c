//! What can be chosen besides ε: the scalar, the order, and whether the state carries its rounding
//! error.

use kahan_core::{Composition, nearest_short_eps};

use super::Need;

/// The numbers that a trajectory is computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ScalarKind {
    /// Single precision.
    F32,
    /// A state in single precision, every stage computed in double precision and rounded once.
    F32ThroughF64,
    /// Double precision.
    F64,
    /// Double-double, 32 digits.
    Dd,
}

/// A way to step, at any ε.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Kind {
    /// The numbers.
    pub scalar: ScalarKind,
    /// The order of the method: 2 is Kahan's map, 4, 6 and 8 are its compositions.
    pub order: u32,
    /// Whether the state is carried with its rounding error.
    pub compensated: bool,
}

/// The orders there are.
pub const ORDERS: [u32; 4] = [2, 4, 6, 8];

impl ScalarKind {
    /// All of them, the cheapest first.
    pub const ALL: [Self; 4] = [Self::F32, Self::F32ThroughF64, Self::F64, Self::Dd];

    /// The name in tables and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F32ThroughF64 => "f32-through-f64",
            Self::F64 => "f64",
            Self::Dd => "dd",
        }
    }

    /// u, the relative error of one rounding.
    #[must_use]
    pub fn unit(self) -> f64 {
        match self {
            Self::F32 | Self::F32ThroughF64 => f64::from(f32::EPSILON) / 2.0,
            Self::F64 => f64::EPSILON / 2.0,
            Self::Dd => f64::EPSILON * f64::EPSILON,
        }
    }

    /// The ε to take for this one: to keep integrals one near it of so few bits that its powers are
    /// exact, for `Dd` too; to follow a trajectory, which must end at its horizon, the nearest
    /// number.
    #[must_use]
    pub fn eps_near(self, eps: f64, need: Need) -> f64 {
        let is_short = need == Need::Integrals;
        match self {
            Self::F32 | Self::F32ThroughF64 if is_short => f64::from(nearest_short_eps(eps as f32)),
            Self::F32 | Self::F32ThroughF64 => f64::from(eps as f32),
            Self::F64 | Self::Dd if is_short => nearest_short_eps(eps),
            Self::F64 | Self::Dd => eps,
        }
    }
}

impl Kind {
    /// Every kind there is. Compensation makes no sense where no rounding is ever seen.
    pub fn all() -> impl Iterator<Item = Self> {
        ScalarKind::ALL.into_iter().flat_map(|scalar| {
            ORDERS.into_iter().flat_map(move |order| {
                let compensated: &[bool] = if scalar == ScalarKind::Dd { &[false] } else { &[false, true] };
                compensated.iter().map(move |&compensated| Kind { scalar, order, compensated })
            })
        })
    }

    /// The composition of this order; for order 2 it is the map itself.
    #[must_use]
    pub fn composition(self) -> Composition {
        Composition::of_order(self.order).unwrap_or(Composition::KAHAN)
    }
}

impl core::fmt::Display for Kind {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}, order {}", self.scalar.name(), self.order)?;
        if self.compensated { write!(f, ", compensated") } else { Ok(()) }
    }
}
