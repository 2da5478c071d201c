//! Families written by hand, in the form that the macro generates.

use std::vec;
use std::vec::Vec;

use crate::lattice::{Boundary, Sizes, Stencil};
use crate::{Constant, LatticeMap, LatticeScalar, Scalar};

const fn boundary(is_open: bool) -> Boundary {
    if is_open { Boundary::Open } else { Boundary::Periodic }
}

/// The Volterra chain ẋᵢ = xᵢ(xᵢ₊₁ − xᵢ₋₁).
#[derive(Clone, Debug)]
pub(super) struct Volterra<const OPEN: bool>;

impl<T: LatticeScalar, const OPEN: bool> LatticeMap<T> for Volterra<OPEN> {
    const ARRAYS: &'static [&'static str] = &["x"];
    const REACH: usize = 1;

    type Kernels = Stencil<1, 1, 0, 1, 1, 1, 3, 3>;

    fn sizes(&self) -> Sizes {
        Self::Kernels::SIZES
    }

    fn boundary(&self) -> Boundary {
        boundary(OPEN)
    }

    fn constants<L: Scalar>(&self, eps: L, _lift: impl Fn(&T) -> L) -> Option<Vec<L>> {
        Some(vec![eps])
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], _c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        let eps = constants[0].clone();
        let difference = x[2].clone() - x[0].clone();
        let scaled = eps.clone() * x[1].clone();
        f[0] = x[1].clone() * difference.clone();
        a[0] = scaled.clone();
        a[1] = L::one().subtract_product(eps, difference);
        a[2] = -scaled;
    }
}

/// The Toda chain in Flaschka's variables: ȧᵢ = aᵢ(bᵢ₊₁ − bᵢ), ḃᵢ = 2(aᵢ² − aᵢ₋₁²).
#[derive(Clone, Debug)]
pub(super) struct Toda<const OPEN: bool>;

impl<T: LatticeScalar, const OPEN: bool> LatticeMap<T> for Toda<OPEN> {
    const ARRAYS: &'static [&'static str] = &["a", "b"];
    const REACH: usize = 1;

    type Kernels = Stencil<2, 1, 0, 2, 3, 3, 3, 7>;

    fn sizes(&self) -> Sizes {
        Self::Kernels::SIZES
    }

    fn boundary(&self) -> Boundary {
        boundary(OPEN)
    }

    fn constants<L: Scalar>(&self, eps: L, _lift: impl Fn(&T) -> L) -> Option<Vec<L>> {
        Some(vec![eps.clone(), L::constant(&Constant::integer(4)) * eps])
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], _c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        let (eps, four_eps) = (constants[0].clone(), constants[1].clone());
        let two = L::constant(&Constant::integer(2));
        f[0] = x[2].clone() * (x[5].clone() - x[3].clone());
        f[1] = two * (x[2].clone() * x[2].clone() - x[0].clone() * x[0].clone());
        let scaled = eps.clone() * x[2].clone();
        a[2] = L::one().subtract_product(eps, x[5].clone() - x[3].clone());
        a[3] = scaled.clone();
        a[5] = -scaled;
        a[6] = four_eps.clone() * x[0].clone();
        a[8] = -(four_eps * x[2].clone());
        a[9] = L::one();
    }
}

/// The equation u_t = −6 u u_x − u_xxx in central differences of step h, with a dispersion
/// coefficient for each site.
#[derive(Clone, Debug)]
pub(super) struct Kdv<T, const OPEN: bool> {
    /// 1/h for the difference step h.
    pub(super) inverse: T,
    pub(super) dispersion: Vec<T>,
}

impl<T: LatticeScalar, const OPEN: bool> LatticeMap<T> for Kdv<T, OPEN> {
    const ARRAYS: &'static [&'static str] = &["u"];
    const REACH: usize = 2;
    const SITE_PARAMETERS: &'static [&'static str] = &["dispersion"];

    type Kernels = Stencil<1, 2, 1, 4, 2, 2, 5, 5>;

    fn sizes(&self) -> Sizes {
        Self::Kernels::SIZES
    }

    fn boundary(&self) -> Boundary {
        boundary(OPEN)
    }

    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>> {
        let inverse = convert(&self.inverse);
        let advection = L::constant(&Constant::integer(3)) * inverse.clone();
        let third = inverse.clone() * inverse.clone() * inverse * L::constant(&Constant::ratio(1, 2));
        Some(vec![advection.clone(), third.clone(), eps.clone() * advection, eps * third])
    }

    fn site_parameter(&self, _index: usize) -> &[T] {
        &self.dispersion
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        let slope = x[3].clone() - x[1].clone();
        let two = L::constant(&Constant::integer(2));
        let third = (x[4].clone() - x[0].clone()).subtract_product(two, slope.clone());
        let advection = constants[0].clone() * x[2].clone() * slope.clone();
        f[0] = -(constants[1].clone() * c[2].clone()).multiply_add(third, advection);
        let dispersion = constants[3].clone() * c[2].clone();
        let both = dispersion.clone() + dispersion.clone();
        let advection = constants[2].clone() * x[2].clone();
        a[0] = -dispersion.clone();
        a[1] = both.clone() - advection.clone();
        a[2] = constants[2].clone().multiply_add(slope, L::one());
        a[3] = advection - both;
        a[4] = dispersion;
    }
}

/// A field with three arrays, neighbours up to five sites away, and eight products per derivative.
#[derive(Clone, Debug)]
pub(super) struct Tangled<T, const OPEN: bool>(pub(super) [T; 8]);

const fn factors(b: usize, term: usize) -> (usize, usize) {
    let seed = 7 * b + 11 * term + 3;
    ((seed * seed + 5 * seed) % 33, (3 * seed * seed + 17) % 33)
}

impl<T: LatticeScalar, const OPEN: bool> LatticeMap<T> for Tangled<T, OPEN> {
    const ARRAYS: &'static [&'static str] = &["u", "v", "w"];
    const REACH: usize = 5;

    type Kernels = Stencil<3, 5, 0, 9, 17, 17, 11, 35>;

    fn sizes(&self) -> Sizes {
        Self::Kernels::SIZES
    }

    fn boundary(&self) -> Boundary {
        boundary(OPEN)
    }

    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&T) -> L) -> Option<Vec<L>> {
        Some(core::iter::once(eps).chain(self.0.iter().map(convert)).collect())
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], _c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        for (b, f) in f.iter_mut().enumerate() {
            *f = L::one();
            for term in 0..8 {
                let (p, q) = factors(b, term);
                *f += constants[1 + term].clone() * (x[p].clone() * x[q].clone());
            }
        }
        for b in 0..3 {
            a[33 * b + 15 + b] = L::one();
            for term in 0..8 {
                let (p, q) = factors(b, term);
                let coefficient = constants[0].clone() * constants[1 + term].clone();
                a[33 * b + p] -= coefficient.clone() * x[q].clone();
                a[33 * b + q] -= coefficient * x[p].clone();
            }
        }
    }
}
