//! The trait of families: the equations of one site, from which a chain's Kahan map is computed.
//!
//! From the states and parameters of a site and its neighbours, a family computes the site's field
//! and rows of A(x,ε) = I − εf′(x). The numbers may be scalars, SIMD lanes or numbers with error
//! bounds.
#![expect(clippy::needless_range_loop, reason = "indices of one formula run through several arrays")]

use core::fmt::Debug;
use std::vec::Vec;

use crate::ensemble::lanes::Lanes;
use crate::{Scalar, eps_from_dt};

use super::parts::{Gathered, Kernels, SiteLine};
use super::{Boundary, LatticeAt, LatticeError, LatticeScalar, Sizes};

/// The Kahan map x ↦ x̃ of a family, for chains of any number of sites.
///
/// A state is stored site by site with interleaved arrays. Array b of site i has index
/// i·[`BLOCK`](Self::BLOCK) + b. **ε is half the time step.** The macro implements this trait for a
/// `kahan!` block that gives the equations of one site by `for i in …`.
///
/// With R = [`Sizes::reach`], the equations of site i get these arguments:
/// - `constants`: the result of the method `constants` for the scalar type L of the computation;
/// - `x`: the states of the sites i − R … i + R, site by site, with interleaved arrays;
/// - `c`: the per-site parameters of these sites, in this order;
/// - `registers`: [`Sizes::registers`] numbers of scratch memory.
///
/// In a short ring, one site may occur several times in `x`; its entries of A are then added.
/// Implementations must be `#[inline(always)]` without closures.
#[expect(private_bounds, reason = "the kernels of a chain are nobody else's")]
pub trait LatticeMap<T: LatticeScalar>: Clone + Debug + Sync {
    /// The names of the arrays, in their order within a site.
    const ARRAYS: &'static [&'static str];
    /// The number of arrays, which is the number of entries per site in a state.
    const BLOCK: usize = Self::ARRAYS.len();
    /// The largest offset of a neighbour in the equations, at least 1.
    const REACH: usize;
    /// The names of the per-site parameters, in the order of their declaration.
    #[doc(hidden)]
    const SITE_PARAMETERS: &'static [&'static str] = &[];

    /// The names of the linear integrals. Empty if the family is only known at run time.
    const INTEGRALS: &'static [&'static str] = &[];
    /// The name of the Hamiltonian H, if the family is ẋ = K∇H with constant antisymmetric K.
    const HAMILTONIAN: Option<&'static str> = None;

    /// Prepares the map at ε, half the time step, for `sites` sites, and allocates all memory.
    ///
    /// If a ring is so short that several neighbours are one site, their entries of A are added.
    ///
    /// # Errors
    /// If `sites` is 0, the number of values of a site parameter is not `sites`, or the equations
    /// divide by zero. Constants that overflow T are no error. A plain step then gives infinities
    /// or NaNs, but [`try_step`](LatticeAt::try_step) works.
    fn at(&self, eps: T, sites: usize) -> Result<LatticeAt<Self, T>, LatticeError> {
        for (index, name) in Self::SITE_PARAMETERS.iter().enumerate() {
            let given = self.site_parameter(index).len();
            if sites != 0 && given != sites {
                return Err(LatticeError::SiteParameter { name, given, sites });
            }
        }
        LatticeAt::new(self.clone(), eps, sites)
    }

    /// Prepares the map for the time step Δt = 2ε; see [`at`](Self::at).
    ///
    /// # Errors
    /// Returns the errors of [`at`](Self::at).
    fn at_dt(&self, dt: T, sites: usize) -> Result<LatticeAt<Self, T>, LatticeError> {
        self.at(eps_from_dt(dt), sites)
    }

    /// The kernels of steps: a [`Stencil`] with the family's sizes, or a
    /// [`StencilMenu`](super::StencilMenu).
    #[doc(hidden)]
    type Kernels: Kernels;

    /// Returns the sizes of the family's equations.
    #[doc(hidden)]
    fn sizes(&self) -> Sizes;

    /// Returns the boundary condition of the chains.
    #[doc(hidden)]
    fn boundary(&self) -> Boundary;

    /// Returns the constants of the equations: ε, the common parameters, and their products and
    /// quotients. Returns `None` if a divisor is 0. `convert` maps a parameter to the scalar L.
    #[doc(hidden)]
    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>>;

    /// Returns the values of a per-site parameter, one per site.
    #[doc(hidden)]
    fn site_parameter(&self, _index: usize) -> &[T] {
        &[]
    }

    /// Computes the field at a site, and the site's rows of A(x,ε) = I − ε f′(x).
    ///
    /// `f[b]` is the derivative of array b. For each array, `a` has one entry for each number in
    /// `x`. The entries are initially zero, and entries that are always zero are not written.
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

    /// Computes the equations of the next site of `sites` in SIMD lanes. Every caller must inline
    /// this function, so that the caller's instruction set applies.
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

    /// Returns the number of linear integrals.
    #[doc(hidden)]
    fn integral_count(&self) -> usize {
        Self::INTEGRALS.len()
    }

    /// Computes the terms of one site. The integrals and the Hamiltonian are the sums of these
    /// terms over all sites. The arguments are those of [`rows`](Self::rows).
    #[doc(hidden)]
    fn densities<L: Scalar>(&self, _constants: &[L], _x: &[L], _c: &[L], _registers: &mut [L], _s: &mut [L]) {
    }
}
