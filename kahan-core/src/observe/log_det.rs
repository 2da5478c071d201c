//! The growth rate of volumes.

use crate::{FloatScalar, StateVector};

use super::growth::Size;
use super::{Observer, TangentMap};

/// An observer of the mean of log |det ∂x̃/∂x| per unit of time, the sum of all Lyapunov exponents.
#[derive(Clone, Debug)]
pub struct MeanLogDet<M: TangentMap> {
    map: M,
    place: M::State,
    product: Size,
    steps: u64,
}

impl<M: TangentMap> MeanLogDet<M> {
    /// Creates an observer for orbits of a prepared map, which is given by value or by reference.
    pub fn new(map: M) -> Self {
        Self { place: M::State::zeros(map.dimension()), map, product: Size::ONE, steps: 0 }
    }
}

impl<M: TangentMap<Scalar = T>, T: FloatScalar> Observer<T> for MeanLogDet<M> {
    /// The mean per unit of time, NaN without a step.
    type Report = f64;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        if step > 0 {
            self.product.multiply(Size::of(self.map.det_jacobian(self.place.as_slice()).approximate()));
            self.steps = step;
        }
        self.place.as_mut_slice().copy_from_slice(x);
    }

    fn report(self) -> f64 {
        self.product.ln() / (self.steps as f64 * 2.0 * self.map.eps().approximate())
    }
}
