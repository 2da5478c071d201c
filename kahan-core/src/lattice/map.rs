//! A family as a map of chains.

use super::{Family, LatticeAt, LatticeError, LatticeScalar};
use crate::eps_from_dt;

/// The Kahan map of a family: x ↦ x̃ for chains of any number of sites.
///
/// A state is site by site, arrays interleaved: array b of site i is entry i·[`BLOCK`](Self::BLOCK)
/// + b. **ε is half the time step.** The macro implements it for a block with a family.
pub trait LatticeMap<T: LatticeScalar>: Family<T> {
    /// The names of the arrays, in their order within a site.
    const ARRAYS: &'static [&'static str];
    /// The number of arrays: the numbers that a site takes in a state.
    const BLOCK: usize = Self::ARRAYS.len();
    /// The largest offset of a neighbour in the equations, at least 1.
    const REACH: usize;
    /// The names of the parameters that each site has, in their order.
    #[doc(hidden)]
    const SITE_PARAMETERS: &'static [&'static str] = &[];

    /// The map at this ε, half the time step, for a chain of this many sites, with all memory that
    /// its steps need.
    ///
    /// Every number of sites but 0 is right: where a periodic chain is shorter than the stencil, a
    /// site is its own neighbour, and its couplings add up.
    ///
    /// # Errors
    /// No sites, parameters of another number of sites, or at which the equations divide by zero.
    /// Where only products of constants and parameters are beyond the range of T there is a map,
    /// whose plain steps are not finite, and whose steps with a promise are as good as ever.
    fn at(&self, eps: T, sites: usize) -> Result<LatticeAt<Self, T>, LatticeError> {
        for (index, name) in Self::SITE_PARAMETERS.iter().enumerate() {
            let given = self.site_parameter(index).len();
            // No sites are refused below, whatever is given.
            if sites != 0 && given != sites {
                return Err(LatticeError::SiteParameter { name, given, sites });
            }
        }
        LatticeAt::new(self.clone(), eps, sites)
    }

    /// The map of the time step Δt = 2ε; see [`at`](Self::at).
    ///
    /// # Errors
    /// See [`at`](Self::at).
    fn at_dt(&self, dt: T, sites: usize) -> Result<LatticeAt<Self, T>, LatticeError> {
        self.at(eps_from_dt(dt), sites)
    }
}
