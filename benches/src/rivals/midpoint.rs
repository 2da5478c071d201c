//! The implicit midpoint rule x̃ = x + h·f(½(x + x̃)) with Newton's method.

use kahan_core::prelude::*;
use nalgebra::{Const, DimMin};

pub(crate) const NAME: &str = "implicit midpoint, Newton";
/// Newton's method ends after an update of at most this size, relative to max(1, |x̃|).
pub(crate) const TOLERANCE: f64 = 1e-14;

/// Returns a step of the midpoint rule. Newton's method begins at the result of Euler's method.
/// Panics if the matrix is singular, which does not occur in the benchmarks.
pub(crate) fn step<M, const N: usize>(map: M, eps: f64) -> impl Fn([f64; N]) -> [f64; N]
where
    M: KahanMap<f64, N>,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let h = 2.0 * eps;
    move |x| {
        let x = SVector::from(x);
        let mut next = x + map.field(&x) * h;
        // Newton's method converges within eight iterations, unless rounding errors exceed the
        // tolerance.
        for _ in 0..8 {
            let middle = (x + next) * 0.5;
            let residual = x + map.field(&middle) * h - next;
            // Newton's matrix I − εf′ is the matrix of Kahan's map at the midpoint.
            let update =
                map.matrix(&middle, eps).lu().solve(&residual).expect("the chains stay away from poles");
            next += update;
            if update.amax() <= TOLERANCE * next.amax().max(1.0) {
                break;
            }
        }
        next.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_bench_fields::E6;

    #[test]
    fn the_defining_equation_holds() {
        let (x, h) = ([1.3, 0.7, 0.4], 0.125);
        let next = SVector::from(step(E6, 0.5 * h)(x));
        let x = SVector::from(x);
        let defect = next - x - E6.field(&((x + next) * 0.5)) * h;
        assert!(defect.amax() < 1e-15, "{defect}");
    }
}
