//! The equations of sites in SIMD lanes, and the rows of A in the layout of the kernels.

use core::array::from_fn;
use core::ops::Range;

use crate::Scalar;
use crate::ensemble::Level;
use crate::ensemble::lanes::Lanes;
use crate::lattice::Stencil;

use super::window::WindowRow;

/// The field and the rows of A at one site.
#[derive(Clone, Copy, Debug)]
pub struct SiteLine<L, const B: usize, const SITES: usize> {
    /// The field at the site, one number per array.
    pub f: [L; B],
    /// The rows of A. For each array of the site, the entries are stored site by site.
    pub a: [[[L; B]; SITES]; B],
}

/// Sites gathered in SIMD lanes, one register per number. Kernels request equations site by site.
#[derive(Debug)]
pub struct Gathered<'a, T, L, const C: usize> {
    /// The prepared constants of the equations.
    pub constants: &'a [T],
    pub(in crate::lattice) spread: [L; C],
    /// The states, site by site.
    pub x: &'a [T],
    /// The parameters, site by site.
    pub c: &'a [T],
    /// Scratch memory of [`Sizes::registers_abreast`](crate::lattice::Sizes::registers_abreast)
    /// registers.
    pub registers: &'a mut [T],
    /// The instruction set of the registers.
    pub level: Level,
    /// The index of the next site among the gathered sites.
    pub site: usize,
    /// For families read at run time: the sites whose equations have already been computed.
    pub computed: Range<usize>,
}

impl<'a, T, L: Lanes<T>, const C: usize> Gathered<'a, T, L, C> {
    #[inline(always)]
    pub(super) fn new(
        constants: &'a [T],
        x: &'a [T],
        c: &'a [T],
        registers: &'a mut [T],
        level: Level,
        site: usize,
    ) -> Self {
        let spread = from_fn(|k| L::spread(&constants[k]));
        Self { constants, spread, x, c, registers, level, site, computed: 0..0 }
    }
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
> Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    /// Returns row b of a site whose equations do not contain the left separator.
    #[inline(always)]
    pub(super) fn row<L: Scalar + Copy>(line: &SiteLine<L, B, SITES>, b: usize) -> WindowRow<L, B, R, WIDTH> {
        let mut row = WindowRow::zero();
        row.right = line.f[b];
        let entries = line.a[b].as_flattened();
        for k in 0..WIDTH {
            if R * B + b + k >= LOWER && R * B + b + k - LOWER < SITES * B {
                row.band[k] = entries[R * B + b + k - LOWER];
            }
        }
        row
    }

    #[inline(always)]
    pub(super) fn row_at_edge<L: Scalar + Copy>(
        line: &SiteLine<L, B, SITES>,
        b: usize,
        i: usize,
    ) -> WindowRow<L, B, R, WIDTH> {
        let mut row = Self::row(line, b);
        for k in 0..R - i {
            for e in 0..B {
                row.left[i + k][e] = line.a[b][k][e];
                // The entry is stored in `left`, and is 0 in the band.
                let distance = (R - k) * B + b - e;
                if distance <= LOWER {
                    row.band[LOWER - distance] = L::zero();
                }
            }
        }
        row
    }

    /// Returns a row of site r of the left separator. Entries for earlier sites are left out,
    /// because the first pass of the previous part adds them.
    #[inline(always)]
    pub(super) fn row_of_left<L: Scalar + Copy>(
        line: &SiteLine<L, B, SITES>,
        b: usize,
        r: usize,
    ) -> WindowRow<L, B, R, WIDTH> {
        let mut row = WindowRow::zero();
        row.right = line.f[b];
        for k in R - r..SITES {
            for e in 0..B {
                let site = r + k - R;
                if site < R {
                    row.left[site][e] = line.a[b][k][e];
                } else if LOWER + (site - R) * B + e < WIDTH {
                    row.band[LOWER + (site - R) * B + e] = line.a[b][k][e];
                }
            }
        }
        row
    }
}
