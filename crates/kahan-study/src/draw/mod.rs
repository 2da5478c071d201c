//! Numbers from the unit interval that an index gives directly: nothing is drawn before it.

mod sobol;
mod uniform;

pub(crate) use sobol::Sobol;
pub(crate) use uniform::Uniform;

/// Where the numbers of an axis come from.
#[derive(Clone, Debug)]
pub(crate) enum Draw {
    /// One dimension of Sobol's sequence: evenly, together with the other dimensions.
    Sobol(Sobol),
    /// At random, by a seed.
    Uniform(Uniform),
}

impl Draw {
    /// The number with this index, 0 ≤ u < 1.
    pub(crate) fn at(&self, index: u64) -> f64 {
        match self {
            Draw::Sobol(sobol) => sobol.at(index),
            Draw::Uniform(uniform) => uniform.at(index),
        }
    }
}
