//! The step of a chain with a small backward error.
//!
//! A step succeeds if |A·x̃ − b|ᵢ ≤ (k + 8)·u·(|A|·|x̃| + |b|)ᵢ for every unknown i. Row i of A has
//! k entries, and u is the rounding unit. At most two steps of iterative refinement follow. Then
//! chains of at most 4096 unknowns try an elimination with many digits. Wider numbers with error
//! bounds compute the residual b − A·x̃ as 2εf(x) − A·(x̃ − x).

use core::cell::Cell;
use std::vec;
use std::vec::Vec;

use num_traits::Zero;

use crate::Scalar;
use crate::scalar::Size;
use crate::scalar::bounded::backward_error;

use super::scalar::BoundedScalar;
use super::sites::Site;
use super::{LatticeMap, LatticeScalar};

pub(super) const REFINEMENTS: usize = 2;

pub(super) struct PromiseCheck<T: LatticeScalar> {
    /// The equations over `BoundedWorking`, tried first. `None` if a divisor may be 0.
    near: Option<BoundedRows<T::BoundedWorking>>,
    /// The equations over `BoundedWide`, tried after `near`. `None` if a divisor may be 0.
    far: Option<BoundedRows<T::BoundedWide>>,
    /// The largest magnitude among ε and the parameters.
    largest: f64,
    pub(super) before: Vec<T>,
    /// The residual b − A·x̃, rounded to T.
    pub(super) residual: Vec<T>,
}

struct BoundedRows<J> {
    eps: J,
    constants: Vec<J>,
    site: Site<J>,
}

struct Residual<T> {
    /// The residual b − A·x̃ in this row, rounded to T.
    residual: T,
    /// An upper bound of the backward error as a multiple of (k + 8)·u, where the row has k entries
    /// and u is the rounding unit. The bound is infinite if unknown.
    bound: f64,
}

impl<T: LatticeScalar> PromiseCheck<T> {
    pub(super) fn new<M: LatticeMap<T>>(map: &M, eps: &T, len: usize) -> Self {
        let largest = Cell::new(larger(0.0, eps));
        let note = |number: &T| {
            largest.set(larger(largest.get(), number));
            T::BoundedWorking::from_input(number)
        };
        let near = BoundedRows::new(map, eps, note);
        for parameter in 0..map.sizes().parameters {
            let values = map.site_parameter(parameter);
            largest.set(values.iter().fold(largest.get(), larger));
        }
        Self {
            near,
            far: BoundedRows::new(map, eps, T::BoundedWide::from_input),
            largest: largest.get(),
            before: vec![T::zero(); len],
            residual: vec![T::zero(); len],
        }
    }

    /// Returns whether every constant of the equations is known over `BoundedWide`.
    pub(super) fn has_equations(&self) -> bool {
        let has_value = |constant: &T::BoundedWide| !constant.known().1.size.is_unknown();
        self.far.as_ref().is_some_and(|far| far.constants.iter().all(has_value))
    }

    /// Stores the residual of `next`, and returns a bound of the backward error as a multiple of
    /// (k + 8)·u. A row of A has k entries, and u is the rounding unit.
    pub(super) fn bound<M: LatticeMap<T>>(&mut self, map: &M, next: &[T]) -> f64 {
        let Self { near, far: Some(far), before, residual, .. } = self else {
            return f64::INFINITY;
        };
        let block = map.sizes().block;
        let largest = before.iter().chain(next).fold(self.largest, larger);
        let mut worst = 0.0_f64;
        for i in 0..before.len() / block {
            if let Some(near) = near {
                near.site.rows(map, &near.constants, before, i, T::BoundedWorking::from_input);
            }
            for b in 0..block {
                let rest = near.as_ref().map(|near| near.residual(map, b, before, next, largest));
                let rest = rest.filter(|rest| rest.bound <= 1.0).unwrap_or_else(|| {
                    far.site.rows(map, &far.constants, before, i, T::BoundedWide::from_input);
                    far.residual(map, b, before, next, largest)
                });
                residual[i * block + b] = rest.residual;
                worst = rest.bound.max(worst);
            }
        }
        worst
    }
}

impl<J: Scalar> BoundedRows<J> {
    fn new<M: LatticeMap<T>, T: LatticeScalar>(map: &M, eps: &T, given: impl Fn(&T) -> J) -> Option<Self> {
        let eps = given(eps);
        Some(Self { constants: map.constants(eps.clone(), given)?, eps, site: Site::of(map.sizes()) })
    }

    /// Computes the residual and the backward error in row b of this site. The number `largest`
    /// bounds the magnitudes of ε, the parameters, and the states `before` and `next`.
    fn residual<M, T>(&self, map: &M, b: usize, before: &[T], next: &[T], largest: f64) -> Residual<T>
    where
        M: LatticeMap<T>,
        T: LatticeScalar,
        J: BoundedScalar<T>,
    {
        let sites = before.len() / map.sizes().block;
        let increment = (self.eps.clone() + self.eps.clone()) * self.site.f(b).clone();
        let (mut rest, mut right) = (increment.clone(), increment);
        let (mut size, mut entries) = (Size::zero(), 0);
        for (column, entry) in self.site.row(map, sites, b) {
            let (_, known) = entry.known();
            let (x, y) = (J::from_input(&before[column]), J::from_input(&next[column]));
            rest -= entry.clone() * (y.clone() - x.clone());
            right += entry * x;
            size = size + known.at_least() * y.known().1.size;
            entries += usize::from(!known.at_least().is_zero());
        }
        let (residual, known) = rest.known();
        let (_, right) = right.known();
        let error = backward_error(known, size, right, Size::from(largest));
        Residual { residual, bound: error / ((entries as f64 + 8.0) * T::UNIT) }
    }
}

fn larger<T: LatticeScalar>(size: f64, number: &T) -> f64 {
    let own = number.approximate().abs();
    if own <= size { size } else { own }
}
