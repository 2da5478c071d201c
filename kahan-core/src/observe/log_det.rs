//! How volumes change.

use core::marker::PhantomData;

use crate::FloatScalar;

use super::growth::Size;
use super::{Observer, Tangent};

/// The mean of log |det ∂x̃/∂x| per unit of time: the rate at which volumes grow, and the sum of
/// all Lyapunov exponents.
///
/// Cost: a determinant a step; the logarithm is taken once, of their product.
#[derive(Clone, Debug)]
pub struct MeanLogDet<M: Tangent<T>, T> {
    map: M,
    /// The point given last.
    place: M::Point,
    product: Size,
    steps: u64,
    scalar: PhantomData<T>,
}

impl<M: Tangent<T>, T: FloatScalar> MeanLogDet<M, T> {
    /// The rate of the map that `tangent` belongs to.
    pub fn new(tangent: M) -> Self {
        let place = tangent.point(|_| T::zero());
        Self { map: tangent, place, product: Size::ONE, steps: 0, scalar: PhantomData }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Observer<T> for MeanLogDet<M, T> {
    /// Not a number where there was no step.
    type Report = f64;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        if step > 0 {
            self.product.multiply(Size::of(self.map.det_jacobian(self.place.as_ref()).approximate()));
            self.steps = step;
        }
        self.place.as_mut().copy_from_slice(x);
    }

    fn report(self) -> f64 {
        self.product.ln() / (self.steps as f64 * 2.0 * self.map.half_step())
    }
}
