//! The equations of a chain as the solver asks for them, compiled or read at run time.
//!
//! In: prepared constants, the states of a site and of its neighbours, their parameters. Out: the
//! site's field and its rows of A(x,ε), over whatever scalar the solver computes with: one number,
//! lanes of them, numbers with bounds. The macro's families have their sizes in a type, so their
//! lines are compiled for them.
#![expect(clippy::needless_range_loop, reason = "indices of one formula run through several arrays")]

use core::fmt::Debug;
use std::vec::Vec;

use crate::Scalar;
use crate::ensemble::lanes::Lanes;

use super::LatticeScalar;
use super::parts::{Gathered, Kernels, SiteLine};

/// What lies beyond the two ends of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// The other end: site n is site 0.
    Periodic,
    /// Nothing: states and parameters there are 0.
    Open,
}

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

/// The equations of one site, for every site of a chain.
///
/// With R = [`Sizes::reach`], a line of site i gets
/// - `constants`: what [`constants`](Self::constants) returned, each as an `L`;
/// - `x`: the states of the sites i − R … i + R, site by site, arrays interleaved;
/// - `c`: their per-site parameters, in the same order;
/// - `registers`: [`Sizes::registers`] scalars of any value, to compute in.
///
/// Where the chain wraps around, the same site may stand at several places of `x`; what the line
/// writes for each place is then added. The lines are `#[inline(always)]`, without closures:
/// inlined into a pass over lanes, they are compiled for its instructions.
#[expect(private_bounds, reason = "the kernels of a chain are nobody else's")]
pub trait Family<T: LatticeScalar>: Clone + Debug + Sync {
    /// The kernels that step the chain in parts: a [`Stencil`] of the family's sizes, or those of a
    /// [`Menu`](super::Menu).
    type Kernels: Kernels;

    /// The sizes.
    fn sizes(&self) -> Sizes;

    /// The values beyond the ends.
    fn boundary(&self) -> Boundary;

    /// What the lines take as constants: ε, the plain parameters, products of them.
    ///
    /// `convert` takes a parameter to the scalar that the lines will be run over. `None` where the
    /// equations divide by a zero that has no reciprocal.
    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>>;

    /// The values of a parameter that each site has, one a site.
    fn site_parameter(&self, _index: usize) -> &[T] {
        &[]
    }

    /// The field of the site, and its rows of A(x,ε) = I − ε f′(x).
    ///
    /// `f[b]` is the derivative of array b. `a` has, for each array b, the (2R + 1)·B entries in
    /// the order of `x`, all of them zero when the line begins; it writes those that are
    /// structurally there.
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
}

/// The sizes of a family's line, as one type, and its kernels.
///
/// | parameter | what it is |
/// |---|---|
/// | `B` | arrays a site |
/// | `R` | the largest offset, at least 1 |
/// | `P` | parameters a site |
/// | `C` | prepared constants |
/// | `LOWER` | the largest distance, in unknowns, of an entry of A to the left of the diagonal |
/// | `UPPER` | the same to the right |
/// | `SITES` | 2R + 1, the sites that a line sees |
/// | `WIDTH` | `LOWER` + 1 + `UPPER`, the entries of a row of the band |
///
/// The entry of row (i, b) at column (i + o, b′) lies o·B + b′ − b to the right of the diagonal.
/// The last two sizes follow from the others and are written out because array lengths are not
/// computed from parameters of a type; wrong ones do not compile.
#[derive(Clone, Copy, Debug)]
pub struct Stencil<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
>;

impl<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
> Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    /// The sizes as values.
    pub const SIZES: Sizes = {
        assert!(B > 0 && R > 0 && SITES == 2 * R + 1 && WIDTH == LOWER + 1 + UPPER);
        assert!(LOWER < (R + 1) * B && UPPER < (R + 1) * B);
        Sizes {
            block: B,
            reach: R,
            parameters: P,
            lower: LOWER,
            upper: UPPER,
            registers: 0,
            registers_abreast: 0,
        }
    };
}
