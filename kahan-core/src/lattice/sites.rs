//! The equations at one site: f and the site's rows of A(x,ε), each entry with its column.

use std::vec;
use std::vec::Vec;

use crate::Scalar;

use super::{Boundary, LatticeMap, LatticeScalar, Sizes};

/// Returns the neighbour of site i at this offset, or `None` beyond an open end.
pub(super) fn neighbour(boundary: Boundary, sites: usize, i: usize, offset: isize) -> Option<usize> {
    let place = i as isize + offset;
    match boundary {
        Boundary::Periodic => Some(place.rem_euclid(sites as isize) as usize),
        Boundary::Open => usize::try_from(place).ok().filter(|&place| place < sites),
    }
}

pub(super) struct Site<L> {
    i: usize,
    x: Vec<L>,
    c: Vec<L>,
    registers: Vec<L>,
    f: Vec<L>,
    a: Vec<L>,
}

impl<L: Scalar> Site<L> {
    pub(super) fn of(sizes: Sizes) -> Self {
        let Sizes { block, parameters, registers, .. } = sizes;
        let seen = 2 * sizes.reach + 1;
        let zeros = |len| vec![L::zero(); len];
        Self {
            i: 0,
            x: zeros(seen * block),
            c: zeros(seen * parameters),
            registers: zeros(registers),
            f: zeros(block),
            a: zeros(block * seen * block),
        }
    }

    /// Gathers the neighbourhood of site i. The functions `convert` and `given` convert states and
    /// parameters to L.
    pub(super) fn gather<M, T, V>(
        &mut self,
        map: &M,
        state: &[V],
        i: usize,
        convert: impl Fn(&V) -> L,
        given: impl Fn(&T) -> L,
    ) where
        T: LatticeScalar,
        M: LatticeMap<T>,
    {
        let Sizes { block, parameters, .. } = map.sizes();
        let reach = map.sizes().reach as isize;
        self.i = i;
        for (place, offset) in (-reach..=reach).enumerate() {
            let site = neighbour(map.boundary(), state.len() / block, i, offset);
            for b in 0..block {
                self.x[place * block + b] =
                    site.map_or_else(L::zero, |site| convert(&state[site * block + b]));
            }
            for p in 0..parameters {
                self.c[place * parameters + p] =
                    site.map_or_else(L::zero, |site| given(&map.site_parameter(p)[site]));
            }
        }
    }

    pub(super) fn densities<M: LatticeMap<T>, T: LatticeScalar>(
        &mut self,
        map: &M,
        constants: &[L],
        densities: &mut [L],
    ) {
        map.densities(constants, &self.x, &self.c, &mut self.registers, densities);
    }

    /// Computes f and the rows of A at site i. The results are valid until the next call.
    pub(super) fn rows<M, T>(
        &mut self,
        map: &M,
        constants: &[L],
        state: &[T],
        i: usize,
        convert: impl Fn(&T) -> L,
    ) where
        T: LatticeScalar,
        M: LatticeMap<T>,
    {
        self.gather(map, state, i, &convert, &convert);
        self.a.fill(L::zero());
        map.rows(constants, &self.x, &self.c, &mut self.registers, &mut self.f, &mut self.a);
    }

    pub(super) fn f(&self, b: usize) -> &L {
        &self.f[b]
    }

    /// Iterates over the entries of row b with their columns, without entries beyond open ends.
    pub(super) fn entries<M: LatticeMap<T>, T: LatticeScalar>(
        &self,
        map: &M,
        sites: usize,
        b: usize,
    ) -> impl Iterator<Item = (usize, &L)> {
        let (boundary, i) = (map.boundary(), self.i);
        let Sizes { block, reach, lower, upper, .. } = map.sizes();
        let row = &self.a[b * (2 * reach + 1) * block..][..(2 * reach + 1) * block];
        row.iter().enumerate().filter_map(move |(place, entry)| {
            let distance = place as isize - (reach * block + b) as isize;
            let is_there = -(lower as isize) <= distance && distance <= upper as isize;
            let offset = (place / block) as isize - reach as isize;
            let site = if is_there { neighbour(boundary, sites, i, offset) } else { None };
            site.map(|site| (site * block + place % block, entry))
        })
    }

    /// Yields the entries of row b of A. Entries in one column, possible in short rings, are added.
    pub(super) fn row<M: LatticeMap<T>, T: LatticeScalar>(
        &self,
        map: &M,
        sites: usize,
        b: usize,
    ) -> impl Iterator<Item = (usize, L)> {
        let entries = move || self.entries(map, sites, b);
        entries().enumerate().filter_map(move |(place, (column, _))| {
            let is_first = entries().take(place).all(|(earlier, _)| earlier != column);
            let same = move || entries().filter(move |(other, _)| *other == column);
            is_first.then(|| (column, same().fold(L::zero(), |sum, (_, entry)| sum + entry.clone())))
        })
    }
}
