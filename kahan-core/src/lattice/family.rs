//! What the macro knows of a family and nobody else: the straight line of one site.
//!
//! In: prepared constants, the states of a site and of its neighbours, their parameters. Out: the
//! site's field and its rows of A(x,ε), over whatever scalar the solver computes with: one number,
//! lanes of them, numbers with bounds. A family's sizes are part of its type, and so its lines are
//! compiled for them; the solver asks for [`Lines`], which families read at run time are, too.

use core::fmt::Debug;
use std::vec::Vec;

use crate::Scalar;
use crate::ensemble::Level;
use crate::ensemble::lanes::Lanes;

use super::parts::{GatheredLines, Passes};
use super::{LatticeScalar, Lines, Sizes};

/// What lies beyond the two ends of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// The other end: site n is site 0.
    Periodic,
    /// Nothing: states and parameters there are 0.
    Open,
}

/// The equations of one site, for every site of a chain.
///
/// With R = [`REACH`](Shape::REACH), a line of site i gets
/// - `constants`: what [`constants`](Self::constants) returned, each as an `L`;
/// - `x`: the states of the sites i − R … i + R, site by site, arrays interleaved;
/// - `c`: their per-site parameters, in the same order.
///
/// Where the chain wraps around, the same site may stand at several places of `x`; what the line
/// writes for each place is then added. The lines are `#[inline(always)]`, without closures:
/// inlined into a pass over lanes, they are compiled for its instructions.
pub trait Family<T: LatticeScalar>: Clone + Debug + Sync {
    /// The sizes, as one type.
    type Shape: Shape;

    /// The names of the arrays, in their order within a site.
    const ARRAYS: &'static [&'static str];
    /// The names of the parameters that each site has, in their order.
    const SITE_PARAMETERS: &'static [&'static str];
    /// What lies beyond the ends.
    const BOUNDARY: Boundary;

    /// What the lines take as constants: ε, the plain parameters, products of them.
    ///
    /// `convert` takes a parameter to the scalar that the lines will be run over. `None` where the
    /// equations divide by a zero that has no reciprocal.
    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>>;

    /// The values of one of the [`SITE_PARAMETERS`](Self::SITE_PARAMETERS), one a site.
    fn site_parameter(&self, index: usize) -> &[T];

    /// The field of the site, and its rows of A(x,ε) = I − ε f′(x).
    ///
    /// `f[b]` is the derivative of array b. `a` has, for each array b, the (2R + 1)·B entries in the order of `x`, all of them zero when
    /// the line begins; it writes those that are structurally there.
    fn rows<L: Scalar>(constants: &[L], x: &[L], c: &[L], f: &mut [L], a: &mut [L]);
}

/// The sizes of a family's line.
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

/// The sizes of a [`Stencil`] as constants.
#[expect(private_bounds, reason = "the passes over a chain are nobody else's")]
pub trait Shape: Passes + 'static {
    /// Arrays a site.
    const BLOCK: usize;
    /// The largest offset, at least 1.
    const REACH: usize;
    /// Parameters a site.
    const PARAMETERS: usize;
    /// The largest distance of an entry to the left of the diagonal.
    const LOWER: usize;
    /// The largest distance of an entry to the right of the diagonal.
    const UPPER: usize;
}

impl<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
> Shape for Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    const BLOCK: usize = B;
    const REACH: usize = {
        assert!(B > 0 && R > 0 && SITES == 2 * R + 1 && WIDTH == LOWER + 1 + UPPER);
        assert!(LOWER < (R + 1) * B && UPPER < (R + 1) * B);
        R
    };
    const PARAMETERS: usize = P;
    const LOWER: usize = LOWER;
    const UPPER: usize = UPPER;
}

impl<M: Family<T>, T: LatticeScalar> Lines<T> for M {
    type Kernels = M::Shape;

    #[inline(always)]
    fn sizes(&self) -> Sizes {
        Sizes {
            block: M::Shape::BLOCK,
            reach: M::Shape::REACH,
            parameters: M::Shape::PARAMETERS,
            lower: M::Shape::LOWER,
            upper: M::Shape::UPPER,
            registers: 0,
            registers_abreast: 0,
        }
    }

    #[inline(always)]
    fn boundary(&self) -> Boundary {
        M::BOUNDARY
    }

    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>> {
        Family::constants(self, eps, convert)
    }

    #[inline(always)]
    fn site_parameter(&self, index: usize) -> &[T] {
        Family::site_parameter(self, index)
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        <M as Family<T>>::rows(constants, x, c, f, a);
    }

    #[inline(always)]
    fn gathered<'a, L: Lanes<T>, const B: usize, const SITES: usize>(
        &'a self,
        constants: &'a [T],
        x: &'a [T],
        c: &'a [T],
        _: &'a mut [T],
        _: Level,
    ) -> impl GatheredLines<L, B, SITES>
    where
        T: Copy,
    {
        M::Shape::lines::<M, L, T, B, SITES>(constants, x, c)
    }
}
