//! Some parts of a group, side by side in lanes: gathered from the state, and scattered back.
//!
//! In: where the parts lie. Out: their sites in turn, each array of a site one register. To either
//! side of an interior stand its separator and R sites more, which the separators' own rows see.

use crate::ensemble::lanes::Lanes;
use crate::lattice::sites::neighbour;
use crate::lattice::{LatticeScalar, Lines};

/// Parts of one length, one after another in the chain, as many as lanes.
#[derive(Clone, Copy)]
pub(super) struct Parts {
    /// The first site of the first of them, with which its separator begins.
    pub(super) start: usize,
    /// The sites of each, its separator included.
    pub(super) length: usize,
}

impl Parts {
    /// Gathers numbers of the sites from `from` to `to` of every part, counted from its first one:
    /// `block` numbers a site, `stride` registers apart, found by their site in the chain.
    #[inline(always)]
    fn gather<L: Lanes<T>, T: LatticeScalar + Copy>(
        self,
        (from, to): (isize, isize),
        block: usize,
        stride: usize,
        lanes: &mut [T],
        number: impl Fn(isize, usize) -> T,
    ) {
        for (s, site) in (from..to).enumerate() {
            for b in 0..block {
                for k in 0..L::WIDTH {
                    let chain = (self.start + k * self.length) as isize + site;
                    lanes[(s * stride + b) * L::WIDTH + k] = number(chain, b);
                }
            }
        }
    }

    /// The states and parameters of all sites that the rows of both separators see, from R before
    /// the left one to R after the right one.
    #[inline(always)]
    pub(super) fn gather_all<M, L, T>(self, map: &M, state: &[T], x: &mut [T], c: &mut [T])
    where
        L: Lanes<T>,
        T: LatticeScalar + Copy,
        M: Lines<T>,
    {
        let (block, reach) = (map.sizes().block, map.sizes().reach as isize);
        let sites = state.len() / block;
        let length = self.length as isize;
        let edge = |site: isize, b: usize| {
            neighbour(map.boundary(), sites, 0, site).map_or_else(T::zero, |site| state[site * block + b])
        };
        // Between the separators' outer neighbours nothing wraps around.
        let place = |site: isize| (site + reach) as usize * block * L::WIDTH;
        self.gather::<L, T>((-reach, 0), block, block, x, edge);
        self.gather_inner::<L, T>(state, block, 1, 0, self.length, &mut x[place(0)..]);
        self.gather::<L, T>((length, length + 2 * reach), block, block, &mut x[place(length)..], edge);
        self.gather_parameters::<M, L, T>(map, sites, c);
    }

    /// The parameters of the same sites.
    #[inline(always)]
    pub(super) fn gather_parameters<M, L, T>(self, map: &M, sites: usize, c: &mut [T])
    where
        L: Lanes<T>,
        T: LatticeScalar + Copy,
        M: Lines<T>,
    {
        let (reach, length) = (map.sizes().reach as isize, self.length as isize);
        let parameters = map.sizes().parameters;
        let place = |site: isize| (site + reach) as usize * parameters * L::WIDTH;
        for p in 0..parameters {
            let values = map.site_parameter(p);
            let edge = |site: isize, _| {
                neighbour(map.boundary(), sites, 0, site).map_or_else(T::zero, |site| values[site])
            };
            let mut gather = |from, to| {
                self.gather::<L, T>((from, to), 1, parameters, &mut c[place(from) + p * L::WIDTH..], edge);
            };
            gather(-reach, 0);
            gather(length, length + 2 * reach);
            self.gather_inner::<L, T>(
                values,
                1,
                parameters,
                0,
                self.length,
                &mut c[place(0) + p * L::WIDTH..],
            );
        }
    }

    /// The sites from `from` to `to` of each part, none of which wraps around, in a run of numbers
    /// in which the first part begins at `start`; one number goes to every `stride`-th register.
    #[inline(always)]
    pub(super) fn gather_inner<L: Lanes<T>, T: LatticeScalar + Copy>(
        self,
        state: &[T],
        block: usize,
        stride: usize,
        from: usize,
        to: usize,
        lanes: &mut [T],
    ) {
        let len = (to - from) * block;
        let part = |k: usize| &state[(self.start + k * self.length + from) * block..][..len];
        let in_squares = in_squares::<L, T>(len);
        for k in (0..L::WIDTH / SIDE).map(|square| square * SIDE) {
            let mut square = [[T::zero(); SIDE]; SIDE];
            for number in (0..in_squares / SIDE).map(|square| square * SIDE) {
                for (r, row) in square.iter_mut().enumerate() {
                    row.copy_from_slice(&part(k + r)[number..][..SIDE]);
                }
                square = L::transposed(square);
                for (r, row) in square.iter().enumerate() {
                    lanes[(number + r) * stride * L::WIDTH + k..][..SIDE].copy_from_slice(row);
                }
            }
        }
        for number in in_squares..len {
            for k in 0..L::WIDTH {
                lanes[number * stride * L::WIDTH + k] = part(k)[number];
            }
        }
    }

    /// The inverse of [`gather_inner`](Self::gather_inner).
    #[inline(always)]
    pub(super) fn scatter_inner<L: Lanes<T>, T: LatticeScalar + Copy>(
        self,
        state: &mut [T],
        block: usize,
        from: usize,
        to: usize,
        lanes: &[T],
    ) {
        let len = (to - from) * block;
        let begin = |k: usize| (self.start + k * self.length + from) * block;
        let in_squares = in_squares::<L, T>(len);
        for k in (0..L::WIDTH / SIDE).map(|square| square * SIDE) {
            let mut square = [[T::zero(); SIDE]; SIDE];
            for number in (0..in_squares / SIDE).map(|square| square * SIDE) {
                for (r, row) in square.iter_mut().enumerate() {
                    row.copy_from_slice(&lanes[(number + r) * L::WIDTH + k..][..SIDE]);
                }
                square = L::transposed(square);
                for (r, row) in square.iter().enumerate() {
                    state[begin(k + r) + number..][..SIDE].copy_from_slice(row);
                }
            }
        }
        for number in in_squares..len {
            for k in 0..L::WIDTH {
                state[begin(k) + number] = lanes[number * L::WIDTH + k];
            }
        }
    }
}

/// The numbers of a side of a square.
const SIDE: usize = 4;

/// How many of so many numbers a part are moved in squares.
#[inline(always)]
fn in_squares<L: Lanes<T>, T>(len: usize) -> usize {
    if L::WIDTH.is_multiple_of(SIDE) { len - len % SIDE } else { 0 }
}
