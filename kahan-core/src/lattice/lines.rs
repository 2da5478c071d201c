//! The equations of a chain as the solver asks for them, compiled or read at run time.
//!
//! In: what a site sees. Out: its field and its rows of A(x,ε). Sizes are values here, which for a
//! family of the macro's are constants.

use core::fmt::Debug;
use std::vec::Vec;

use crate::Scalar;
use crate::ensemble::Level;
use crate::ensemble::lanes::Lanes;

use super::parts::{GatheredLines, Kernels};
use super::{Boundary, LatticeScalar};

/// The sizes of a family's lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Arrays a site.
    pub block: usize,
    /// The largest offset, at least 1.
    pub reach: usize,
    /// Parameters a site.
    pub parameters: usize,
    /// The largest distance, in unknowns, of an entry of A to the left of the diagonal.
    pub lower: usize,
    /// The largest such distance to the right of the diagonal.
    pub upper: usize,
    /// The scalars that a line of one site computes in.
    pub registers: usize,
    /// The registers that lines of gathered sites compute in.
    pub registers_abreast: usize,
}

/// The lines of the sites of a chain: what a [`Family`](super::Family) has, or a family that was
/// read at run time.
///
/// Lines take what those of a family take: constants, the states of the sites that a site sees, the
/// parameters of these sites.
#[expect(private_bounds, reason = "the kernels of a chain are nobody else's")]
pub trait Lines<T: LatticeScalar>: Clone + Debug + Sync {
    /// The kernels that step the chain in parts.
    type Kernels: Kernels;

    /// The sizes.
    fn sizes(&self) -> Sizes;

    /// The values beyond the ends.
    fn boundary(&self) -> Boundary;

    /// The constants of the lines at this ε, the parameters taken to L by `convert`; `None`
    /// where the equations divide by a zero that has no reciprocal.
    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>>;

    /// The values of a parameter that each site has.
    fn site_parameter(&self, index: usize) -> &[T];

    /// The field of the site, and its rows of A(x,ε): for each array an entry for every number of
    /// `x`, of which those are written that are structurally there. `registers` are
    /// [`Sizes::registers`] scalars, whatever they hold.
    fn rows<L: Scalar>(
        &self,
        constants: &[L],
        x: &[L],
        c: &[L],
        registers: &mut [L],
        f: &mut [L],
        a: &mut [L],
    );

    /// The lines of sites that stand side by side in lanes, one register an entry of `x` and of
    /// `c`. `registers` has room for [`Sizes::registers_abreast`] of the widest ones; the lanes are
    /// those of `level`.
    ///
    /// To be inlined, as work over lanes is.
    fn gathered<'a, L: Lanes<T>, const B: usize, const SITES: usize>(
        &'a self,
        constants: &'a [T],
        x: &'a [T],
        c: &'a [T],
        registers: &'a mut [T],
        level: Level,
    ) -> impl GatheredLines<L, B, SITES>
    where
        T: Copy;
}
