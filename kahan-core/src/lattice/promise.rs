//! The step that promises a small backward error.
//!
//! In: a state and ε as given. Out: a finite x̃ with |A·x̃ − b|ᵢ ≤ (k + 8)·u·(|A|·|x̃| + |b|)ᵢ for every
//! unknown i, A(x,ε) and b(x,ε) exact at the floats as given and k the entries in its row of A; or
//! why there is none. Residuals are computed in wider numbers that carry bounds on their own errors,
//! and refine a step at most twice. With d = x̃ − x the residual b − A·x̃ is 2εf − A·d, and b is
//! A·x + 2εf.

use core::cell::Cell;
use std::vec;
use std::vec::Vec;

use crate::Scalar;

use super::sites::Site;
use super::{Judged, LatticeMap, LatticeScalar, Shape};

/// How often a step is refined.
pub(super) const REFINEMENTS: usize = 2;

/// The memory of steps that promise.
pub(super) struct Promise<T: LatticeScalar> {
    eps: T::Judge,
    constants: Vec<T::Judge>,
    site: Site<T::Judge>,
    /// The largest of ε and the parameters.
    largest: f64,
    /// The state that the step began at.
    pub(super) before: Vec<T>,
    /// b − A·x̃, rounded.
    pub(super) residual: Vec<T>,
}

impl<T: LatticeScalar> Promise<T> {
    pub(super) fn new<M: LatticeMap<T>>(map: &M, eps: &T, len: usize) -> Self {
        let largest = Cell::new(0.0);
        let given = |number: &T| {
            largest.set(larger(largest.get(), number));
            number.judged()
        };
        let constants = map.constants(&given(eps), given);
        for parameter in 0..M::Shape::PARAMETERS {
            let values = map.site_parameter(parameter);
            largest.set(values.iter().fold(largest.get(), larger));
        }
        Self {
            eps: eps.judged(),
            constants,
            site: Site::of::<M::Shape>(),
            largest: largest.get(),
            before: vec![T::zero(); len],
            residual: vec![T::zero(); len],
        }
    }

    /// The backward error of `next` in units of (k + 8)·u, at most; not a number, or infinite, where
    /// it is not known. Leaves the residual.
    pub(super) fn bound<M: LatticeMap<T>>(&mut self, map: &M, next: &[T]) -> f64 {
        let Self { eps, constants, site, before, residual, .. } = self;
        let (block, sites) = (M::Shape::BLOCK, before.len() / M::Shape::BLOCK);
        let largest = before.iter().chain(next).fold(self.largest, larger);
        let (mut worst, mut largest_input) = (0.0, f64::INFINITY);
        for i in 0..sites {
            site.rows(map, constants, before, i, T::judged);
            for b in 0..block {
                let own = i * block + b;
                let increment = (eps.clone() + eps.clone()) * site.f(b).clone();
                let (mut rest, mut right) = (increment.clone(), increment);
                let (mut size, mut entries) = (0.0, 0);
                for (column, entry) in site.row::<M::Shape>(M::BOUNDARY, sites, b) {
                    let known = T::known(&entry).1;
                    let (x, y) = (before[column].judged(), next[column].judged());
                    rest -= entry.clone() * (y.clone() - x.clone());
                    right += entry * x;
                    size += known.at_least() * T::known(&y).1.size;
                    entries += usize::from(known.size + known.error > 0.0);
                }
                let (rounded, known) = T::known(&rest);
                let right = T::known(&right).1;
                residual[own] = rounded;
                largest_input = known.largest_input.min(right.largest_input).min(largest_input);
                let (error, size) = (known.size + known.error, size + right.at_least());
                let quotient = error / size / ((entries as f64 + 8.0) * T::UNIT);
                // What is not a number is worse than any.
                if !(size == 0.0 && known.size == 0.0) && !(quotient <= worst) {
                    worst = quotient;
                }
            }
        }
        if largest < largest_input { worst } else { f64::INFINITY }
    }
}

/// The larger of a size and that of a number.
fn larger<T: LatticeScalar>(size: f64, number: &T) -> f64 {
    let own = number.approximate().abs();
    if own <= size { size } else { own }
}
