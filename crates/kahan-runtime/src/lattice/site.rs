//! One site after another: what it sees is gathered, its line run.

use kahan_core::__private::{Boundary, neighbour};
use kahan_core::Scalar;

use crate::line::{Line, Results, has_value};

/// A chain's shape and the parameters of its sites.
#[derive(Debug)]
pub(super) struct Chain {
    pub(super) boundary: Boundary,
    pub(super) sites: usize,
    /// Arrays a site.
    pub(super) block: usize,
    pub(super) reach: usize,
    /// A list of numbers a parameter, one a site.
    pub(super) parameters: Vec<Vec<f64>>,
}

impl Chain {
    /// How many numbers a state has.
    pub(super) fn unknowns(&self) -> usize {
        self.sites * self.block
    }

    /// The unknown that stands at a place among the values that site i sees, if there is one.
    pub(super) fn unknown(&self, i: usize, place: usize) -> Option<usize> {
        let site = self.neighbour(i, place / self.block)?;
        Some(site * self.block + place % self.block)
    }

    /// The site that stands at a place of the stencil of site i, if there is one.
    fn neighbour(&self, i: usize, place: usize) -> Option<usize> {
        neighbour(self.boundary, self.sites, i, place as isize - self.reach as isize)
    }

    /// How many sites a site sees.
    fn stencil(&self) -> usize {
        2 * self.reach + 1
    }
}

/// The memory of a line, over the scalar that it is run over.
#[derive(Debug)]
pub(super) struct Site<V> {
    /// What the site sees: the arrays site by site, then its parameters one after the other.
    values: Vec<V>,
    registers: Vec<V>,
}

impl<V: Scalar> Site<V> {
    /// Workspace for a line, which has got its constants.
    pub(super) fn new(chain: &Chain, line: &Line, constants: impl IntoIterator<Item = V>) -> Self {
        let mut registers = vec![V::zero(); line.registers()];
        line.give(constants, &mut registers);
        let values = chain.stencil() * (chain.block + chain.parameters.len());
        Site { values: vec![V::zero(); values], registers }
    }

    /// Runs the line at site i; `state` is what an entry of the state is in this scalar, and
    /// `convert` what a parameter is. Beyond the ends of an open chain both are 0.
    pub(super) fn run<'a>(
        &'a mut self,
        chain: &Chain,
        line: &'a Line,
        i: usize,
        state: impl Fn(usize) -> V,
        convert: impl Fn(f64) -> V,
    ) -> Results<'a, V> {
        for place in 0..chain.stencil() {
            let site = chain.neighbour(i, place);
            for b in 0..chain.block {
                self.values[place * chain.block + b] =
                    site.map_or_else(V::zero, |site| state(site * chain.block + b));
            }
            for (p, numbers) in chain.parameters.iter().enumerate() {
                self.values[chain.stencil() * (chain.block + p) + place] =
                    site.map_or_else(V::zero, |site| convert(numbers[site]));
            }
        }
        has_value(line.run(&mut self.registers, &self.values))
    }
}
