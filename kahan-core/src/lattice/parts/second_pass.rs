//! The second pass, which steps the interiors after the separators are solved.
//!
//! The states x become x + 2ε·w, where A(x,ε)·w = f(x). The elimination is repeated, because
//! storing its rows would move more memory.
#![expect(clippy::needless_range_loop, reason = "indices of one formula run through several arrays")]

use core::array::from_fn;
use core::ops::Range;

use crate::ensemble::lanes::{InLanes, Lanes, OverLanes};
use crate::lattice::{LatticeMap, LatticeScalar, Stencil};

use super::group::PartGroup;
use super::kernels::{KernelCall, batches, is_small};
use super::lines::Gathered;
use super::partition::Partition;
use super::scratch::Scratch;
use super::window::{Window, WindowRow};

pub(in crate::lattice) struct SecondPass<'a, M, T> {
    pub(super) partition: &'a Partition,
    pub(super) map: &'a M,
    pub(super) constants: &'a [T],
    pub(super) twice: &'a T,
    pub(super) kept: &'a [T],
    pub(super) gained: &'a [T],
    pub(super) sites: usize,
    pub(super) groups: Range<usize>,
    pub(super) scratch: &'a mut Scratch<T>,
    /// The states from the first site of the first group on.
    pub(super) state: &'a mut [T],
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
> OverLanes<T> for KernelCall<Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>, SecondPass<'_, M, T>>
{
    type Output = ();
    const IS_SMALL: bool = is_small(LOWER, WIDTH);

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let SecondPass { partition, map, constants, twice, kept, gained, sites, groups, scratch, state } =
            self.0;
        let (s, level, twice) = (R * B, scratch.level, L::spread(twice));
        let begin = partition.start(groups.start);
        for (part, parts) in batches(partition, groups, L::WIDTH) {
            let interior = parts.length - R;
            parts.gather_parameters(map, sites, scratch.c.entries(), level);
            let here = PartGroup { start: parts.start - begin, ..parts };
            let (x, known) = (scratch.x.entries(), scratch.known.entries());
            here.gather_inner(state, B, 1, parts.length, &mut x[s * L::WIDTH..], level);
            for lane in 0..L::WIDTH {
                let separators = (part + lane) * s;
                for k in 0..s {
                    // The right separator may lie in another thread's states; `kept` has a copy.
                    x[(parts.length * B + s + k) * L::WIDTH + lane] = kept[separators + s + k];
                }
                for k in 0..2 * s {
                    known[k * L::WIDTH + lane] = gained[separators + k];
                }
            }

            let (c, registers) = (scratch.c.entries(), scratch.registers.entries());
            let mut sites = Gathered::<T, L, C>::new(constants, x, c, registers, level, 2 * R);
            let left: [[L; B]; R] = from_fn(|r| from_fn(|b| L::load(known, (r * B + b) * L::WIDTH)));
            let done = scratch.done.entries();
            let mut sweep =
                InteriorElimination { window: Window::<L, B, 0, LOWER, WIDTH>::new(), done, count: 0 };
            for i in 0..R {
                let line = map.line::<L, B, P, C, SITES>(&mut sites);
                for b in 0..B {
                    let row = Stencil::<B, R, P, C, LOWER, UPPER, SITES, WIDTH>::row_at_edge(&line, b, i);
                    let mut right = row.right;
                    for r in 0..R {
                        for b in 0..B {
                            right = right.subtract_product(row.left[r][b], left[r][b]);
                        }
                    }
                    sweep.take(row.without_left(right));
                }
            }
            for _ in R..interior {
                let line = map.line::<L, B, P, C, SITES>(&mut sites);
                for b in 0..B {
                    let row = Stencil::<B, R, P, C, LOWER, UPPER, SITES, WIDTH>::row(&line, b);
                    sweep.take(row.without_left(row.right));
                }
            }
            for _ in 0..LOWER {
                sweep.take(WindowRow::zero());
            }

            // The solution at the next unknowns, which at first are those of the right separator.
            let mut after = [L::zero(); WIDTH];
            for k in 0..WIDTH {
                if k < s {
                    after[k] = L::load(known, (s + k) * L::WIDTH);
                }
            }
            let stride = (WIDTH + 1) * L::WIDTH;
            for unknown in (0..interior * B).rev() {
                let row = &done[(LOWER + unknown) * stride..][..stride];
                let mut sum = L::load(row, WIDTH * L::WIDTH);
                for k in (1..WIDTH).rev() {
                    sum = sum.subtract_product(L::load(row, k * L::WIDTH), after[k - 1]);
                    after[k] = after[k - 1];
                }
                let gained = sum * L::load(row, 0);
                after[0] = gained;
                let place = (2 * s + unknown) * L::WIDTH;
                gained.multiply_add(twice, L::load(x, place)).store(x, place);
            }
            here.scatter_inner(state, B, R, &x[2 * s * L::WIDTH..], level);
        }
    }
}

struct InteriorElimination<'a, L, T, const B: usize, const LOWER: usize, const WIDTH: usize> {
    window: Window<L, B, 0, LOWER, WIDTH>,
    done: &'a mut [T],
    count: usize,
}

impl<L: Lanes<T>, T, const B: usize, const LOWER: usize, const WIDTH: usize>
    InteriorElimination<'_, L, T, B, LOWER, WIDTH>
{
    #[inline(always)]
    fn take(&mut self, row: WindowRow<L, B, 0, WIDTH>) {
        let pivot = self.window.push(row);
        let stride = (WIDTH + 1) * L::WIDTH;
        let kept = &mut self.done[self.count * stride..][..stride];
        for k in 0..WIDTH {
            pivot.band[k].store(kept, k * L::WIDTH);
        }
        pivot.right.store(kept, WIDTH * L::WIDTH);
        self.count += 1;
    }
}
