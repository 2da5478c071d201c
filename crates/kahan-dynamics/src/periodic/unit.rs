//! A map in its own unit of length, so that tolerances do not depend on the caller's unit.
//!
//! Points are divided by a power of two near the size of a cycle, without rounding. The size of the
//! scaled cycle is then usually about 1.

use kahan_core::nalgebra::DMatrix;

use super::{Differentiable, Parametric};

#[derive(Clone, Copy, Debug)]
pub(super) struct LengthUnit {
    /// The unit of length, a power of two, measured in the caller's unit.
    pub(super) length: f64,
    /// The size of the cycle in this unit: about 1, or 0 if the given size was 0 or not finite.
    pub(super) size: f64,
}

impl LengthUnit {
    /// Returns the unit whose length is the largest power of two up to `size`.
    pub(super) fn of(size: f64) -> Self {
        if size > 0.0 && size.is_finite() {
            LengthUnit { length: libm::ldexp(1.0, libm::ilogb(size)), size: 1.0 }
        } else {
            LengthUnit { length: 1.0, size: 0.0 }
        }
    }
}

/// A map of points that are measured in units of `unit.length`.
#[derive(Clone, Debug)]
pub(super) struct ScaledMap<M> {
    pub(super) map: M,
    pub(super) unit: LengthUnit,
}

impl<M> ScaledMap<M> {
    pub(super) fn outside(&self, x: &[f64]) -> Vec<f64> {
        x.iter().map(|x| x * self.unit.length).collect()
    }

    fn inside(&self, x: Vec<f64>) -> Vec<f64> {
        x.into_iter().map(|x| x / self.unit.length).collect()
    }
}

impl<M: Differentiable> ScaledMap<M> {
    pub(super) fn dimension(&self) -> usize {
        self.map.dimension()
    }

    pub(super) fn image(&self, x: &[f64]) -> Vec<f64> {
        self.inside(self.map.image(&self.outside(x)))
    }

    pub(super) fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        self.map.derivative(&self.outside(x))
    }
}

impl<M: Parametric> ScaledMap<M> {
    pub(super) fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.inside(self.map.by_parameter(&self.outside(x)))
    }
}

impl<M: Differentiable> Differentiable for &M {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        M::derivative(self, x)
    }
}

pub(super) fn size(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}
