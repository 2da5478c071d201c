//! A family as a map of chains: its names, what it claims to keep, and its equations as the solver
//! asks for them, compiled or read at run time.
//!
//! In: prepared constants, the states of a site and of its neighbours, their parameters. Out: the
//! site's field and its rows of A(x,ε), over whatever scalar the solver computes with: one number,
//! lanes of them, numbers with bounds. The macro's families have their sizes in a type, so their
//! lines are compiled for them.
#![expect(clippy::needless_range_loop, reason = "indices of one formula run through several arrays")]

use core::fmt::Debug;
use std::vec::Vec;

use crate::ensemble::lanes::Lanes;
use crate::{Scalar, eps_from_dt};

use super::parts::{Gathered, Kernels, SiteLine};
use super::{Boundary, LatticeAt, LatticeError, LatticeScalar, Sizes};

/// The Kahan map of a family: x ↦ x̃ for chains of any number of sites.
///
/// A state is site by site, arrays interleaved: array b of site i is entry
/// i·[`BLOCK`](Self::BLOCK) + b. **ε is half the time step.** The macro implements it for a block
/// with a family, and writes the equations of one site, which serve every site of a chain.
///
/// With R = [`Sizes::reach`], a line of site i gets
/// - `constants`: what `constants` returned, each as an `L`;
/// - `x`: the states of the sites i − R … i + R, site by site, arrays interleaved;
/// - `c`: their per-site parameters, in the same order;
/// - `registers`: [`Sizes::registers`] scalars of any value, to compute in.
///
/// Where the chain wraps around, the same site may stand at several places of `x`; what the line
/// writes for each place is then added. The lines are `#[inline(always)]`, without closures:
/// inlined into a pass over lanes, they are compiled for its instructions.
#[expect(private_bounds, reason = "the kernels of a chain are nobody else's")]
pub trait LatticeMap<T: LatticeScalar>: Clone + Debug + Sync {
    /// The names of the arrays, in their order within a site.
    const ARRAYS: &'static [&'static str];
    /// The number of arrays: the numbers that a site takes in a state.
    const BLOCK: usize = Self::ARRAYS.len();
    /// The largest offset of a neighbour in the equations, at least 1.
    const REACH: usize;
    /// The names of the parameters that each site has, in their order.
    #[doc(hidden)]
    const SITE_PARAMETERS: &'static [&'static str] = &[];

    /// The names of the linear integrals; none of a family read at run time, whose reader has them.
    const INTEGRALS: &'static [&'static str] = &[];
    /// The name of H, if the family is ẋ = K∇H with a constant antisymmetric K.
    const HAMILTONIAN: Option<&'static str> = None;

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

    /// The kernels that step the chain in parts: a [`Stencil`] of the family's sizes, or those of a
    /// [`Menu`](super::Menu).
    #[doc(hidden)]
    type Kernels: Kernels;

    /// The sizes.
    #[doc(hidden)]
    fn sizes(&self) -> Sizes;

    /// The values beyond the ends.
    #[doc(hidden)]
    fn boundary(&self) -> Boundary;

    /// What the lines take as constants: ε, the plain parameters, products of them.
    ///
    /// `convert` takes a parameter to the scalar that the lines will be run over. `None` where the
    /// equations divide by a zero that has no reciprocal.
    #[doc(hidden)]
    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>>;

    /// The values of a parameter that each site has, one a site.
    #[doc(hidden)]
    fn site_parameter(&self, _index: usize) -> &[T] {
        &[]
    }

    /// The field of the site, and its rows of A(x,ε) = I − ε f′(x).
    ///
    /// `f[b]` is the derivative of array b. `a` has, for each array b, the (2R + 1)·B entries in
    /// the order of `x`, all of them zero when the line begins; it writes those that are
    /// structurally there.
    #[doc(hidden)]
    fn rows<L: Scalar>(
        &self,
        constants: &[L],
        x: &[L],
        c: &[L],
        registers: &mut [L],
        f: &mut [L],
        a: &mut [L],
    );

    /// The line of the next of some gathered sites, by [`rows`](Self::rows) with P parameters a
    /// site and C constants.
    ///
    /// To be inlined, as work over lanes is.
    #[doc(hidden)]
    #[inline(always)]
    fn line<L: Lanes<T>, const B: usize, const P: usize, const C: usize, const SITES: usize>(
        &self,
        sites: &mut Gathered<'_, T, L, C>,
    ) -> SiteLine<L, B, SITES> {
        let first = sites.site - SITES / 2;
        sites.site += 1;
        let seen_x = &sites.x[first * B * L::WIDTH..][..SITES * B * L::WIDTH];
        let seen_c = &sites.c[first * P * L::WIDTH..][..SITES * P * L::WIDTH];
        let (mut x, mut c) = ([[L::zero(); B]; SITES], [[L::zero(); P]; SITES]);
        for k in 0..SITES {
            for b in 0..B {
                x[k][b] = L::load(seen_x, (k * B + b) * L::WIDTH);
            }
            for p in 0..P {
                c[k][p] = L::load(seen_c, (k * P + p) * L::WIDTH);
            }
        }
        let mut line = SiteLine { f: [L::zero(); B], a: [[[L::zero(); B]; SITES]; B] };
        let a = line.a.as_flattened_mut().as_flattened_mut();
        self.rows(&sites.spread, x.as_flattened(), c.as_flattened(), &mut [], &mut line.f, a);
        line
    }

    /// The number of linear integrals.
    #[doc(hidden)]
    fn integral_count(&self) -> usize {
        Self::INTEGRALS.len()
    }

    /// The densities at a site, from the arguments of [`rows`](Self::rows): those of the integrals,
    /// then that of the Hamiltonian, if there is one.
    #[doc(hidden)]
    fn densities<L: Scalar>(&self, _constants: &[L], _x: &[L], _c: &[L], _registers: &mut [L], _s: &mut [L]) {
    }
}
