//! A map in a unit of length of its own, so that no tolerance depends on that of its caller.
//!
//! In: a map, and a power of two. Out: the same map of points that are divided by that power, which
//! rounds nothing. Where the power is about the size of a cycle, the cycle's size is about 1, and
//! its points can be measured together with a parameter.

use kahan_core::nalgebra::DMatrix;

use super::{Differentiable, Parametric};

/// A unit of length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    /// A power of two.
    pub(super) length: f64,
    /// The size that lengths are compared with, in this unit: 1, or 0 where there was none.
    pub(super) size: f64,
}

impl Unit {
    /// The largest power of two that is no larger than a size.
    pub(super) fn of(size: f64) -> Self {
        if size > 0.0 && size.is_finite() {
            Unit { length: libm::ldexp(1.0, libm::ilogb(size)), size: 1.0 }
        } else {
            Unit { length: 1.0, size: 0.0 }
        }
    }
}

/// A map of points in units of `unit`.
#[derive(Clone, Debug)]
pub(super) struct InUnits<M> {
    pub(super) map: M,
    pub(super) unit: Unit,
}

impl<M> InUnits<M> {
    /// A point in the units of the map itself.
    pub(super) fn outside(&self, x: &[f64]) -> Vec<f64> {
        x.iter().map(|x| x * self.unit.length).collect()
    }

    fn inside(&self, x: Vec<f64>) -> Vec<f64> {
        x.into_iter().map(|x| x / self.unit.length).collect()
    }
}

impl<M: Differentiable> InUnits<M> {
    /// The number of variables.
    pub(super) fn dimension(&self) -> usize {
        self.map.dimension()
    }

    /// x̃
    pub(super) fn image(&self, x: &[f64]) -> Vec<f64> {
        self.inside(self.map.image(&self.outside(x)))
    }

    /// ∂x̃/∂x
    pub(super) fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        self.map.derivative(&self.outside(x))
    }
}

impl<M: Parametric> InUnits<M> {
    /// ∂x̃/∂p
    pub(super) fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.inside(self.map.by_parameter(&self.outside(x)))
    }
}

impl<M: Differentiable> Differentiable for &M {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        M::derivative(self, x)
    }
}

/// The largest coordinate in size.
pub(super) fn size(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}
