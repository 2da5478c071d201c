//! Some parts of a group, side by side in lanes: gathered from the state, and scattered back.
//!
//! In: where the parts lie. Out: their sites in turn, each array of a site one register. To either
//! side of an interior stand its separator and R sites more, which the separators' own rows see.

use crate::lattice::sites::neighbour;
use crate::lattice::{Family, LatticeScalar, Shape};

/// The lanes of the widest register.
const MOST: usize = 32;

/// Parts of one length, one after another in the chain.
#[derive(Clone, Copy)]
pub(super) struct Parts {
    /// The first site of the first of them, with which its separator begins.
    pub(super) start: usize,
    /// The sites of each, its separator included.
    pub(super) length: usize,
    /// How many.
    pub(super) count: usize,
}

impl Parts {
    /// Gathers numbers of the sites from `from` to `to` of every part, counted from its first one:
    /// `block` numbers a site, `stride` registers apart, found by their site in the chain.
    #[inline(always)]
    fn gather<T: LatticeScalar + Copy>(
        self,
        (from, to): (isize, isize),
        block: usize,
        stride: usize,
        lanes: &mut [T],
        number: impl Fn(isize, usize) -> T,
    ) {
        for (s, site) in (from..to).enumerate() {
            for b in 0..block {
                for k in 0..self.count {
                    let chain = (self.start + k * self.length) as isize + site;
                    lanes[(s * stride + b) * self.count + k] = number(chain, b);
                }
            }
        }
    }

    /// The states and parameters of all sites that the rows of both separators see, from R before
    /// the left one to R after the right one.
    #[inline(always)]
    pub(super) fn gather_all<M, T>(self, map: &M, state: &[T], x: &mut [T], c: &mut [T])
    where
        T: LatticeScalar + Copy,
        M: Family<T>,
    {
        let (block, reach) = (M::Shape::BLOCK, M::Shape::REACH as isize);
        let sites = state.len() / block;
        let (length, count) = (self.length as isize, self.count);
        let edge = |site: isize, b: usize| {
            neighbour(M::BOUNDARY, sites, 0, site).map_or_else(T::zero, |site| state[site * block + b])
        };
        // Between the separators' outer neighbours nothing wraps around.
        let place = |site: isize| (site + reach) as usize * block * count;
        self.gather((-reach, 0), block, block, x, edge);
        self.gather_inner(state, block, 1, 0, self.length, &mut x[place(0)..]);
        self.gather((length, length + 2 * reach), block, block, &mut x[place(length)..], edge);
        self.gather_parameters(map, sites, c);
    }

    /// The parameters of the same sites.
    #[inline(always)]
    pub(super) fn gather_parameters<M, T>(self, map: &M, sites: usize, c: &mut [T])
    where
        T: LatticeScalar + Copy,
        M: Family<T>,
    {
        let (reach, length) = (M::Shape::REACH as isize, self.length as isize);
        let (count, parameters) = (self.count, M::Shape::PARAMETERS);
        let place = |site: isize| (site + reach) as usize * parameters * count;
        for p in 0..parameters {
            let values = map.site_parameter(p);
            let edge = |site: isize, _| {
                neighbour(M::BOUNDARY, sites, 0, site).map_or_else(T::zero, |site| values[site])
            };
            let mut gather =
                |from, to| self.gather((from, to), 1, parameters, &mut c[place(from) + p * count..], edge);
            gather(-reach, 0);
            gather(length, length + 2 * reach);
            self.gather_inner(values, 1, parameters, 0, self.length, &mut c[place(0) + p * count..]);
        }
    }

    /// The sites from `from` to `to` of each part, none of which wraps around, in a run of numbers
    /// in which the first part begins at `start`; one number goes to every `stride`-th register.
    #[inline(always)]
    pub(super) fn gather_inner<T: LatticeScalar + Copy>(
        self,
        state: &[T],
        block: usize,
        stride: usize,
        from: usize,
        to: usize,
        lanes: &mut [T],
    ) {
        let len = (to - from) * block;
        let mut parts: [&[T]; MOST] = [&[]; MOST];
        for (k, part) in parts.iter_mut().enumerate().take(self.count) {
            *part = &state[(self.start + k * self.length + from) * block..][..len];
        }
        for (place, registers) in lanes.chunks_mut(stride * self.count).take(len).enumerate() {
            let register = &mut registers[..self.count];
            for k in 0..self.count {
                register[k] = parts[k][place];
            }
        }
    }

    /// The inverse of [`gather_inner`](Self::gather_inner).
    #[inline(always)]
    pub(super) fn scatter_inner<T: LatticeScalar + Copy>(
        self,
        state: &mut [T],
        block: usize,
        from: usize,
        to: usize,
        lanes: &[T],
    ) {
        let len = (to - from) * block;
        let mut parts: [&mut [T]; MOST] = core::array::from_fn(|_| [].as_mut_slice());
        let mut rest = &mut state[(self.start + from) * block..];
        for part in parts.iter_mut().take(self.count) {
            let (first, others) = rest.split_at_mut(len);
            *part = first;
            rest = others.get_mut(self.length * block - len..).unwrap_or_default();
        }
        for (place, register) in lanes.chunks_exact(self.count).take(len).enumerate() {
            for k in 0..self.count {
                parts[k][place] = register[k];
            }
        }
    }
}
