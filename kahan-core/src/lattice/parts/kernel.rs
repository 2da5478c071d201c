//! The two passes over some parts side by side, one in each lane.
//!
//! In: gathered sites. Out of the first pass: what eliminating the interiors leaves of the rows of
//! the separators to either side. Out of the second, with the separators known: the interiors one
//! step later. The second eliminates again what the first has not stored, which moves less memory
//! than storing it would.
#![expect(clippy::needless_range_loop, reason = "indices of one formula run through several arrays")]

use core::array::from_fn;
use core::marker::PhantomData;

use crate::Scalar;
use crate::ensemble::lanes::{InLanes, Lanes, OverLanes};
use crate::lattice::{Family, LatticeScalar, Lines, Stencil};

use super::scratch::Scratch;
use super::window::{Window, WindowRow};

/// A line's results at one site: f, and for each array its entries, site by site.
#[derive(Clone, Copy, Debug)]
pub struct SiteLine<L, const B: usize, const SITES: usize> {
    /// The field.
    pub f: [L; B],
    /// The rows of A.
    pub a: [[[L; B]; SITES]; B],
}

/// The lines of sites that stand side by side in lanes.
pub trait GatheredLines<L, const B: usize, const SITES: usize> {
    /// The line of a site, counted in the registers that were gathered; each call asks for a site
    /// behind the one before.
    fn at(&mut self, site: usize) -> SiteLine<L, B, SITES>;
}

/// The lines of a family's type, each computed where it is asked for.
struct Compiled<'a, M, L, T, const R: usize, const P: usize, const C: usize> {
    family: PhantomData<M>,
    constants: [L; C],
    x: &'a [T],
    c: &'a [T],
}

impl<M, L, T, const B: usize, const R: usize, const P: usize, const C: usize, const SITES: usize>
    GatheredLines<L, B, SITES> for Compiled<'_, M, L, T, R, P, C>
where
    M: Family<T>,
    L: Lanes<T>,
    T: LatticeScalar + Copy,
{
    #[inline(always)]
    fn at(&mut self, site: usize) -> SiteLine<L, B, SITES> {
        let first = site - R;
        let seen_x = &self.x[first * B * L::WIDTH..][..SITES * B * L::WIDTH];
        let seen_c = &self.c[first * P * L::WIDTH..][..SITES * P * L::WIDTH];
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
        M::rows(&self.constants, x.as_flattened(), c.as_flattened(), &mut line.f, a);
        line
    }
}

/// The first pass under way.
struct Sweep<L, const B: usize, const R: usize, const LOWER: usize, const WIDTH: usize> {
    window: Window<L, B, R, LOWER, WIDTH>,
    /// The rows of the left separator.
    border: [[WindowRow<L, B, R, WIDTH>; B]; R],
    /// The largest multiplier of such a row.
    worst: L,
}

impl<L: Scalar + Copy, const B: usize, const R: usize, const LOWER: usize, const WIDTH: usize>
    Sweep<L, B, R, LOWER, WIDTH>
{
    /// Takes in the next row and eliminates a column.
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

/// The second pass under way, to where the elimination is complete.
struct Again<'a, L, T, const B: usize, const LOWER: usize, const WIDTH: usize> {
    window: Window<L, B, 0, LOWER, WIDTH>,
    /// The rows that are done with, each with its right-hand side.
    done: &'a mut [T],
    count: usize,
}

impl<L: Lanes<T>, T, const B: usize, const LOWER: usize, const WIDTH: usize>
    Again<'_, L, T, B, LOWER, WIDTH>
{
    /// Takes in the next row, eliminates a column, and keeps its row.
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

/// The passes of a [`Shape`](crate::lattice::Shape).
pub(in crate::lattice) trait Passes {
    /// The first pass over parts of `interior` sites and their separators: writes 2S rows of 2S + 1
    /// numbers, S = R·B, first those of the separators to the right, and in each row first the
    /// columns of the separators to the right; and last the largest multiplier of such a row.
    fn contribute<M, L, T>(map: &M, constants: &[T], interior: usize, scratch: &mut Scratch<T>)
    where
        M: Lines<T>,
        L: Lanes<T>,
        T: LatticeScalar + InLanes + Copy;

    /// The second pass, with what the separators gain, first that to the left: x + 2ε w in place of
    /// x.
    fn substitute<M, L, T>(map: &M, constants: &[T], twice: &T, interior: usize, scratch: &mut Scratch<T>)
    where
        M: Lines<T>,
        L: Lanes<T>,
        T: LatticeScalar + InLanes + Copy;

    /// The lines of a family of this shape.
    fn lines<'a, M, L, T, const B: usize, const SITES: usize>(
        constants: &'a [T],
        x: &'a [T],
        c: &'a [T],
    ) -> impl GatheredLines<L, B, SITES>
    where
        M: Family<T, Shape = Self> + 'a,
        L: Lanes<T>,
        T: LatticeScalar + Copy;
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
> Passes for Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    #[inline(always)]
    fn contribute<M, L, T>(map: &M, constants: &[T], interior: usize, scratch: &mut Scratch<T>)
    where
        M: Lines<T>,
        L: Lanes<T>,
        T: LatticeScalar + InLanes + Copy,
    {
        let (x, c) = (scratch.x.entries(), scratch.c.entries());
        let (registers, level) = (scratch.registers.entries(), scratch.level);
        let mut lines = map.gathered::<L, B, SITES>(constants, x, c, registers, level);
        // The rows of the left separator, which no part before this one sees to the left.
        let mut border = [[WindowRow::<L, B, R, WIDTH>::zero(); B]; R];
        for r in 0..R {
            let SiteLine { f, a } = lines.at(R + r);
            for b in 0..B {
                border[r][b].right = f[b];
                for k in R - r..SITES {
                    for e in 0..B {
                        let site = r + k - R;
                        if site < R {
                            border[r][b].left[site][e] = a[b][k][e];
                        } else if LOWER + (site - R) * B + e < WIDTH {
                            border[r][b].band[LOWER + (site - R) * B + e] = a[b][k][e];
                        }
                    }
                }
            }
        }
        let mut sweep = Sweep { window: Window::<L, B, R, LOWER, WIDTH>::new(), border, worst: L::zero() };
        for i in 0..R {
            let line = lines.at(2 * R + i);
            for b in 0..B {
                sweep.take(Self::row_at_edge(&line, b, i));
            }
        }
        for i in R..interior {
            let line = lines.at(2 * R + i);
            for b in 0..B {
                sweep.take(Self::row(&line, b));
            }
        }
        let Sweep { window, border, worst } = sweep;

        // What is left is small and dense: the last interior columns, the separator to the right,
        // the one to the left, right-hand sides.
        let s = R * B;
        let (rows, columns) = (LOWER + 2 * s, LOWER + 2 * s + 1);
        let dense = scratch.dense.entries();
        let place = |row: usize, column: usize| (row * columns + column) * L::WIDTH;
        for row in 0..rows {
            for column in 0..columns {
                L::zero().store(dense, place(row, column));
            }
        }
        for k in 0..LOWER {
            window.rows[k].write(dense, place(k, 0), LOWER + s);
        }
        for r in 0..R {
            for b in 0..B {
                border[r][b].write(dense, place(LOWER + s + r * B + b, 0), LOWER + s);
            }
        }
        for r in 0..R {
            // Of the right separator's rows only what leads to the interior: the rest is the next
            // part's.
            let SiteLine { a, .. } = lines.at(2 * R + interior + r);
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
        worst.store(dense, place(rows, 0));
        T::run(Rest { dense, first: LOWER, rows, width: L::WIDTH }, level);
    }

    #[inline(always)]
    fn substitute<M, L, T>(map: &M, constants: &[T], twice: &T, interior: usize, scratch: &mut Scratch<T>)
    where
        M: Lines<T>,
        L: Lanes<T>,
        T: LatticeScalar + InLanes + Copy,
    {
        let twice = L::spread(twice);
        let (x, c) = (scratch.x.entries(), scratch.c.entries());
        let (registers, level) = (scratch.registers.entries(), scratch.level);
        let mut lines = map.gathered::<L, B, SITES>(constants, x, c, registers, level);
        let (done, known) = (scratch.done.entries(), scratch.known.entries());
        let left: [[L; B]; R] = from_fn(|r| from_fn(|b| L::load(known, (r * B + b) * L::WIDTH)));
        let stride = (WIDTH + 1) * L::WIDTH;

        // The first ones that are done with are rows of the identity.
        let mut sweep = Again { window: Window::<L, B, 0, LOWER, WIDTH>::new(), done, count: 0 };
        for i in 0..R {
            let line = lines.at(2 * R + i);
            for b in 0..B {
                let row = Self::row_at_edge(&line, b, i);
                let mut right = row.right;
                for r in 0..R {
                    for b in 0..B {
                        right = right.subtract_product(row.left[r][b], left[r][b]);
                    }
                }
                sweep.take(row.without_left(right));
            }
        }
        for i in R..interior {
            let line = lines.at(2 * R + i);
            for b in 0..B {
                let row = Self::row(&line, b);
                sweep.take(row.without_left(row.right));
            }
        }
        for _ in 0..LOWER {
            sweep.take(WindowRow::zero());
        }
        drop(lines);

        // What the unknowns after the current one gain, beginning with the right separator's.
        let mut after = [L::zero(); WIDTH];
        for k in 0..WIDTH {
            if k < R * B {
                after[k] = L::load(known, (R * B + k) * L::WIDTH);
            }
        }
        for unknown in (0..interior * B).rev() {
            let kept = &done[(LOWER + unknown) * stride..][..stride];
            let mut sum = L::load(kept, WIDTH * L::WIDTH);
            for k in (1..WIDTH).rev() {
                sum = sum.subtract_product(L::load(kept, k * L::WIDTH), after[k - 1]);
                after[k] = after[k - 1];
            }
            let gained = sum * L::load(kept, 0);
            after[0] = gained;
            let place = (2 * R * B + unknown) * L::WIDTH;
            gained.multiply_add(twice, L::load(x, place)).store(x, place);
        }
    }

    #[inline(always)]
    fn lines<'a, M, L, T, const BLOCK: usize, const SEEN: usize>(
        constants: &'a [T],
        x: &'a [T],
        c: &'a [T],
    ) -> impl GatheredLines<L, BLOCK, SEEN>
    where
        M: Family<T, Shape = Self> + 'a,
        L: Lanes<T>,
        T: LatticeScalar + Copy,
    {
        let constants = from_fn(|k| L::spread(&constants[k]));
        Compiled::<'a, M, L, T, R, P, C> { family: PhantomData, constants, x, c }
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
    /// A row whose site sees no separator to the left.
    #[inline(always)]
    fn row<L: Scalar + Copy>(line: &SiteLine<L, B, SITES>, b: usize) -> WindowRow<L, B, R, WIDTH> {
        let mut row = WindowRow::zero();
        row.right = line.f[b];
        let entries = line.a[b].as_flattened();
        for k in 0..WIDTH {
            // The first and last rows of a block see fewer entries to one side.
            if R * B + b + k >= LOWER && R * B + b + k - LOWER < SITES * B {
                row.band[k] = entries[R * B + b + k - LOWER];
            }
        }
        row
    }

    /// A row of the first R sites, i of them before its own.
    #[inline(always)]
    fn row_at_edge<L: Scalar + Copy>(
        line: &SiteLine<L, B, SITES>,
        b: usize,
        i: usize,
    ) -> WindowRow<L, B, R, WIDTH> {
        let mut row = Self::row(line, b);
        for k in 0..R - i {
            for e in 0..B {
                row.left[i + k][e] = line.a[b][k][e];
                // Where it stands in the band it would be eliminated with the identity's rows.
                let distance = (R - k) * B + b - e;
                if distance <= LOWER {
                    row.band[LOWER - distance] = L::zero();
                }
            }
        }
        row
    }
}

/// The small system that the first pass ends with, and behind it the largest multipliers so far:
/// eliminates its first columns, with pivots from the first rows only.
struct Rest<'a, T> {
    dense: &'a mut [T],
    first: usize,
    rows: usize,
    /// Parts side by side.
    width: usize,
}

impl<T: LatticeScalar + InLanes + Copy> OverLanes<T> for Rest<'_, T> {
    type Output = ();
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let Rest { dense, first, rows, width } = self;
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
