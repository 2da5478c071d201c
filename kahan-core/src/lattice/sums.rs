//! The linear integrals, the energy, and the modified energy that the map conserves.
//!
//! All sums over sites use compensated summation (A. Neumaier, ZAMM 54 (1974) 39–51).

use std::vec;
use std::vec::Vec;

use crate::scalar::DirectionalDual;
use crate::{Constant, Scalar};

use super::sites::Site;
use super::{LatticeAt, LatticeMap, LatticeScalar};

impl<M: LatticeMap<T>, T: LatticeScalar> LatticeAt<M, T> {
    /// Returns the names of the linear integrals, in the order of their values.
    pub fn integral_names(&self) -> &'static [&'static str] {
        M::INTEGRALS
    }

    /// Returns the values of the linear integrals.
    ///
    /// # Panics
    /// If the state has the wrong length.
    pub fn integrals(&self, x: &[T]) -> Vec<T> {
        let mut totals = vec![CompensatedSum::zero(); self.map().integral_count()];
        self.for_each_site(x, T::clone, |densities: &[T]| {
            totals.iter_mut().zip(densities).for_each(|(total, density)| total.add(density));
        });
        totals.into_iter().map(CompensatedSum::sum).collect()
    }

    fn for_each_site<S, L: Scalar + FromScalar<T>>(
        &self,
        x: &[S],
        convert: impl Fn(&S) -> L,
        mut visit: impl FnMut(&[L]),
    ) {
        let (map, sites) = (self.map(), self.sites());
        let block = map.sizes().block;
        assert!(x.len() == sites * block, "a state of {} numbers for a chain of {}", x.len(), sites * block);
        // The constants exist, because the chain was created with them.
        let Some(constants) = map.constants(L::from_scalar(self.eps()), L::from_scalar) else { return };
        let (mut site, mut densities) = (Site::of(map.sizes()), vec![L::zero(); map.integral_count() + 1]);
        for i in 0..sites {
            site.gather(map, x, i, &convert, L::from_scalar);
            site.densities(map, &constants, &mut densities);
            visit(&densities);
        }
    }

    /// Returns the Hamiltonian H(x), which the flow conserves but the map does not.
    ///
    /// A family without a Hamiltonian fails to compile in `cargo build`, but not in `cargo check`.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    /// kahan! { pub struct Decay; for i in periodic { x[i]dot = -x[i]; } }
    /// assert!(Decay.at(0.1, 4).unwrap().integrals(&[1.0; 4]).is_empty());
    /// ```
    ///
    /// ```compile_fail
    /// use kahan_core::prelude::*;
    /// kahan! { pub struct Decay; for i in periodic { x[i]dot = -x[i]; } }
    /// Decay.at(0.1, 4).unwrap().hamiltonian(&[1.0; 4]);
    /// ```
    ///
    /// # Panics
    /// If the state has the wrong length.
    pub fn hamiltonian(&self, x: &[T]) -> T {
        const { assert!(M::HAMILTONIAN.is_some(), "the family claims no `hamiltonian`") };
        let (mut total, place) = (CompensatedSum::zero(), self.map().integral_count());
        self.for_each_site(x, T::clone, |densities: &[T]| total.add(&densities[place]));
        total.sum()
    }

    /// Returns the modified energy H(x) + (2ε/3) ∇H(x)ᵀ A(x,ε)⁻¹ f(x) for the Hamiltonian H. The
    /// map conserves this energy if H has degree at most three (E. Celledoni, R. I. McLachlan, B.
    /// Owren, G. R. W. Quispel, J. Phys. A 46 (2013) 025201).
    ///
    /// The cost is one step and a copy of the state.
    ///
    /// # Panics
    /// Panics as [`step`](Self::step) does.
    pub fn modified_energy(&mut self, x: &[T]) -> T {
        const { assert!(M::HAMILTONIAN.is_some(), "the family claims no `hamiltonian`") };
        let mut next = x.to_vec();
        self.step(&mut next);
        let along: Vec<(T, T)> = x.iter().zip(next).map(|(x, next)| (x.clone(), next - x.clone())).collect();
        let third = T::constant(&Constant::ratio(1, 3));
        let (mut total, place) = (CompensatedSum::zero(), self.map().integral_count());
        let convert =
            |(value, step): &(T, T)| DirectionalDual { value: value.clone(), slope: Some(step.clone()) };
        self.for_each_site(&along, convert, |densities: &[DirectionalDual<T>]| {
            let density = densities[place].clone();
            total.add(&density.value);
            total.add(&(third.clone() * density.into_slope()));
        });
        total.sum()
    }
}

trait FromScalar<T> {
    fn from_scalar(value: &T) -> Self;
}

impl<T: LatticeScalar> FromScalar<T> for T {
    fn from_scalar(value: &T) -> Self {
        value.clone()
    }
}

impl<T: LatticeScalar> FromScalar<T> for DirectionalDual<T> {
    fn from_scalar(value: &T) -> Self {
        DirectionalDual::from_value(value.clone())
    }
}

#[derive(Clone, Debug)]
pub(super) struct CompensatedSum<T> {
    sum: T,
    lost: T,
}

impl<T: LatticeScalar> CompensatedSum<T> {
    pub(super) fn zero() -> Self {
        Self { sum: T::zero(), lost: T::zero() }
    }

    pub(super) fn add(&mut self, term: &T) {
        let sum = self.sum.clone() + term.clone();
        let (large, small) = if term.magnitude_exceeds(&self.sum) {
            (term.clone(), &self.sum)
        } else {
            (self.sum.clone(), term)
        };
        self.lost += (large - sum.clone()) + small.clone();
        self.sum = sum;
    }

    pub(super) fn sum(self) -> T {
        // If the sum is infinite, the compensation is left out, because it would make the sum NaN.
        if self.sum.is_finite_number() { self.sum + self.lost } else { self.sum }
    }
}
