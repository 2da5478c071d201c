//! Why there is no bracket.

use std::error::Error;
use std::fmt;

use crate::poly::OverBudget;

/// Why a bracket, or a function of one, could not be formed.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PoissonError {
    /// Brackets need at least two states.
    Dimension {
        /// The number of states.
        dimension: usize,
    },
    /// A system of n states needs n−2 integrals.
    IntegralCount {
        /// The number of states, n.
        dimension: usize,
        /// How many integrals were given.
        given: usize,
    },
    /// A tensor of n states has n(n−1)/2 entries above its diagonal.
    EntryCount {
        /// The number of states, n.
        dimension: usize,
        /// How many entries were given.
        given: usize,
    },
    /// The density is zero identically, so it measures nothing.
    ZeroDensity,
    /// dI₁∧…∧dI_k = 0: the integral is a function of those before it (or constant), and the bracket would be zero.
    DependentIntegral {
        /// Which integral, counted from 0.
        index: usize,
    },
    /// The claim divides by zero identically.
    UndefinedClaim {
        /// The claim's name.
        name: String,
    },
    /// The formulas are too large to be expanded within the budget.
    OverBudget,
}

impl fmt::Display for PoissonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PoissonError::Dimension { dimension } => {
                write!(f, "a Poisson bracket needs at least two state variables, and this system has {dimension}")
            }
            PoissonError::IntegralCount { dimension, given } => write!(
                f,
                "an invariant bracket of {dimension} state variables is made of a density and {} integrals (two fewer than \
                 variables), and {given} were given",
                dimension.saturating_sub(2)
            ),
            PoissonError::EntryCount { dimension, given } => write!(
                f,
                "a tensor of {dimension} state variables has {} entries above its diagonal, and {given} were given",
                dimension * dimension.saturating_sub(1) / 2
            ),
            PoissonError::ZeroDensity => {
                f.write_str("the density is zero everywhere; give an invariant density that is not")
            }
            PoissonError::DependentIntegral { index: 0 } => f.write_str(
                "integral 1 depends on no state variable, so its bracket is zero; give one that is not constant",
            ),
            PoissonError::DependentIntegral { index } => write!(
                f,
                "integral {} is a function of those before it, or constant, so their bracket is zero; give integrals that are \
                 independent",
                index + 1
            ),
            PoissonError::UndefinedClaim { name } => {
                write!(f, "the claim `{name}` divides by zero identically; correct its divisors")
            }
            PoissonError::OverBudget => {
                f.write_str("the bracket is too large to be expanded within the budget; fix parameters, or allow more work")
            }
        }
    }
}

impl Error for PoissonError {}

impl From<OverBudget> for PoissonError {
    fn from(_: OverBudget) -> Self {
        PoissonError::OverBudget
    }
}
