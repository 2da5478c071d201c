//! The step by elimination, for maps without a closed form.
//!
//! The increment is x̃ − x = 2ε·A(x,ε)⁻¹f(x) with A(x,ε) = I − εf′(x). Elimination fails where det
//! A(x,ε) = 0, even if a common factor cancels in x̃ and the map is defined there.

use nalgebra::SVector;

use crate::field::linear::increment_by_elimination;
use crate::step::NoLanes;
use crate::{KahanMap, PreparedStep, Quotients, Scalar};

/// The prepared step of any map M, which solves a linear system at every state.
///
/// A step evaluates A(x,ε) and f(x), and takes about N³/3 multiplications and N divisions. With
/// this type, a handwritten map implements [`KahanMap`] in two lines:
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::{Elimination, QuadraticField};
///
/// /// ẋ = −x².
/// #[derive(Clone)]
/// struct Decay;
///
/// impl QuadraticField<f64, 1> for Decay {
///     fn field(&self, x: &SVector<f64, 1>) -> SVector<f64, 1> {
///         self.polarized(x, x)
///     }
///     fn field_jacobian(&self, x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
///         -2.0 * x
///     }
///     fn bilinear(&self, x: &SVector<f64, 1>, y: &SVector<f64, 1>) -> SVector<f64, 1> {
///         vector![-x[0] * y[0]]
///     }
///     fn polarized(&self, x: &SVector<f64, 1>, y: &SVector<f64, 1>) -> SVector<f64, 1> {
///         self.bilinear(x, y)
///     }
/// }
///
/// impl KahanMap<f64, 1> for Decay {
///     type Prepared = Elimination<Self, f64>;
///     fn prepare(&self, eps: &f64) -> Self::Prepared {
///         Elimination::new(self.clone(), *eps)
///     }
/// }
///
/// // Kahan's map is exact on this field: 1/x̃ = 1/x + 2ε.
/// assert!((Decay.step(&vector![0.5], 0.25)[0] - 0.4).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elimination<M, T> {
    map: M,
    eps: T,
}

impl<M, T> Elimination<M, T> {
    /// Prepares the step of `map` at `eps`, half the time step.
    #[inline]
    pub fn new(map: M, eps: T) -> Self {
        Self { map, eps }
    }
}

impl<M: KahanMap<T, N>, T: Scalar, const N: usize> PreparedStep<T, N> for Elimination<M, T> {
    type Wide<L: Scalar> = NoLanes;

    #[inline]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        let Self { map, eps } = self;
        let increment = increment_by_elimination(map.matrix(x, eps.clone()), map.field_at(x, eps), eps)?;
        let [increments] = increment.data.0;
        Some(Quotients::whole(increments))
    }
}
