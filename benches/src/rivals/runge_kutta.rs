//! The classical Runge–Kutta method of order 4.

use kahan_core::prelude::*;

pub(crate) fn step<F, const N: usize>(field: F, eps: f64) -> impl Fn([f64; N]) -> [f64; N]
where
    F: QuadraticField<f64, N>,
{
    let h = 2.0 * eps;
    move |x| {
        let x = SVector::from(x);
        let first = field.field(&x);
        let second = field.field(&(x + first * (0.5 * h)));
        let third = field.field(&(x + second * (0.5 * h)));
        let fourth = field.field(&(x + third * h));
        (x + (first + (second + third) * 2.0 + fourth) * (h / 6.0)).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_bench_fields::E1;

    /// E1 has x = 1/(1 + t) for x(0) = 1. Halving the step must divide the error by 2⁴.
    #[test]
    fn the_order_is_four() {
        let error = |steps: usize| {
            let step = step(E1, 0.5 / steps as f64);
            let end = (0..steps).fold([1.0, 0.0, 0.0], |x, _| step(x));
            (end[0] - 0.5_f64).abs()
        };
        let order = (error(16) / error(32)).log2();
        assert!((order - 4.0).abs() < 0.2, "{order}");
    }
}
