//! The first pass, which eliminates the interiors of parts and leaves the Schur complements of the
//! separators between parts.
//!
//! Each lane holds one part. The result for a part is the largest multiplier of its separators'
//! rows, and 2S linear equations, where S is the number of unknowns of a separator. An equation has
//! 2S coefficients and a right-hand side. The equations of the right separator precede those of the
//! left.
#![expect(clippy::needless_range_loop, reason = "indices of one formula run through several arrays")]

use core::ops::Range;

use crate::Scalar;
use crate::ensemble::lanes::{InLanes, Lanes, OverLanes};
use crate::lattice::{LatticeMap, LatticeScalar, Stencil};

use super::kernels::{KernelCall, batches, is_small};
use super::lines::{Gathered, SiteLine};
use super::partition::Partition;
use super::scratch::Scratch;
use super::separators;
use super::window::{Window, WindowRow};

pub(in crate::lattice) struct FirstPass<'a, M, T> {
    pub(super) partition: &'a Partition,
    pub(super) map: &'a M,
    pub(super) constants: &'a [T],
    pub(super) state: &'a [T],
    pub(super) groups: Range<usize>,
    pub(super) scratch: &'a mut Scratch<T>,
    pub(super) joints: &'a mut [T],
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
    M: LatticeMap<T>,
    T: LatticeScalar + InLanes,
> OverLanes<T> for KernelCall<Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>, FirstPass<'_, M, T>>
{
    type Output = ();
    const IS_SMALL: bool = is_small(LOWER + R * B, WIDTH + R * B);

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let FirstPass { partition, map, constants, state, groups, scratch, joints } = self.0;
        let (s, level) = (R * B, scratch.level);
        // The columns are the last LOWER interior unknowns (LOWER is the lower bandwidth), the
        // right and the left separator with s unknowns each, and the right-hand side.
        let (rows, columns) = (LOWER + 2 * s, LOWER + 2 * s + 1);
        let place = |row: usize, column: usize| (row * columns + column) * L::WIDTH;
        let mut joints = joints.chunks_exact_mut(separators::size(s));
        for (_, parts) in batches(partition, groups, L::WIDTH) {
            let interior = parts.length - R;
            parts.gather(map, state, scratch.x.entries(), scratch.c.entries(), level);
            let (x, c, registers) = (scratch.x.entries(), scratch.c.entries(), scratch.registers.entries());
            let mut sites = Gathered::<T, L, C>::new(constants, x, c, registers, level, R);
            let mut border = [[WindowRow::<L, B, R, WIDTH>::zero(); B]; R];
            for r in 0..R {
                let line = map.line::<L, B, P, C, SITES>(&mut sites);
                for b in 0..B {
                    border[r][b] =
                        Stencil::<B, R, P, C, LOWER, UPPER, SITES, WIDTH>::row_of_left(&line, b, r);
                }
            }
            let mut sweep = InteriorElimination {
                window: Window::<L, B, R, LOWER, WIDTH>::new(),
                border,
                worst: L::zero(),
            };
            for i in 0..R {
                let line = map.line::<L, B, P, C, SITES>(&mut sites);
                for b in 0..B {
                    sweep.take(Stencil::<B, R, P, C, LOWER, UPPER, SITES, WIDTH>::row_at_edge(&line, b, i));
                }
            }
            for _ in R..interior {
                let line = map.line::<L, B, P, C, SITES>(&mut sites);
                for b in 0..B {
                    sweep.take(Stencil::<B, R, P, C, LOWER, UPPER, SITES, WIDTH>::row(&line, b));
                }
            }

            let dense = scratch.dense.entries();
            for row in 0..rows {
                for column in 0..columns {
                    L::zero().store(dense, place(row, column));
                }
            }
            for k in 0..LOWER {
                sweep.window.rows[k].write(dense, place(k, 0), LOWER + s);
            }
            for r in 0..R {
                for b in 0..B {
                    sweep.border[r][b].write(dense, place(LOWER + s + r * B + b, 0), LOWER + s);
                }
            }
            for r in 0..R {
                let SiteLine { a, .. } = map.line::<L, B, P, C, SITES>(&mut sites);
                for b in 0..B {
                    for k in 0..R - r {
                        for e in 0..B {
                            let back = (R - r - k) * B - e;
                            if back <= LOWER {
                                a[b][k][e].store(dense, place(LOWER + r * B + b, LOWER - back));
                            }
                        }
                    }
                }
            }
            sweep.worst.store(dense, place(rows, 0));
            T::run(SeparatorSystem { dense, first: LOWER, rows, width: L::WIDTH }, level);
            for (lane, joint) in joints.by_ref().take(L::WIDTH).enumerate() {
                for row in 0..2 * s {
                    for column in 0..2 * s + 1 {
                        joint[row * (2 * s + 1) + column] = dense[place(LOWER + row, LOWER + column) + lane];
                    }
                }
                joint[separators::size(s) - 1] = dense[place(rows, 0) + lane];
            }
        }
    }
}

struct InteriorElimination<L, const B: usize, const R: usize, const LOWER: usize, const WIDTH: usize> {
    window: Window<L, B, R, LOWER, WIDTH>,
    border: [[WindowRow<L, B, R, WIDTH>; B]; R],
    /// In each lane, the largest |multiplier| that reduced a row of `border`.
    worst: L,
}

impl<L: Scalar + Copy, const B: usize, const R: usize, const LOWER: usize, const WIDTH: usize>
    InteriorElimination<L, B, R, LOWER, WIDTH>
{
    #[inline(always)]
    fn take<T>(&mut self, row: WindowRow<L, B, R, WIDTH>)
    where
        L: Lanes<T>,
    {
        let pivot = self.window.push(row);
        for r in 0..R {
            for b in 0..B {
                let multiplier = self.border[r][b].band[0] * pivot.band[0];
                self.worst = L::choose(self.worst.exceeds(multiplier), self.worst, multiplier);
                self.border[r][b] = self.border[r][b].reduced(multiplier, &pivot);
            }
        }
    }
}

/// The dense linear system that the elimination of the band leaves, followed in memory by the
/// largest multiplier of each lane. `run` eliminates only columns 0 to `first` − 1.
struct SeparatorSystem<'a, T> {
    dense: &'a mut [T],
    first: usize,
    rows: usize,
    width: usize,
}

impl<T: InLanes> OverLanes<T> for SeparatorSystem<'_, T> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let SeparatorSystem { dense, first, rows, width } = self;
        let columns = rows + 1;
        for register in 0..width / L::WIDTH {
            let place = |row: usize, column: usize| (row * columns + column) * width + register * L::WIDTH;
            let mut worst = L::load(dense, place(rows, 0));
            for column in 0..first {
                for row in column + 1..first {
                    let (a, b) = (place(column, column), place(row, column));
                    let mask = L::load(dense, b).exceeds(L::load(dense, a));
                    for k in column..columns {
                        let (a, b) = (L::load(dense, place(column, k)), L::load(dense, place(row, k)));
                        L::choose(mask, b, a).store(dense, place(column, k));
                        L::choose(mask, a, b).store(dense, place(row, k));
                    }
                }
                let reciprocal = L::one() / L::load(dense, place(column, column));
                for row in column + 1..rows {
                    let multiplier = L::load(dense, place(row, column)) * reciprocal;
                    if row >= first {
                        worst = L::choose(worst.exceeds(multiplier), worst, multiplier);
                    }
                    for k in column + 1..columns {
                        let pivot = L::load(dense, place(column, k));
                        let entry = L::load(dense, place(row, k)).subtract_product(multiplier, pivot);
                        entry.store(dense, place(row, k));
                    }
                }
            }
            worst.store(dense, place(rows, 0));
        }
    }
}
