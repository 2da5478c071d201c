//! One site after another: its neighbourhood is gathered, its line run, its entries placed.
//!
//! In: a state and a site. Out: f and the rows of A(x,ε) there, each entry with the unknown that it
//! belongs to. The line may run over another scalar than the state's.

use std::vec;
use std::vec::Vec;

use crate::Scalar;

use super::{Boundary, Family, LatticeScalar, Shape};

/// The neighbour of site i at this offset, if the chain has one there.
pub fn neighbour(boundary: Boundary, sites: usize, i: usize, offset: isize) -> Option<usize> {
    let place = i as isize + offset;
    match boundary {
        Boundary::Periodic => Some(place.rem_euclid(sites as isize) as usize),
        Boundary::Open => usize::try_from(place).ok().filter(|&place| place < sites),
    }
}

/// The neighbourhood of a site, and what its line says.
pub(super) struct Site<L> {
    /// The site.
    i: usize,
    x: Vec<L>,
    c: Vec<L>,
    f: Vec<L>,
    a: Vec<L>,
}

impl<L: Scalar> Site<L> {
    /// Workspace for the sites of a family.
    pub(super) fn of<S: Shape>() -> Self {
        let seen = 2 * S::REACH + 1;
        let zeros = |len| vec![L::zero(); len];
        Self {
            i: 0,
            x: zeros(seen * S::BLOCK),
            c: zeros(seen * S::PARAMETERS),
            f: zeros(S::BLOCK),
            a: zeros(S::BLOCK * seen * S::BLOCK),
        }
    }

    /// The neighbourhood of site i: entries of the state, taken to L by `convert`, and parameters,
    /// taken there by `given`.
    pub(super) fn gather<M, T, V>(
        &mut self,
        map: &M,
        state: &[V],
        i: usize,
        convert: impl Fn(&V) -> L,
        given: impl Fn(&T) -> L,
    ) -> [&[L]; 2]
    where
        T: LatticeScalar,
        M: Family<T>,
    {
        let (block, reach, parameters) = (M::Shape::BLOCK, M::Shape::REACH as isize, M::Shape::PARAMETERS);
        self.i = i;
        for (place, offset) in (-reach..=reach).enumerate() {
            let site = neighbour(M::BOUNDARY, state.len() / block, i, offset);
            for b in 0..block {
                self.x[place * block + b] =
                    site.map_or_else(L::zero, |site| convert(&state[site * block + b]));
            }
            for p in 0..parameters {
                self.c[place * parameters + p] =
                    site.map_or_else(L::zero, |site| given(&map.site_parameter(p)[site]));
            }
        }
        [&self.x, &self.c]
    }

    /// f of site i.
    pub(super) fn field<M, T>(
        &mut self,
        map: &M,
        constants: &[L],
        state: &[T],
        i: usize,
        convert: impl Fn(&T) -> L,
    ) -> &[L]
    where
        T: LatticeScalar,
        M: Family<T>,
    {
        self.gather(map, state, i, &convert, &convert);
        M::field(constants, &self.x, &self.c, &mut self.f);
        &self.f
    }

    /// f and the rows of A of site i, kept until the next call.
    pub(super) fn rows<M, T>(
        &mut self,
        map: &M,
        constants: &[L],
        state: &[T],
        i: usize,
        convert: impl Fn(&T) -> L,
    ) where
        T: LatticeScalar,
        M: Family<T>,
    {
        self.gather(map, state, i, &convert, &convert);
        self.a.fill(L::zero());
        M::rows(constants, &self.x, &self.c, &mut self.f, &mut self.a);
    }

    /// f of array b.
    pub(super) fn f(&self, b: usize) -> &L {
        &self.f[b]
    }

    /// The entries of the row of array b: the unknown, and what is added there.
    ///
    /// What leads beyond the ends of an open chain is left out.
    pub(super) fn entries<S: Shape>(
        &self,
        boundary: Boundary,
        sites: usize,
        b: usize,
    ) -> impl Iterator<Item = (usize, &L)> {
        let (reach, i) = (S::REACH as isize, self.i);
        let row = &self.a[b * (2 * S::REACH + 1) * S::BLOCK..][..(2 * S::REACH + 1) * S::BLOCK];
        row.iter().enumerate().filter_map(move |(place, entry)| {
            let distance = place as isize - (reach * S::BLOCK as isize + b as isize);
            let is_there = -(S::LOWER as isize) <= distance && distance <= S::UPPER as isize;
            let offset = (place / S::BLOCK) as isize - reach;
            let site = if is_there { neighbour(boundary, sites, i, offset) } else { None };
            site.map(|site| (site * S::BLOCK + place % S::BLOCK, entry))
        })
    }

    /// The entries of the row of array b of A itself, each unknown once: on a ring shorter than the
    /// stencil several entries of a line are added.
    pub(super) fn row<S: Shape>(
        &self,
        boundary: Boundary,
        sites: usize,
        b: usize,
    ) -> impl Iterator<Item = (usize, L)> {
        let entries = move || self.entries::<S>(boundary, sites, b);
        entries().enumerate().filter_map(move |(place, (column, _))| {
            let is_first = entries().take(place).all(|(earlier, _)| earlier != column);
            let same = move || entries().filter(move |(other, _)| *other == column);
            is_first.then(|| (column, same().fold(L::zero(), |sum, (_, entry)| sum + entry.clone())))
        })
    }
}
